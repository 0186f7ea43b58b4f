// The library's public interface: reading and making height maps, the ray of a pixel, tracers, their hits, and the
// record of every step. Only what these headers declare is installed; everything else may change.
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
