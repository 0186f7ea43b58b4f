// Files of another program's tracer: the rays of a scenario's view, and its hits.
#pragma once

#include <fstream>

#include <QTemporaryDir>

#include "rendering/view_rays.h"
#include "scenario/ray_files.h"
#include "scenario/rays_view.h"

namespace reliefui {

// Writes the rays with their view, and the hits of an exact tracer; flipped: of one that reads the map upside down.
// Returns the scenario with these files.
inline relief::Scenario withForeignTracer(relief::Scenario scenario, const QTemporaryDir& folder, bool flipped) {
    relief::Work work;
    relief::AssetStore store;
    const relief::FrameRequest request = relief::frameRequest(scenario, store.load(scenario.pictures, work));
    const relief::ViewRays view = relief::viewRays(request);
    const relief::HeightField& field = request.field;
    relief::FloatImage heights = field.heights();
    for (int y = 0; flipped && y < heights.height(); ++y) {
        std::ranges::copy(field.heights().row(heights.height() - 1 - y), heights.row(y).begin());
    }
    const relief::HeightField read(std::make_shared<const relief::FloatImage>(std::move(heights)), field.surface(),
                                   field.address(), field.reliefDepth());
    relief::HitBlock hits;
    relief::NullSink sink;
    relief::MapCache maps;
    relief::makeTracer({"exact", {}}, read, maps, work)->trace(view.rays, hits, sink, work);
    const auto write = [&](const char* name, const std::string& text) {
        const std::string path = folder.filePath(QString::fromLatin1(name)).toStdString();
        std::ofstream(path, std::ios::binary) << text;
        return path;
    };
    scenario.other.rays =
        write("rays.csv", std::string(relief::kRaysHeader) + "\n" + relief::rayLines(view.rays, work));
    scenario.other.steps = write("hits.csv", std::string(relief::kHitsHeader) + "\n" + relief::hitLines(hits, work));
    write("rays.json", relief::raysViewText(scenario, request, view, scenario.other.rays));
    return scenario;
}

}  // namespace reliefui
