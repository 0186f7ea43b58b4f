// The charts: the methods on the Pareto front, the drawing, and the exported figures.
#include <cmath>
#include <fstream>
#include <set>

#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>

#include "chart_laws.h"
#include "golden.h"
#include "painting/chart.h"
#include "painting/painter.h"
#include "panes/charts/charts_drawing.h"
#include "relief/errors.h"
#include "relief/files.h"
#include "rendering/error_layer.h"
#include "scenario/scenario.h"
#include "window_fixture.h"

namespace reliefui {

namespace {

relief::BenchRow row(const std::string& method, double nanoseconds, double error, std::int64_t wrong = 0) {
    relief::BenchRow row;
    row.height = "bricks";
    row.width = row.heightTexels = 256;
    row.reliefDepth = 0.1;
    row.method = {method, {}};
    row.elevation = 25;
    row.seed = 1;
    row.threads = 2;
    row.rate = 1e9 / nanoseconds;
    row.spread = 0.04;
    row.errors.mean = error;
    row.errors.p95 = 2 * error;
    row.errors.p9999 = 3 * error;
    row.errors.max = 4 * error;
    row.errors.wrongOutcome = wrong;
    row.stepsMean = 20;
    row.compiler = "g++";
    row.cpu = "a processor";
    row.commit = "0";
    return row;
}

// On the front: offset, layers-secant, cone, exact. Dominated: layers (by layers-secant), max-pyramid (by exact).
std::vector<relief::BenchRow> madeUp() {
    return {row("offset", 20, 3),   row("layers", 90, 0.5), row("layers-secant", 80, 0.2),
            row("cone", 150, 0.01), row("exact", 300, 0),   row("max-pyramid", 420, 0)};
}

ParetoSource sourceOf(const std::vector<relief::BenchRow>& rows) {
    ParetoSource source;
    source.table = relief::paretoTable(rows);
    source.title = paretoTitle(source.table);
    return source;
}

std::set<std::string> frontOf(const ParetoSource& source) {
    const std::vector<bool> dominated = relief::dominatedPoints(source.table.points, source.measure);
    std::set<std::string> names;
    for (std::size_t p = 0; p < dominated.size(); ++p) {
        if (!dominated[p]) names.insert(source.table.points[p].name);
    }
    return names;
}

// A title that would be too small in one line is broken into two, above the bars.
TEST(ChartsDrawing, LongTitlesStandInTwoLines) {
    relief::FrameHistograms data;
    data.steps = {1, 2, 3};
    data.stepWidth = 1;
    data.rays = 6;
    const auto titles = [](const HistogramPicture& picture) {
        std::vector<Label> found;
        for (const Item& item : picture.drawing.items) {
            const auto* const label = std::get_if<Label>(&item.primitive);
            if (label != nullptr && label->text.id == relief::MessageId::DrawChartSteps) found.push_back(*label);
        }
        return found;
    };
    const HistogramPicture wide = stepsHistogram(data, 0, {0, 0, 600, 200});
    ASSERT_EQ(titles(wide).size(), 1U);
    const HistogramPicture narrow = stepsHistogram(data, 0, {0, 0, 200, 200});
    const std::vector<Label> two = titles(narrow);
    ASSERT_EQ(two.size(), 2U);
    EXPECT_EQ(labelText(two[0], relief::Language::English), "steps per ray");
    EXPECT_EQ(labelText(two[1], relief::Language::English).find("mean"), 0U);
    for (const Label& label : two) EXPECT_GT(label.size, 0.55);
    EXPECT_GT(narrow.plot.y0, wide.plot.y0 + 5) << "room for the second line";
}

TEST(Charts, TheFrontIsNotDominated) {
    const ParetoSource source = sourceOf(madeUp());
    EXPECT_EQ(frontOf(source), (std::set<std::string>{"offset", "layers-secant", "cone", "exact"}));
    // A method with fewer wrong outcomes is not dominated, either.
    std::vector<relief::BenchRow> rows = madeUp();
    rows[2].errors.wrongOutcome = 7;
    EXPECT_EQ(frontOf(sourceOf(rows)), (std::set<std::string>{"offset", "layers", "layers-secant", "cone", "exact"}));
    // Methods with equal values do not dominate each other; one that never hits has no error and is not on the front.
    rows = madeUp();
    rows[5].rate = rows[4].rate;
    rows[0].errors.mean = std::nan("");
    rows.push_back(row("bad", 25, std::nan("")));
    EXPECT_EQ(frontOf(sourceOf(rows)),
              (std::set<std::string>{"offset", "layers-secant", "cone", "exact", "max-pyramid"}));
}

TEST(Charts, CellsArePooled) {
    std::vector<relief::BenchRow> rows = madeUp();
    for (relief::BenchRow other : madeUp()) {
        if (other.method.name == "cone") continue;  // not measured there
        other.height = "city";
        other.rate /= 4;
        other.errors.mean *= 3;
        other.errors.max *= 5;
        rows.push_back(other);
    }
    const relief::ParetoTable table = relief::paretoTable(rows);
    EXPECT_EQ(table.cells, 2u);
    EXPECT_EQ(table.leftOut, std::vector<std::string>{"cone"});
    ASSERT_EQ(table.points.size(), 5u);
    EXPECT_NEAR(table.points[0].nanoseconds, 20 * std::sqrt(4.0), 1e-9);
    EXPECT_NEAR(table.points[0].error[0], 3 * (1 + 3) / 2.0, 1e-9);
    EXPECT_NEAR(table.points[0].error[3], 12 * 5, 1e-9);
    EXPECT_EQ(relief::chosenRows(rows, "city", "").size(), 5u);
    EXPECT_EQ(relief::chosenRows(rows, "", "25").size(), rows.size());
    EXPECT_THROW(relief::chosenRows(rows, "hills", ""), relief::InputError);
    EXPECT_THROW(relief::chosenRows(rows, "", "random"), relief::InputError);
}

TEST(Charts, DominatedMarksAreFaintAndTheLineIsTheFront) {
    const ParetoSource source = sourceOf(madeUp());
    const ParetoPicture picture = paretoPicture(source, {0, 0, 450, 300});
    ASSERT_EQ(picture.marks.size(), 6u);
    int marks = 0;
    for (const Item& item : picture.drawing.items) {
        const auto* marker = std::get_if<Marker>(&item.primitive);
        if (marker == nullptr) continue;
        const ParetoMark& mark = picture.marks[static_cast<std::size_t>(item.id.i)];
        EXPECT_EQ(item.role, mark.dominated ? Role::Layer : Role::Series);
        EXPECT_EQ(marker->at, mark.at);
        ++marks;
    }
    EXPECT_EQ(marks, 6);
    for (const ParetoMark& mark : picture.marks) {
        const relief::ParetoPoint& point = source.table.points[mark.point];
        const bool corner = std::find(picture.front.begin(), picture.front.end(), mark.at) != picture.front.end();
        EXPECT_EQ(corner, !mark.dominated) << point.name;
        EXPECT_TRUE(picture.frame.whole.contains(mark.at)) << point.name;
        EXPECT_FALSE(mark.label.empty()) << point.name << " has no name beside it";
        EXPECT_EQ(paretoPointAt(picture, {mark.at.x + 3, mark.at.y - 3}), mark.point);
        EXPECT_EQ(paretoPointAt(picture, mark.label.center()), mark.point);
        for (const ParetoMark& other : picture.marks) {
            EXPECT_TRUE(&other == &mark || !other.label.overlaps(mark.label)) << point.name;
        }
    }
    // The front only has horizontal steps to the right and vertical ones downwards.
    for (std::size_t i = 1; i < picture.front.size(); ++i) {
        EXPECT_GE(picture.front[i].x, picture.front[i - 1].x);
        EXPECT_GE(picture.front[i].y, picture.front[i - 1].y);
    }
    EXPECT_FALSE(paretoPointAt(picture, {picture.frame.plot.x1, picture.frame.plot.y0}));
}

TEST(Charts, ScalesAreLogarithmicAndNoErrorHasItsOwnRow) {
    const ParetoPicture picture = paretoPicture(sourceOf(madeUp()), {0, 0, 450, 300});
    const ParetoFrame& frame = picture.frame;
    EXPECT_NEAR(frame.xAt(200) - frame.xAt(100), frame.xAt(40) - frame.xAt(20), 1e-9);
    EXPECT_NEAR(frame.yAt(0.01) - frame.yAt(0.1), frame.yAt(0.1) - frame.yAt(1), 1e-9);
    EXPECT_GT(frame.yAt(0), frame.plot.y1);
    EXPECT_LT(frame.yAt(0), frame.whole.y1);
    EXPECT_LE(std::pow(10, frame.errorLow), 0.01);
    EXPECT_GE(std::pow(10, frame.errorHigh), 3);
}

TEST(Charts, HistogramsCountEveryRay) {
    relief::FrameHistograms data;
    data.rays = 1111;
    data.steps = {0, 1000, 100, 10, 1};
    data.exact = 600;
    data.wrong = 11;
    data.lowDecade = -2;
    data.before = {100, 0, 0, 0, 200};
    data.behind = {0, 0, 100, 0, 100};
    data.largest = 0.1;
    const HistogramPicture steps = stepsHistogram(data, 2, {0, 0, 220, 140});
    ASSERT_EQ(steps.bars.size(), 5u);
    const double decade = steps.yAt(1) - steps.yAt(10);
    EXPECT_NEAR(steps.yAt(10) - steps.yAt(1000), 2 * decade, 1e-9);
    EXPECT_LT(steps.yAt(1), steps.plot.y1) << "one ray is seen";
    const HistogramPicture errors = errorHistogram(data, {0, 0, 220, 140});
    // The axis has a title that names the count, within its margin.
    for (const HistogramPicture* picture : {&steps, &errors}) {
        int said = 0;
        for (const Item& item : picture->drawing.items) {
            const auto* const label = std::get_if<Label>(&item.primitive);
            if (label == nullptr || label->text.id != relief::MessageId::DrawChartRays) continue;
            ++said;
            for (const relief::Language language : {relief::Language::English, relief::Language::Ukrainian}) {
                const std::string text = labelText(*label, language);
                EXPECT_GE(label->at.x + label->offset.x - textWidth(text, label->size), -1) << text;
            }
        }
        EXPECT_EQ(said, 1);
    }
    std::int64_t rays = 0;
    for (const HistogramBar& bar : errors.bars) rays += bar.rays;
    EXPECT_EQ(rays, data.rays);
    ChartsPicture both;
    both.steps = steps;
    const ChartsReading at = chartsReading(both, steps.bars[2].box.center());
    ASSERT_TRUE(at.bar);
    EXPECT_EQ(at.bar->rays, 100);
    EXPECT_EQ(at.bar->low, 2);
}

TEST(Charts, AreAsStored) {
    auto histograms = std::make_shared<relief::FrameHistograms>();
    histograms->rays = 5931;
    histograms->steps = {0, 40, 900, 3000, 1200, 500, 200, 60, 20, 8, 3};
    histograms->stepWidth = 4;
    histograms->stepsMean = 14.2;
    histograms->stepsP95 = 24;
    histograms->stepsMost = 43;
    histograms->exact = 2400;
    histograms->wrong = 11;
    histograms->lowDecade = -3;
    histograms->before = {100, 300, 500, 700, 200, 60, 20, 3, 1};
    histograms->behind = {0, 20, 100, 300, 700, 400, 90, 20, 6};
    histograms->largest = 0.84;
    ChartsSource source;
    ParetoSource pareto = sourceOf(madeUp());
    pareto.current = "layers";
    source.pareto = std::make_shared<const ParetoSource>(std::move(pareto));
    source.histograms = histograms;
    source.chosenSteps = 17;
    const auto paint = [&](QPainter& painter, const Box& page, const Style& style) {
        const double unit = style.pixelsPerPoint();
        const Drawing legend = chartsLegend(source, page.width() / unit - 2 * kFigureMargin, style.language);
        const Box room = figureRoom(legend, page, style);
        const ChartsPicture charts = chartsPicture(source, room.width() / unit, room.height() / unit, style.language);
        paintFigure(painter, {&charts.drawing}, legend, page, style);
    };
    expectGoldens(paint, 420, 460, "charts");
    for (const auto& [width, height] : {std::pair(320.0, 300.0), {400.0, 420.0}, {900.0, 300.0}}) {
        const ChartsPicture charts = chartsPicture(source, width, height, relief::Language::English);
        for (const HistogramPicture* picture : {&*charts.steps, &*charts.errors}) expectWordsInside(picture->drawing);
        expectWordsInside(charts.pareto->drawing);
    }
}

// The program exports the charts without a display.
TEST(Charts, TheProgramExportsThem) {
    const QTemporaryDir folder;
    const QString table = folder.filePath(QStringLiteral("bench.json"));
    const QString wrong = folder.filePath(QStringLiteral("wrong.json"));
    const QString scenario = folder.filePath(QStringLiteral("scenario.json"));
    std::ofstream(table.toStdString()) << relief::benchJson(madeUp());
    std::ofstream(wrong.toStdString()) << "[{\n\"height\": ]";
    relief::saveScenario(scenario.toStdString(), smallScenario());
    const auto run = [&](const QStringList& arguments, QString* error = nullptr) {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.remove(QStringLiteral("DISPLAY"));
        environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral("detect_leaks=0"));
        process.setProcessEnvironment(environment);
        process.start(QStringLiteral(RELIEFSCOPE), arguments);
        process.waitForFinished(60000);
        if (error != nullptr) *error = QString::fromUtf8(process.readAllStandardError());
        return process.exitCode();
    };
    const auto view = [&](const char* name, const QString& file) {
        return QStringList{QStringLiteral("--export"), QString::fromLatin1(name), QStringLiteral("-o"), file};
    };
    for (const char* const ending : {"svg", "pdf", "png"}) {
        const QString file = folder.filePath(QStringLiteral("pareto.") + QString::fromLatin1(ending));
        EXPECT_EQ(run(QStringList{table} + view("pareto", file)), 0);
        EXPECT_TRUE(validFigure(file)) << ending;
    }
    // The same table as CSV gives the same chart.
    std::string csv = relief::benchCsvHeader();
    for (const relief::BenchRow& row : madeUp()) csv += relief::benchCsvLine(row);
    const QString asCsv = folder.filePath(QStringLiteral("bench.csv"));
    relief::writeTextFile(asCsv.toStdString(), csv);
    const QString fromCsv = folder.filePath(QStringLiteral("csv.svg"));
    EXPECT_EQ(run(QStringList{asCsv} + view("pareto", fromCsv)), 0);
    EXPECT_EQ(relief::readTextFile(fromCsv.toStdString()),
              relief::readTextFile(folder.filePath(QStringLiteral("pareto.svg")).toStdString()));
    const QString charts = folder.filePath(QStringLiteral("charts.svg"));
    EXPECT_EQ(run(QStringList{scenario} + view("charts", charts)), 0);
    EXPECT_TRUE(validFigure(charts));
    const QString none = folder.filePath(QStringLiteral("none.svg"));
    for (const QStringList& arguments :
         {QStringList{wrong}, QStringList{scenario}, QStringList{}, QStringList{folder.filePath(QStringLiteral("x"))},
          QStringList{table, QStringLiteral("--elevation"), QStringLiteral("80")},
          QStringList{table, QStringLiteral("--error"), QStringLiteral("median")}}) {
        QString error;
        EXPECT_EQ(run(arguments + view("pareto", none), &error), 2) << arguments.join(' ').toStdString();
        EXPECT_TRUE(error.startsWith(QStringLiteral("reliefscope: ")) && error.count('\n') == 1) << error.toStdString();
        EXPECT_FALSE(QFileInfo::exists(none));
    }
}

}  // namespace

}  // namespace reliefui
