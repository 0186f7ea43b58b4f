// The dialog for moving pictures (moving_picture.h) from the window.
#pragma once

#include <QString>

class QWidget;

namespace reliefui {

class Workspace;

// Asks for a pane, what is to change, how it is to be written, and for a file; then writes the moving picture in
// another process (share.h). pane: the name of the pane proposed.
void askMovingPicture(QWidget* window, Workspace* workspace, const QString& pane);

}  // namespace reliefui
