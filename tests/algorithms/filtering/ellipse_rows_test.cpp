// Footprints computed along rows (ellipse_rows.h) against those from each pixel's own Jacobian, on rendered scenes.
#include "filtering/ellipse_rows.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "algorithms/relief/fields.h"
#include "filter_cases.h"
#include "filtering/methods/elliptical_filter.h"
#include "rendering/ellipse_error.h"

namespace relief::test {
namespace {

constexpr std::uint64_t kSeed = 31;
constexpr EllipseForm kForms[] = {EllipseForm::Iterative, EllipseForm::Cached};

std::string nameOf(EllipseForm form) {
    return form == EllipseForm::Iterative ? "iterative" : form == EllipseForm::Cached ? "cached" : "direct";
}

FrameRequest request(SceneKind scene, double elevation) {
    FrameRequest request(HeightField(share(makeRelief("bricks", 64, 48, 1)), Surface::Bilinear, Address::Repeat, 0.1));
    request.width = 93;  // not a multiple of the anchor spacing or of a tile
    request.height = 70;
    request.scene = scene;
    request.camera.elevation = elevation;
    request.camera.azimuth = 25;
    request.color = randomPicture(128, 80, kSeed);
    request.light.ambient = request.light.intensity = 1;
    request.filter.name = "elliptical";
    return request;
}

// A rendered frame and the filter queries of all its hits, row by row.
struct FrameQueries {
    explicit FrameQueries(const FrameRequest& wanted) : FrameQueries(wanted, 1) {}
    FrameQueries(const FrameRequest& wanted, int threads) : request(wanted) {
        Work work(threads);
        frame = FrameRenderer(std::make_shared<MapCache>()).render(request, work);
        visible = frame->visible(request);
        for (int y = 0; y < request.height; ++y) {
            for (int x = 0; x < request.width; ++x) {
                if (const auto query = filterQuery(*frame, request, visible, x, y)) block.push(*query);
            }
        }
    }
    FrameRequest request;
    std::shared_ptr<const Frame> frame;
    VisiblePolygons visible;
    FilterBlock block;
};

std::vector<FrameRequest> views() {
    std::vector<FrameRequest> all;
    for (const double elevation : {70.0, 25.0, 5.0, 2.0}) all.push_back(request(SceneKind::Floor, elevation));
    for (const double elevation : {60.0, 10.0}) all.push_back(request(SceneKind::Cube, elevation));
    for (const double elevation : {40.0, 5.0}) all.push_back(request(SceneKind::Wall, elevation));
    return all;
}

MadeFilter filterOf(const FrameRequest& request, OptionValues options) {
    return {{"elliptical", std::move(options)}, request.color, request.field};
}

std::vector<Color> colorsOf(const TextureFilter& filter, const FilterBlock& block, FootprintCounts& counts) {
    Work work(1);
    std::vector<Color> colors(block.size());
    filter.colors(block, colors, counts, work);
    return colors;
}

// Relative errors of the semi-axes.
struct Tolerance {
    double major, minor;
};

// Derived bound. u = 2^-24 is the unit roundoff of float. A pixel's q and its a, b, c, d are each sums of two or three
// terms, with an error of at most 4 u times the sum of the terms' magnitudes. The iterative form adds up to 15 more
// steps, each with one rounding, and accumulates the rounding of its increments. Since J = N / q^2, the relative error
// of the semi-axes is twice that of q plus that of the norm of N: relative to the major axis or, where the minor axis
// is computed from the difference a d - b c (iterative), relative to the minor axis. The cached F' = det^2 / q^2
// contains no difference, only q a third time. 16 u covers the remaining operations.
Tolerance toleranceOf(EllipseForm form, const PixelView& view, int x, int y) {
    const double u = std::ldexp(1, -24), k = form == EllipseForm::Iterative ? 4 + 2 * 15 : 4;
    const Homography& m = view.texelFromScreen;
    const double px = x + 0.5, py = y + 0.5, q = m.denominator(px, py);
    const double inQ = 2 * k * u * (std::abs(m.qx * px) + std::abs(m.qy * py) + std::abs(m.q1)) / q;
    const auto terms = [](double at, double per, double constant) { return std::abs(at * per) + std::abs(constant); };
    double norm = 0;
    for (const double sum : {terms(py, m.sx * m.qy - m.sy * m.qx, m.sx * m.q1 - m.s1 * m.qx),
                             terms(py, m.tx * m.qy - m.ty * m.qx, m.tx * m.q1 - m.t1 * m.qx),
                             terms(px, m.sy * m.qx - m.sx * m.qy, m.sy * m.q1 - m.s1 * m.qy),
                             terms(px, m.ty * m.qx - m.tx * m.qy, m.ty * m.q1 - m.t1 * m.qy)}) {
        norm = std::hypot(norm, sum);
    }
    const SemiAxes<double> axes = ellipseOf(jacobianAt(m, px, py)).semiAxes();
    const double inN = k * u * norm / (q * q) / axes.major + 16 * u;
    return {inN + inQ, form == EllipseForm::Iterative ? inN * axes.major / axes.minor + inQ : inN + 2.5 * inQ};
}

// Checks every pixel of the block against its tolerance, for all forms.
void expectNearDirect(const FilterBlock& block) {
    for (const EllipseForm form : kForms) {
        SCOPED_TRACE(nameOf(form));
        FilterBlock rows;
        ellipseRows(form, block, rows);
        std::size_t moved = 0;
        double most = 0, share = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const SemiAxes<double> is = ellipseOf(rows[i].jacobian).semiAxes();
            const SemiAxes<double> direct = ellipseOf(block[i].jacobian).semiAxes();
            const double major = std::abs(is.major / direct.major - 1), minor = std::abs(is.minor / direct.minor - 1);
            const Tolerance allowed = toleranceOf(form, *block.view[i], block.x[i], block.y[i]);
            ASSERT_LE(major, allowed.major) << block.x[i] << ' ' << block.y[i];
            ASSERT_LE(minor, allowed.minor) << block.x[i] << ' ' << block.y[i];
            moved += major > 0 ? 1 : 0;
            most = std::max({most, major, minor});
            share = std::max({share, major / allowed.major, minor / allowed.minor});
        }
        // Most values differ, so the form itself was used and not the direct one; the tolerance is not far too large;
        // the reported difference is the largest one found.
        EXPECT_GT(moved, rows.size() / 2);
        EXPECT_GT(share, 0.01);
        EXPECT_EQ(largestAxisDifference(rows, block), most);
    }
}

TEST(EllipseRows, SemiAxesAreWithinTheirRoundingOfDirect) {
    for (const FrameRequest& request : views()) {
        SCOPED_TRACE("elevation " + std::to_string(request.camera.elevation));
        const FrameQueries queries(request);
        ASSERT_GT(queries.block.size(), 50U);
        expectNearDirect(queries.block);
    }
}

// An infinite plane whose horizon crosses the picture at an angle: q from 2 down to 1e-4.
TEST(EllipseRows, AndUpToTheHorizon) {
    PixelView view;
    view.texelFromScreen = Homography{30, 2, -900, 1, 11, 300, 0.002, 0.03, -0.8}.normalised();
    FilterBlock block;
    double least = 1;
    for (int y = 0; y < 70; ++y) {
        for (int x = 0; x < 93; ++x) {
            const double q = view.texelFromScreen.denominator(x + 0.5, y + 0.5);
            if (q < 1e-4) continue;
            least = std::min(least, q);
            FilterQuery query;
            query.jacobian = jacobianAt(view.texelFromScreen, x + 0.5, y + 0.5);
            query.view = &view;
            query.x = x, query.y = y;
            block.push(query);
        }
    }
    ASSERT_LT(least, 2e-3);
    expectNearDirect(block);
}

// The whole ellipse agrees, not only the lengths of its axes: the quadratic forms are compared.
TEST(EllipseRows, DirectionsAreThoseOfDirect) {
    for (const FrameRequest& request : views()) {
        const FrameQueries queries(request);
        for (const EllipseForm form : kForms) {
            FilterBlock rows;
            ellipseRows(form, queries.block, rows);
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const Ellipse is = ellipseOf(rows[i].jacobian), direct = ellipseOf(queries.block[i].jacobian);
                const Tolerance most =
                    toleranceOf(form, *queries.block.view[i], queries.block.x[i], queries.block.y[i]);
                const double apart = std::hypot(is.a - direct.a, (is.b - direct.b) / 2, is.c - direct.c);
                ASSERT_LE(apart, 4 * most.major * (direct.a + direct.c)) << nameOf(form) << ' ' << i;
            }
        }
    }
}

TEST(EllipseRows, DirectIsTheKernelWithItsUsualOptions) {
    for (const char* implementation : {"lanes", "scalar"}) {
        const FrameQueries queries(request(SceneKind::Cube, 20));
        EllipticalOptions usual;
        usual.implementation = implementation;
        Work work(1);
        FilterTools tools{queries.request.color, std::make_shared<const ColorLevels>(queries.request.color, work),
                          queries.request.field};
        std::vector<Color> expected(queries.block.size());
        FootprintCounts counts;
        ellipticalKernel(usual, tools, work).filter(queries.block, tools.pictureScale(), expected, counts);
        for (const OptionValues& options : {OptionValues{}, OptionValues{{"ellipse", "direct"}}}) {
            OptionValues all = options;
            all["implementation"] = implementation;
            MadeFilter made = filterOf(queries.request, all);
            EXPECT_EQ(colorsOf(*made.filter, queries.block, made.counts), expected);
            for (std::size_t i = 0; i < expected.size(); i += 7) ASSERT_EQ(made.at(queries.block[i]), expected[i]);
        }
    }
}

// Blocks of any size, in any order, and single pixels.
TEST(EllipseRows, ColoursDependOnNoNeighbour) {
    const FrameQueries queries(request(SceneKind::Cube, 20));
    const std::size_t count = queries.block.size();
    for (const EllipseForm form : kForms) {
        MadeFilter made = filterOf(queries.request, {{"ellipse", nameOf(form)}});
        const auto expected = colorsOf(*made.filter, queries.block, made.counts);
        EXPECT_NE(expected, colorsOf(*filterOf(queries.request, {}).filter, queries.block, made.counts));
        std::vector<std::size_t> order(count);
        for (std::size_t i = 0; i < count; ++i) order[i] = i;
        Random random(kSeed);
        for (const std::size_t size : {count, std::size_t{211}, std::size_t{16}, std::size_t{1}}) {
            for (std::size_t first = 0; first < count; first += size) {
                FilterBlock part;
                for (std::size_t i = first; i < std::min(first + size, count); ++i) part.push(queries.block[order[i]]);
                const auto colors = colorsOf(*made.filter, part, made.counts);
                for (std::size_t i = 0; i < part.size(); ++i) ASSERT_EQ(colors[i], expected[order[first + i]]) << size;
            }
            for (std::size_t i = count; i > 1; --i) {
                std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
            }
        }
        for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(made.at(queries.block[i]), expected[i]) << i;
    }
}

// Pictures depend neither on the number of threads nor on earlier frames: the option is part of the key by which a
// frame's colours are reused.
TEST(EllipseRows, PicturesAreTheirPixels) {
    for (const EllipseForm form : kForms) {
        FrameRequest rows = request(SceneKind::Cube, 20);
        const FrameRequest direct = rows;
        rows.filter.options["ellipse"] = nameOf(form);
        const FrameQueries one(rows, 1), two(rows, 2);
        EXPECT_EQ(one.frame->color->color, two.frame->color->color);
        Work work(1);
        FilterBlock own;
        ellipseRows(form, one.block, own);
        const double off = ellipseError(*one.frame, rows, work);
        EXPECT_EQ(off, largestAxisDifference(own, one.block));
        EXPECT_GT(off, 0);
        EXPECT_EQ(ellipseError(*one.frame, direct, work), 0);
        MadeFilter made = filterOf(rows, rows.filter.options);
        for (std::size_t i = 0; i < one.block.size(); ++i) {
            ASSERT_EQ(made.at(one.block[i]), one.frame->color->color(one.block.x[i], one.block.y[i])) << i;
        }

        FrameRenderer kept(std::make_shared<MapCache>());
        const auto before = kept.render(direct, work);
        const auto after = kept.render(rows, work);
        EXPECT_EQ(after->hits, before->hits);
        EXPECT_EQ(after->color->color, one.frame->color->color);
        EXPECT_EQ(kept.render(direct, work)->color->color, before->color->color);
    }
}

// Where the ellipse cannot be represented in float, the pixel's own is used, with the same bits.
TEST(EllipseRows, WithoutAnEllipseTheDirectOne) {
    const double nan = std::nan(""), huge = 1e300;
    std::vector<PixelView> none(7);
    none[0].texelFromScreen = {1, 2, 3, 2, 4, 6, 0.001, 0, 1};         // edge-on: t = 2 s
    none[1].texelFromScreen = {1, 2, 3, 2, 4 + 1e-7, 6, 0.001, 0, 1};  // nearly edge-on
    none[2].texelFromScreen = {0, 0, 3, 0, 0, 5, 0, 0, 1};             // a point
    none[3].texelFromScreen = {1, 0, 0, 0, 1, 0, 0, 1, -20.5};         // q = 0 in row 20
    none[4].texelFromScreen = {nan, 0, 0, 0, 1, 0, 0, 0, 1};
    none[5].texelFromScreen = {huge, 0, 0, 0, 1, 0, 0, 0, 1};
    none[6].texelFromScreen = {1e-30, 0, 0, 0, 1e-30, 0, 0, 0, 1};  // F underflows
    FilterBlock block;
    Random random(kSeed);
    for (int i = 0; i < 400; ++i) {
        FilterQuery query;
        query.place = {random.between(0, 64), random.between(0, 48)};
        query.jacobian = randomJacobian(random);
        query.view = i % 8 == 7 ? nullptr : &none[static_cast<std::size_t>(i % 8)];
        query.x = i / 8 * (i % 3), query.y = 20;
        query.lambda = i % 5 == 0 ? nan : 0.5;
        query.spread = 0.1;
        block.push(query);
    }
    const FrameRequest with = request(SceneKind::Floor, 30);
    MadeFilter direct = filterOf(with, {});
    const auto expected = colorsOf(*direct.filter, block, direct.counts);
    for (const EllipseForm form : kForms) {
        MadeFilter made = filterOf(with, {{"ellipse", nameOf(form)}});
        EXPECT_EQ(colorsOf(*made.filter, block, made.counts), expected) << nameOf(form);
        for (std::size_t i = 0; i < block.size(); ++i) ASSERT_EQ(made.at(block[i]), expected[i]) << i;
    }
}

// The parallax of a hit scales the footprint; a missing hit must not scale it by NaN.
TEST(EllipseRows, DeeperHitsHaveWiderFootprints) {
    PixelView view;
    view.texelFromScreen = {2, 0.25, 0, 0.5, 3, 0, 0, 0, 1};
    for (const EllipseForm form : kForms) {
        FilterBlock block, rows;
        for (const double lambda : {0.0, 0.5, 1.0}) {
            FilterQuery query;
            const double scale = 1 + lambda * 0.5;
            query.jacobian = {2 * scale, 0.5 * scale, 0.25 * scale, 3 * scale};
            query.lambda = lambda, query.spread = 0.5;
            query.view = &view;
            block.push(query);
        }
        ellipseRows(form, block, rows);
        EXPECT_LE(largestAxisDifference(rows, block), 4 * std::numeric_limits<float>::epsilon()) << nameOf(form);
    }
}

// Filters that need more than the ellipse refuse the option.
TEST(EllipseRows, RefusedWhereThePixelsOrientationCounts) {
    const FrameRequest with = request(SceneKind::Floor, 30);
    for (const char* weights : {"box", "lcd", "crt"}) {
        EXPECT_THROW(filterOf(with, {{"ellipse", "cached"}, {"weights", weights}}), InputError) << weights;
        EXPECT_NO_THROW(filterOf(with, {{"ellipse", "iterative"}, {"weights", weights}})) << weights;
    }
    EXPECT_THROW(parseFilter("elliptical:ellipse=cached:weights=box", "--filter"), InputError);
    EXPECT_THROW(parseFilter("elliptical-visible:ellipse=cached", "--filter"), InputError);
    EXPECT_THROW(parseFilter("elliptical:ellipse=round", "--filter"), InputError);
}

}  // namespace
}  // namespace relief::test
