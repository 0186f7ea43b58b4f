// Compares our tracers with Embree in one process, with interleaved rounds, on the same rays: 800 x 600 perspective
// views of the floor in the order of a frame's tiles, and random rays; relief depth 0.1.
//  relief_peers [--methods NAME,...] [--maps NAME[:SEED]|FILE,...] [--sizes N,...] [--views DEGREES|random,...]
//               [--rays N] [--rounds N] [--threads N] [--address border|clamp|repeat] [--depth D] [--distance D]
//               [--azimuth A] [--fov A] [--lowest A] [--seed S] [--lanes AVX3|AVX2|SSE4|...] [--embree CONFIG]
//               [--shapes triangles,grid] [-o FILE.csv|json]
// A ratio is our rate divided by that of the fastest of Embree's variants (triangles, grid; packets of 1, 8, 16; with
// and without the hint that rays are coherent) in the same round; the median of the rounds. Exit status 1 if one of our
// methods with the exact guarantee gave another hit.
#include <algorithm>
#include <iostream>

#include "mapping/rows/row_lanes.h"
#include "peer_table.h"
#include "tracer_peers.h"

namespace relief::peers {
namespace {

[[noreturn]] void unknown(const std::string& what, const std::string& name) {
    throw InputError(name, Message(MessageId::UnknownName,
                                   {{"what", what}, {"name", name}, {"known", "see the head of tracer_peers.cpp"}}));
}

PeerOptions parse(int argc, char** argv) {
    PeerOptions options;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (i + 1 >= argc) unknown("option", word);
        const std::string value = argv[++i];
        const auto number = [&] { return parseNumber(value, word); };
        if (word == "--methods") {
            options.methods = partsOf(value);
        } else if (word == "--maps") {
            options.maps = partsOf(value);
        } else if (word == "--sizes") {
            options.sizes.clear();
            for (const std::string& size : partsOf(value)) {
                options.sizes.push_back(static_cast<int>(parseNumber(size, word)));
            }
        } else if (word == "--views") {
            options.views.clear();
            for (const std::string& view : partsOf(value)) options.views.push_back(parseElevation(view, word));
        } else if (word == "--rays") {
            options.view.rays = static_cast<std::size_t>(number());
        } else if (word == "--rounds") {
            options.rounds = static_cast<int>(number());
        } else if (word == "--threads") {
            options.threads = static_cast<int>(number());
        } else if (word == "--address") {
            options.address = parseAddress(value);
        } else if (word == "--depth") {
            options.reliefDepth = number();
        } else if (word == "--distance") {
            options.view.distance = number();
        } else if (word == "--azimuth") {
            options.view.azimuth = number();
        } else if (word == "--fov") {
            options.view.fov = number();
        } else if (word == "--lowest") {
            options.view.lowest = number();
        } else if (word == "--seed") {
            options.view.seed = static_cast<std::uint64_t>(number());
        } else if (word == "--lanes") {
            const auto targets = laneTargets();
            const auto target = std::find_if(targets.begin(), targets.end(),
                                             [&](std::int64_t each) { return value == laneTargetName(each); });
            if (target == targets.end()) unknown("instruction set of this machine", value);
            forceLaneTarget(*target);
            options.lanes = value;
        } else if (word == "--embree") {
            options.embree = value;
        } else if (word == "--shapes") {
            options.shapes.clear();
            for (const std::string& shape : partsOf(value)) {
                if (shape != "triangles" && shape != "grid") unknown("shape", shape);
                options.shapes.push_back(shape == "grid" ? EmbreeShape::Grid : EmbreeShape::Triangles);
            }
        } else if (word == "-o") {
            options.output = value;
        } else {
            unknown("option", word);
        }
    }
    return options;
}

}  // namespace
}  // namespace relief::peers

int main(int argc, char** argv) {
    try {
        return relief::peers::compareTracers(relief::peers::parse(argc, argv), std::cout) ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
