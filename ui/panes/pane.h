// Description of a pane for the window, its menus and layouts, and for `reliefscope --export`: an entry of the list of
// panes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <QString>

#include "panes/figure.h"
#include "workspace/pane_store.h"
#include "workspace/snapshot.h"

class QWidget;

namespace reliefui {

class Workspace;

// Initial place of a pane: the centre (only the result), the upper or lower right, the bottom, or the left. The first
// pane of a place is in front, the others are tabs behind it.
enum class DockPlace : std::uint8_t { Center, UpperRight, LowerRight, Bottom, Left };

struct FigureKind {
    std::string name;
    bool vectors = true;
    // Creates the figure for the scenario's step, with the options in the panes' states. May take seconds if the pane
    // measures. Throws InputError. Empty for figures that do not show a snapshot ("pareto" shows a table of
    // measurements).
    std::function<std::shared_ptr<const Figure>(std::shared_ptr<const Snapshot>, const relief::Scenario&)> make;
    // Of 3-D views: the same from a camera turned by this angle in degrees around the vertical, for an orbit, in which
    // all angles have the same distance.
    std::function<std::shared_ptr<const Figure>(std::shared_ptr<const Snapshot>, const relief::Scenario&, double turn)>
        turned{};
};

struct PaneKind {
    QString name;   // "profile": its dock is "profile-pane"
    QString title;  // title bar of the pane
    QString tab;    // shorter title for tabs; empty: the title
    QString help;   // one line on what the pane shows
    DockPlace place = DockPlace::LowerRight;
    std::function<QWidget*(Workspace* workspace, QWidget* parent)> make;
    // Returns the widget of the pane that gets the keyboard focus. Empty: the pane's focus proxy, as set by
    // FigureView::setFace(), or the pane itself.
    std::function<QWidget*(QWidget* pane)> focus{};
    std::vector<FigureKind> figures{};
    // Readers of the states that the pane stores in scenarios.
    StateReaders states{};
    bool open = true;  // initially
};

// For PaneKind::make.
template <class View>
QWidget* makePane(Workspace* workspace, QWidget* parent) {
    return new View(workspace, parent);
}

// For FigureKind::make of panes whose figures do not depend on a state.
template <std::shared_ptr<const Figure> (*make)(std::shared_ptr<const Snapshot>)>
std::shared_ptr<const Figure> plainFigure(std::shared_ptr<const Snapshot> snapshot, const relief::Scenario&) {
    return make(std::move(snapshot));
}

}  // namespace reliefui
