#include "panes/footprint/footprint_drawing.h"

#include <algorithm>
#include <cmath>

#include "painting/chart.h"
#include "painting/view_map.h"
#include "rendering/display.h"

namespace reliefui {

namespace {

using relief::FootprintKind;
using relief::FootprintTexel;
using relief::LevelAxis;

// Margin around the footprint, as a share of its larger side; below it a minimum in texels.
constexpr double kAround = 0.18;
constexpr double kLeastAround = 1.5;
// Largest side of the window, in texels; more could not be distinguished on any screen.
constexpr double kLongestWindow = 4096;
// Diameter of the largest dot, as a share of a texel's side.
constexpr double kLargestDot = 0.92;
// In points; smaller dots and texels are not drawn.
constexpr double kSmallestDot = 0.5;
constexpr double kSmallestTexel = 4;
constexpr std::size_t kMostDots = 3000;
constexpr std::size_t kMostLines = 250;

// A run of uniformly spaced texels along a row or column: part of one periodic copy, or beyond the border.
struct Run {
    double start = 0;  // start of the first texel
    int first = 0;
    int count = 0;
    bool rim = false;  // beyond the border: the same texel repeated
    double end = 0;    // end of the periodic copy, which may cut off the last texel
};

std::vector<Run> runsOf(const LevelAxis& axis, double low, double high) {
    std::vector<Run> runs;
    const auto inside = [&](double base) {
        const int from = static_cast<int>(std::clamp(std::floor(low - base), 0.0, double(axis.size)));
        const int to = static_cast<int>(std::clamp(std::ceil(high - base), 0.0, double(axis.size)));
        if (from < to) runs.push_back({base + from, from, to - from, false, base + axis.extent});
    };
    if (axis.address == relief::Address::Repeat) {
        for (double k = std::floor(low / axis.extent); k * axis.extent < high; k += 1) inside(k * axis.extent);
        return runs;
    }
    const auto rim = [&](double from, double to, int texel) {
        if (from < to) runs.push_back({from, texel, static_cast<int>(std::ceil(to - from)), true, to});
    };
    rim(std::floor(low), std::min(0.0, high), 0);
    inside(0);
    rim(std::max(axis.extent, axis.extent + std::floor(low - axis.extent)), high, axis.size - 1);
    return runs;
}

// Colours of the texels of two runs, as encoded values of ColorMap::Picture.
std::shared_ptr<const relief::FloatImage> codes(const relief::ColorImage& colors, const Run& across, const Run& down) {
    auto image = std::make_shared<relief::FloatImage>(across.count, down.count);
    std::vector<relief::Color> row(static_cast<std::size_t>(across.count));
    std::vector<std::uint32_t> packed(row.size());
    for (int y = 0; y < down.count; ++y) {
        for (int x = 0; x < across.count; ++x) {
            row[static_cast<std::size_t>(x)] =
                colors(across.first + (across.rim ? 0 : x), down.first + (down.rim ? 0 : y));
        }
        relief::toSrgb32(row, packed);
        for (int x = 0; x < across.count; ++x) {
            (*image)(x, y) = static_cast<float>(packed[static_cast<std::size_t>(x)] & 0xFFFFFFU);
        }
    }
    return image;
}

Box circleBox(const relief::Jacobian& j, double radius, Point centre) {
    const double u = radius * std::hypot(j.ux, j.uy);
    const double v = radius * std::hypot(j.vx, j.vy);
    return {centre.x - u, centre.y - v, centre.x + u, centre.y + v};
}

Point pointOf(glm::dvec2 p) {
    return {p.x, p.y};
}

bool isEllipse(const PixelFootprint& f) {
    return f.log.footprint.kind == FootprintKind::Ellipse && f.listed;
}

// Bounding box of everything that must be visible, without a margin.
Box extentOf(const PixelFootprint& f) {
    // Hidden texels and their occluders are included if they are no farther away than this multiple of the ellipse's
    // size.
    constexpr double kHiddenReach = 1;
    const Point centre = pointOf(f.centre());
    Box box{centre.x - 0.5, centre.y - 0.5, centre.x + 0.5, centre.y + 0.5};
    if (f.bounded) box = box.joined(circleBox(f.seen, 1, centre));
    if (isEllipse(f)) box = box.joined(circleBox(f.log.footprint.widened, f.log.footprint.radius, centre));
    const auto add = [&](const FootprintTexel& texel) {
        const double half = f.sideOf(texel) / 2;
        box = box.joined({texel.u - half, texel.v - half, texel.u + half, texel.v + half});
    };
    for (const FootprintTexel& texel : f.log.texels) {
        if (!texel.hidden) add(texel);
    }
    const Box near = box.grown(kHiddenReach * std::max(box.width(), box.height()));
    for (const FootprintTexel& texel : f.log.texels) {
        if (!texel.hidden || !near.contains({texel.u, texel.v})) continue;
        add(texel);
        const Point blocker = blockerPlace(f, texel);
        if (near.contains(blocker)) box = box.joined({blocker.x, blocker.y, blocker.x, blocker.y});
    }
    return box;
}

// Image of the circle of `radius` pixels under the Jacobian.
Polyline circleLine(const relief::Jacobian& j, double radius, Point centre) {
    return {ellipseLine(centre, {radius * j.ux, radius * j.vx}, {radius * j.uy, radius * j.vy})};
}

class Marks {
  public:
    Marks(const PixelFootprint& footprint, const FootprintOptions& options, const Box& seen, double scale)
        : f_(footprint), options_(options), seen_(seen), scale_(scale), centre_(pointOf(footprint.centre())) {}

    FootprintMarks take(std::optional<std::size_t> chosen) {
        neighbours();
        texels();
        rays();
        outlines();
        if (chosen && *chosen < f_.log.texels.size()) highlight(f_.log.texels[*chosen]);
        numbers();
        return std::move(out_);
    }

  private:
    void add(Role role, Primitive primitive, Emphasis emphasis = Emphasis::Normal) {
        out_.drawing.add({}, role, std::move(primitive), emphasis);
    }
    Box boxOf(const FootprintTexel& t) const {
        const double half = f_.sideOf(t) / 2;
        return {t.u - half, t.v - half, t.u + half, t.v + half};
    }

    void neighbours() {
        if (options_.neighbours == 0) return;
        const double shrink = std::ldexp(1.0, -f_.level());
        for (const PixelCircle& circle : f_.neighbours) {
            if (options_.neighbours == 4 && !circle.sharesSide) continue;
            const relief::Jacobian& j = circle.jacobian;
            Point at{circle.centre.x * shrink, circle.centre.y * shrink};
            if (f_.across.address == relief::Address::Repeat) {
                // Moved to the periodic copy in which the pixel's own footprint lies.
                at.x += std::round((centre_.x - at.x) / f_.across.extent) * f_.across.extent;
                at.y += std::round((centre_.y - at.y) / f_.down.extent) * f_.down.extent;
            }
            add(Role::Neighbour,
                circleLine({j.ux * shrink, j.vx * shrink, j.uy * shrink, j.vy * shrink}, circle.radius, at));
        }
    }

    void outlines() {
        const relief::LevelFootprint& f = f_.log.footprint;
        if (f_.bounded) {
            const relief::SemiAxes<double> axes = relief::ellipseOf(f_.seen).semiAxes();
            const auto axis = [&](double length, double u, double v) {
                add(Role::PixelCircle, Polyline{{{centre_.x - length * u, centre_.y - length * v},
                                                 {centre_.x + length * u, centre_.y + length * v}},
                                                false});
            };
            axis(axes.major, axes.majorU, axes.majorV);
            axis(axes.minor, -axes.majorV, axes.majorU);
            add(Role::PixelCircle, circleLine(f_.seen, 1, centre_));
        }
        if (isEllipse(f_)) {
            const Box b = circleBox(f.widened, f.radius, centre_);
            add(Role::Frame, Polyline{{{b.x0, b.y0}, {b.x1, b.y0}, {b.x1, b.y1}, {b.x0, b.y1}, {b.x0, b.y0}}, false},
                Emphasis::Strong);
            add(Role::Footprint, circleLine(f.widened, f.radius, centre_));
        }
        add(Role::Hit, Marker{centre_, Shape::Dot, 4});
    }

    void texels() {
        std::vector<const FootprintTexel*> seen;
        std::size_t hidden = 0;
        for (const FootprintTexel& t : f_.log.texels) {
            const bool large = f_.sideOf(t) * scale_ >= kSmallestTexel || f_.sideOf(t) < 1;
            if (!large || !boxOf(t).overlaps(seen_)) continue;
            seen.push_back(&t);
            hidden += t.hidden ? 1 : 0;
        }
        const bool none = scale_ < kSmallestTexel || seen.size() > kMostDots;
        out_.weights = f_.log.texels.empty() || !none;
        if (!out_.weights) return;
        for (const FootprintTexel* t : seen) {
            // Texels of other levels get an outline of their own.
            if (f_.sideOf(*t) != 1) add(Role::Neighbour, Rectangle{boxOf(*t), false, 0.4, 0}, Emphasis::Faint);
        }
        if (hidden <= kMostLines) {
            for (const FootprintTexel* t : seen) {
                if (t->hidden) sightLine(*t, Emphasis::Faint);
            }
        }
        for (const FootprintTexel* t : seen) dot(*t);
    }

    // Hits of the samples' rays; the area of a mark is proportional to the ray's share of the pixel.
    void rays() {
        constexpr double kLargest = 6;  // in points
        if (f_.rays.size() > kMostDots) return;
        double greatest = 0;
        for (const RayHit& ray : f_.rays) greatest = std::max(greatest, ray.share);
        for (const RayHit& ray : f_.rays) {
            const double size = kLargest * std::sqrt(ray.share / greatest);
            if (size >= kSmallestDot) add(Role::Sample, Marker{pointOf(ray.at), Shape::Dot, size});
        }
    }

    // Indices of the level's texels, along the upper and left sides of the visible part.
    void numbers() {
        constexpr double kAcross = 60;  // between numbers, in points
        constexpr double kDown = 30;
        // half the height of a number with its margin; numbers that would be cut off at the bottom are omitted
        constexpr double kHalf = 6;
        const double unit = 1 / scale_;
        const auto along = [&](double low, double high, double apart, const LevelAxis& axis, const auto& place) {
            if (!(high > low)) return;
            const int step =
                static_cast<int>(std::max(1.0, chart::niceStep(high - low, (high - low) * scale_ / apart)));
            for (const Run& run : runsOf(axis, low, high)) {
                for (int n = 0; n < run.count && !run.rim; ++n) {
                    const double at = run.start + n + 0.5;
                    if ((run.first + n) % step != 0 || at < low || at > high) continue;
                    Label label{
                        .text = plainText(std::to_string(run.first + n)), .size = 0.8, .plate = true, .yields = true};
                    place(label, at);
                    add(Role::Background, std::move(label));
                }
            }
        };
        along(seen_.x0 + kAcross / 2 * unit, seen_.x1, kAcross, f_.across, [&](Label& label, double at) {
            label.at = {at, seen_.y0};
            label.anchor = Anchor::Top;
            label.offset = {0, 3};
        });
        along(seen_.y0 + 2 * kDown / 3 * unit, seen_.y1 - kHalf * unit, kDown, f_.down, [&](Label& label, double at) {
            label.at = {seen_.x0, at};
            label.anchor = Anchor::Left;
            label.offset = {4, 0};
        });
    }

    void sightLine(const FootprintTexel& t, Emphasis emphasis) {
        const Point to = blockerPlace(f_, t);
        add(Role::Blocker, Polyline{{{t.u, t.v}, to}, false}, emphasis);
        add(Role::Blocker, Marker{to, Shape::Diamond, emphasis == Emphasis::Faint ? 4.0 : 8.0});
    }

    void dot(const FootprintTexel& t) {
        const double weight = PixelFootprint::weightOf(t);
        const double share = std::min(1.0, weight / std::max(f_.greatest, 1e-300));
        const double radius = 0.5 * kLargestDot * std::sqrt(share);
        const bool drawn = radius * scale_ >= kSmallestDot;
        if (!t.hidden) {
            if (drawn) add(Role::Weight, Circle{{t.u, t.v}, radius, true, true}, Emphasis::Strong);
            return;
        }
        if (drawn) add(Role::Hidden, Circle{{t.u, t.v}, radius, false}, Emphasis::Faint);
        const double arm = 0.38 * std::min(1.0, f_.sideOf(t));
        add(Role::Hidden, Polyline{{{t.u - arm, t.v - arm}, {t.u + arm, t.v + arm}}, false});
        add(Role::Hidden, Polyline{{{t.u - arm, t.v + arm}, {t.u + arm, t.v - arm}}, false});
    }

    void highlight(const FootprintTexel& t) {
        if (t.hidden) sightLine(t, Emphasis::Strong);
        add(Role::Highlight, Rectangle{boxOf(t), false, 0, 6});
    }

    const PixelFootprint& f_;
    const FootprintOptions& options_;
    Box seen_;
    double scale_;
    Point centre_;
    FootprintMarks out_;
};

}  // namespace

Drawing footprintTexture(const PixelFootprint& f, double aspect, double beyond) {
    Box box = extentOf(f);
    box = box.grown(std::max(kLeastAround, kAround * std::max(box.width(), box.height())));
    const Point middle = box.center();
    const double width = std::min(std::max(box.width(), box.height() * aspect), kLongestWindow);
    const double height = std::min(std::max(box.height(), width / aspect), kLongestWindow);
    const auto around = [&](double times) {
        const double w = std::min(width * times, kLongestWindow) / 2;
        const double h = std::min(height * times, kLongestWindow) / 2;
        return Box{middle.x - w, middle.y - h, middle.x + w, middle.y + h};
    };
    Drawing texture;
    texture.bounds = around(1);
    const Box window = around(1 + 2 * beyond);
    const std::vector<Run> columns = runsOf(f.across, window.x0, window.x1);
    for (const Run& row : runsOf(f.down, window.y0, window.y1)) {
        for (const Run& column : columns) {
            Cells cells;
            cells.values = codes(*f.colors, column, row);
            cells.map = ColorMap::Picture;
            cells.x = column.start;
            cells.y = row.start;
            cells.clip = Box{column.start, row.start, column.start + column.count, row.start + row.count}
                             .cut({column.start, row.start, column.end, row.end})
                             .cut(window);
            cells.firstI = column.first;
            cells.firstJ = row.first;
            texture.add({ItemKind::Level, f.level(), 0, 0}, Role::HeightFill, std::move(cells));
        }
    }
    if (beyond == 0) texture.add({}, Role::Frame, Rectangle{window, false, -0.5, 0});
    return texture;
}

FootprintMarks footprintMarks(const PixelFootprint& footprint, const FootprintOptions& options, const Box& seen,
                              double pointsPerTexel, std::optional<std::size_t> chosen) {
    return Marks(footprint, options, seen, pointsPerTexel).take(chosen);
}

std::optional<std::size_t> footprintTexelAt(const PixelFootprint& f, Point at) {
    std::optional<std::size_t> found;
    for (std::size_t n = 0; n < f.log.texels.size(); ++n) {
        const FootprintTexel& t = f.log.texels[n];
        const double half = f.sideOf(t) / 2;
        if (std::abs(at.x - t.u) > half || std::abs(at.y - t.v) > half) continue;
        if (!found || f.sideOf(t) < f.sideOf(f.log.texels[*found])) found = n;
    }
    return found;
}

const RayHit* footprintRayAt(const PixelFootprint& f, Point at, double reach) {
    const RayHit* nearest = nullptr;
    for (const RayHit& ray : f.rays) {
        const double away = std::hypot(ray.at.x - at.x, ray.at.y - at.y);
        if (away > reach) continue;
        nearest = &ray;
        reach = away;
    }
    return nearest;
}

Point blockerPlace(const PixelFootprint& f, const FootprintTexel& texel) {
    return {texel.blocker.x * f.perHeight.x, texel.blocker.y * f.perHeight.y};
}

}  // namespace reliefui
