// Wraps ITK's Euclidean distance transform (Maurer's) in an interface without ITK's headers.
#pragma once

#include <memory>
#include <string>

#include "relief/maps/distance_map.h"

namespace relief::peers {

class ItkDistance {
  public:
    // solid: 1 for solid voxels, in a volume of nx x ny x (layers + 1), x fastest, whose lowest layer is wholly solid.
    // dz: height of a layer in texels.
    ItkDistance(const unsigned char* solid, int nx, int ny, int layers, double dz, int threads);
    ~ItkDistance();
    ItkDistance(const ItkDistance&) = delete;
    ItkDistance& operator=(const ItkDistance&) = delete;

    void build();
    // Returns the distance in texels for the voxel in layer k of our map (the lowest, solid layer is -1); 0 where
    // solid.
    double at(int x, int y, int k) const;
    static std::string version();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace relief::peers
