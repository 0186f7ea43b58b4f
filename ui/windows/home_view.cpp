#include "windows/home_view.h"

#include "windows/scene_panel.h"
#include "workspace/change_name.h"

namespace reliefui {

HomeView* HomeView::of(Workspace* workspace) {
    auto* const there = workspace->findChild<HomeView*>(QString(), Qt::FindDirectChildrenOnly);
    return there != nullptr ? there : new HomeView(workspace);
}

HomeView::HomeView(Workspace* workspace)
    : QObject(workspace), workspace_(workspace), seen_(workspace->scenario()), camera_(seen_.camera) {
    connect(workspace_, &Workspace::scenarioChanged, this, &HomeView::watch);
}

// A newly opened scenario brings its own camera, which becomes the home view. A change of camera, pixel or step alone
// (turning, going to a bookmark) leaves it as it is. Another scene gets the slanted view as its home.
void HomeView::watch() {
    const relief::Scenario& now = workspace_->scenario();
    relief::Scenario turned = seen_;
    turned.camera = now.camera;
    turned.pixel = now.pixel;
    turned.step = now.step;
    const bool whole = !(now.camera == seen_.camera) && !(relief::withNotesOf(turned, now) == now);
    if (whole) {
        camera_ = now.camera;
    } else if (now.scene != seen_.scene) {
        camera_ = presetCamera(viewPresets()[1], now.scene);
        camera_.fov = now.camera.fov;
    }
    seen_ = now;
}

void HomeView::go() {
    relief::Scenario scenario = workspace_->scenario();
    scenario.camera = camera_;
    workspace_->change(scenario, changeName([] { return tr("First view"); }));
}

}  // namespace reliefui
