// Cameras that are turned and moved around their target.
#include "panes/orbit.h"

#include "window_fixture.h"

namespace reliefui {
namespace {

TEST(OrbitCamera, onlyWhatIsChangedChanges) {
    const relief::Camera camera = smallScenario().camera;
    ASSERT_EQ(camera.kind, relief::Camera::Kind::Orbit);
    EXPECT_EQ(asOrbit(camera), camera);
    const relief::Camera near = moved(camera, 0.5);
    EXPECT_NEAR(near.distance, camera.distance / 2, 1e-4);
    const relief::Camera aside = turned(camera, 10, 0, relief::SceneKind::Wall);
    EXPECT_NEAR(aside.azimuth, camera.azimuth + 10, 0.01);
    EXPECT_NEAR(aside.elevation, camera.elevation, 0.01);
    EXPECT_EQ(aside.distance, camera.distance);
}

}  // namespace
}  // namespace reliefui
