// The camera as a pinhole in the pixels of a screen.
#pragma once

#include "mapping/homography.h"
#include "relief/camera.h"

namespace relief {

// The camera in pixels of a width x height screen, its principal point in the middle.
// Throws InputError("--camera", ...) where the camera is degenerate (eye at the target, fov out of range, NaN).
PinholeCamera pinholeCamera(const Camera& camera, int width, int height);

}  // namespace relief
