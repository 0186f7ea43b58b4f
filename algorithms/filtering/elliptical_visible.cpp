#include "filtering/elliptical_visible.h"

#include <algorithm>
#include <cmath>

#include "filtering/bilinear_texels.h"
#include "filtering/surface_pieces.h"
#include "filtering/tangent_footprint.h"
#include "filtering/visible_piece.h"

namespace relief {

// Bounds of the heights in the footprint. flat: no height exceeds the lowest of them; clear: none can hide another.
struct VisibleKernel::Region {
    HeightBounds under;
    bool flat = false;
    bool clear = false;
};

// Buffers reused from pixel to pixel of a block, to avoid allocations.
struct VisibleKernel::Scratch {
    std::vector<Piece> pieces;
    AnyRayBlock rays;
    std::vector<std::size_t> which;
    VisibilityBlock results;
};

VisibleKernel::VisibleKernel(EllipticalKernel plain, VisibleForm form, const HeightField& field,
                             std::shared_ptr<const AnyHitQuery> query, std::shared_ptr<const HeightBoundsMap> range)
    : plain_(std::move(plain)),
      form_(form),
      field_(field),
      query_(std::move(query)),
      range_(std::move(range)),
      perColor_(static_cast<double>(field.width()) / plain_.levels().width(),
                static_cast<double>(field.height()) / plain_.levels().height()) {}

glm::dvec2 VisibleKernel::fieldTexels(glm::dvec2 levelPlace, int level) const {
    return glm::dvec2(std::ldexp(levelPlace.x, level), std::ldexp(levelPlace.y, level)) * perColor_;
}

VisibleKernel::Region VisibleKernel::regionOf(const LevelFootprint& f, const SeenPoint& seen) const {
    const double a = seen.ray.a;
    const double b = seen.ray.b;
    const HeightBounds all{range_->lowest.level(range_->lowest.levels() - 1)(0, 0),
                           range_->highest.level(range_->highest.levels() - 1)(0, 0)};
    const HalfExtents<double> half = f.ellipse.halfExtents(f.radius);
    const glm::dvec2 centre = fieldTexels(f.centre, f.level);
    // A texel's centre may be half a texel of the level away from what it covers, and one texel is added on each side.
    const glm::dvec2 extent = fieldTexels({half.u + 0.5, half.v + 0.5}, f.level) + 1.0;
    const double h0 = 1 - seen.lambda;
    const auto rangeOver = [&](double near, double far) {
        // Bounds over the box swept along (-a, -b), from `near` to `far` times that vector.
        const double s0 = std::min(-near * a, -far * a), s1 = std::max(-near * a, -far * a);
        const double t0 = std::min(-near * b, -far * b), t1 = std::max(-near * b, -far * b);
        return heightBounds(*range_, field_, centre.x - extent.x + s0, centre.y - extent.y + t0,
                            centre.x + extent.x + s1, centre.y + extent.y + t1);
    };
    Region region{all};
    if (form_ == VisibleForm::Plane) {
        region.under = rangeOver(0, 0);
    } else {
        // A point at height h is visible where the plane's point is displaced by (h - h0) back along the ray.
        for (int n = 0; n < 2; ++n) region.under = rangeOver(region.under.low - h0, region.under.high - h0);
    }
    // Bounds the highest point that a segment from the footprint can meet before it has risen above it.
    double top = all.high;
    for (int n = 0; n < 2; ++n) {
        const double reach = std::max(0.0, top - region.under.low);
        const double near = form_ == VisibleForm::Plane ? 0 : std::min(0.0, region.under.low - h0);
        const double far = form_ == VisibleForm::Plane ? 0 : std::max(0.0, region.under.high - h0);
        top = rangeOver(near, far + reach).high;
    }
    const double rise = top - region.under.low;
    const double run =
        field_.surface() == Surface::Bilinear ? std::abs(a) + std::abs(b) : 2 * std::max(std::abs(a), std::abs(b));
    region.flat = rise <= 0;
    // For columns, the distance to the next texel is half a texel only from the centre of a texel.
    const bool centred = f.level == 0 && perColor_ == glm::dvec2(1);
    region.clear = region.flat || (run * rise < 1 && (field_.surface() == Surface::Bilinear || centred));
    return region;
}

void VisibleKernel::test(Scratch& scratch, const SeenPoint& seen, FootprintCounts& counts, Work& work, bool log) const {
    auto& [pieces, rays, which, results] = scratch;
    rays.resize(0);
    which.clear();
    for (std::size_t n = 0; n < pieces.size(); ++n) {
        const Piece& piece = pieces[n];
        if (piece.h >= 1) continue;  // at the top plane
        const double mu = 1 - piece.h;
        rays.push({piece.s, piece.t, piece.h, -mu * seen.ray.a, -mu * seen.ray.b, mu});
        which.push_back(n);
    }
    NullSink sink;
    query_->query(rays, results, sink, work);
    for (std::size_t n = 0; n < which.size(); ++n) {
        FootprintTexel& texel = pieces[which[n]].texel;
        texel.tested = true;
        texel.hidden = results.visibility[n] == Visibility::Blocked;
        if (!texel.hidden || !log) continue;
        // Repeats the query with a log, whose last step is at what hides the texel.
        AnyRayBlock one;
        one.push(rays[n]);
        VisibilityBlock again;
        StepLog steps;
        query_->query(one, again, steps, work);
        if (steps.steps.empty()) continue;
        // The log stores heights as descents; the blocker is marked at the middle of the interval in the blocking cell.
        const double z = 1 - 0.5 * (steps.steps.back().lambdaIn + steps.steps.back().lambdaOut);
        const double mu = (z - rays.z[n]) / rays.dz[n];
        texel.blocker = {rays.s[n] + mu * rays.ds[n], rays.t[n] + mu * rays.dt[n]};
    }
    counts.tested += static_cast<std::int64_t>(which.size());
}

std::optional<Jacobian> VisibleKernel::plainJacobian(const Jacobian& j, const SeenPoint& seen, bool& clear) const {
    const Jacobian onField = scaled(j, perColor_);
    const TangentFootprint tangent =
        tangentFootprint({*range_, field_, plain_.settings(), perColor_}, onField, seen.place, seen.ray, seen.lambda);
    clear = tangent.clear;
    if (form_ == VisibleForm::Plane || !tangent.planar || !tangent.clear) return std::nullopt;
    // Level ground keeps the bits of the pixel's own Jacobian.
    const Jacobian& t = tangent.jacobian;
    if (t.ux == onField.ux && t.vx == onField.vx && t.uy == onField.uy && t.vy == onField.vy) return j;
    return scaled(tangent.jacobian, 1.0 / perColor_);
}

Color VisibleKernel::filter(const Jacobian& j, glm::dvec2 centre, const SeenPoint& seen, FootprintCounts& counts,
                            Work& work, FootprintLog* log) const {
    Scratch scratch;
    bool clear = false;
    const std::optional<Jacobian> plain = plainJacobian(j, seen, clear);
    if (!plain) return filterPieces(j, centre, seen, clear, scratch, counts, work, log);
    const FootprintCounts before = counts;
    const Color color = plain_.filter(*plain, centre, counts, log);
    counts.skipped += counts.texels - before.texels;
    counts.flat += counts.footprints - before.footprints;
    if (log != nullptr) log->skipped = true;
    return color;
}

void VisibleKernel::filter(const FilterBlock& block, glm::dvec2 scale, std::span<Color> colors, FootprintCounts& counts,
                           Work& work) const {
    Scratch scratch;
    FilterBlock plain;
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < block.size() && !work.stopped(); ++i) {
        const FilterQuery query = block[i];
        const Jacobian j = scaled(query.jacobian, scale);
        const glm::dvec2 centre = query.place * scale;
        const SeenPoint seen{query.ray, query.lambda, query.place};
        bool clear = false;
        if (const std::optional<Jacobian> jacobian = plainJacobian(j, seen, clear)) {
            plain.push({centre, *jacobian, {}, 0});
            which.push_back(i);
        } else {
            colors[i] = filterPieces(j, centre, seen, clear, scratch, counts, work, nullptr);
        }
    }
    const FootprintCounts before = counts;
    std::vector<Color> found(which.size());
    plain_.filter(plain, {1, 1}, found, counts);
    for (std::size_t n = 0; n < which.size(); ++n) colors[which[n]] = found[n];
    counts.skipped += counts.texels - before.texels;
    counts.flat += counts.footprints - before.footprints;
}

// clear: the tangent plane proves that nothing on the plane's footprint is hidden.
Color VisibleKernel::filterPieces(const Jacobian& j, glm::dvec2 centre, const SeenPoint& seen, bool clear,
                                  Scratch& scratch, FootprintCounts& counts, Work& work, FootprintLog* log) const {
    const LevelFootprint f = plain_.footprint(j, centre);
    if (f.kind != FootprintKind::Ellipse) return plain_.filter(j, centre, counts, log);
    Region region = regionOf(f, seen);
    // The proof is valid for the plane's footprint only; the other forms sample ground beyond it, which may be hidden.
    region.clear = region.clear || (clear && form_ == VisibleForm::Plane);
    if (region.flat || (region.clear && skip_ && form_ == VisibleForm::Plane)) {
        const std::int64_t before = counts.texels;
        const Color color = plain_.filter(j, centre, counts, log);
        counts.skipped += counts.texels - before;
        ++counts.flat;
        if (log != nullptr) log->skipped = true;
        return color;
    }
    std::vector<Piece>& pieces = scratch.pieces;
    pieces.clear();
    if (form_ == VisibleForm::Plane) {
        gatherTexels(f, pieces);
    } else {
        SurfacePieces(*this, f, seen).gather(region.under, pieces);
    }
    if (region.clear && skip_) {
        counts.skipped += static_cast<std::int64_t>(pieces.size());
        ++counts.flat;
    } else {
        test(scratch, seen, counts, work, log != nullptr);
    }
    const bool unhidden = std::none_of(pieces.begin(), pieces.end(), [](const Piece& p) { return p.texel.hidden; });
    // If nothing is hidden, the texels are those of plain filtering, which must give the same bits.
    if (form_ == VisibleForm::Plane && unhidden) return plain_.filter(j, centre, counts, log);
    ++counts.footprints;
    counts.texels += static_cast<std::int64_t>(pieces.size());
    bool none = false;
    const Color color = summed(f, centre, pieces, counts, log, none);
    counts.allHidden += none ? 1 : 0;
    if (log != nullptr) {
        log->footprint = f;
        log->skipped = region.clear && skip_;
        log->allHidden = none;
        log->color = color;
    }
    return color;
}

// none: set to whether no channel has a visible texel.
Color VisibleKernel::summed(const LevelFootprint& f, glm::dvec2 centre, const std::vector<Piece>& pieces,
                            FootprintCounts& counts, FootprintLog* log, bool& none) const {
    const double toUnit = 1 / (f.ellipse.f * f.radius * f.radius);
    glm::dvec3 sum(0);
    glm::dvec3 total(0);
    plain_.weighted(f, [&](const auto& weight) {
        for (const Piece& piece : pieces) {
            const auto r2 = static_cast<float>(std::clamp(f.ellipse.form(piece.du, piece.dv) * toUnit, 0.0, 1.0));
            const auto w = weight(piece.du, piece.dv, r2) * static_cast<float>(piece.share);
            counts.hidden += piece.texel.hidden ? 1 : 0;
            if (log != nullptr) {
                log->texels.push_back(piece.texel);
                log->texels.back().weight = Color(w);
            }
            if (piece.texel.hidden) continue;
            sum += glm::dvec3(w * piece.color);
            total += glm::dvec3(w);
        }
    });
    // With lcd and crt, one channel alone may see nothing.
    Color unseen(0);
    for (int c = 0; c < 3; ++c) unseen[c] = total[c] > 0 ? 0.0F : 1.0F;
    none = unseen == Color(1);
    if (unseen == Color(0)) return Color(sum / total);
    counts.texels += 4;
    const Color atHit = plain_.levels().bilinear(0, centre, plain_.address());
    for (int c = 0; c < 3; ++c) {
        if (unseen[c] > 0) sum[c] = atHit[c], total[c] = 1;
    }
    if (log != nullptr && !none) {
        const SampledTexture texture{plain_.levels().width(), plain_.levels().height(), plain_.address()};
        addBilinearTexels(log->texels, texture, centre, 0, f.level, unseen);
    }
    return Color(sum / total);
}

void VisibleKernel::gatherTexels(const LevelFootprint& f, std::vector<Piece>& pieces) const {
    const ColorImage& image = plain_.levels().level(f.level);
    overEllipse(f, plain_.across(f.level), plain_.down(f.level), [&](int i, int j, double u, double v, float share) {
        const glm::dvec2 place = fieldTexels(f.centre + glm::dvec2(u, v), f.level);
        Piece piece;
        piece.texel = {i, j, f.level, u + f.centre.x, v + f.centre.y};
        piece.color = image(i, j);
        piece.share = share;
        piece.s = place.x;
        piece.t = place.y;
        // Outside a border there is no surface that could be hidden; its colour counts, as in plain filtering.
        piece.h = outside(place) ? 1.0 : field_.at(place.x, place.y);
        piece.du = u;
        piece.dv = v;
        pieces.push_back(piece);
    });
}

bool VisibleKernel::outside(glm::dvec2 place) const {
    return field_.address() == Address::Border &&
           (place.x < 0 || place.y < 0 || place.x > field_.width() || place.y > field_.height());
}

}  // namespace relief
