#include "filtering/elliptical_visible.h"

#include <algorithm>
#include <cmath>

namespace relief {

// One texel of the level, before and after its test.
struct VisibleKernel::Texel {
    int i, j;
    double u, v;         // centre less the footprint's, texels of the level
    double share;
    double s, t, h;      // its surface point, texels of the height map
    double du, dv;       // its place in the footprint, texels of the level
    double area;
    bool hidden = false;
    bool tested = false;
    glm::dvec2 blocker{0};
};

// Heights under what the footprint may see, and whether any of them can hide another.
struct VisibleKernel::Region {
    HeightBounds under;
    bool flat = false;
    bool clear = false;
};

namespace {

// The row of a capsule: an ellipse moved along a straight way, from `from` to `to` (texels): the spans of the ellipse
// at both ends, and of the parallelogram between the points of its outline where the way is a tangent.
Span<double> capsuleSpan(const Ellipse& e, double radius, glm::dvec2 from, glm::dvec2 to, double v) {
    Span<double> out;
    const auto join = [&](double begin, double end) {
        if (out.empty()) {
            out = {begin, end};
        } else {
            out = {std::min(out.begin, begin), std::max(out.end, end)};
        }
    };
    for (const glm::dvec2& at : {from, to}) {
        const Span<double> span = e.rowSpan(v - at.y, radius);
        if (!span.empty()) join(at.x + span.begin, at.x + span.end);
    }
    const glm::dvec2 way = to - from;
    // Conjugate of the way: [[A, B/2], [B/2, C]] way turned by a right angle, brought onto the outline.
    const glm::dvec2 gradient{e.a * way.x + 0.5 * e.b * way.y, 0.5 * e.b * way.x + e.c * way.y};
    glm::dvec2 side{-gradient.y, gradient.x};
    const double form = e.form(side.x, side.y);
    if (form > 0) {
        side *= radius * std::sqrt(e.f / form);
        const std::array<glm::dvec2, 4> corner{from + side, to + side, to - side, from - side};
        for (std::size_t n = 0; n < 4; ++n) {
            const glm::dvec2& p = corner[n];
            const glm::dvec2& q = corner[(n + 1) % 4];
            if ((p.y - v) * (q.y - v) > 0) continue;
            if (p.y == q.y) {
                join(std::min(p.x, q.x), std::max(p.x, q.x));
            } else {
                const double x = p.x + (q.x - p.x) * ((v - p.y) / (q.y - p.y));
                join(x, x);
            }
        }
    }
    return out;
}

}  // namespace

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
    // A texel's centre may lie half a texel of the level off what it stands for, and one texel is added all round.
    const glm::dvec2 extent = fieldTexels({half.u + 0.5, half.v + 0.5}, f.level) + 1.0;
    const double h0 = 1 - seen.lambda;
    const auto rangeOver = [&](double near, double far) {
        // Of the box moved by near .. far times (-a, -b).
        const double s0 = std::min(-near * a, -far * a), s1 = std::max(-near * a, -far * a);
        const double t0 = std::min(-near * b, -far * b), t1 = std::max(-near * b, -far * b);
        return heightBounds(*range_, field_, centre.x - extent.x + s0, centre.y - extent.y + t0,
                           centre.x + extent.x + s1, centre.y + extent.y + t1);
    };
    Region region{all};
    if (form_ == VisibleForm::Plane) {
        region.under = rangeOver(0, 0);
    } else {
        // What is at height h is seen where the plane's point is moved by (h - h0) back along the ray.
        for (int n = 0; n < 2; ++n) region.under = rangeOver(region.under.low - h0, region.under.high - h0);
    }
    // The highest point that a segment from here can meet before it has risen above it.
    double top = all.high;
    for (int n = 0; n < 2; ++n) {
        const double reach = std::max(0.0, top - region.under.low);
        const double near = form_ == VisibleForm::Plane ? 0 : std::min(0.0, region.under.low - h0);
        const double far = form_ == VisibleForm::Plane ? 0 : std::max(0.0, region.under.high - h0);
        top = rangeOver(near, far + reach).high;
    }
    const double rise = top - region.under.low;
    const double run = field_.surface() == Surface::Bilinear ? std::abs(a) + std::abs(b)
                                                             : 2 * std::max(std::abs(a), std::abs(b));
    region.flat = rise <= 0;
    // Columns: the way to the next texel is half a texel only from a texel's centre.
    const bool centred = f.level == 0 && perColor_ == glm::dvec2(1);
    region.clear = region.flat || (run * rise < 1 && (field_.surface() == Surface::Bilinear || centred));
    return region;
}

std::vector<VisibleKernel::Texel> VisibleKernel::gather(const LevelFootprint& f, const SeenPoint& seen,
                                                        const Region& region) const {
    std::vector<Texel> texels;
    const LevelAxis columns = plain_.across(f.level);
    const LevelAxis rows = plain_.down(f.level);
    const double h0 = 1 - seen.lambda;
    // The view ray in texels of the level.
    const glm::dvec2 run{std::ldexp(seen.ray.a / perColor_.x, -f.level), std::ldexp(seen.ray.b / perColor_.y, -f.level)};
    const auto add = [&](int i, int j, double u, double v, float share) {
        Texel texel{i, j, u, v, share, 0, 0, 0, u, v, 1};
        const glm::dvec2 place = fieldTexels(f.centre + glm::dvec2(u, v), f.level);
        if (field_.address() == Address::Border &&
            (place.x < 0 || place.y < 0 || place.x > field_.width() || place.y > field_.height())) {
            return;
        }
        texel.s = place.x;
        texel.t = place.y;
        texel.h = field_.at(place.x, place.y);
        if (form_ != VisibleForm::Plane) {
            texel.du += (texel.h - h0) * run.x;
            texel.dv += (texel.h - h0) * run.y;
            if (!f.ellipse.contains(texel.du, texel.dv, f.radius)) return;
        }
        if (form_ == VisibleForm::PositionArea && field_.surface() == Surface::Bilinear) {
            const auto [hs, ht] = field_.slope(place.x, place.y);
            texel.area = 1 + seen.ray.a * hs + seen.ray.b * ht;
            if (!(texel.area > 0)) return;  // turned away from the viewer
        }
        texels.push_back(texel);
    };
    if (form_ == VisibleForm::Plane) {
        overEllipse(f, columns, rows, add);
        return texels;
    }
    const glm::dvec2 from = -(region.under.low - h0) * run;
    const glm::dvec2 to = -(region.under.high - h0) * run;
    const double height = f.ellipse.halfExtents(f.radius).v;
    rows.over(f.centre.y + std::min(from.y, to.y) - height, f.centre.y + std::max(from.y, to.y) + height,
              [&](int j, double y, float rowShare) {
                  const double v = y - f.centre.y;
                  const Span<double> span = capsuleSpan(f.ellipse, f.radius, from, to, v);
                  if (span.empty()) return;
                  columns.over(f.centre.x + span.begin, f.centre.x + span.end, [&](int i, double x, float share) {
                      add(i, j, x - f.centre.x, v, share * rowShare);
                  });
              });
    return texels;
}

void VisibleKernel::test(std::vector<Texel>& texels, const SeenPoint& seen, FootprintCounts& counts, Work& work,
                         FootprintLog* log) const {
    AnyRayBlock rays;
    std::vector<std::size_t> which;
    for (std::size_t n = 0; n < texels.size(); ++n) {
        const Texel& texel = texels[n];
        if (texel.h >= 1) continue;  // at the top plane
        const double mu = 1 - texel.h;
        rays.push({texel.s, texel.t, texel.h, -mu * seen.ray.a, -mu * seen.ray.b, mu});
        which.push_back(n);
    }
    SightBlock sights;
    NullSink sink;
    query_->look(rays, sights, sink, work);
    for (std::size_t n = 0; n < which.size(); ++n) {
        Texel& texel = texels[which[n]];
        texel.tested = true;
        texel.hidden = sights.sight[n] == Sight::Blocked;
        if (!texel.hidden || log == nullptr) continue;
        // Once more with a log: what it ended at is what hides the texel.
        AnyRayBlock one;
        one.push(rays[n]);
        SightBlock again;
        StepLog steps;
        query_->look(one, again, steps, work);
        if (!steps.steps.empty()) {
            const double mu = steps.steps.back().lambdaIn;
            texel.blocker = {std::floor(rays.s[n] + mu * rays.ds[n]) + 0.5, std::floor(rays.t[n] + mu * rays.dt[n]) + 0.5};
        }
    }
    counts.tested += static_cast<std::int64_t>(which.size());
}

Color VisibleKernel::filter(const Jacobian& j, glm::dvec2 centre, const SeenPoint& seen, FootprintCounts& counts,
                            Work& work, FootprintLog* log) const {
    const LevelFootprint f = plain_.footprint(j, centre);
    if (f.kind != FootprintKind::Ellipse) return plain_.filter(j, centre, counts, log);
    const Region region = regionOf(f, seen);
    if (region.flat || (region.clear && skip_ && form_ == VisibleForm::Plane)) {
        const std::int64_t before = counts.texels;
        const Color color = plain_.filter(j, centre, counts, log);
        counts.skipped += counts.texels - before;
        ++counts.flat;
        if (log != nullptr) log->skipped = true;
        return color;
    }
    std::vector<Texel> texels = gather(f, seen, region);
    if (region.clear && skip_) {
        counts.skipped += static_cast<std::int64_t>(texels.size());
        ++counts.flat;
    } else {
        test(texels, seen, counts, work, log);
    }
    const ColorImage& image = plain_.levels().level(f.level);
    const double toUnit = 1 / (f.ellipse.f * f.radius * f.radius);
    glm::dvec3 sum(0);
    glm::dvec3 total(0);
    plain_.weighted(f, [&](const auto& weight) {
        for (const Texel& texel : texels) {
            const auto r2 = static_cast<float>(std::clamp(f.ellipse.form(texel.du, texel.dv) * toUnit, 0.0, 1.0));
            const auto w = weight(texel.du, texel.dv, r2) * static_cast<float>(texel.share * texel.area);
            counts.hidden += texel.hidden ? 1 : 0;
            if (log != nullptr) {
                log->texels.push_back({texel.i, texel.j, texel.u + f.centre.x, texel.v + f.centre.y, Color(w),
                                       texel.tested, texel.hidden, texel.blocker});
            }
            if (texel.hidden) continue;
            sum += glm::dvec3(w * image(texel.i, texel.j));
            total += glm::dvec3(w);
        }
    });
    ++counts.footprints;
    counts.texels += static_cast<std::int64_t>(texels.size());
    Color color(sum / total);
    if (!(total.x > 0 && total.y > 0 && total.z > 0)) {
        ++counts.allHidden;
        color = plain_.levels().bilinear(0, centre, plain_.address());
    }
    if (log != nullptr) {
        log->footprint = f;
        log->skipped = region.clear && skip_;
        log->allHidden = !(total.x > 0 && total.y > 0 && total.z > 0);
        log->color = color;
    }
    return color;
}

}  // namespace relief
