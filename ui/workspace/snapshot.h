// The complete state shown on screen, computed by the worker and displayed by the views. Immutable and shared.
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
    std::uint64_t version = 0;  // version of the scenario
    relief::Scenario scenario;
    relief::Assets assets;
    std::shared_ptr<const relief::FrameRequest> request;  // request of the frame as it was drawn (reduced if `coarse`)
    bool coarse = false;                                  // drawn at lower quality or resolution during a drag
    std::shared_ptr<const relief::Frame> frame;           // has the reduced size if `coarse`
    QImage picture;                                       // the frame as shown; has the frame's size
    LayerPicture layer;                                   // layer shown instead of the picture in the result view
    std::shared_ptr<const relief::Tracer> tracer;         // the frame's tracer
    relief::Guarantee guarantee = relief::Guarantee::Approximate;  // guarantee of the method with its options
    std::size_t methodBytes = 0;                                   // memory of the method's maps
    // only for full frames that skip work within an error bound
    std::optional<relief::BoundedError> bounded;
    double ellipseOff = 0;                            // ellipseError() of a full frame
    std::shared_ptr<const PixelFootprint> footprint;  // footprint of the chosen pixel; null without a hit
    PixelTrace trace;                                 // in full-size pixels, even if `coarse`
    // ray of another program's tracer; null if no files are open
    std::shared_ptr<const PixelTrace> other;
    std::shared_ptr<const OtherFiles> otherFiles;  // that the ray is from
    // why these are not what the files contain: they could not be read again; null if they could
    std::shared_ptr<const relief::InputError> otherProblem;
    std::size_t otherRays = 0;                            // number of rays in the files
    std::shared_ptr<const relief::MaxPyramidMap> maxima;  // over the cells of the field
    // Over the texels; for large pictures only the one that is shown.
    std::shared_ptr<const relief::Pyramid> means;
    std::shared_ptr<const relief::Pyramid> minima;
    std::shared_ptr<relief::MapCache> maps;  // contains the maps built for this snapshot; further maps may be added

    bool has(relief::PyramidKind levels) const {
        return levels == relief::PyramidKind::Mean  ? means != nullptr
               : levels == relief::PyramidKind::Min ? minima != nullptr
                                                    : maxima != nullptr;
    }
};

}  // namespace reliefui
