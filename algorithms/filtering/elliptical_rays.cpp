#include "filtering/elliptical_rays.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "relief/block_work.h"
#include "relief/methods/look_up_point.h"

namespace relief {

namespace {

// Size of a ray's footprint over the spacing of the rays. With smaller footprints there are gaps between them; larger
// ones reach across edges.
constexpr double kBlurPerSpacing = 0.55;
// Rotation of the four first rays, in radians, so that edges along the axes are crossed one ray at a time.
constexpr double kProbeTurn = 0.4636476090008061;
// Share of the weights' mass inside the circle of the first rays: edges farther out have little weight.
constexpr double kProbeMass = 0.6;
// Planarity: largest second difference of the hits, relative to the first difference, and in texels of the picture.
// Deviations below the latter are invisible.
constexpr double kRelativeBend = 0.1;
constexpr double kAbsoluteBend = 0.05;
// Hits whose heights differ by at most this are at one height up to rounding: level ground, which keeps the pixel's own
// bits.
constexpr double kLevel = 1e-9;
// Lower bound for 1 + r . g of a ray's tangent plane (r: run of the ray, g: slope). Footprints become shorter where the
// surface turns towards the viewer. They do not become longer where it turns away, because they would reach beyond the
// piece of surface that was hit.
constexpr double kLeastFacing = 1;

// Radius that encloses this share of the weights' mass, in units of sigma or of the disc's radius.
double massRadius(const EllipticalSettings& settings, double mass) {
    return settings.weights == WeightKind::Uniform ? std::sqrt(mass) : std::sqrt(-2 * std::log1p(-mass));
}

// Translates and scales the places so that their mean is 0, the sums of x x and of y y are `second`, and that of x y is
// 0.
void whiten(std::span<glm::dvec2> places, double second) {
    glm::dvec2 mean(0);
    for (const glm::dvec2& p : places) mean += p / static_cast<double>(places.size());
    double xx = 0, xy = 0, yy = 0;
    for (glm::dvec2& p : places) {
        p -= mean;
        xx += p.x * p.x;
        xy += p.x * p.y;
        yy += p.y * p.y;
    }
    const double shear = xy / xx;
    const double across = std::sqrt(second / xx), down = std::sqrt(second / (yy - shear * xy));
    for (glm::dvec2& p : places) p = {across * p.x, down * (p.y - shear * p.x)};
}

Jacobian times(const Jacobian& j, double factor) {
    return {factor * j.ux, factor * j.vx, factor * j.uy, factor * j.vy};
}

// The Jacobian on a plane of this slope, through a point at which the Jacobian of the horizontal plane is j.
Jacobian onSlope(const Jacobian& j, const ViewRay& ray, double slopeS, double slopeT) {
    const double facing = std::max(kLeastFacing, 1 + ray.a * slopeS + ray.b * slopeT);
    const double alongX = (slopeS * j.ux + slopeT * j.vx) / facing;
    const double alongY = (slopeS * j.uy + slopeT * j.vy) / facing;
    return {j.ux - ray.a * alongX, j.vx - ray.b * alongX, j.uy - ray.a * alongY, j.vy - ray.b * alongY};
}

}  // namespace

double weightVariance(const EllipticalSettings& settings) {
    if (settings.weights == WeightKind::Uniform) return settings.radius * settings.radius / 4;
    const double x = settings.radius * settings.radius / (2 * settings.sigma * settings.sigma);
    return settings.sigma * settings.sigma * (1 - x / std::expm1(x));
}

RayPattern RayPattern::of(const EllipticalSettings& settings, int samples) {
    assert(samples >= 2 * kProbes);
    RayPattern pattern;
    const double spread = kBlurPerSpacing * std::sqrt(2 * std::numbers::pi / samples);
    const double variance = weightVariance(settings) / (1 + spread * spread);
    pattern.blur = spread / std::sqrt(1 + spread * spread);
    const double unit = std::sqrt(variance / (settings.weights == WeightKind::Uniform ? 0.25 : 1.0));
    const double radius = unit * massRadius(settings, kProbeMass);
    for (int n = 0; n < kProbes; ++n) {
        const double angle = kProbeTurn + 0.5 * std::numbers::pi * n;
        pattern.places.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    const int rest = samples - kProbes;
    const int inside = std::clamp(static_cast<int>(kProbeMass * samples - 0.5 * kProbes), 0, rest);
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    for (int n = 0; n < rest; ++n) {
        const double mass = (n < inside ? n + 0.5 : n + kProbes + 0.5) / samples;
        const double r = unit * massRadius(settings, mass);
        pattern.places.emplace_back(r * std::cos(golden * n), r * std::sin(golden * n));
    }
    // The probes contribute 2 radius^2 along each axis.
    whiten({pattern.places.data() + kProbes, static_cast<std::size_t>(rest)}, samples * variance - 2 * radius * radius);
    return pattern;
}

RayFan::RayFan(const FilterQuery& query)
    : entry(query.place - query.lambda * glm::dvec2(query.ray.a, query.ray.b)),
      run(query.ray.a, query.ray.b),
      top(times(query.jacobian, 1 / (1 + query.lambda * query.spread))),
      spread(query.spread) {}

ViewRay RayFan::ray(glm::dvec2 place) const {
    const glm::dvec2 d{top.ux * place.x + top.uy * place.y, top.vx * place.x + top.vy * place.y};
    return {entry.x + d.x, entry.y + d.y, run.x + spread * d.x, run.y + spread * d.y};
}

Jacobian RayFan::jacobianAt(double lambda) const {
    return times(top, 1 + lambda * spread);
}

// Buffers reused from chunk to chunk, to avoid allocations.
struct RaysKernel::Scratch {
    glm::dvec2 scale{1};
    RayBlock rays;
    HitBlock hits;
    std::vector<std::size_t> traced;  // pixels whose rays these are
    // Queries of the pixels on planes, and the pixels' indices in the block.
    FilterBlock plain;
    std::vector<std::size_t> plainOf;
    // Indices of the other pixels, and the hits of their probes.
    std::vector<std::size_t> edges;
    std::vector<Hit> edgeHits;
    // Samples of a chunk of these pixels: colours by slot, whether the ray hit, and the footprints to filter.
    std::vector<Color> found;
    std::vector<std::uint8_t> met;
    FilterBlock small;
    std::vector<std::size_t> slots;
    std::vector<Color> colors;
    std::size_t used = 0;
    std::size_t tiny = 0;  // samples with footprints too small to filter, which read four texels each
};

RaysKernel::RaysKernel(EllipticalKernel plain, std::unique_ptr<const Tracer> tracer, int samples)
    : plain_(std::move(plain)),
      tracer_(std::move(tracer)),
      pattern_(RayPattern::of(plain_.settings(), samples)),
      smallest_(plain_.settings().exhaustive ? 0 : bilinearMajor(plain_.settings())) {}

bool RaysKernel::usable(const FilterQuery& query) const {
    const Jacobian& j = query.jacobian;
    const double size = std::abs(j.ux) + std::abs(j.uy) + std::abs(j.vx) + std::abs(j.vy);
    const double largest = 4.0 * std::max(tracer_->field().width(), tracer_->field().height());
    return size < largest && query.lambda >= 0 && query.ray.finite() && std::isfinite(query.place.x + query.place.y) &&
           query.spread >= 0 && std::isfinite(query.spread);
}

bool RaysKernel::planeThrough(const FilterQuery& query, const HitBlock& hits, std::size_t first, glm::dvec2 scale,
                              Jacobian& found) const {
    std::array<glm::dvec2, kProbes> at;
    bool level = true;
    for (std::size_t n = 0; n < kProbes; ++n) {
        if (hits.outcome[first + n] != Outcome::Hit) return false;
        at[n] = (glm::dvec2(hits.s[first + n], hits.t[first + n]) - query.place) * scale;
        level = level && std::abs(hits.lambda[first + n] - query.lambda) <= kLevel;
    }
    if (level) {
        found = scaled(query.jacobian, scale);
        return true;
    }
    const auto square = [](glm::dvec2 v) { return v.x * v.x + v.y * v.y; };
    std::array<glm::dvec2, 2> step;
    for (std::size_t k = 0; k < 2; ++k) {
        step[k] = 0.5 * (at[k] - at[k + 2]);
        const double bend = 0.25 * square(at[k] + at[k + 2]);
        if (!(bend <= kRelativeBend * kRelativeBend * square(step[k]) + kAbsoluteBend * kAbsoluteBend)) return false;
    }
    // With the places e and f = e turned by 90 degrees, x = (e.x e - e.y f) / e^2 and y = (e.y e + e.x f) / e^2.
    const glm::dvec2 e = pattern_.places[0] / square(pattern_.places[0]);
    const glm::dvec2 x = e.x * step[0] - e.y * step[1], y = e.y * step[0] + e.x * step[1];
    found = {x.x, x.y, y.x, y.y};
    return true;
}

void RaysKernel::probe(const FilterBlock& block, std::size_t first, std::size_t last, Scratch& scratch,
                       Work& work) const {
    scratch.traced.clear();
    scratch.rays.resize((last - first) * kProbes);
    const auto plain = [&](std::size_t i, const FilterQuery& query, const Jacobian& j) {
        scratch.plain.set(scratch.plainOf.size(), {query.place * scratch.scale, j, {}, 0});
        scratch.plainOf.push_back(i);
    };
    for (std::size_t i = first; i < last; ++i) {
        const FilterQuery query = block[i];
        if (!usable(query)) {
            plain(i, query, scaled(query.jacobian, scratch.scale));
            continue;
        }
        const RayFan fan(query);
        for (std::size_t n = 0; n < kProbes; ++n) {
            scratch.rays.set(scratch.traced.size() * kProbes + n, fan.ray(pattern_.places[n]));
        }
        scratch.traced.push_back(i);
    }
    scratch.rays.resize(scratch.traced.size() * kProbes);
    NullSink sink;
    tracer_->trace(scratch.rays, scratch.hits, sink, work);
    for (std::size_t k = 0; k < scratch.traced.size(); ++k) {
        const std::size_t i = scratch.traced[k];
        const FilterQuery query = block[i];
        Jacobian j;
        if (planeThrough(query, scratch.hits, k * kProbes, scratch.scale, j)) {
            plain(i, query, j);
            continue;
        }
        scratch.edges.push_back(i);
        for (std::size_t n = 0; n < kProbes; ++n) scratch.edgeHits.push_back(scratch.hits[k * kProbes + n]);
    }
}

void RaysKernel::addSample(const RayFan& fan, const ViewRay& ray, const Hit& hit, std::size_t slot,
                           Scratch& scratch) const {
    scratch.met[slot] = hit.outcome == Outcome::Hit ? 1 : 0;
    if (hit.outcome != Outcome::Hit) return;
    const HeightField& field = tracer_->field();
    const glm::dvec2 place = lookUpPoint(field, ray, hit);
    Jacobian j = times(fan.jacobianAt(hit.lambda), pattern_.blur);
    if (field.surface() == Surface::Bilinear) {
        const auto [slopeS, slopeT] = field.slope(place.x, place.y);
        j = onSlope(j, ray, slopeS, slopeT);
    }
    j = scaled(j, scratch.scale);
    const glm::dvec2 centre = place * scratch.scale;
    if (j.ux * j.ux + j.vx * j.vx + j.uy * j.uy + j.vy * j.vy < smallest_ * smallest_) {
        scratch.found[slot] = plain_.levels().bilinear(0, centre, plain_.address());
        ++scratch.tiny;
        return;
    }
    scratch.small.set(scratch.used, {centre, j, {}, 0});
    scratch.slots[scratch.used++] = slot;
}

void RaysKernel::sample(const FilterBlock& block, std::size_t first, std::size_t last, std::span<Color> colors,
                        FootprintCounts& counts, Scratch& scratch, Work& work, FootprintLog* log) const {
    const std::size_t samples = pattern_.places.size(), rest = samples - kProbes;
    const std::size_t pixels = last - first;
    scratch.rays.resize(pixels * rest);
    for (std::size_t k = 0; k < pixels; ++k) {
        const RayFan fan(block[scratch.edges[first + k]]);
        for (std::size_t n = 0; n < rest; ++n) scratch.rays.set(k * rest + n, fan.ray(pattern_.places[kProbes + n]));
    }
    NullSink sink;
    tracer_->trace(scratch.rays, scratch.hits, sink, work);
    for (auto* sized : {&scratch.found, &scratch.colors}) sized->resize(pixels * samples);
    scratch.met.resize(pixels * samples);
    scratch.slots.resize(pixels * samples);
    scratch.small.resize(pixels * samples);
    scratch.used = scratch.tiny = 0;
    for (std::size_t k = 0; k < pixels; ++k) {
        const RayFan fan(block[scratch.edges[first + k]]);
        for (std::size_t n = 0; n < samples; ++n) {
            const ViewRay ray = n < kProbes ? fan.ray(pattern_.places[n]) : scratch.rays[k * rest + n - kProbes];
            const Hit hit =
                n < kProbes ? scratch.edgeHits[(first + k) * kProbes + n] : scratch.hits[k * rest + n - kProbes];
            addSample(fan, ray, hit, k * samples + n, scratch);
        }
    }
    scratch.small.resize(scratch.used);
    FootprintCounts read;
    plain_.filter(scratch.small, {1, 1}, {scratch.colors.data(), scratch.used}, read);
    for (std::size_t n = 0; n < scratch.used; ++n) scratch.found[scratch.slots[n]] = scratch.colors[n];
    counts.texels += read.texels + 4 * static_cast<std::int64_t>(scratch.tiny);
    counts.tested += static_cast<std::int64_t>(pixels * samples);
    counts.footprints += static_cast<std::int64_t>(pixels);
    for (std::size_t k = 0; k < pixels; ++k) {
        glm::dvec3 sum(0);
        double total = 0;
        for (std::size_t n = k * samples; n < (k + 1) * samples; ++n) {
            if (scratch.met[n] == 0) continue;
            sum += glm::dvec3(scratch.found[n]);
            total += 1;
        }
        const std::size_t i = scratch.edges[first + k];
        const FilterQuery query = block[i];
        const glm::dvec2 centre = query.place * scratch.scale;
        if (total == 0) {
            // No sample hit the relief, although the pixel's own ray did: the colour at its hit is read.
            ++counts.allHidden;
            counts.texels += 4;
        }
        colors[i] = total > 0 ? Color(sum / total) : plain_.levels().bilinear(0, centre, plain_.address());
        if (log == nullptr) continue;
        log->footprint = plain_.footprint(scaled(query.jacobian, scratch.scale), centre);
        log->allHidden = total == 0;
        log->color = colors[i];
        if (total > 0) logSamples(query, scratch, samples, *log);
    }
}

// Logs the samples of the block's only pixel by filtering them again: its texels, weighted as parts of a ray's share.
void RaysKernel::logSamples(const FilterQuery& query, const Scratch& scratch, std::size_t samples,
                            FootprintLog& log) const {
    const RayFan fan(query);
    const glm::dvec2 own = query.place * scratch.scale;
    const double toLevel = std::ldexp(1.0, -log.footprint.level);
    Scratch again;
    again.scale = scratch.scale;
    for (auto* sized : {&again.found, &again.colors}) sized->resize(1);
    again.met.resize(1);
    again.slots.resize(1);
    again.small.resize(1);
    const auto add = [&](FootprintTexel texel, glm::dvec2 away, double weight) {
        const glm::dvec2 at = log.footprint.centre + away * toLevel;
        texel.u = at.x;
        texel.v = at.y;
        texel.weight = Color(static_cast<float>(weight));
        texel.tested = true;
        log.texels.push_back(texel);
    };
    std::size_t next = 0;
    for (std::size_t n = 0; n < samples; ++n) {
        if (scratch.met[n] == 0) continue;
        if (next < scratch.used && scratch.slots[next] == n) {
            const FilterQuery small = scratch.small[next++];
            FootprintLog part;
            FootprintCounts counts;
            plain_.filter(small.jacobian, small.place, counts, &part);
            double total = 0;
            for (const FootprintTexel& texel : part.texels) total += texel.weight.x;
            for (const FootprintTexel& texel : part.texels) {
                const glm::dvec2 off = glm::dvec2(texel.u, texel.v) - part.footprint.centre;
                add(texel, small.place - own + off * std::ldexp(1.0, part.footprint.level), texel.weight.x / total);
            }
            if (part.footprint.kind == FootprintKind::Top) add({0, 0, part.footprint.level}, small.place - own, 1);
            if (!part.texels.empty() || part.footprint.kind == FootprintKind::Top) continue;
        }
        const Hit hit = n < kProbes ? scratch.edgeHits[n] : scratch.hits[n - kProbes];
        const ViewRay ray = fan.ray(pattern_.places[n]);
        const glm::dvec2 place = lookUpPoint(tracer_->field(), ray, hit) * scratch.scale;
        const BilinearSupport x = plain_.across(0).support(place.x), y = plain_.down(0).support(place.y);
        for (int c = 0; c < 4; ++c) {
            const bool right = c % 2 == 1, below = c / 2 == 1;
            FootprintTexel texel;
            texel.i = right ? x.second : x.first;
            texel.j = below ? y.second : y.first;
            add(texel, place - own + glm::dvec2((right ? 1 : 0) - x.share, (below ? 1 : 0) - y.share),
                (right ? x.share : 1 - x.share) * (below ? y.share : 1 - y.share));
        }
    }
}

void RaysKernel::filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, FootprintCounts& counts,
                        Work& work, FootprintLog* log) const {
    Scratch scratch;
    scratch.scale = scale;
    scratch.plain.resize(block.size());
    // Pixels per chunk, so that one thread traces the rays of a chunk at once.
    constexpr std::size_t kPixels = kRayGrain / kProbes;
    for (std::size_t i = 0; i < block.size() && !work.stopped(); i += kPixels) {
        probe(block, i, std::min(i + kPixels, block.size()), scratch, work);
    }
    const std::size_t plains = scratch.plainOf.size();
    scratch.plain.resize(plains);
    const FootprintCounts before = counts;
    std::vector<Color> found(plains);
    if (log != nullptr && plains == 1) {
        const FilterQuery plain = scratch.plain[0];
        found[0] = plain_.filter(plain.jacobian, plain.place, counts, log);
        log->skipped = true;
    } else {
        plain_.filter(scratch.plain, {1, 1}, found, counts);
    }
    counts.skipped += counts.texels - before.texels;
    counts.flat += counts.footprints - before.footprints;
    for (std::size_t n = 0; n < plains; ++n) colors[scratch.plainOf[n]] = found[n];
    const std::size_t chunk = std::max<std::size_t>(1, kRayGrain / (pattern_.places.size() - kProbes));
    for (std::size_t i = 0; i < scratch.edges.size() && !work.stopped(); i += chunk) {
        sample(block, i, std::min(i + chunk, scratch.edges.size()), colors, counts, scratch, work, log);
    }
}

}  // namespace relief
