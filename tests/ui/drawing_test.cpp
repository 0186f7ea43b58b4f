// Drawings as data, and their rendering by QPainter.
#include <algorithm>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <QSvgGenerator>
#include <QSvgRenderer>

#include "painting/legend_rows.h"
#include "painting/painter.h"
#include "painting/table_drawing.h"
#include "panes/pyramid/pyramid_drawing.h"
#include "panes/ray_geometry.h"
#include "relief/files.h"
#include "relief/maps/max_pyramid_map.h"
#include "relief/reliefs.h"
#include "relief/tracers.h"

namespace reliefui {
namespace {

using relief::Address;
using relief::Surface;

// A relief, its pyramid and a traced ray.
struct Traced {
    relief::Work work;
    relief::MapCache cache;
    relief::HeightField field;
    std::shared_ptr<const relief::MaxPyramidMap> map;
    relief::HitBlock hits;
    relief::StepLog log;
    relief::ViewRay ray;

    Traced(const char* recipe, int width, int height, Surface surface, Address address)
        : field(std::make_shared<const relief::FloatImage>(relief::makeRelief(recipe, width, height, 3)), surface,
                address),
          map(relief::maxPyramidMap(field, cache, work)) {}

    void trace(const relief::ViewRay& viewRay, const char* method = "max-pyramid") {
        ray = viewRay;
        relief::RayBlock rays;
        rays.push(ray);
        log = {};
        relief::makeTracer({method, {}}, field, cache, work)->trace(rays, hits, log, work);
    }
    PyramidSource source() const {
        PyramidSource s;
        s.field = &field;
        s.pyramid = {map, &map->pyramid};
        s.hasRay = true;
        s.ray = ray;
        s.hit = hits[0];
        s.steps = &log.steps;
        return s;
    }
};

// The basis of every pane: at the position that a step records, the ray is inside the step's texel.
TEST(RayGeometry, theRayIsInsideTheTexelOfEachStep) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const Surface surface : {Surface::Bilinear, Surface::Columns}) {
        for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
            Traced t("fractal", 37, 20, surface, address);
            for (int n = 0; n < 40; ++n) {
                const double far = address == Address::Repeat ? 500 : 0;
                t.trace({unit(random) * 37 + far, unit(random) * 20 - far, unit(random) * 160 - 80,
                         unit(random) * 160 - 80});
                const RayPath path(t.field, t.ray);
                for (const relief::Step& step : t.log.steps) {
                    if (step.decision == relief::Decision::Advance || step.lambdaOut <= step.lambdaIn) continue;
                    const Point middle = path.at((step.lambdaIn + step.lambdaOut) / 2);
                    EXPECT_TRUE(stepBox(t.field, step).grown(1e-6).contains(middle))
                        << relief::decisionName(step.decision) << " level " << step.level << " at " << middle.x << ","
                        << middle.y;
                }
            }
        }
    }
}

TEST(RayGeometry, wrappingKeepsLengthsAndAreas) {
    const Box domain{0.5, 0.5, 8.5, 4.5};
    const Segment segment{{1, 1}, {21, -12}};
    double length = 0;
    for (const Segment& piece : wrapped(segment, domain, true)) {
        EXPECT_TRUE(domain.grown(1e-9).contains(piece.first));
        EXPECT_TRUE(domain.grown(1e-9).contains(piece.second));
        length += std::hypot(piece.second.x - piece.first.x, piece.second.y - piece.first.y);
    }
    EXPECT_NEAR(length, std::hypot(20, 13), 1e-9);
    double area = 0;
    for (const Box& piece : wrapped(Box{-3, -2, 1, 2}, domain, true)) area += piece.width() * piece.height();
    EXPECT_NEAR(area, 16, 1e-9);
    EXPECT_TRUE(wrapped(Segment{{20, 20}, {30, 20}}, domain, false).empty());
    // The drawing of a ray through a million periods has a limited number of pieces.
    EXPECT_LT(wrapped(Segment{{0, 0}, {8e6, 3e6}}, domain, true).size(), 500u);
}

TEST(PyramidLayout, blocksStandApartInsideTheRoom) {
    for (const double width : {150.0, 400.0, 1200.0}) {
        for (const double height : {120.0, 300.0, 800.0}) {
            for (const int levels : {1, 2, 4, 9, 13}) {
                for (const double aspect : {0.01, 0.5, 1.0, 2.0, 300.0}) {
                    const auto blocks = pyramidLayout(levels, {0, 0, 100 * aspect, 100}, width, height);
                    ASSERT_EQ(blocks.size(), static_cast<std::size_t>(levels));
                    for (std::size_t k = 0; k < blocks.size(); ++k) {
                        const Box& box = blocks[k].box;
                        EXPECT_GT(box.height(), 0);
                        EXPECT_LE(box.x1, width + 1e-6);
                        EXPECT_LE(box.y1, height + 1e-6);
                        EXPECT_LE(box.height(), blocks[0].box.height() + 1e-9);
                        for (std::size_t m = k + 1; m < blocks.size(); ++m) {
                            EXPECT_FALSE(box.overlaps(blocks[m].box)) << k << " " << m;
                        }
                    }
                }
            }
        }
    }
}

TEST(PyramidDrawing, pickingAnswersWithTexelsAndSteps) {
    for (const Address address : {Address::Repeat, Address::Clamp, Address::Border}) {
        Traced t("paper8x8", 8, 8, Surface::Bilinear, address);
        t.trace({1.2, 5.1, 5, -2});
        const PyramidPicture picture = pyramidPicture(t.source(), 600, 400);
        const relief::CellGrid grid(t.field);
        const ViewMap map{2, 11, 7};
        for (const LevelBlock& block : picture.blocks) {
            const relief::FloatImage& level = t.map->pyramid.level(block.level);
            const double side = std::ldexp(1.0, block.level);
            for (int j = 0; j < level.height(); ++j) {
                for (int i = 0; i < level.width(); ++i) {
                    // 0.7: under border the first half of the outer cells is outside.
                    const Point texel{(i + 0.7) * side - grid.x.shift, (j + 0.7) * side - grid.y.shift};
                    if (!block.domain.contains(texel)) continue;
                    const ItemId id = pick(picture.levels, map, map.toScreen(block.toDrawing(texel)), 1);
                    const int first = block.level == 0 ? grid.x.firstName : 0;
                    EXPECT_EQ(idText(id), "texel/" + std::to_string(block.level) + "/" + std::to_string(i + first) +
                                              "/" + std::to_string(j + first));
                }
            }
        }
        const Drawing marks = pyramidMarks(t.source(), picture, 0);
        std::set<std::int64_t> found;
        for (const Item& item : marks.items) {
            if (item.id.kind == ItemKind::Step) found.insert(item.id.i);
        }
        EXPECT_EQ(found.size(), t.log.steps.size());
    }
}

// The first outline of a texel lies at its border; those of further decisions about it are nested in it.
TEST(PyramidDrawing, decisionsAboutOneTexelAreNested) {
    Traced t("paper8x8", 8, 8, Surface::Bilinear, Address::Repeat);
    t.trace({1.2, 5.1, 5, -2});
    const std::vector<relief::Step> steps(4, t.log.steps.front());
    PyramidSource source = t.source();
    source.steps = &steps;
    std::map<std::int64_t, double> insets;
    for (const Item& item : pyramidMarks(source, pyramidPicture(source, 600, 400), 3).items) {
        const auto* const box = std::get_if<Rectangle>(&item.primitive);
        if (box != nullptr && !box->fill && item.role == roleOf(steps[0].decision)) insets[item.id.i] = box->inset;
    }
    ASSERT_EQ(insets.size(), 4U);
    EXPECT_LT(insets[0], 1);
    for (std::int64_t k = 1; k < 4; ++k) EXPECT_GT(insets[k], insets[k - 1] + 1);
    // The ray ends at its hit, whatever the last step says.
    source.hit = relief::Hit::at(t.ray, 0.875);
    EXPECT_EQ(rayEnd(source), 0.875);
    source.hit = relief::Hit::none(relief::Outcome::Limit);
    EXPECT_EQ(rayEnd(source), std::clamp(steps.back().lambdaAfter, 0.0, 1.0));
}

TEST(PyramidDrawing, nearTheRayEveryStepIsInTheBlocks) {
    Traced t("bricks", 256, 128, Surface::Bilinear, Address::Repeat);
    t.trace({3.2, 60, -14, 9});  // through the seam at s = 0
    PyramidSource source = t.source();
    source.nearRay = true;
    const PyramidPicture picture = pyramidPicture(source, 600, 400);
    EXPECT_FALSE(picture.wraps);
    const RayPath path(t.field, t.ray);
    for (const LevelBlock& block : picture.blocks) {
        EXPECT_LT(block.domain.width(), 60);
        EXPECT_TRUE(block.domain.contains(path.at(0)));
        EXPECT_TRUE(block.domain.contains(path.at(source.hit.lambda)));
    }
    // Each block is completely covered by cells, also beyond the seam.
    double covered = 0;
    double blocks = 0;
    for (const LevelBlock& block : picture.blocks) blocks += block.box.width() * block.box.height();
    for (const Item& item : picture.levels.items) {
        if (const auto* cells = std::get_if<Cells>(&item.primitive)) {
            covered += cells->clip.width() * cells->clip.height();
        }
    }
    EXPECT_NEAR(covered, blocks, 1e-6 * blocks);
    // For a ray longer than the texture the whole texture is shown.
    t.trace({3.2, 60, 1e5, 9e4});
    source = t.source();
    source.hit = relief::Hit::none(relief::Outcome::Limit);
    source.steps = nullptr;
    source.nearRay = true;
    EXPECT_TRUE(pyramidPicture(source, 600, 400).wraps);
}

TEST(Painter, cellsHaveTheColoursOfTheirValues) {
    if (QCoreApplication::instance() == nullptr) GTEST_SKIP() << "no display, no fonts";
    Traced t("paper8x8", 8, 8, Surface::Columns, Address::Repeat);
    t.trace({1.2, 5.1, 5, -2});
    const PyramidPicture picture = pyramidPicture(t.source(), 600, 400);
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        for (const HeightColors heights : {HeightColors::Grey, HeightColors::Cividis}) {
            Style style;
            style.theme = theme;
            style.heights = heights;
            QImage image(700, 500, QImage::Format_RGB32);
            QPainter painter(&image);
            const ViewMap map{1, 10, 10};
            paint(painter, picture.levels, map, style, {0, 0, 700, 500});
            painter.end();
            for (const LevelBlock& block : picture.blocks) {
                const double side = std::ldexp(1.0, block.level);
                const relief::FloatImage& level = t.map->pyramid.level(block.level);
                const Point at = map.toScreen(block.toDrawing(Point{0.2 * side, 0.2 * side}));
                const Rgba expected = style.mapped(ColorMap::Height, static_cast<double>(level(0, 0)));
                const QColor seen = image.pixelColor(static_cast<int>(at.x), static_cast<int>(at.y));
                EXPECT_EQ(seen, QColor(expected.r, expected.g, expected.b)) << block.level;
            }
        }
    }
}

// The kept part of a long grid has the colours of the cells, near the grid's end and away from it.
TEST(Painter, keptCellsHaveTheColoursOfTheirValues) {
    constexpr int kLong = 4000000, kHigh = 1;
    auto values = std::make_shared<relief::FloatImage>(kLong, kHigh);
    for (int i = 0; i < 6000; ++i) (*values)(i, 0) = static_cast<float>(i * 7 % 64) / 63;
    Cells cells;
    cells.values = values;
    cells.clip = {0, 0, kLong, kHigh};
    const Style style;
    CellPictures kept;
    for (const int from : {2, 5000}) {
        QImage image(400, kHigh, QImage::Format_RGB32);
        QPainter painter(&image);
        kept.begin();
        kept.draw(painter, cells, {1, -1.0 * from, 0}, style, {0, 0, 400, kHigh});
        kept.end();
        painter.end();
        for (const int at : {0, 5, 17, 398}) {
            const Rgba expected = style.cell(cells.map, static_cast<double>((*values)(from + at, 0)), cells.scale);
            EXPECT_NEAR(image.pixelColor(at, 0).green(), expected.g, 1) << from << " + " << at;
        }
    }
}

// A cross has four arms, and a line is cut where it leaves the box.
TEST(Painter, marksAndLinesLieWhereTheyShould) {
    const Style style;
    const auto painted = [&](const Primitive& what) {
        Drawing drawing;
        drawing.add({}, Role::Hidden, what);
        QImage image(100, 100, QImage::Format_RGB32);
        image.fill(Qt::magenta);
        QPainter painter(&image);
        paint(painter, drawing, {}, style, {0, 0, 100, 100});
        painter.end();
        return image;
    };
    const auto inked = [](const QImage& image, int x, int y) { return image.pixelColor(x, y) != QColor(Qt::magenta); };
    const QImage cross = painted(Marker{{50, 50}, Shape::Cross, 60 / style.pixelsPerPoint()});
    for (const int x : {30, 70}) {
        for (const int y : {30, 70}) EXPECT_TRUE(inked(cross, x, y)) << x << ' ' << y;
        EXPECT_FALSE(inked(cross, x, 50) || inked(cross, 50, x)) << x;
    }
    const auto runs = clippedTo({{-10, 10}, {30, 50}, {30, 300}}, {0, 0, 100, 100});
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_EQ(runs[0], (std::vector<Point>{{0, 20}, {30, 50}, {30, 100}}));
}

// Qt would write a path without points, which is a fault in a PDF.
TEST(Painter, aLineWithoutLengthIsNotWritten) {
    const auto written = [](const Primitive& what) {
        Drawing drawing;
        drawing.add({}, Role::Ray, what);
        QByteArray bytes;
        QBuffer buffer(&bytes);
        QSvgGenerator svg;
        svg.setOutputDevice(&buffer);
        QPainter painter(&svg);
        paint(painter, drawing, {}, Style(), {0, 0, 100, 100});
        painter.end();
        return bytes.count("<p");
    };
    EXPECT_EQ(written(Polyline{{{50, 50}, {50, 50}, {50, 50.0001}}}), written(Polyline{}));
    EXPECT_GT(written(Polyline{{{50, 50}, {50, 51}}}), written(Polyline{}));
}

// More cells than are written one by one are an image, which Qt does not clip in SVG: it is cut at the plot's edge,
// also within a cell.
TEST(Painter, manyCellsStayInTheirPlotInSvg) {
    auto values = std::make_shared<relief::FloatImage>(100, 100);
    for (int j = 0; j < 100; ++j) {
        for (int i = 50; i < 100; ++i) (*values)(i, j) = 1;
    }
    Cells cells;
    cells.values = values;
    cells.clip = {10.25, 0, 90.5, 80};
    Drawing drawing;
    drawing.add({}, Role::HeightFill, cells);
    const Style style;
    QBuffer buffer;
    QSvgGenerator svg;
    svg.setOutputDevice(&buffer);
    svg.setViewBox(QRect(0, 0, 200, 200));
    QPainter painter(&svg);
    paint(painter, drawing, {2, 0, 0}, style, {0, 0, 200, 200});
    painter.end();
    constexpr int kCell = 8;  // pixels
    QImage image(100 * kCell, 100 * kCell, QImage::Format_RGB32);
    image.fill(Qt::magenta);
    QPainter drawn(&image);
    QSvgRenderer(buffer.data()).render(&drawn);
    drawn.end();
    const auto at = [&](double x, double y) {
        return image.pixelColor(static_cast<int>(x * kCell), static_cast<int>(y * kCell));
    };
    for (const auto& [x, y] : {std::pair(10.0, 40.0), {90.8, 40.0}, {50.0, 80.3}}) {
        EXPECT_EQ(at(x, y), QColor(Qt::magenta)) << x << ' ' << y;
    }
    for (const double x : {10.5, 49.5, 50.5, 90.2}) {
        const Rgba expected = style.cell(cells.map, x < 50 ? 0 : 1, cells.scale);
        EXPECT_NEAR(at(x, 79.7).green(), expected.g, 2) << x;
    }
}

// Numbers stand at the right of their column, words at the left; of the rows, only the chosen one is marked.
TEST(TableDrawing, columnsAreAlignedAndTheChosenRowIsMarked) {
    TableSource source;
    source.titles = {"step", "what"};
    source.numbers = {true, false};
    source.rows.resize(2);
    source.rows[0].cells = source.rows[1].cells = {"17", "down"};
    const auto marks = [&] {
        const Drawing drawing = tableDrawing(source, 200);
        int marked = 0;
        for (const Item& item : drawing.items) {
            marked += item.role == Role::Highlight ? 1 : 0;
            const auto* const label = std::get_if<Label>(&item.primitive);
            if (label == nullptr) continue;
            const std::string text = labelText(*label, relief::Language::English);
            const bool number = text == "17" || text == "step";
            EXPECT_EQ(label->anchor, number ? Anchor::Right : Anchor::Left) << text;
        }
        return marked;
    };
    EXPECT_EQ(marks(), 0);
    source.rows[1].chosen = true;
    EXPECT_GT(marks(), 0);
}

// A part that the text does not have is empty.
TEST(Label, aPartIsWhatStandsBetweenTheDots) {
    const auto part = [](int number) {
        const Label label{.text = plainText("one · two"), .part = number};
        return labelText(label, relief::Language::English);
    };
    EXPECT_EQ(part(-1), "one · two");
    EXPECT_EQ(part(0), "one");
    EXPECT_EQ(part(1), "two");
    EXPECT_EQ(part(2), "");
}

// Steps without a sphere or cone promise nothing.
TEST(LegendRows, explainsOnlyBodiesThatAreThere) {
    LegendRows rows(400, relief::Language::English);
    rows.bodies({relief::Step{}}, {}, {});
    EXPECT_TRUE(rows.take().items.empty());
}

TEST(Painter, figuresHoldWordsInBothLanguages) {
    if (QCoreApplication::instance() == nullptr) GTEST_SKIP() << "no display, no fonts";
    Traced t("bricks", 64, 64, Surface::Bilinear, Address::Repeat);
    t.trace({12, 40, 20, -9});
    for (const relief::Language language : {relief::Language::English, relief::Language::Ukrainian}) {
        Style style;
        style.theme = Theme::Light;
        style.language = language;
        const PyramidPicture picture = pyramidPicture(t.source(), 700, 400);
        const Drawing marks = pyramidMarks(t.source(), picture, 3);
        RangedValues heights;
        heights.spread = std::make_shared<const ValueSpread>();
        const Drawing legend = pyramidLegend(t.source(), heights, 700, language);
        QByteArray bytes;
        QBuffer buffer(&bytes);
        QSvgGenerator svg;
        svg.setOutputDevice(&buffer);
        svg.setSize(QSize(900, 600));
        svg.setViewBox(QRect(0, 0, 900, 600));
        QPainter painter(&svg);
        paintFigure(painter, {&picture.levels, &marks}, legend, {0, 0, 900, 600}, style);
        painter.end();
        const QString text = QString::fromUtf8(bytes);
        const relief::Message skipped(relief::MessageId::DrawSkip);
        EXPECT_TRUE(text.contains(QString::fromStdString(relief::sentence(skipped, language))));
        EXPECT_FALSE(text.contains('{'));
        EXPECT_GT(text.count("<text"), 10);
    }
}

double lightness(Rgba color) {
    const auto linear = [](std::uint8_t c) { return static_cast<double>(relief::linearFromSrgb(c / 255.0F)); };
    const double y = 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;  // CIE L*
}

// Levels are distinguished by lightness alone, in nearly equal steps; each is visible on its background.
TEST(Style, levelsGoDownInEvenSteps) {
    constexpr int kLevels = 11;
    Style style;
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        style.theme = theme;
        double least = 100;
        double most = 0;
        for (int level = 0; level < kLevels; ++level) {
            const double here = lightness(style.levelLine({level, kLevels}));
            EXPECT_GT(std::abs(here - lightness(style.background())), 25) << level;
            if (level == 0) continue;
            const double step = lightness(style.levelLine({level - 1, kLevels})) - here;
            least = std::min(least, step);
            most = std::max(most, step);
        }
        EXPECT_GT(least, 2.5);
        EXPECT_LT(most, 1.4 * least);
    }
}

TEST(Style, decisionsDifferInColourOrDashAndInShape) {
    for (const Theme theme : {Theme::Dark, Theme::Light}) {
        Style style;
        style.theme = theme;
        std::set<Shape> shapes;
        for (std::size_t d = 0; d < relief::kDecisionNames.size(); ++d) {
            shapes.insert(shapeOf(static_cast<relief::Decision>(d)));
        }
        EXPECT_EQ(shapes.size(), relief::kDecisionNames.size());
        EXPECT_EQ(style.color(Role::Descended), style.color(Role::Ascended));
        EXPECT_FALSE(style.stroke(Role::Ascended, Emphasis::Normal).dash.empty());
        EXPECT_NE(style.color(Role::Hit), style.background());
        Style projector = style;
        projector.projector = true;
        EXPECT_NEAR(projector.stroke(Role::Ray, Emphasis::Normal).width,
                    3 * style.stroke(Role::Ray, Emphasis::Normal).width, 1e-9);
        EXPECT_NEAR(projector.textPixels(), 1.8 * style.textPixels(), 1e-9);
    }
}

}  // namespace
}  // namespace reliefui
