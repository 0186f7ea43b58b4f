// What a pane is to the window, its menus and layouts, and to `reliefscope --export`: an entry of the list of panes.
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

// Where a pane stands at first: in the middle (the result alone), right of it above or below, under it, left of it. The
// first pane of a place stands in front, the others behind it in tabs.
enum class DockPlace : std::uint8_t { Center, UpperRight, LowerRight, Bottom, Left };

struct FigureKind {
    std::string name;
    bool vectors = true;
    // At the scenario's step of the ray, as its panes' states say; may take seconds, of what a pane measures. Throws
    // InputError. Empty: not of a snapshot ("pareto", of a table of measurements).
    std::function<std::shared_ptr<const Figure>(std::shared_ptr<const Snapshot>, const relief::Scenario&)> make;
};

struct PaneKind {
    QString name;   // "profile": its dock is "profile-pane"
    QString title;  // in the pane
    QString tab;    // shorter, where there are many; empty: the title
    QString help;   // what it shows, in a line
    DockPlace place = DockPlace::LowerRight;
    std::function<QWidget*(Workspace* workspace, QWidget* parent)> make;
    // The part of it that gets the keyboard; empty: its focus proxy, as FigureView::setFace() sets it, or all of it.
    std::function<QWidget*(QWidget* pane)> focus{};
    std::vector<FigureKind> figures{};
    // Of what it keeps in scenarios.
    StateReaders states{};
    bool open = true;  // at first
};

// As PaneKind::make.
template <class View>
QWidget* makePane(Workspace* workspace, QWidget* parent) {
    return new View(workspace, parent);
}

// As FigureKind::make, of panes without a state that figures show.
template <std::shared_ptr<const Figure> (*make)(std::shared_ptr<const Snapshot>)>
std::shared_ptr<const Figure> plainFigure(std::shared_ptr<const Snapshot> snapshot, const relief::Scenario&) {
    return make(std::move(snapshot));
}

}  // namespace reliefui
