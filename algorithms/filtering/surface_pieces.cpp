#include "filtering/surface_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "filtering/visible_piece.h"

namespace relief {

namespace {

// Span of a row of a capsule: an ellipse swept along a straight line from `from` to `to` (texels). It joins the spans
// of the ellipse at both ends and of the parallelogram between the points of its outline where the direction is
// tangent.
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
    // Conjugate direction: [[A, B/2], [B/2, C]] (to - from), turned by a right angle and scaled to the outline.
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

SurfacePieces::SurfacePieces(const VisibleKernel& kernel, const LevelFootprint& f, const SeenPoint& seen)
    : kernel_(kernel),
      f_(f),
      seen_(seen),
      h0_(1 - seen.lambda),
      toField_(kernel.fieldTexels({1, 1}, f.level)),
      area_(kernel.form_ == VisibleForm::PositionArea),
      columns_(kernel.field_.surface() == Surface::Columns) {
    run_ = glm::dvec2(seen.ray.a, seen.ray.b) / toField_;
    const double square = f.ellipse.form(run_.x, run_.y) / f.ellipse.f;
    runPixels_ = std::sqrt(std::max(0.0, square));
}

void SurfacePieces::gather(HeightBounds under, std::vector<VisibleKernel::Piece>& pieces) {
    pieces_ = &pieces;
    while (true) {
        visitsLeft_ = kMostVisits;
        texel_ = 0;
        gatherOnce(under);
        if (visitsLeft_ >= 0) return;
        pieces.clear();
        if (mostParts_ > 1) {
            mostParts_ /= 2;
        } else {
            stride_ = 2 * stride_ + 1;  // odd, so that it does not resonate with rows of a power of two
        }
    }
}

void SurfacePieces::gatherOnce(HeightBounds under) {
    const LevelAxis columns = kernel_.plain_.across(f_.level);
    const LevelAxis rows = kernel_.plain_.down(f_.level);
    const glm::dvec2 from = -(under.low - h0_) * run_;
    const glm::dvec2 to = -(under.high - h0_) * run_;
    // Parts of a texel may be visible where its centre is not.
    const double rim = 0.5;
    const double height = f_.ellipse.halfExtents(f_.radius).v + rim;
    rows.over(
        f_.centre.y + std::min(from.y, to.y) - height, f_.centre.y + std::max(from.y, to.y) + height,
        [&](int j, double y, float rowShare) {
            if (visitsLeft_ < 0) return;
            const double v = y - f_.centre.y;
            Span<double> span;
            for (const double at : {v - rim, v, v + rim}) {
                const Span<double> one = capsuleSpan(f_.ellipse, f_.radius, from, to, at);
                if (one.empty()) continue;
                span = span.empty() ? one : Span<double>{std::min(span.begin, one.begin), std::max(span.end, one.end)};
            }
            if (span.empty()) return;
            columns.over(f_.centre.x + span.begin - rim, f_.centre.x + span.end + rim,
                         [&](int i, double x, float share) {
                             if (texel_++ % stride_ == 0) add({f_.level, i, j, x - f_.centre.x, v, share, rowShare});
                         });
        });
}

// Returns true if any of the block's heights could put it into the ellipse. The ellipse is enlarged by the block's own
// extent.
bool SurfacePieces::reaches(const Block& block, HeightBounds bounds) const {
    const glm::dvec2 at{block.u, block.v};
    const glm::dvec2 from = at + (bounds.low - h0_) * run_;
    const glm::dvec2 way = (bounds.high - bounds.low) * run_;
    // The point of the path nearest to the centre in the pixel's metric.
    const Ellipse& e = f_.ellipse;
    const double along = e.form(way.x, way.y);
    const double mixed = e.a * from.x * way.x + 0.5 * e.b * (from.x * way.y + from.y * way.x) + e.c * from.y * way.y;
    const double share = along > 0 ? std::clamp(-mixed / along, 0.0, 1.0) : 0.0;
    const glm::dvec2 nearest = from + share * way;
    const double half = 0.5 * std::hypot(block.width, block.height);
    // Half a diagonal is at most this number of pixels: the larger of the ellipse's inverse axes.
    const double perTexel = std::sqrt((e.a + e.c + std::hypot(e.a - e.c, e.b)) / (2 * e.f));
    return e.contains(nearest.x, nearest.y, f_.radius + half * perTexel);
}

void SurfacePieces::add(const Block& block) {
    if (visitsLeft_ < 0) return;
    --visitsLeft_;
    const glm::dvec2 place = (f_.centre + glm::dvec2(block.u, block.v)) * toField_;
    if (kernel_.outside(place)) return;
    const glm::dvec2 half = 0.5 * glm::dvec2(block.width, block.height) * toField_;
    const HeightBounds bounds = heightBounds(*kernel_.range_, kernel_.field_, place.x - half.x, place.y - half.y,
                                             place.x + half.x, place.y + half.y);
    if (!reaches(block, bounds)) return;
    const bool wide = (bounds.high - bounds.low) * runPixels_ > kLargestSpread;
    // Parts along a side that a texel of this level may still be divided into.
    const int parts = mostParts_ == kMostParts ? kMostParts : mostParts_ >> (f_.level - block.level);
    if (wide && block.level > 0 && parts > 1) {
        split(block);
    } else if (wide && !columns_ && block.level == 0 && parts > 1) {
        addParts(block, bounds, parts);
    } else {
        addPiece(block, block.u, block.v, block.width, block.height,
                 kernel_.plain_.levels().level(block.level)(block.i, block.j));
    }
}

void SurfacePieces::split(const Block& block) {
    const int level = block.level - 1;
    const LevelAxis columns = kernel_.plain_.across(level);
    const LevelAxis rows = kernel_.plain_.down(level);
    const double scale = std::ldexp(1.0, level - f_.level);
    // From the block's first corner, its texels of the finer level in order; the last one may be narrow or missing.
    double v = block.v - 0.5 * block.height;
    for (int j = 2 * block.j; j < std::min(2 * block.j + 2, rows.size); ++j) {
        const double height = (j + 1 < rows.size ? 1.0 : rows.lastShare()) * scale;
        double u = block.u - 0.5 * block.width;
        for (int i = 2 * block.i; i < std::min(2 * block.i + 2, columns.size); ++i) {
            const double width = (i + 1 < columns.size ? 1.0 : columns.lastShare()) * scale;
            add({level, i, j, u + 0.5 * width, v + 0.5 * height, width, height});
            u += width;
        }
        v += height;
    }
}

void SurfacePieces::addParts(const Block& block, HeightBounds bounds, int most) {
    // The number of parts follows from the steepest slope across each axis.
    const glm::dvec2 place = (f_.centre + glm::dvec2(block.u, block.v)) * toField_;
    const glm::dvec2 half = 0.5 * glm::dvec2(block.width, block.height) * toField_;
    const HeightField& field = kernel_.field_;
    const double h = field.at(place.x, place.y);
    const auto parts = [&](double before, double after) {
        const double rise = 2 * std::max(std::abs(h - before), std::abs(after - h));
        return static_cast<int>(std::clamp(
            std::ceil(std::min(rise, bounds.high - bounds.low) * runPixels_ / kLargestSpread), 1.0, double(most)));
    };
    const int across = parts(field.at(place.x - half.x, place.y), field.at(place.x + half.x, place.y));
    const int down = parts(field.at(place.x, place.y - half.y), field.at(place.x, place.y + half.y));
    const double width = block.width / across;
    const double height = block.height / down;
    const double texels = std::ldexp(1.0, f_.level);  // of level 0
    for (int y = 0; y < down && visitsLeft_ >= 0; ++y) {
        for (int x = 0; x < across; ++x) {
            const double u = block.u + (x + 0.5) * width - 0.5 * block.width;
            const double v = block.v + (y + 0.5) * height - 0.5 * block.height;
            const glm::dvec2 at = (f_.centre + glm::dvec2(u, v)) * texels;
            addPiece(block, u, v, width, height, kernel_.plain_.levels().bilinear(0, at, kernel_.plain_.address()));
        }
    }
}

void SurfacePieces::addPiece(const Block& block, double u, double v, double width, double height, Color color) {
    --visitsLeft_;
    const HeightField& field = kernel_.field_;
    const glm::dvec2 place = (f_.centre + glm::dvec2(u, v)) * toField_;
    const double h = field.at(place.x, place.y);
    double area = 1;
    if (columns_) {
        if (area_ && block.level == 0) addWalls(block, place, h);
    } else if (area_) {
        const glm::dvec2 half = 0.5 * glm::dvec2(width, height) * toField_;
        const double hs = (field.at(place.x + half.x, place.y) - field.at(place.x - half.x, place.y)) / (2 * half.x);
        const double ht = (field.at(place.x, place.y + half.y) - field.at(place.x, place.y - half.y)) / (2 * half.y);
        area = 1 + seen_.ray.a * hs + seen_.ray.b * ht;
        if (!(area > 0)) return;  // turned away from the viewer
    }
    push(block, u, v, color, width * height * area, {place, h});
}

// Adds the walls of the column on the sides that face the viewer.
void SurfacePieces::addWalls(const Block& block, glm::dvec2 place, double h) {
    const HeightField& field = kernel_.field_;
    const Color color = kernel_.plain_.levels().level(0)(block.i, block.j);
    // Just in front of the wall, outside this column.
    constexpr double kFront = 1e-7;
    for (const bool acrossS : {true, false}) {
        const double run = acrossS ? seen_.ray.a : seen_.ray.b;
        if (run == 0) continue;
        const double side = run > 0 ? -1 : 1;
        const double half = 0.5 * (acrossS ? block.width * toField_.x : block.height * toField_.y);
        glm::dvec2 at = place;
        (acrossS ? at.x : at.y) += side * (half + kFront);
        const double foot = field.at(at.x, at.y);
        if (!(foot < h) || kernel_.outside(at)) continue;
        const int count =
            static_cast<int>(std::clamp(std::ceil((h - foot) * runPixels_ / kLargestSpread), 1.0, double(mostParts_)));
        visitsLeft_ -= count;
        // Area of a part of the wall in the pixel: its length times the run of the ray over its height, in texels of
        // the level.
        const double area =
            (h - foot) / count * std::abs(run) * (acrossS ? block.height / toField_.x : block.width / toField_.y);
        const glm::dvec2 local = at / toField_ - f_.centre;
        for (int n = 0; n < count; ++n) {
            push(block, local.x, local.y, color, area, {at, foot + (h - foot) * (n + 0.5) / count});
        }
    }
}

void SurfacePieces::push(const Block& block, double u, double v, Color color, double share, glm::dvec3 point) {
    VisibleKernel::Piece piece;
    piece.h = point.z;
    piece.du = u + (piece.h - h0_) * run_.x;
    piece.dv = v + (piece.h - h0_) * run_.y;
    if (!f_.ellipse.contains(piece.du, piece.dv, f_.radius)) return;
    piece.texel = {block.i, block.j, block.level, u + f_.centre.x, v + f_.centre.y};
    piece.color = color;
    piece.share = share;
    piece.s = point.x;
    piece.t = point.y;
    pieces_->push_back(piece);
}

}  // namespace relief
