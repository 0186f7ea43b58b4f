// What OpenGL keeps for a pane that is closed.
#pragma once

class QVTKOpenGLNativeWidget;

namespace reliefui {

// Of a widget that is not on the screen: its buffers are made small, then its context ends, with textures and programs;
// some 30 to 80 MB a pane. Shown again, it has its size again and makes all of it anew, as after a move to another
// window. (Small first: Mesa keeps some of the buffers of a context that ends until the whole window is gone.)
void releaseGl(QVTKOpenGLNativeWidget& widget);

}  // namespace reliefui
