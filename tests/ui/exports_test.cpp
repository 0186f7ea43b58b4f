// Every view goes into a file without a display: lines and words into SVG and PDF, everything into PNG.
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "measuring/compare/flip.h"
#include "panes/pyramid/pyramid_view.h"
#include "panes/steps/step_table.h"
#include "panes/trace/trace3d_view.h"
#include "relief/files.h"
#include "window_fixture.h"
#include "windows/pane_list.h"
#include "windows/time_pane.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

namespace {

constexpr int kPatienceMs = 60000;

// No display and no platform asked for, Ukrainian.
int exportFigure(const QStringList& arguments, QString* complaint, const char* language = "uk_UA.UTF-8") {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* const name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        environment.remove(QLatin1String(name));
    }
    environment.insert(QStringLiteral("LC_ALL"), QLatin1String(language));
    environment.insert(QStringLiteral("LIBGL_ALWAYS_SOFTWARE"), QStringLiteral("1"));  // as the stored figures
    environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral("detect_leaks=0"));
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(RELIEFSCOPE), arguments);
    if (!process.waitForFinished(kPatienceMs)) return -1;
    *complaint = QString::fromUtf8(process.readAllStandardError());
    return process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool hasCyrillic(const QByteArray& svg) {
    // Words between <text> and </text>, not a title.
    const QRegularExpression words(QStringLiteral("<text[^>]*>[^<]*[а-яіїєґ]{3}[^<]*</text>"));
    return words.match(QString::fromUtf8(svg)).hasMatch();
}

// Everything a view could want: a ray, methods to compare with; a relief by hand for the pane of that name.
QString writeScenario(const QTemporaryDir& folder, bool drawn) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {{"layers", "8"}}};
    scenario.comparison.others = {{"max-pyramid", {}}};
    scenario.step = 1;
    if (drawn) {
        scenario.pictures = {};
        scenario.pictures.drawn.width = scenario.pictures.drawn.height = 8;
        for (int i = 0; i < 64; ++i) scenario.pictures.drawn.heights.push_back((i * 7 % 64) / 64.0);
    }
    const QString path = folder.filePath(drawn ? QStringLiteral("drawn.json") : QStringLiteral("scenario.json"));
    relief::saveScenario(path.toStdString(), scenario);
    return path;
}

// Compares an exported figure with tests/files/figures/NAME.png, which somebody has looked at and found right, by the
// mean FLIP of each block of 16 x 16 pixels, so that one number or mark that is elsewhere counts. The bound leaves room
// for how processors round the smoothing of lines; a letter that moves by a pixel is 0.1 and more.
void expectGolden(const QString& exported, const std::string& name) {
    constexpr int kBlock = 16;
    constexpr double kBound = 0.05, kPixelsPerDegree = 67;
    const std::string golden = RELIEF_SOURCE "/tests/files/figures/" + name + ".png";
    if (const char* wish = std::getenv("RELIEF_GOLDEN"); wish != nullptr && std::string(wish) == "write") {
        std::filesystem::copy_file(exported.toStdString(), golden, std::filesystem::copy_options::overwrite_existing);
        return;
    }
    relief::Work work(1);
    const relief::ColorImage wanted = relief::readColor(golden, work);
    const relief::ColorImage seen = relief::readColor(exported.toStdString(), work);
    ASSERT_EQ(wanted.width(), seen.width()) << golden;
    ASSERT_EQ(wanted.height(), seen.height()) << golden;
    const relief::FloatImage errors = relief::flipErrors(wanted, seen, kPixelsPerDegree, work);
    for (int y0 = 0; y0 < errors.height(); y0 += kBlock) {
        for (int x0 = 0; x0 < errors.width(); x0 += kBlock) {
            const int x1 = std::min(x0 + kBlock, errors.width()), y1 = std::min(y0 + kBlock, errors.height());
            double sum = 0;
            for (int y = y0; y < y1; ++y) {
                for (int x = x0; x < x1; ++x) sum += static_cast<double>(errors(x, y));
            }
            const double mean = sum / ((x1 - x0) * (y1 - y0));
            if (mean <= kBound) continue;
            const auto kept = std::filesystem::temp_directory_path() / ("relief-" + name + ".png");
            std::filesystem::copy_file(exported.toStdString(), kept, std::filesystem::copy_options::overwrite_existing);
            FAIL() << name << " is not as stored: FLIP " << mean << " at " << x0 << ", " << y0 << "; it is in " << kept
                   << " (with RELIEF_GOLDEN=write it is stored)";
        }
    }
}

// So many pixels as are asked for: 127 mm of 80 an inch are 400. Captions name folders of this machine.
const QStringList& pictureSize() {
    static const QStringList size{QStringLiteral("--width"), QStringLiteral("127"), QStringLiteral("--dpi"),
                                  QStringLiteral("80"), QStringLiteral("--no-caption")};
    return size;
}

// A figure of a scenario in a file, as it must be: without a word.
QString exportedFigure(const QString& scenario, const QString& view, const QString& path,
                       const QStringList& more = {}) {
    QString complaint;
    const int status = exportFigure(
        QStringList{scenario, QStringLiteral("--export"), view, QStringLiteral("-o"), path} + more, &complaint);
    EXPECT_EQ(complaint.toStdString(), "");
    EXPECT_EQ(status, 0) << path.toStdString();
    return path;
}

class EveryExport : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryExport, needsNoDisplay) {
    const QTemporaryDir folder;
    const std::string& name = GetParam();
    const QString view = QString::fromStdString(name);
    const QString scenario = writeScenario(folder, name == "drawn");
    const auto run = [&](const QString& ending, const QStringList& more = {}) {
        return exportedFigure(scenario, view, folder.filePath(view + ending), more);
    };
    const QString picture = run(QStringLiteral(".png"), pictureSize());
    const QImage image(picture);
    EXPECT_EQ(image.width(), 400);
    EXPECT_GT(colorsIn(image), 8);
    // These two show measured times.
    if (name != "charts" && name != "compare") expectGolden(picture, name);
    if (name == "trace" || name == "slabs") return;
    const QByteArray svg = contents(run(QStringLiteral(".svg")));
    if (name == "result") {
        EXPECT_TRUE(svg.contains("<image"));
    } else {
        EXPECT_TRUE(hasCyrillic(svg));
        EXPECT_TRUE(svg.contains("<path") || svg.contains("<polyline") || svg.contains("<rect"));
    }
    const QByteArray pdf = contents(run(QStringLiteral(".pdf")));
    EXPECT_TRUE(pdf.startsWith("%PDF"));
    EXPECT_TRUE(pdf.contains("/FontFile2")) << "words are words, in a font of the file's own";
}

// What each kind of method looks at: nodes, voxels and spheres, round cones and square ones; from outside and across.
TEST(Exports, whatMethodsLookAtIsAsStored) {
    struct Shown {
        const char* name;
        relief::MethodChoice method;
        relief::PixelChoice pixel;
        int step;
        std::vector<const char*> views;
    };
    const std::vector<Shown> all{
        {"max-pyramid", {"max-pyramid", {}}, {60, 70}, 3, {"trace", "profile", "distance"}},
        {"distance-conservative", {"distance-conservative", {}}, {60, 70}, 3, {"trace", "profile", "distance"}},
        {"cone", {"cone", {{"layout", "texel"}}}, {60, 70}, 3, {"trace", "profile", "distance"}},
        {"square-cone", {"cone", {}}, {150, 80}, 8, {"trace", "profile"}}};
    const QTemporaryDir folder;
    for (const Shown& shown : all) {
        for (const char* const view : shown.views) {
            SCOPED_TRACE(std::string(shown.name) + " " + view);
            relief::Scenario scenario = smallScenario();
            scenario.method = shown.method;
            scenario.pixel = shown.pixel;
            scenario.step = shown.step;
            const QString file = folder.filePath(QStringLiteral("scenario.json"));
            relief::saveScenario(file.toStdString(), scenario);
            const QString picture = exportedFigure(file, QString::fromLatin1(view),
                                                   folder.filePath(QStringLiteral("figure.png")), pictureSize());
            expectGolden(picture, std::string(view) + "-" + shown.name);
        }
    }
}

// In English and dark: a descent of the paper's recursion, and how an ellipse's texels are weighed.
TEST(Exports, formulasAndWeightsAreAsStored) {
    const QTemporaryDir folder;
    relief::Scenario scenario = deepRay();
    scenario.pictures.recipeWidth = scenario.pictures.recipeHeight = 512;
    scenario.filter.name = "elliptical";
    scenario.filter.options = {{"levels", "exhaustive"}};
    scenario.step = 2;
    const QString file = folder.filePath(QStringLiteral("scenario.json"));
    relief::saveScenario(file.toStdString(), scenario);
    for (const char* const view : {"formula", "footprint"}) {
        const QString path = folder.filePath(QString::fromLatin1(view) + QStringLiteral(".png"));
        QString complaint;
        const int status = exportFigure(QStringList{file, QStringLiteral("--export"), QString::fromLatin1(view),
                                                    QStringLiteral("-o"), path, QStringLiteral("--dark")} +
                                            pictureSize(),
                                        &complaint, "C.UTF-8");
        EXPECT_EQ(status, 0) << complaint.toStdString();
        expectGolden(path, std::string(view) + "-english");
    }
}

std::vector<std::string> exportedViews() {
    std::vector<std::string> views;
    for (const FigureKind& kind : figureList()) {
        if (kind.make) views.push_back(kind.name);  // "pareto", of a table of measurements: charts_test.cpp
    }
    return views;
}
INSTANTIATE_TEST_SUITE_P(Exports, EveryExport, ::testing::ValuesIn(exportedViews()), [](const auto& made) {
    std::string name = made.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

// A figure of more pixels is the same figure: lines cover the same part of it.
TEST(Exports, linesOnSlabsAreAsWideAtAnyResolution) {
    const QTemporaryDir folder;
    const QString scenario = writeScenario(folder, false);
    const auto covered = [&](const char* dpi) {
        const QString path = folder.filePath(QString::fromLatin1(dpi) + QStringLiteral(".png"));
        QString complaint;
        const int status =
            exportFigure({scenario, QStringLiteral("--export"), QStringLiteral("slabs"), QStringLiteral("-o"), path,
                          QStringLiteral("--width"), QStringLiteral("127"), QStringLiteral("--dpi"),
                          QString::fromLatin1(dpi), QStringLiteral("--no-caption")},
                         &complaint);
        EXPECT_EQ(status, 0) << complaint.toStdString();
        const QImage image(path);
        constexpr int kColoured = 60;  // heights, frames and words are grey
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y).saturation() > kColoured ? 1 : 0;
        }
        return static_cast<double>(count) / image.width() / std::max(1, image.height());
    };
    const double coarse = covered("96"), fine = covered("288");
    EXPECT_GT(coarse, 0.002);
    // Smoothing takes colour from thin lines in the coarse one; lines twice too wide would be far more.
    EXPECT_LT(fine / coarse, 1.4);
    EXPECT_GT(fine / coarse, 0.6);
}

// The legend stands below the picture, which stays as it is; in vectors its words are words.
TEST(Exports, aLayerOfTheResultHasItsLegend) {
    const QTemporaryDir folder;
    const QString scenario = writeScenario(folder, false);
    const auto image = [&](const QString& layer, const QString& ending, const QStringList& more = {}) {
        const QString path = folder.filePath(layer + more.join(QString()) + ending);
        QString complaint;
        EXPECT_EQ(exportFigure(QStringList{scenario, QStringLiteral("--export"), QStringLiteral("result"),
                                           QStringLiteral("-o"), path, QStringLiteral("--layer"), layer,
                                           QStringLiteral("--width"), QStringLiteral("127"), QStringLiteral("--dpi"),
                                           QStringLiteral("192"), QStringLiteral("--no-caption")} +
                                   more,
                               &complaint),
                  0)
            << complaint.toStdString();
        return path;
    };
    const QImage plain(image(QStringLiteral("color"), QStringLiteral(".png")));
    EXPECT_EQ(plain.height(), plain.width() * 3 / 4) << "no legend";
    for (const char* const layer : {"steps", "error", "outcome", "depth", "normal"}) {
        const QImage picture(image(QString::fromLatin1(layer), QStringLiteral(".png")));
        const int below = picture.height() - plain.height();
        EXPECT_GT(below, 15) << layer;
        EXPECT_LT(below, plain.height() * 6 / 10) << layer;
        // It does not reach into the picture: its colours are those of the theme, the picture's are not.
        const QImage dark(image(QString::fromLatin1(layer), QStringLiteral(".png"), {QStringLiteral("--dark")}));
        const QRect edge(0, plain.height() - 40, 60, 38);
        EXPECT_EQ(picture.copy(edge), dark.copy(edge)) << layer;
        EXPECT_NE(picture.copy(edge.translated(0, 40)), dark.copy(edge.translated(0, 40))) << layer;
        EXPECT_GT(colorsIn(picture.copy(0, plain.height() + 1, picture.width(), below - 1)), 8) << layer;
    }
    EXPECT_TRUE(hasCyrillic(contents(image(QStringLiteral("outcome"), QStringLiteral(".svg")))));
}

// The line below a figure names pictures, method with its options, pixel and step, and adds to its height alone.
TEST(Exports, figuresSayWhatTheyShow) {
    const QTemporaryDir folder;
    const QString scenario = writeScenario(folder, false);
    const QString with =
        exportedFigure(scenario, QStringLiteral("profile"), folder.filePath(QStringLiteral("with.svg")));
    const QString words = QString::fromUtf8(contents(with));
    for (const char* const part : {"bricks:", "layers:layers=8", "крок 2 з ", "піксель ("}) {
        EXPECT_TRUE(words.contains(QString::fromUtf8(part))) << part;
    }
    const auto picture = [&](const char* name, const QStringList& more) {
        const QString path = folder.filePath(QString::fromLatin1(name));
        return QImage(exportedFigure(scenario, QStringLiteral("profile"), path,
                                     QStringList{QStringLiteral("--width"), QStringLiteral("127"),
                                                 QStringLiteral("--dpi"), QStringLiteral("80")} +
                                         more));
    };
    const QImage captioned = picture("a.png", {});
    const QImage plain = picture("b.png", {QStringLiteral("--no-caption")});
    EXPECT_GT(captioned.height(), plain.height() + 8);
    EXPECT_LT(captioned.height(), plain.height() + 60);
    EXPECT_EQ(captioned.copy(plain.rect()), plain);
    EXPECT_GT(colorsIn(captioned.copy(0, plain.height(), 400, captioned.height() - plain.height())), 4);
}

// A figure of nothing is an error that says what to give, and no file.
TEST(Exports, nothingToDrawIsAnError) {
    const QTemporaryDir folder;
    relief::Scenario scenario = smallScenario();
    scenario.pixel.reset();
    scenario.comparison.others.clear();
    const QString file = folder.filePath(QStringLiteral("empty.json"));
    relief::saveScenario(file.toStdString(), scenario);
    const QString path = folder.filePath(QStringLiteral("figure.svg"));
    const auto refused = [&](const QString& view, const QString& hint, const QStringList& more = {}) {
        QString complaint;
        const int status = exportFigure(
            QStringList{file, QStringLiteral("--export"), view, QStringLiteral("-o"), path} + more, &complaint);
        EXPECT_EQ(status, 2) << view.toStdString();
        EXPECT_EQ(complaint.count('\n'), 1) << complaint.toStdString();
        EXPECT_TRUE(complaint.contains(view) && complaint.contains(hint)) << complaint.toStdString();
        EXPECT_FALSE(QFile::exists(path)) << view.toStdString();
    };
    const QString pixel = QStringLiteral("--pixel X,Y");
    for (const char* const view : {"profile", "footprint", "rows", "steps", "duel"}) {
        refused(QString::fromLatin1(view), pixel);
    }
    refused(QStringLiteral("compare"), QStringLiteral("--tracers A,B"));
    refused(QStringLiteral("drawn"), QString());
    scenario.camera.distance = 20;
    relief::saveScenario(file.toStdString(), scenario);
    refused(QStringLiteral("profile"), pixel, {QStringLiteral("--pixel"), QStringLiteral("0,0")});  // the sky
}

// The command chooses pixel, methods and size; the result is the very picture of that size, also inside a PDF.
TEST(Exports, theCommandChoosesWhatIsShown) {
    const QTemporaryDir folder;
    relief::Scenario scenario = smallScenario();
    scenario.pixel.reset();
    const QString file = folder.filePath(QStringLiteral("scenario.json"));
    relief::saveScenario(file.toStdString(), scenario);
    const QStringList size{QStringLiteral("--pixels"), QStringLiteral("320x240"), QStringLiteral("--no-caption")};
    const QImage shown(
        exportedFigure(file, QStringLiteral("result"), folder.filePath(QStringLiteral("result.png")), size));
    relief::Work work;
    relief::Scenario wanted = scenario;
    wanted.width = 320;
    wanted.height = 240;
    EXPECT_EQ(shown.convertToFormat(QImage::Format_RGB32), SnapshotMaker().make({wanted}, work)->picture);
    const QByteArray pdf =
        contents(exportedFigure(file, QStringLiteral("result"), folder.filePath(QStringLiteral("result.pdf")), size));
    EXPECT_TRUE(pdf.contains("/Width 320"));
    EXPECT_FALSE(pdf.contains("/DCTDecode")) << "lossy";
    const QString profile =
        exportedFigure(file, QStringLiteral("profile"), folder.filePath(QStringLiteral("profile.svg")),
                       {QStringLiteral("--pixel"), QStringLiteral("60,70"), QStringLiteral("--tracers"),
                        QStringLiteral("cone,layers")});
    const QString words = QString::fromUtf8(contents(profile));
    EXPECT_TRUE(words.contains(QStringLiteral("(60, 70)")));
    EXPECT_TRUE(words.contains(QStringLiteral(" cone ")));
    for (const auto& [option, value] :
         {std::pair("--pixel", "60"), std::pair("--pixel", "9999,1"), std::pair("--tracers", "nothing"),
          std::pair("--tracers", "exact,exact,exact,exact,exact"), std::pair("--pixels", "0x9")}) {
        QString complaint;
        EXPECT_EQ(exportFigure({file, QStringLiteral("--export"), QStringLiteral("profile"), QStringLiteral("-o"),
                                folder.filePath(QStringLiteral("no.svg")), QString::fromLatin1(option),
                                QString::fromLatin1(value)},
                               &complaint),
                  2);
        EXPECT_TRUE(complaint.contains(QString::fromLatin1(option))) << complaint.toStdString();
    }
}

TEST(Exports, theTraceIsPixelsAlone) {
    const QTemporaryDir folder;
    const QString scenario = writeScenario(folder, false);
    QString complaint;
    EXPECT_EQ(exportFigure({scenario, QStringLiteral("--export"), QStringLiteral("trace"), QStringLiteral("-o"),
                            folder.filePath(QStringLiteral("trace.svg"))},
                           &complaint),
              2);
    EXPECT_EQ(complaint.count('\n'), 1) << complaint.toStdString();
    EXPECT_TRUE(complaint.contains(QStringLiteral("png"))) << complaint.toStdString();
    EXPECT_FALSE(QFile::exists(folder.filePath(QStringLiteral("trace.svg"))));
}

// Pixels near the colour.
int like(const QImage& image, Rgba color) {
    constexpr int kNear = 40;
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor c = image.pixelColor(x, y);
            count += std::abs(c.red() - color.r) + std::abs(c.green() - color.g) + std::abs(c.blue() - color.b) < kNear;
        }
    }
    return count;
}

// From the panes of a window: the same picture, at the asked-for size.
TEST_F(WindowTest, PanesAreExportedAtAnySize) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {{"layers", "8"}}};
    scenario.comparison.others = {{"max-pyramid", {}}};
    openWindow(scenario);
    const QTemporaryDir folder;
    const QString trace = folder.filePath(QStringLiteral("trace.png"));
    window_->pane<Trace3dView>()->saveFigure({trace, 900});
    const QImage solid(trace);
    ASSERT_EQ(solid.width(), 900);
    Style style = workspace_->style();
    style.theme = Theme::Light;
    EXPECT_EQ(solid.pixelColor(2, 2), QColor(style.background().r, style.background().g, style.background().b));
    // Shaded by the light, yet the ray's hue is there in a line of it.
    EXPECT_GT(like(solid, {170, 74, 0, 255}), 100) << "the ray";
    // The slabs of the pyramid, from where they are seen.
    window_->pane<PyramidView>()->setStacked(true);
    grab(window_->pane<PyramidView>());
    const QString slabs = folder.filePath(QStringLiteral("slabs.png"));
    window_->pane<PyramidView>()->saveFigure({slabs, 900});
    EXPECT_EQ(QImage(slabs).width(), 900);
    EXPECT_GT(colorsIn(QImage(slabs)), 30);
    // They fill the page.
    const QImage page(slabs);
    QRect ink;
    int inked = 0;
    for (int y = 0; y < page.height(); ++y) {
        for (int x = 0; x < page.width(); ++x) {
            if (page.pixel(x, y) == page.pixel(0, 0)) continue;
            ink |= QRect(x, y, 1, 1);
            ++inked;
        }
    }
    EXPECT_GT(ink.width() * ink.height(), 0.6 * page.width() * page.height());
    EXPECT_GT(inked, 0.35 * page.width() * page.height());
    EXPECT_TRUE(page.rect().adjusted(2, 2, -2, -2).contains(ink));
    // The pane itself goes on drawing.
    EXPECT_GT(colorsIn(grab(window_->pane<Trace3dView>())), 30);
    for (const QString& view : {QStringLiteral("result"), QStringLiteral("steps"), QStringLiteral("skipped")}) {
        const QString path = folder.filePath(view + QStringLiteral(".png"));
        window_->saveView(view, {path, 640});
        ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path); }, 10000));
        EXPECT_EQ(QImage(path).width(), 640) << view.toStdString();
        EXPECT_GT(colorsIn(QImage(path)), 8) << view.toStdString();
    }
    // The chosen step is the one that the table marks.
    workspace_->chooseStep(0);
    const QString first = folder.filePath(QStringLiteral("first.svg"));
    window_->saveView(QStringLiteral("steps"), {first});
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(first); }, 10000));
    workspace_->chooseStep(2);
    const QString third = folder.filePath(QStringLiteral("third.svg"));
    window_->saveView(QStringLiteral("steps"), {third});
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(third); }, 10000));
    EXPECT_NE(contents(first), contents(third));
    EXPECT_TRUE(contents(third).contains(window_->time()->table()->sentence().left(12).toUtf8()));
}

// A figure that takes long is cancelled with everything else that runs; the file that was there stays.
TEST_F(WindowTest, AnExportIsCancelled) {
    relief::Scenario scenario = smallScenario();
    scenario.filter.name = relief::kSupersample;
    scenario.filter.samples = 3;
    openWindow(scenario);
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("large.png"));
    relief::writeTextFile(path.toStdString(), "of before");
    QSignalSpy notices(workspace_.get(), &Workspace::notice);
    QSignalSpy progress(&workspace_->tasks(), &BackgroundTasks::progress);
    window_->saveView(QStringLiteral("result"), {path, 3000});
    EXPECT_TRUE(workspace_->tasks().busy());
    ASSERT_TRUE(QTest::qWaitFor([&] { return progress.size() > 1; }, kPatienceMs));
    QTest::keyClick(window_.get(), Qt::Key_Escape);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !workspace_->tasks().busy(); }, 10000));
    ASSERT_EQ(notices.size(), 1);
    EXPECT_TRUE(notices[0][0].toString().contains(path));
    EXPECT_EQ(contents(path), "of before");
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1) << "nothing is left beside it";
}

// The window names its own controls, not options of the command.
TEST_F(WindowTest, NothingToExportIsSaidInTheWindowsWords) {
    relief::Scenario scenario = smallScenario();
    scenario.pixel.reset();
    openWindow(scenario);
    QSignalSpy problems(workspace_.get(), &Workspace::problem);
    const QTemporaryDir folder;
    window_->saveView(QStringLiteral("steps"), {folder.filePath(QStringLiteral("steps.svg"))});
    ASSERT_EQ(problems.size(), 1);
    EXPECT_TRUE(problems[0][0].toString().contains(QStringLiteral("no pixel is chosen")));
    EXPECT_FALSE(problems[0][0].toString().contains(QStringLiteral("--")));
}

}  // namespace

}  // namespace reliefui
