#include "panes/profile/profile_pane.h"

#include "panes/profile/profile_figure.h"
#include "panes/profile/profile_view.h"

namespace reliefui {

PaneKind profilePane() {
    PaneKind kind;
    kind.name = QStringLiteral("profile");
    kind.title = ProfileView::tr("Profile");
    kind.help = ProfileView::tr("The relief under the ray, cut along it");
    kind.place = DockPlace::LowerRight;
    kind.make = makePane<ProfileView>;
    kind.figures = {{"profile", true, [](std::shared_ptr<const Snapshot> s, int step, const PaneStates& p) {
                         ProfileOptions options;
                         takeProfile(options, p.profile);
                         return profileFigure(std::move(s), step, options, p.query);
                     }}};
    return kind;
}

}  // namespace reliefui
