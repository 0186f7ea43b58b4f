// A model of somebody's tracer: what it does differently from `exact`. diagnose() compares the tracer's answers with
// those that a model predicts.
//
// Frame and units: ray.h.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "measuring/diagnose/fault.h"
#include "relief/height_field.h"
#include "relief/ray.h"
#include "relief/work.h"

namespace relief {

// How the model finds the surface along its ray. Exact: the first hit. Layers: the first of `layers` equal layers at or
// below the surface; after `halvings` of the last layer, the lower end of what is left. Middle: its middle, which may
// be above the surface. Secant: the line between that layer and the one before. OneSample: the height at the entry.
enum class ModelSearch : std::uint8_t { Exact, Layers, Middle, Secant, OneSample };

struct TracerModel {
    // The direction: axes swapped, then multiplied by the signs, then turned by `turn` radians, then scaled by
    // runScale; limited: and by limitedShare(), as if the direction were not divided by its height.
    bool swapped = false;
    double signA = 1;
    double signB = 1;
    double turn = 0;
    double runScale = 1;
    bool limited = false;
    // Where heights are read: shifted (texels), transposed, from the bottom row up.
    double shiftS = 0;
    double shiftT = 0;
    bool transposed = false;
    bool flipped = false;
    // The heights: of this level of the mean pyramid; rounded (8) or cut off (-8) to 8 bits; decoded as sRGB values (1)
    // or encoded (-1); then gain * h + lift, clamped to [0, 1].
    int mip = 0;
    int bits = 0;
    int curve = 0;
    double gain = 1;
    double lift = 0;
    std::optional<Address> address;
    // Answers are this far in front of the hit: lambda; and texels along the ray, in the metric (s, t, slab z).
    double bias = 0;
    double biasTexels = 0;
    ModelSearch search = ModelSearch::Exact;
    int layers = 0;
    int halvings = 0;
    // If it is not 0, the number of layers depends on the view, as in public shaders: `layers` for rays along the
    // normal, this for rays along the plane, linearly in the cosine in between; seldom an integer.
    int grazingLayers = 0;
    // The cosine of the view is that of a texture that is taken as square.
    bool squareCosine = false;

    bool operator==(const TracerModel&) const = default;
};

// The faults of a model, each with the number that describes it: layers, degrees, factor, heights, level; 0 if there is
// none.
struct ModelFault {
    Fault fault;
    double value = 0;
};
std::vector<ModelFault> modelFaults(const TracerModel& model, Address address);
// Returns the model without one of its faults.
TracerModel withoutFault(TracerModel model, Fault fault);

// Makes the height fields that models read, and keeps them. Not thread-safe.
class ModelFields {
  public:
    ModelFields(HeightField field, Work& work) : field_(std::move(field)), work_(work) {}

    const HeightField& given() const { return field_; }
    // The field, whose coordinates are those of the map at the model's level; scaleS, scaleT: its texels per texel of
    // the given map.
    struct Placed {
        HeightField field;
        double scaleS = 1;
        double scaleT = 1;
    };
    const Placed& of(const TracerModel& model);

  private:
    using Key = std::tuple<int, int, int, double, double, Address>;
    std::shared_ptr<const FloatImage> level(int mip);

    HeightField field_;
    Work& work_;
    std::vector<std::shared_ptr<const FloatImage>> levels_;
    std::map<Key, Placed> fields_;
};

// Returns the ray that the model follows, in the texels of its field.
ViewRay modelRay(const TracerModel& model, const ModelFields::Placed& placed, const ViewRay& ray,
                 const HeightField& given);

// Returns how far the model's answer on the ray lies in front of its hit, lambda.
double lambdaBias(const TracerModel& model, const ViewRay& ray, const HeightField& given);

// Returns the factor by which offset limiting shortens the ray's run, the cosine of the view: slab / |(a, b, slab)|.
// square: as if the texture was as high as it is wide.
double limitedShare(const ViewRay& ray, const HeightField& given, bool square = false);
// Returns the number of layers of a model that has some.
double layersOf(const TracerModel& model, const ViewRay& ray, const HeightField& given);
// Returns true if the model searches layers.
bool hasLayers(const TracerModel& model);
// Returns the factor by which offset limiting shortens the model's answer from one sample; 1 for models that search.
double oneSampleShare(const TracerModel& model, const ViewRay& ray, const HeightField& given);

// Returns the model's answers. s and t are left out: lambda alone is compared.
std::vector<Hit> predict(const TracerModel& model, const RayBlock& rays, ModelFields& fields, Work& work);

}  // namespace relief
