#include "relief/maps/baked_normals.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "relief/addressing.h"
#include "relief/maps/map_memory.h"
#include "relief/messages.h"

namespace relief {

namespace {

constexpr float kUnit = 127.0F;

glm::i8vec3 bakedTexel(const HeightField& field, int i, int j) {
    const float slab = static_cast<float>(field.slabTexels());
    const float perS = 0.5F * (field.texel(i + 1, j) - field.texel(i - 1, j));
    const float perT = 0.5F * (field.texel(i, j + 1) - field.texel(i, j - 1));
    return {glm::round(kUnit * glm::normalize(glm::vec3(-slab * perS, slab * perT, 1)))};
}

BakedNormals bake(const HeightField& field, Work& work) {
    BakedNormals baked{Image<glm::i8vec3>(field.width(), field.height())};
    parallelFor(work, field.height(), [&](int j) {
        for (int i = 0; i < field.width(); ++i) baked.texels(i, j) = bakedTexel(field, i, j);
    });
    return baked;
}

}  // namespace

glm::vec3 BakedNormals::at(double s, double t, Address address) const {
    const BilinearSupport x = bilinearSupport(s, texels.width(), address);
    const BilinearSupport y = bilinearSupport(t, texels.height(), address);
    const auto texel = [&](int i, int j) { return glm::vec3(texels(i, j)) / kUnit; };
    const glm::vec3 top = (1 - x.share) * texel(x.first, y.first) + x.share * texel(x.second, y.first);
    const glm::vec3 bottom = (1 - x.share) * texel(x.first, y.second) + x.share * texel(x.second, y.second);
    return (1 - y.share) * top + y.share * bottom;
}

std::shared_ptr<const BakedNormals> bakedNormals(const HeightField& field, MapCache& cache, Work& work) {
    const std::string kind = "normals/" + std::string(field.address() == Address::Repeat ? "repeat" : "clamped") + "/" +
                             numberText(field.reliefDepth());
    const std::uint64_t need = bytesForTexels(field, sizeof(glm::i8vec3));
    return cache.get<BakedNormals>({kind, field.sharedHeights()}, need, work, [&](Work& w) { return bake(field, w); });
}

}  // namespace relief
