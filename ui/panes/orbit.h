// Rotation of a camera around its target.
#pragma once

#include "relief/camera.h"
#include "rendering/scene.h"

namespace reliefui {

// The same view expressed as an orbit around its target; free cameras are converted.
relief::Camera asOrbit(const relief::Camera& camera);
// Rotates by these angles in degrees; the azimuth stays in (-180, 180], the elevation short of the poles. A camera in
// front of a wall or above a floor stays on that side, because nothing is visible from behind.
relief::Camera turned(const relief::Camera& camera, double azimuth, double elevation, relief::SceneKind scene);
// Scales the distance to the target; factor < 1 moves the camera closer.
relief::Camera moved(const relief::Camera& camera, double factor);

}  // namespace reliefui
