// A height field as Embree traces it: the surface's vertices connected by triangles or as Embree's grid, in place of
// bilinear patches. Between vertices the two models differ by up to a quarter of the cell's twist; at vertices they
// agree.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "relief/height_field.h"
#include "relief/ray.h"
#include "relief/work.h"

namespace relief::peers {

// The range of texels whose centres are the mesh's vertices.
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

// Rays in float, as Embree takes them; converted once per view, outside the timing.
struct EmbreeRays {
    std::vector<float> s, t, a, b;
    float top = 0;   // start height in texels
    float down = 0;  // vertical component of the direction, in texels
};
EmbreeRays embreeRays(const HeightField& field, const RayBlock& rays);

// A committed geometry; immutable.
class EmbreeScene {
  public:
    // config: additional device settings (isa=avx2). Under border the surface extends from edge to edge of the picture;
    // under clamp and repeat the mesh contains the texels of the extent.
    EmbreeScene(const HeightField& field, EmbreeShape shape, const MeshExtent& extent, int threads,
                const std::string& config);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    EmbreeShape shape() const;
    std::size_t bytes() const;  // everything that Embree allocates, including vertices
    double buildSeconds() const;
    // Writes lambda of each ray's first hit, NaN for a miss; `lambda` must have the size of the rays.
    void trace(const EmbreeVariant& variant, const EmbreeRays& rays, std::vector<float>& lambda, Work& work) const;

  private:
    struct Held;
    std::unique_ptr<Held> held_;
};

std::string embreeText();  // "Embree 3.13.5"

}  // namespace relief::peers
