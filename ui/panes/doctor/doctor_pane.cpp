#include "panes/doctor/doctor_pane.h"

#include "panes/doctor/doctor_drawing.h"
#include "panes/doctor/doctor_view.h"

namespace reliefui {

PaneKind doctorPane() {
    PaneKind kind;
    kind.name = QStringLiteral("doctor");
    kind.title = DoctorView::tr("Doctor");
    kind.help = DoctorView::tr("What is wrong with another tracer, from its rays and hits");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<DoctorView>;
    kind.figures = {{"doctor", true, diagnosedFigure}};
    kind.open = false;  // needs the files of another tracer
    return kind;
}

}  // namespace reliefui
