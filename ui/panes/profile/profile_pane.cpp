#include "panes/profile/profile_pane.h"

#include "panes/point_state.h"
#include "panes/profile/profile_figure.h"
#include "panes/profile/profile_state.h"
#include "panes/profile/profile_view.h"
#include "workspace/annotation_state.h"

namespace reliefui {

PaneKind profilePane() {
    PaneKind kind;
    kind.name = QStringLiteral("profile");
    kind.title = ProfileView::tr("Profile");
    kind.help = ProfileView::tr("Section of the relief along the ray");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<ProfileView>;
    kind.figures = {{"profile", true, [](std::shared_ptr<const Snapshot> s, const relief::Scenario& now) {
                         ProfileOptions options;
                         takeProfile(options, stateOf<ProfilePane>(now));
                         return profileFigure(std::move(s), now.step, options, stateOf<PointState>(now).point,
                                              stateOf<AnnotationState>(now).list);
                     }}};
    kind.states = {readerOf<ProfilePane>(), readerOf<PointState>()};
    return kind;
}

}  // namespace reliefui
