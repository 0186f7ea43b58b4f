#include "measuring/diagnose/tracer_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "images/pyramid.h"
#include "measuring/diagnose/layer_bracket.h"
#include "relief/files.h"
#include "relief/tracers.h"

namespace relief {

namespace {

// Lifts up to this height, heights, are a bias against self-shadowing; larger ones are another zero level.
constexpr double kLargestBias = 0.03;
// Numbers closer than this are equal.
constexpr double kSameNumber = 1e-3;

bool near(double a, double b) {
    return std::abs(a - b) <= kSameNumber;
}

// Appends the faults of gain and lift: heights gain * h + lift.
void heightFaults(const TracerModel& model, std::vector<ModelFault>& faults) {
    double gain = model.gain;
    double lift = model.lift;
    if (gain < 0) {
        faults.push_back({Fault::InvertedHeights});
        // gain * h + lift = -gain * (1 - h) + (lift + gain).
        lift += gain;
        gain = -gain;
    }
    if (!near(gain, 1)) {
        faults.push_back({Fault::ReliefDepth, gain});
        // Scaled from the plane on top, from the bottom or from the middle; another remainder is a zero level.
        for (const double pivot : {1.0, 0.0, 0.5}) {
            if (near(lift, (1 - gain) * pivot)) return;
        }
        lift -= 1 - gain;
    }
    if (near(lift, 0)) return;
    const bool bias = lift > 0 && lift <= kLargestBias;
    faults.push_back({bias ? Fault::SelfShadowBias : Fault::ZeroLevel, lift});
}

}  // namespace

std::vector<ModelFault> modelFaults(const TracerModel& model, Address address) {
    std::vector<ModelFault> faults;
    const bool sign = model.signA < 0 || model.signB < 0;
    const bool halfTurn = near(std::abs(model.turn), std::numbers::pi);
    if (model.swapped || model.transposed) faults.push_back({Fault::SwappedAxes});
    if (sign || halfTurn) faults.push_back({Fault::DirectionSign});
    if (model.turn != 0 && !halfTurn) faults.push_back({Fault::TangentFrame, model.turn * 180 / std::numbers::pi});
    if (model.limited) faults.push_back({Fault::OffsetLimiting});
    if (!near(model.runScale, 1)) faults.push_back({Fault::ReliefDepth, model.runScale});
    if (model.shiftS != 0 || model.shiftT != 0) faults.push_back({Fault::HalfTexelShift});
    if (model.flipped) faults.push_back({Fault::YFlipped});
    if (model.mip > 0) faults.push_back({Fault::MipLevel, static_cast<double>(model.mip)});
    if (model.bits != 0) faults.push_back({Fault::Terraces});
    if (model.curve != 0) faults.push_back({Fault::HeightCurve});
    heightFaults(model, faults);
    if (model.address && *model.address != address) faults.push_back({Fault::WrapAgainstClamp});
    if (model.bias != 0) faults.push_back({Fault::SelfShadowBias, model.bias});
    if (model.biasTexels != 0) faults.push_back({Fault::SelfShadowBias, model.biasTexels});
    if (model.search == ModelSearch::OneSample) faults.push_back({Fault::NoSearch});
    return faults;
}

TracerModel withoutFault(TracerModel model, Fault fault) {
    switch (fault) {
        case Fault::SwappedAxes:
            model.swapped = model.transposed = false;
            break;
        case Fault::DirectionSign:
            model.signA = model.signB = 1;
            if (near(std::abs(model.turn), std::numbers::pi)) model.turn = 0;
            break;
        case Fault::TangentFrame:
            model.turn = 0;
            break;
        case Fault::OffsetLimiting:
            model.limited = false;
            break;
        case Fault::ReliefDepth:
            model.runScale = 1;
            model.lift += model.gain < 0 ? -1 - model.gain : model.gain - 1;
            model.gain = model.gain < 0 ? -1 : 1;
            break;
        case Fault::HalfTexelShift:
            model.shiftS = model.shiftT = 0;
            break;
        case Fault::YFlipped:
            model.flipped = false;
            break;
        case Fault::MipLevel:
            model.mip = 0;
            break;
        case Fault::Terraces:
            model.bits = 0;
            break;
        case Fault::HeightCurve:
            model.curve = 0;
            break;
        case Fault::InvertedHeights:
            model.lift += model.gain;
            model.gain = -model.gain;
            break;
        case Fault::ZeroLevel:
            model.lift = model.gain < 0 ? -model.gain : 1 - model.gain;
            break;
        case Fault::SelfShadowBias:
            model.bias = model.biasTexels = 0;
            model.lift = model.gain < 0 ? -model.gain : 1 - model.gain;
            break;
        case Fault::WrapAgainstClamp:
            model.address.reset();
            break;
        case Fault::NoSearch:
            model.search = ModelSearch::Exact;
            break;
        default:
            break;
    }
    return model;
}

std::shared_ptr<const FloatImage> ModelFields::level(int mip) {
    if (levels_.empty()) {
        const Pyramid means(PyramidKind::Mean, field_.sharedHeights(), work_);
        for (int l = 0; l < means.levels(); ++l) levels_.push_back(std::make_shared<const FloatImage>(means.level(l)));
    }
    return levels_[static_cast<std::size_t>(std::min<int>(mip, static_cast<int>(levels_.size()) - 1))];
}

const ModelFields::Placed& ModelFields::of(const TracerModel& model) {
    const Address address = model.address.value_or(field_.address());
    const Key key{model.mip, model.bits, model.curve, model.gain, model.lift, address};
    const auto found = fields_.find(key);
    if (found != fields_.end()) return found->second;
    std::shared_ptr<const FloatImage> heights = model.mip > 0 ? level(model.mip) : field_.sharedHeights();
    if (model.bits != 0 || model.curve != 0 || model.gain != 1 || model.lift != 0) {
        auto changed = std::make_shared<FloatImage>(*heights);
        for (float& height : changed->pixels()) {
            if (model.bits != 0) {
                const float codes = height * 255.0F;
                height = (model.bits > 0 ? std::round(codes) : std::floor(codes)) / 255.0F;
            }
            if (model.curve != 0) height = model.curve > 0 ? linearFromSrgb(height) : srgbFromLinear(height);
            const double read = model.gain * static_cast<double>(height) + model.lift;
            if (model.gain != 1 || model.lift != 0) height = static_cast<float>(std::clamp(read, 0.0, 1.0));
        }
        heights = changed;
    }
    // Fits try many gains and lifts: only the latest are kept.
    constexpr std::size_t kMost = 24;
    if (fields_.size() >= kMost) fields_.clear();
    const double scaleS = static_cast<double>(heights->width()) / field_.width();
    const double scaleT = static_cast<double>(heights->height()) / field_.height();
    const HeightField field(heights, field_.surface(), address, field_.reliefDepth());
    return fields_.emplace(key, Placed{field, scaleS, scaleT}).first->second;
}

double limitedShare(const ViewRay& ray, const HeightField& given, bool square) {
    const double slab = given.slabTexels();
    const double b = square ? ray.b * given.width() / given.height() : ray.b;
    return slab / std::hypot(ray.a, b, slab);
}

double layersOf(const TracerModel& model, const ViewRay& ray, const HeightField& given) {
    if (model.grazingLayers == 0) return model.layers;
    return std::lerp(model.grazingLayers, model.layers, limitedShare(ray, given, model.squareCosine));
}

bool hasLayers(const TracerModel& model) {
    return model.search == ModelSearch::Layers || model.search == ModelSearch::Middle ||
           model.search == ModelSearch::Secant;
}

ViewRay modelRay(const TracerModel& model, const ModelFields::Placed& placed, const ViewRay& ray,
                 const HeightField& given) {
    ViewRay out = ray;
    if (model.swapped) std::swap(out.a, out.b);
    out.a *= model.signA;
    out.b *= model.signB;
    if (model.turn != 0) {
        const double c = std::cos(model.turn), s = std::sin(model.turn);
        const double a = out.a;
        out.a = c * a - s * out.b;
        out.b = s * a + c * out.b;
    }
    double scale = model.runScale;
    if (model.limited) scale *= limitedShare(ray, given, model.squareCosine);
    out.a *= scale;
    out.b *= scale;
    out.s0 += model.shiftS;
    out.t0 += model.shiftT;
    if (model.transposed) out = {out.t0, out.s0, out.b, out.a};
    if (model.flipped) {
        out.t0 = given.height() - out.t0;
        out.b = -out.b;
    }
    return {out.s0 * placed.scaleS, out.t0 * placed.scaleT, out.a * placed.scaleS, out.b * placed.scaleT};
}

double lambdaBias(const TracerModel& model, const ViewRay& ray, const HeightField& given) {
    if (model.biasTexels == 0) return model.bias;
    return model.bias + model.biasTexels / std::hypot(ray.a, ray.b, given.slabTexels());
}

double oneSampleShare(const TracerModel& model, const ViewRay& ray, const HeightField& given) {
    return model.search == ModelSearch::OneSample && model.limited ? limitedShare(ray, given, model.squareCosine) : 1;
}

namespace {

// Returns the hit of a model with layers. ray: the model's, in the field's texels.
Hit layerHit(const TracerModel& model, const HeightField& field, const ViewRay& ray, double layers) {
    const SampledSurface surface(field, ray);
    std::optional<LayerBracket> bracket = firstLayer(surface, layers);
    if (!bracket) return Hit::none(Outcome::Miss);
    double lambda = 0;
    if (model.search == ModelSearch::Secant) {
        lambda = bracket->secant();
    } else {
        for (int n = 0; n < model.halvings; ++n) bracket->halve(surface);
        lambda = model.search == ModelSearch::Middle ? bracket->middle() : bracket->below;
    }
    return {Outcome::Hit, std::min(lambda, 1.0)};
}

}  // namespace

std::vector<Hit> predict(const TracerModel& model, const RayBlock& rays, ModelFields& fields, Work& work) {
    const ModelFields::Placed& placed = fields.of(model);
    RayBlock traced(rays.size());
    for (std::size_t r = 0; r < rays.size(); ++r) traced.set(r, modelRay(model, placed, rays[r], fields.given()));
    std::vector<Hit> out(rays.size());
    if (hasLayers(model)) {
        parallelFor(work, rays.size(), [&](std::size_t r) {
            out[r] = layerHit(model, placed.field, traced[r], layersOf(model, rays[r], fields.given()));
        });
    } else {
        const MethodChoice method{model.search == ModelSearch::OneSample ? "offset" : "exact", {}};
        MapCache maps;
        NullSink sink;
        HitBlock hits;
        makeTracer(method, placed.field, maps, work)->trace(traced, hits, sink, work);
        for (std::size_t r = 0; r < rays.size(); ++r) out[r] = hits[r];
    }
    for (std::size_t r = 0; r < rays.size(); ++r) {
        // An answer by one sample is shortened, not its direction: both arrive at the same place, and what is reported
        // is the lambda of the given ray.
        const double share = oneSampleShare(model, rays[r], fields.given());
        out[r].lambda = std::max(0.0, out[r].lambda * share - lambdaBias(model, rays[r], fields.given()));
    }
    return out;
}

}  // namespace relief
