// What the comparison of tracers with Embree measures and prints.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "embree_peer.h"
#include "measuring/bench/bench_tracers.h"
#include "peer_rays.h"

namespace relief::peers {

struct PeerOptions {
    std::vector<std::string> methods{"max-pyramid", "cone"};
    std::vector<std::string> maps{"fractal", "bricks", "spikes"};  // recipes, each NAME or NAME:SEED, or files
    std::vector<int> sizes{256, 1024, 4096};                       // of the recipes
    std::vector<Elevation> views{60.0, 25.0, 8.0, std::nullopt};
    PeerView view;
    int rounds = 5;
    int threads = 1;
    Address address = Address::Border;  // as Embree's mesh ends; else the mesh is as large as the rays reach
    double reliefDepth = 0.1;
    std::vector<EmbreeShape> shapes{EmbreeShape::Triangles, EmbreeShape::Grid};
    std::string lanes;   // the only instruction set that ours may use; empty: the best
    std::string embree;  // further settings of its device, such as isa=avx2
    std::string output;  // rows with the columns of relief bench tracers
};

// False if a method that promises the exact hit gave another, or Embree something else altogether.
bool compareTracers(const PeerOptions& options, std::ostream& out);

// One method of ours in one cell: a map, a size, a view.
struct PeerCell {
    std::string map;
    int size = 0;
    Elevation view;
    std::size_t rays = 0;
    std::string method;
    double rate = 0, spread = 0;  // rays a second
    std::string best;             // Embree's fastest variant by median
    double bestRate = 0, bestSpread = 0;
    double ratio = 0, ratioSpread = 0;  // medians over rounds
    double differs = 0;                 // share of the rays on which Embree's fastest variant is off by > 0.05 texel
    std::int64_t wrong = 0;             // rays on which the method is not bit for bit the reference
    double bytes = 0;                   // of maps and heights that the reference reads per ray, mean
};
// Cells, geometric means, growth with the size.
void printCells(const std::vector<PeerCell>& cells, std::ostream& out);

}  // namespace relief::peers
