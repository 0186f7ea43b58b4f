// A height field as Embree traces it: the surface's vertices joined by triangles or as Embree's grid, not by bilinear
// patches. Between vertices the two models differ by up to a quarter of the cell's twist; at vertices they agree.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "relief/height_field.h"
#include "relief/ray.h"
#include "relief/work.h"

namespace relief::peers {

// The texels whose centres are the mesh's vertices.
struct MeshExtent {
    int i0 = 0, j0 = 0, i1 = 0, j1 = 0;  // first and last texel, unwrapped
};

enum class EmbreeShape : std::uint8_t { Triangles, Grid };

struct EmbreeVariant {
    EmbreeShape shape = EmbreeShape::Triangles;
    int packet = 1;  // 1, 8, 16
    bool coherent = false;

    std::string method() const { return shape == EmbreeShape::Grid ? "embree-grid" : "embree-triangles"; }
    std::string text() const {
        return method() + ":packet=" + std::to_string(packet) + (coherent ? ":coherent=1" : "");
    }
};
std::vector<EmbreeVariant> embreeVariants(const std::vector<EmbreeShape>& shapes);

// As floats, what Embree is given; made once for a view, outside the timing.
struct EmbreeRays {
    std::vector<float> s, t, a, b;
    float top = 0;   // height of the start, texels
    float down = 0;  // of the direction, texels
};
EmbreeRays embreeRays(const HeightField& field, const RayBlock& rays);

// One geometry committed; immutable.
class EmbreeScene {
  public:
    // config: added to the device's settings (isa=avx2). Under border the surface reaches from edge to edge of the
    // picture; under clamp and repeat the mesh has the texels of the extent.
    EmbreeScene(const HeightField& field, EmbreeShape shape, const MeshExtent& extent, int threads,
                const std::string& config);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    EmbreeShape shape() const;
    std::size_t bytes() const;  // of everything that Embree holds, vertices included
    double buildSeconds() const;
    // Lambda of each ray's first hit, NaN where it misses; `lambda` has the size of the rays.
    void trace(const EmbreeVariant& variant, const EmbreeRays& rays, std::vector<float>& lambda, Work& work) const;

  private:
    struct Held;
    std::unique_ptr<Held> held_;
};

std::string embreeText();  // "Embree 3.13.5"

}  // namespace relief::peers
