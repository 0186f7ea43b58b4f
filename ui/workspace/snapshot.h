// One state of everything on screen, made by the worker and looked at by the views. Immutable, shared.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <QImage>

#include "images/pyramid.h"
#include "relief/maps/max_pyramid_map.h"
#include "relief/tracers.h"
#include "rendering/skip_ledger.h"
#include "scenario/scenario.h"
#include "workspace/layers.h"
#include "workspace/pixel_footprint.h"
#include "workspace/pixel_trace.h"

namespace reliefui {

struct Snapshot {
    std::uint64_t version = 0;  // of the scenario
    relief::Scenario scenario;
    relief::Assets assets;
    std::shared_ptr<const relief::FrameRequest> request;  // of the frame, as it was drawn: coarse, if coarse
    bool coarse = false;                                  // drawn with less, or smaller, while something is dragged
    std::shared_ptr<const relief::Frame> frame;           // of the coarse size, if coarse
    QImage picture;                                       // the frame as shown; its size is the frame's
    LayerPicture layer;                                   // what the result view was asked to show instead of it
    std::shared_ptr<const relief::Tracer> tracer;         // of the frame
    relief::Guarantee guarantee = relief::Guarantee::Approximate;  // of the method with these options
    std::size_t methodBytes = 0;                                   // of its maps
    std::optional<relief::BoundedError> bounded;                   // of a full frame that skips within a bound
    double ellipseOff = 0;                                         // of a full frame: ellipseError()
    std::shared_ptr<const PixelFootprint> footprint;               // of the pixel; null where it has no hit
    PixelTrace trace;                                              // in full-size pixels, also when coarse
    std::shared_ptr<const PixelTrace> other;                       // of somebody else's tracer; null: no files are open
    std::size_t otherRays = 0;                                     // that the files have
    std::shared_ptr<const relief::MaxPyramidMap> maxima;           // over the cells of the field
    // Over the texels; of large pictures only if they are shown.
    std::shared_ptr<const relief::Pyramid> means;
    std::shared_ptr<const relief::Pyramid> minima;
    std::shared_ptr<relief::MapCache> maps;  // that were built for it, and take more

    bool has(relief::PyramidKind levels) const {
        return levels == relief::PyramidKind::Mean  ? means != nullptr
               : levels == relief::PyramidKind::Min ? minima != nullptr
                                                    : maxima != nullptr;
    }
};

}  // namespace reliefui
