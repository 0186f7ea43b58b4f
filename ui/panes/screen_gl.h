// Whether windows can show OpenGL, and what 3-D views show where they cannot.
#pragma once

class QBoxLayout;
class QWidget;

namespace reliefui {

// Returns true if the X server that DISPLAY names has the extension GLX, through which Qt and VTK draw in windows. It
// is asked once. True also without an X server, as when figures are drawn, which need no window.
bool screenHasGl();

// The parent to construct an OpenGL widget of a pane with: none where the screen has no OpenGL, because Qt composes
// windows that have such a child by OpenGL, even if it is hidden.
QWidget* glParent(QWidget* pane);
// Adds a widget that was made so to the pane's layout or, where the screen has no OpenGL, a sentence in its place; the
// widget is then never shown, and deleted with the pane.
void addGlWidget(QWidget& widget, QBoxLayout& layout, QWidget& pane);

}  // namespace reliefui
