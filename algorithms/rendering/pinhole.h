// Converts a camera to a pinhole in the pixels of a screen.
#pragma once

#include "mapping/homography.h"
#include "relief/camera.h"

namespace relief {

// Returns the camera in the pixels of a width x height screen, with its principal point at the centre. Throws
// InputError("--camera", ...) for a degenerate camera (eye at the target, fov out of range, NaN).
PinholeCamera pinholeCamera(const Camera& camera, int width, int height);

}  // namespace relief
