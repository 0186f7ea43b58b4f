// ITK's Euclidean distance transform (Maurer's), behind a face that needs none of its headers.
#pragma once

#include <memory>
#include <string>

#include "relief/maps/distance_map.h"

namespace relief::peers {

class ItkDistance {
  public:
    // Solid voxels are 1 in a volume of nx x ny x (layers + 1), x fastest, its lowest layer wholly solid; a layer is
    // dz texels high.
    ItkDistance(const unsigned char* solid, int nx, int ny, int layers, double dz, int threads);
    ~ItkDistance();
    ItkDistance(const ItkDistance&) = delete;
    ItkDistance& operator=(const ItkDistance&) = delete;

    void build();
    // Texels, of the voxel in layer k of ours (the lowest, solid layer is -1); 0 where solid.
    double at(int x, int y, int k) const;
    static std::string version();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace relief::peers
