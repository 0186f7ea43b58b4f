#include "measuring/verify/certificate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "measuring/verify/certificate_rays.h"
#include "measuring/verify/engine_bounds.h"
#include "relief/tracers/map_choice.h"

namespace relief {

namespace {

// Number of rays traced through each value that breaks its bound.
constexpr std::size_t kWitnesses = 4096;

// Returns the storable map that the method, or its inner method, traverses, as that tracer gets it. Maps in other
// layouts are tested with rays only.
std::optional<StoredMap> mapOf(const MethodChoice& choice, const HeightField& field, MapCache& cache, Work& work) {
    auto used = usedMap(choice);
    if (!used) return std::nullopt;
    const auto layout = used->options.find(std::string(kLayoutOption));
    if (layout != used->options.end() && layout->second != kStoredLayout) return std::nullopt;
    // A tracer that is given another map than its own has options which that map's own tracer does not have.
    const OptionValues& known = findTracer(methodOfMap(used->kind)).defaults;
    std::erase_if(used->options, [&](const auto& option) { return !known.contains(option.first); });
    return buildMap(used->kind, used->options, field, cache, work);
}

class Certifier {
  public:
    Certifier(const MethodChoice& choice, const HeightField& field, const CertificateOptions& options, MapCache& cache,
              Work& work)
        : field_(field),
          options_(options),
          work_(work),
          exact_(makeTracer({"exact", {}}, field, cache, work)),
          tracer_(makeTracer(choice, field, cache, work)),
          map_(mapOf(choice, field, cache, work)),
          rays_(field, longest()) {
        result_.method = choice.name;
        result_.seed = options.seed;
        result_.longest = rays_.longest();
        if (map_) result_.map = mapKindName(*map_);
        const Guarantee promise = tracer_->guarantee();
        result_.allowed = promise == Guarantee::Exact          ? 0
                          : promise == Guarantee::Conservative ? kRoundingTexels
                                                               : kCoarseTexels;
    }

    Certificate run() {
        if (const DistanceMap* map = distances(); map != nullptr && ofBoxes(map->kind)) {
            result_.bounds = checkDistanceBounds(*map, field_, work_);
        }
        if (const ConeMap* map = cones(); map != nullptr && map->kind == ConeKind::Conservative) {
            result_.bounds = checkConeBounds(*map, field_, work_);
        }
        if (const ConeMap* map = cones(); map != nullptr && map->kind == ConeKind::Robust) proveSurfaceCones(*map);
        overRays();
        if (result_.bounds && result_.bounds->broken > 0 && !result_.first) witness();
        return std::move(result_);
    }

  private:
    const DistanceMap* distances() const {
        const auto* map = map_ ? std::get_if<0>(&*map_) : nullptr;
        return map == nullptr ? nullptr : map->get();
    }
    const ConeMap* cones() const {
        const auto* map = map_ ? std::get_if<1>(&*map_) : nullptr;
        return map == nullptr ? nullptr : map->get();
    }
    double longest() const {
        const DistanceMap* map = distances();
        if (map != nullptr && std::isfinite(map->maxRun)) return map->maxRun * (1 - 1e-12);
        return field_.slabTexels() / std::tan(kFlattestCertified * std::numbers::pi / 180);
    }
    double lengthOf(const ViewRay& ray) const { return std::hypot(ray.a, ray.b, field_.slabTexels()); }

    HitBlock traced(const Tracer& tracer, const RayBlock& rays) const {
        HitBlock hits;
        NullSink sink;
        tracer.trace(rays, hits, sink, work_);
        return hits;
    }

    // Interpolated cones that stand on the surface. They are proven, or nothing is said of their values: a cell
    // without proof is no violation.
    void proveSurfaceCones(const ConeMap& map) {
        ConeCoding coding;
        coding.unit = ConeUnit::Slope;
        coding.length = ConeLength::Width;
        coding.scale = field_.width();
        FloatImage slopes(map.nx(), map.ny());
        for (int y = 0; y < map.ny(); ++y) {
            for (int x = 0; x < map.nx(); ++x) slopes(x, y) = map.slopes(x, y, 0);
        }
        const EngineBoundCheck check = checkEngineCones(field_, slopes, coding, work_);
        if (check.open > 0) return;
        result_.bounds.emplace();
        result_.bounds->values = check.cells;
    }

    void overRays() {
        work_.progress().begin("comparing rays with exact", static_cast<std::int64_t>(options_.rays));
        for (std::uint64_t done = 0; done < options_.rays; done += kCertificateBlock) {
            work_.throwIfStopped();
            const auto count = static_cast<std::size_t>(std::min(kCertificateBlock, options_.rays - done));
            const RayBlock rays = rays_.block(seedFor(options_.seed, done), count);
            const HitBlock truth = traced(*exact_, rays);
            const HitBlock found = traced(*tracer_, rays);
            for (std::size_t r = 0; r < count; ++r) {
                const double texels = texelsPast(field_, rays[r], truth[r], found[r]);
                if (!(texels > result_.allowed)) continue;
                ++result_.overshoots;
                result_.worst = std::max(result_.worst, texels);
                if (!result_.first) result_.first = example(rays[r], truth[r], found[r]);
            }
            result_.rays += count;
            work_.progress().advance(static_cast<std::int64_t>(count));
        }
    }

    CounterExample example(const ViewRay& ray, const Hit& truth, const Hit& found) const {
        return counterExample(field_, ray, truth, found, stepPast(ray, truth.lambda));
    }

    // Describes the step that went past the first hit.
    std::string stepPast(const ViewRay& ray, double truth) const {
        RayBlock rays(1);
        rays.set(0, ray);
        HitBlock hits;
        StepLog log;
        tracer_->trace(rays, hits, log, work_);
        for (std::size_t n = 0; n < log.steps.size(); ++n) {
            const Step& step = log.steps[n];
            if (!(step.lambdaAfter > truth) && step.decision != Decision::Miss) continue;
            constexpr int kDigits = 6;
            std::string place = std::to_string(step.i) + ", " + std::to_string(step.j);
            if (distances() != nullptr) place += ", " + std::to_string(step.k);
            return std::string(distances() != nullptr ? "voxel" : "texel") + " (" + place + "), value " +
                   numberText(step.value, kDigits) + ": step " + std::to_string(n + 1) + " goes from lambda " +
                   numberText(step.lambdaIn, kDigits) + " to " + numberText(step.lambdaAfter, kDigits);
        }
        return "no single step";
    }

    // Rays through points of the broken value's cell or voxel towards the cell that sets its bound. from: lambda of
    // that point; to: lambda up to which the value alone lets the ray advance.
    struct Tried {
        RayBlock rays;
        std::vector<double> from;
        std::vector<double> to;
    };
    Tried raysThrough(const BrokenBound& broken) const;
    double allowedBy(const BrokenBound& broken, const ViewRay& ray, double from) const;
    void witness();

    HeightField field_;
    CertificateOptions options_;
    Work& work_;
    std::unique_ptr<Tracer> exact_;
    std::unique_ptr<Tracer> tracer_;
    std::optional<StoredMap> map_;
    CertificateRays rays_;
    Certificate result_;
};

// Returns a point of [low, high): half of them next to an end, the others uniform.
double inside(Random& random, double low, double high) {
    const int which = random.below(4);
    const double share = which == 0 ? 1e-9 : which == 1 ? 1 - 1e-9 : random.unit();
    return low + share * (high - low);
}

// Returns the extent of the cells [first, last) of an axis, texels; the outermost cells extend one texel beyond the
// picture.
std::pair<double, double> texelsOf(const GridAxis& axis, int first, int last) {
    return {first - axis.shift, last - axis.shift};
}

double Certifier::allowedBy(const BrokenBound& broken, const ViewRay& ray, double from) const {
    if (distances() != nullptr) {
        return from + static_cast<double>(distances()->at(broken.i, broken.j, broken.k, broken.sector)) / lengthOf(ray);
    }
    const auto apex = static_cast<double>(cones()->apex(broken.i, broken.j, 0));
    const auto kappa = static_cast<double>(cones()->slopes(broken.i, broken.j, broken.sector));
    return from + (1 - from - apex) / (1 + kappa * std::hypot(ray.a, ray.b));
}

Certifier::Tried Certifier::raysThrough(const BrokenBound& broken) const {
    const CellGrid grid(field_);
    const DistanceMap* map = distances();
    const int f = map == nullptr ? 1 : map->parameters.footprint;
    const auto [s0, s1] = texelsOf(grid.x, broken.i * f, std::min((broken.i + 1) * f, grid.x.cells));
    const auto [t0, t1] = texelsOf(grid.y, broken.j * f, std::min((broken.j + 1) * f, grid.y.cells));
    double z0 = 0;
    double z1 = 1;
    if (map != nullptr) {
        z0 = static_cast<double>(broken.k) / map->layers();
        z1 = static_cast<double>(broken.k + 1) / map->layers();
    } else {
        const auto apex = static_cast<double>(cones()->apex(broken.i, broken.j, 0));
        if (apex > 0 && apex < 1) z0 = apex;
    }
    const auto [u0, u1] = texelsOf(grid.x, broken.cellX, broken.cellX + 1);
    const auto [v0, v1] = texelsOf(grid.y, broken.cellY, broken.cellY + 1);
    const int sectors = map != nullptr ? map->parameters.sectors : cones()->parameters.sectors;
    Random random(seedFor(options_.seed, ~std::uint64_t{0}));
    Tried tried;
    for (std::size_t n = 0; n < kWitnesses; ++n) {
        const double s = inside(random, s0, s1);
        const double t = inside(random, t0, t1);
        const double z = inside(random, z0, z1);
        const double x = inside(random, u0, u1) - s;
        const double y = inside(random, v0, v1) - t;
        if (azimuthSector(x, y, sectors) != broken.sector) continue;
        const double drop = z - field_.at(s + x, t + y);
        const double away = std::hypot(x, y);
        // The ray descends to that surface point, or as gently as the map allows.
        const double perDrop = drop * rays_.longest() > away ? 1 / drop : (away > 0 ? rays_.longest() / away : 0);
        const auto ray = rays_.through(s, t, z, x * perDrop, y * perDrop);
        if (!ray) continue;
        tried.rays.push(*ray);
        tried.from.push_back(1 - z);
        tried.to.push_back(allowedBy(broken, *ray, 1 - z));
    }
    return tried;
}

void Certifier::witness() {
    work_.progress().begin("tracing rays through violating values",
                           static_cast<std::int64_t>(result_.bounds->first.size()));
    for (std::size_t n = 0; n < result_.bounds->first.size(); ++n) {
        work_.throwIfStopped();
        const BrokenBound& broken = result_.bounds->first[n];
        const Tried tried = raysThrough(broken);
        const HitBlock truth = traced(*exact_, tried.rays);
        const HitBlock found = traced(*tracer_, tried.rays);
        for (std::size_t r = 0; r < tried.rays.size(); ++r) {
            const ViewRay ray = tried.rays[r];
            if (texelsPast(field_, ray, truth[r], found[r]) > result_.allowed) {
                result_.first = example(ray, truth[r], found[r]);
                return;
            }
            // The value is judged alone, so rays that hit something before reaching it do not count.
            if (truth[r].outcome != Outcome::Hit || truth[r].lambda < tried.from[r]) continue;
            const double texels = (tried.to[r] - truth[r].lambda) * lengthOf(ray);
            if (!(texels > 0) || (result_.byValue && texels <= result_.byValue->texels)) continue;
            result_.byValue = {ray, truth[r].lambda, tried.to[r], texels, brokenBoundText(broken, field_)};
        }
        work_.progress().advance();
    }
}

}  // namespace

double texelsPast(const HeightField& field, const ViewRay& ray, const Hit& truth, const Hit& found) {
    if (truth.outcome != Outcome::Hit || found.outcome == Outcome::Limit) return 0;
    if (found.outcome != Outcome::Hit) return std::numeric_limits<double>::infinity();
    return (found.lambda - truth.lambda) * std::hypot(ray.a, ray.b, field.slabTexels());
}

CounterExample counterExample(const HeightField& field, const ViewRay& ray, const Hit& truth, const Hit& found,
                              std::string where) {
    const double answered = found.outcome == Outcome::Hit ? found.lambda : std::numeric_limits<double>::infinity();
    return {ray, truth.lambda, answered, texelsPast(field, ray, truth, found), std::move(where)};
}

Certificate certify(const MethodChoice& choice, const HeightField& field, const CertificateOptions& options,
                    MapCache& cache, Work& work) {
    return Certifier(withStoredMap(choice), field, options, cache, work).run();
}

}  // namespace relief
