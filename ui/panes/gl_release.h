// What OpenGL keeps for a pane that is closed.
#pragma once

class QVTKOpenGLNativeWidget;

namespace reliefui {

// Of a widget that is not on the screen: VTK gives back its buffers, textures and programs, then the context ends; some
// 30 to 80 MB a pane. Shown again, it has its size again and makes all of it anew, as after a move to another window.
// (Small first: a little stays with the contexts that share it until the whole window is gone.)
void releaseGl(QVTKOpenGLNativeWidget& widget);

}  // namespace reliefui
