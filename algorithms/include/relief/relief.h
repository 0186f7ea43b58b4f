// The library, for programs of others: a height map read or made, the ray of a pixel, the tracers, what they hit and
// every step on the way. What these headers declare is what is installed; all else may change.
#pragma once

#include "relief/addressing.h"
#include "relief/camera.h"
#include "relief/describe.h"
#include "relief/errors.h"
#include "relief/files.h"
#include "relief/height_field.h"
#include "relief/image.h"
#include "relief/map_cache.h"
#include "relief/messages.h"
#include "relief/ray.h"
#include "relief/reliefs.h"
#include "relief/step_log.h"
#include "relief/tracer.h"
#include "relief/tracers.h"
#include "relief/work.h"
