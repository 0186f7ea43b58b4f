// All panes beside the result, in the order of their keys: window, menus, layouts, export and help iterate over them.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <QString>

class QWidget;

namespace reliefui {

class Workspace;

// Where a pane stands at first: right of the result above or below, under it, left of it. The first pane of a home
// stands in front, the others behind it in tabs.
enum class Home : std::uint8_t { High, Low, Time, Side };

struct PaneKind {
    QString name;   // "profile": also of its figure; its dock is "profile-pane"
    QString title;  // in the pane
    QString tab;    // shorter, where there are many
    QString help;   // what it shows, in a line
    Home home = Home::Low;
    // A FigureView, or a widget whose focus proxy, if it has one, gets the keyboard.
    std::function<QWidget*(Workspace* workspace, QWidget* parent)> make;
    bool open = true;  // at first
};

// In the window's language: not before the application is dressed.
std::vector<PaneKind> paneList();

}  // namespace reliefui
