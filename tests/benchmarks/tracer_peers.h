// Measures and prints the comparison of our tracers with Embree.
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
    std::vector<int> sizes{256, 1024, 4096};                       // of the procedural reliefs
    std::vector<Elevation> views{60.0, 25.0, 8.0, std::nullopt};
    PeerView view;
    int rounds = 5;
    int threads = 1;
    // border: the surface ends like Embree's mesh; otherwise the mesh extends as far as the rays
    Address address = Address::Border;
    double reliefDepth = 0.1;
    std::vector<EmbreeShape> shapes{EmbreeShape::Triangles, EmbreeShape::Grid};
    std::string lanes;   // the only instruction set that our code may use; empty: the best
    std::string embree;  // additional device settings, such as isa=avx2
    std::string output;  // rows with the columns of relief bench tracers
};

// Returns false if one of our exact methods gave another hit, or if Embree's results are entirely different.
bool compareTracers(const PeerOptions& options, std::ostream& out);

// One of our methods in one cell: a map, a size, a view.
struct PeerCell {
    std::string map;
    int size = 0;
    Elevation view;
    std::size_t rays = 0;
    std::string method;
    double rate = 0, spread = 0;  // rays per second
    std::string best;             // Embree's fastest variant, by median
    double bestRate = 0, bestSpread = 0;
    double ratio = 0, ratioSpread = 0;  // medians over rounds
    double differs = 0;      // share of the rays on which Embree's fastest variant differs by more than 0.05 texels
    std::int64_t wrong = 0;  // rays whose hit is not the reference's, bit for bit
    double bytes = 0;        // bytes of maps and heights that the reference fetches per ray, mean
};
// Prints the cells, geometric means, and the growth with the size.
void printCells(const std::vector<PeerCell>& cells, std::ostream& out);

}  // namespace relief::peers
