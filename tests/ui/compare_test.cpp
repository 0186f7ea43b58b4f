// The drawing of the compare pane: the positions of its pictures and the text about them.
#include <algorithm>

#include <gtest/gtest.h>
#include <QBuffer>
#include <QCoreApplication>
#include <QSvgGenerator>
#include <QSvgRenderer>

#include "golden.h"
#include "painting/chart.h"
#include "painting/painter.h"
#include "panes/compare/compare_painting.h"

namespace reliefui {

namespace {

CompareSource madeUp(std::size_t count, relief::CompareMode mode) {
    CompareSource source;
    source.mode = mode;
    source.reference = "exact";
    source.rays = 8192;
    source.rounds = 7;
    for (std::size_t n = 0; n < count; ++n) {
        CompareTile tile;
        tile.name = std::string(1, static_cast<char>('A' + n)) + " method-" + std::to_string(n);
        tile.title = "Method " + std::to_string(n);
        tile.rmse = 0.0123456;
        tile.psnr = 38.17;
        tile.flip = 0.05;
        tile.rate = 12.5;
        tile.steps = 17.25;
        source.tiles.push_back(tile);
        if (n > 0) source.dividers.push_back(static_cast<double>(n) / static_cast<double>(count));
    }
    return source;
}

TEST(Compare, TilesLieBesideEachOther) {
    for (std::size_t count = 2; count <= relief::kMostCompared; ++count) {
        for (const Box& page : {Box{0, 0, 420, 300}, Box{0, 0, 900, 250}, Box{0, 0, 200, 600}}) {
            const CompareLayout layout =
                compareLayout(madeUp(count, relief::CompareMode::Tiles), page.width(), page.height(), {});
            ASSERT_EQ(layout.rooms.size(), count);
            for (std::size_t n = 0; n < count; ++n) {
                const Box& room = layout.rooms[n];
                EXPECT_EQ(layout.clips[n], room);
                EXPECT_TRUE(page.contains({room.x0, room.y0}) && page.contains({room.x1, room.y1}));
                EXPECT_NEAR(room.width(), layout.rooms[0].width(), 1e-9);
                EXPECT_NEAR(room.height(), layout.rooms[0].height(), 1e-9);
                for (std::size_t m = 0; m < n; ++m) EXPECT_FALSE(room.overlaps(layout.rooms[m])) << count;
            }
        }
    }
    // Pages of various heights: the pictures are stacked on a high page, and side by side on a wide one.
    const auto second = [&](double width, double height) {
        return compareLayout(madeUp(2, relief::CompareMode::Tiles), width, height, {}).rooms[1];
    };
    EXPECT_GT(second(900, 250).x0, 300);
    EXPECT_GT(second(200, 600).y0, 200);
}

TEST(Compare, WhatStandsAroundThePicturesIsAsStored) {
    CompareSource source = madeUp(3, relief::CompareMode::Difference);
    source.tiles[0].reference = true;
    source.tiles[1].equal = true;
    source.tiles[2].missing = relief::Message(relief::MessageId::DrawCompareMeasuring);
    const auto paint = [&](QPainter& painter, const Box& page, const Style& style) {
        const double unit = style.pixelsPerPoint();
        const Drawing legend = compareLegend(source, page.width() / unit - 2 * kFigureMargin, style.language);
        const Box room = figureRoom(legend, page, style);
        const CompareLayout layout = compareLayout(source, room.width() / unit, room.height() / unit, style.language);
        paintFigure(painter, {&layout.drawing}, legend, page, style);
    };
    expectGoldens(paint, 420, 260, "compare");
}

// A figure is as high as its tiles need to be as wide as their columns, and no higher.
TEST(Compare, TheHeightOfAFigureIsThatOfItsRows) {
    constexpr double kWidth = 800, kRounding = 0.5;
    for (std::size_t count = 2; count <= relief::kMostCompared; ++count) {
        for (int columns = 1; columns <= 3; ++columns) {
            CompareSource source = madeUp(count, relief::CompareMode::Tiles);
            source.columns = columns;
            const double height = compareHeight(source, kWidth, {});
            const auto roomAt = [&](double high) { return compareLayout(source, kWidth, high, {}).rooms[0].height(); };
            const double room = roomAt(height);
            EXPECT_NEAR(room, roomAt(2 * height), kRounding) << count << " in " << columns;
            EXPECT_LT(roomAt(height - 8), room - kRounding) << count << " in " << columns;
        }
    }
}

// A lecturer reads the title; what to type stands below, with its options.
TEST(Compare, TitlesHeadTheTilesAndIdentifiersStandBelow) {
    const CompareSource source = madeUp(3, relief::CompareMode::Tiles);
    const CompareLayout layout = compareLayout(source, 700, 300, relief::Language::English);
    std::vector<std::string> headings, below;
    for (const Item& item : layout.drawing.items) {
        const auto* const label = std::get_if<Label>(&item.primitive);
        if (label == nullptr) continue;
        (item.role == Role::Title ? headings : below).push_back(relief::sentence(label->text));
    }
    EXPECT_EQ(headings, (std::vector<std::string>{"A Method 0", "B Method 1", "C Method 2"}));
    for (const char* const name : {"method-0", "method-1", "method-2"}) {
        EXPECT_TRUE(std::any_of(below.begin(), below.end(), [&](const std::string& line) {
            return line.starts_with(name);
        })) << name;
    }
}

// The pictures do not move when their numbers arrive.
TEST(Compare, RoomIsReservedForNumbersThatAreNotThereYet) {
    const CompareSource measured = madeUp(3, relief::CompareMode::Tiles);
    const CompareLayout later = compareLayout(measured, 400, 300, {});
    CompareSource before = measured;
    for (CompareTile& tile : before.tiles) tile.rmse = tile.psnr = tile.flip = tile.rate = tile.steps = std::nullopt;
    ASSERT_NE(compareLayout(before, 400, 300, {}).rooms, later.rooms);
    before.lines = later.lines;
    EXPECT_EQ(compareLayout(before, 400, 300, {}).rooms, later.rooms);
}

// Even in narrow tiles, no line of numbers overlaps the next one.
TEST(Compare, NumbersStayBelowTheirPicture) {
    for (const relief::Language language : {relief::Language::English, relief::Language::Ukrainian}) {
        for (const double width : {380.0, 440.0, 700.0, 1500.0}) {
            CompareSource source = madeUp(4, relief::CompareMode::Tiles);
            source.tiles[2].equal = true;
            const CompareLayout layout = compareLayout(source, width, 130, language);
            int numbers = 0;
            for (const Item& item : layout.drawing.items) {
                const auto* const label = std::get_if<Label>(&item.primitive);
                if (label == nullptr || item.role != Role::Legend) continue;
                const std::string text = relief::sentence(label->text, language);
                const auto room = std::find_if(layout.rooms.begin(), layout.rooms.end(), [&](const Box& box) {
                    return label->at.x >= box.x0 && label->at.x <= box.x1 && label->at.y >= box.y1;
                });
                ASSERT_NE(room, layout.rooms.end()) << text;
                EXPECT_LE(label->at.x + textWidth(text), room->x1 + 4) << text << ", " << width;
                ++numbers;
            }
            EXPECT_GE(numbers, 4) << width;
        }
    }
}

TEST(Compare, SwipeSharesOnePictureAndFlickerShowsOne) {
    CompareSource source = madeUp(3, relief::CompareMode::Swipe);
    source.dividers = {0.25, 0.7};
    const CompareLayout swipe = compareLayout(source, 400, 300, {});
    const Box room = swipe.rooms[0];
    EXPECT_EQ(swipe.clips[0].x0, room.x0);
    EXPECT_NEAR(swipe.clips[0].x1, room.x0 + 0.25 * room.width(), 1e-9);
    EXPECT_EQ(swipe.clips[1].x0, swipe.clips[0].x1);
    EXPECT_NEAR(swipe.clips[1].x1, room.x0 + 0.7 * room.width(), 1e-9);
    EXPECT_EQ(swipe.clips[2].x1, room.x1);
    source.mode = relief::CompareMode::Flicker;
    source.shown = 2;
    const CompareLayout flicker = compareLayout(source, 400, 300, {});
    EXPECT_TRUE(flicker.clips[0].empty() && flicker.clips[1].empty());
    EXPECT_EQ(flicker.clips[2], flicker.rooms[2]);
}

// Qt writes no clips into SVG, where each picture would cover those before it.
TEST(Compare, SwipeShowsAPartOfEachPictureInSvg) {
    if (QCoreApplication::instance() == nullptr) GTEST_SKIP() << "no display, no fonts";
    std::vector<QImage> pictures;
    for (const Qt::GlobalColor color : {Qt::red, Qt::blue}) {
        pictures.emplace_back(400, 300, QImage::Format_RGB32);
        pictures.back().fill(color);
    }
    const Style style;
    constexpr int kSide = 800;
    const Box page{0, 0, kSide, kSide};
    const ComparePage parts = comparePage(madeUp(2, relief::CompareMode::Swipe), page, style, true);
    QBuffer buffer;
    QSvgGenerator svg;
    svg.setOutputDevice(&buffer);
    svg.setViewBox(QRect(0, 0, kSide, kSide));
    QPainter painter(&svg);
    paintRedrawn(painter, pictures, parts, page, style, {});
    painter.end();
    QImage image(kSide, kSide, QImage::Format_RGB32);
    QPainter drawn(&image);
    QSvgRenderer(buffer.data()).render(&drawn);
    drawn.end();
    const Box& room = parts.layout.rooms[0];
    const auto at = [&](double along) {
        const ViewMap map{style.pixelsPerPoint(), parts.room.x0, parts.room.y0};
        const Point point = map.toScreen(Point{room.x0 + along * room.width(), room.y0 + 0.7 * room.height()});
        return image.pixelColor(static_cast<int>(point.x), static_cast<int>(point.y));
    };
    for (const double along : {0.1, 0.45}) EXPECT_EQ(at(along), QColor(Qt::red)) << along;
    for (const double along : {0.55, 0.9}) EXPECT_EQ(at(along), QColor(Qt::blue)) << along;
}

TEST(Compare, NumbersAndLegendAreWholeInBothLanguages) {
    for (const relief::Language language : {relief::Language::English, relief::Language::Ukrainian}) {
        CompareSource source = madeUp(3, relief::CompareMode::Difference);
        source.tiles[1].equal = true;
        source.tiles[2].psnr = INFINITY;
        const std::vector<std::string> numbers = compareNumbers(source.tiles[0], language);
        ASSERT_EQ(numbers.size(), 5u);
        EXPECT_EQ(numbers[0], "RMSE 0.0123");
        EXPECT_NE(compareNumbers(source.tiles[2], language)[1].find("∞"), std::string::npos);
        EXPECT_EQ(compareNumbers(source.tiles[1], language).size(), 3u) << "equality is reported in one word";
        for (const double width : {150.0, 400.0, 1500.0}) {
            const Drawing legend = compareLegend(source, width, language);
            EXPECT_LE(legend.bounds.width(), std::max(width, 300.0));
            std::string all;
            for (const Item& item : legend.items) {
                const auto* label = std::get_if<Label>(&item.primitive);
                if (label != nullptr) all += relief::sentence(label->text, language) + ' ';
            }
            EXPECT_EQ(all.find('{'), std::string::npos) << all;
            for (const char* const word : {"FLIP", "exact", "8192"})
                EXPECT_NE(all.find(word), std::string::npos) << all;
        }
    }
}

}  // namespace

}  // namespace reliefui
