#include "panes/shader/shader_pane.h"

#include "panes/shader/shader_figure.h"
#include "panes/shader/shader_view.h"

namespace reliefui {

PaneKind shaderPane() {
    PaneKind kind;
    kind.name = QStringLiteral("shader");
    kind.title = ShaderView::tr("Shader");
    kind.help = ShaderView::tr("The picture of the exported shader, compared with the CPU's");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<ShaderView>;
    kind.figures = {{"shader", true, drawnShader}};
    kind.states = {readerOf<ShaderPane>()};
    kind.open = false;  // it starts OpenGL: opened from the menu or by its key
    return kind;
}

}  // namespace reliefui
