// Every filter behind one face, made ready for one picture (and, where it asks what is hidden, one height field).
#pragma once

#include <memory>

#include "filtering/elliptical_visible.h"
#include "filtering/filter_choice.h"
#include "filtering/footprint_log.h"

namespace relief {

// What a pixel asks: where its ray met the relief, and how the plane there is projected.
struct FilterQuery {
    glm::dvec2 place{0};  // texels of the height map, unwrapped: where colours are looked up
    Jacobian jacobian;    // texels of the height map a pixel
    ViewRay ray;
    double lambda = 0;
};

// Immutable, shared by threads.
class TextureFilter {
  public:
    virtual ~TextureFilter() = default;
    TextureFilter() = default;
    TextureFilter(const TextureFilter&) = delete;
    TextureFilter& operator=(const TextureFilter&) = delete;

    virtual const FilterDescription& description() const = 0;
    // log: may be null. Throws Cancelled.
    virtual Color color(const FilterQuery& query, FootprintCounts& counts, Work& work,
                        FootprintLog* log = nullptr) const = 0;
    // Beyond the picture itself.
    virtual std::size_t bytes() const = 0;
};

// What filters are made of.
struct FilterTools {
    std::shared_ptr<const ColorImage> picture;  // not null
    std::shared_ptr<const ColorLevels> levels;  // of the picture; null: built here, if the filter needs it
    HeightField field;
    bool skip = true;  // tests that cannot matter are skipped
};

// `supersample` reads each of its samples bilinearly. Throws InputError (names, options), Cancelled.
std::unique_ptr<const TextureFilter> makeFilter(const FilterChoice& choice, const FilterTools& tools, MapCache& maps,
                                                Work& work);
// Whether the filter reads the mean pyramid.
bool needsLevels(const FilterChoice& choice);

}  // namespace relief
