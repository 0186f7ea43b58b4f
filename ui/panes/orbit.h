// Turning a camera around its target.
#pragma once

#include "relief/camera.h"
#include "rendering/scene.h"

namespace reliefui {

// The same view as an orbit around its target; free cameras become one.
relief::Camera asOrbit(const relief::Camera& camera);
// Turned by so many degrees; azimuth kept in (-180, 180], elevation short of the poles. A camera in front of a wall or
// above a floor stays there: behind is nothing to be seen.
relief::Camera turned(const relief::Camera& camera, double azimuth, double elevation, relief::SceneKind scene);
// Nearer (factor < 1) or further away.
relief::Camera moved(const relief::Camera& camera, double factor);

}  // namespace reliefui
