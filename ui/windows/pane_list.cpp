#include "windows/pane_list.h"

#include <QScrollArea>
#include <QScrollBar>

#include "panes/charts/charts_view.h"
#include "panes/compare/compare_view.h"
#include "panes/distance/distance_view.h"
#include "panes/drawn/drawn_view.h"
#include "panes/duel/duel_view.h"
#include "panes/footprint/footprint_view.h"
#include "panes/profile/profile_view.h"
#include "panes/pyramid/pyramid_view.h"
#include "panes/rows/rows_view.h"
#include "panes/skipped/skipped_panel.h"
#include "panes/trace/trace3d_view.h"
#include "windows/main_window.h"
#include "windows/scene_panel.h"
#include "windows/time_pane.h"

namespace reliefui {

namespace {

template <class Pane>
QWidget* make(Workspace* workspace, QWidget* parent) {
    return new Pane(workspace, parent);
}

QWidget* makeScene(Workspace* workspace, QWidget* parent) {
    auto* const scroll = new QScrollArea(parent);
    auto* const panel = new ScenePanel(workspace, scroll);
    scroll->setWidget(panel);
    scroll->setAccessibleName(MainWindow::tr("Scene"));
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(panel->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
    return scroll;
}

PaneKind pane(const char* name, const QString& title, const QString& help, Home home,
              QWidget* (*made)(Workspace*, QWidget*), const QString& tab = {}) {
    return {QString::fromLatin1(name), title, tab.isEmpty() ? title : tab, help, home, made};
}

}  // namespace

std::vector<PaneKind> paneList() {
    std::vector<PaneKind> list{
        pane("trace", MainWindow::tr("Trace 3-D"), MainWindow::tr("The ray through the relief, in space"), Home::High,
             make<Trace3dView>, MainWindow::tr("Trace 3-D", "tab")),
        pane("pyramid", MainWindow::tr("Pyramid"),
             MainWindow::tr("The levels of the pyramid and the texels that the ray looked at"), Home::Low,
             make<PyramidView>),
        pane("steps", MainWindow::tr("Steps"),
             MainWindow::tr("The steps of the ray, one by one, and what each of them means"), Home::Time,
             make<TimePane>),
        pane("scene", MainWindow::tr("Scene"), MainWindow::tr("Pictures, method, filter, camera and light"), Home::Side,
             makeScene),
        pane("profile", MainWindow::tr("Profile"), MainWindow::tr("The relief under the ray, cut along it"), Home::Low,
             make<ProfileView>),
        pane("distance", MainWindow::tr("Distance map"), MainWindow::tr("A slice through what the method has stored"),
             Home::Low, make<DistanceView>, MainWindow::tr("Distance map", "tab")),
        pane("footprint", MainWindow::tr("Footprint"),
             MainWindow::tr("The part of the texture that the pixel covers, and the weight of each texel"), Home::Low,
             make<FootprintView>, MainWindow::tr("Footprint", "tab")),
        pane("rows", MainWindow::tr("Rows"),
             MainWindow::tr("Texture coordinates along the pixel's row, computed in several ways"), Home::Low,
             make<RowsView>),
        pane("charts", MainWindow::tr("Charts"),
             MainWindow::tr("Run time against error, steps and errors of all pixels"), Home::Low, make<ChartsView>),
        pane("compare", MainWindow::tr("Compare"), MainWindow::tr("Pictures of several methods beside each other"),
             Home::High, make<CompareView>),
        pane("drawn", MainWindow::tr("By hand"), MainWindow::tr("A small relief, drawn texel by texel"), Home::Side,
             make<DrawnView>),
        pane("duel", MainWindow::tr("Duel"), MainWindow::tr("Several methods on one ray, step by step"), Home::Low,
             make<DuelView>),
        pane("skipped", MainWindow::tr("Skipped"), MainWindow::tr("What the picture did without, and why"), Home::Time,
             make<SkippedPanel>),
    };
    // Opened from the menu, by its key or from the bottom line.
    list.back().open = false;
    return list;
}

}  // namespace reliefui
