// Every view can be exported without a display: lines and text to SVG and PDF, everything to PNG.
#include <algorithm>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "../small_disk.h"
#include "foreign_tracer.h"
#include "golden.h"
#include "panes/figure.h"
#include "panes/pyramid/pyramid_view.h"
#include "panes/steps/step_table.h"
#include "panes/trace/trace3d_view.h"
#include "window_fixture.h"
#include "windows/message_bar.h"
#include "windows/pane_list.h"
#include "windows/share.h"
#include "windows/time_pane.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

namespace {

constexpr int kPatienceMs = 60000;

// Runs the program without a display and platform setting; in Ukrainian by default.
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
    // Cyrillic text between <text> and </text>, as opposed to a title.
    const QRegularExpression words(QStringLiteral("<text[^>]*>[^<]*[а-яіїєґ]{3}[^<]*</text>"));
    return words.match(QString::fromUtf8(svg)).hasMatch();
}

// A scenario with everything that a view may need: a ray, methods to compare with; for the pane "drawn" a relief drawn
// by hand, for "doctor" the files of another tracer.
QString writeScenario(const QTemporaryDir& folder, bool drawn, bool foreign = false) {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {{"layers", "8"}}};
    scenario.comparison.others = {{"max-pyramid", {}}};
    scenario.step = 1;
    if (drawn) {
        scenario.pictures = {};
        scenario.pictures.drawn.width = scenario.pictures.drawn.height = 8;
        for (int i = 0; i < 64; ++i) scenario.pictures.drawn.heights.push_back((i * 7 % 64) / 64.0);
    }
    if (foreign) {
        scenario.pictures.recipe = "fractal";
        scenario = withForeignTracer(scenario, folder, true);
    }
    const QString path = folder.filePath(drawn ? QStringLiteral("drawn.json") : QStringLiteral("scenario.json"));
    relief::saveScenario(path.toStdString(), scenario);
    return path;
}

// Exact sizes in pixels: 127 mm at 80 dpi are 400, a column of a paper at 96 dpi 317. Captions are omitted, because
// they contain paths of this machine.
const QStringList& pictureSize() {
    static const QStringList size{QStringLiteral("--width"), QStringLiteral("127"), QStringLiteral("--dpi"),
                                  QStringLiteral("80"), QStringLiteral("--no-caption")};
    return size;
}

const QStringList& darkColumn() {
    static const QStringList size{QStringLiteral("--width"), QStringLiteral("84"),           QStringLiteral("--dpi"),
                                  QStringLiteral("96"),      QStringLiteral("--no-caption"), QStringLiteral("--dark")};
    return size;
}

// Exports a figure of a scenario file and checks that no message is printed. Returns `path`.
QString exportedFigure(const QString& scenario, const QString& view, const QString& path, const QStringList& more = {},
                       const char* language = "uk_UA.UTF-8") {
    QString complaint;
    const int status =
        exportFigure(QStringList{scenario, QStringLiteral("--export"), view, QStringLiteral("-o"), path} + more,
                     &complaint, language);
    EXPECT_EQ(complaint.toStdString(), "");
    EXPECT_EQ(status, 0) << path.toStdString();
    return path;
}

// Text is text, in TrueType fonts that are embedded as far as they are used; pdffonts is asked where it is installed.
void expectTrueType(const QByteArray& pdf, const QString& path) {
    const int fonts = pdf.count("/Subtype /CIDFontType2");
    EXPECT_GT(fonts, 0);
    EXPECT_EQ(pdf.count("/FontFile2"), fonts);
    for (const char* const other : {"/Type3", "/Type1", "/FontFile3"}) EXPECT_FALSE(pdf.contains(other)) << other;
    if (QStandardPaths::findExecutable(QStringLiteral("pdffonts")).isEmpty()) return;
    QProcess process;
    process.start(QStringLiteral("pdffonts"), {path});
    ASSERT_TRUE(process.waitForFinished(kPatienceMs));
    const QStringList lines = QString::fromUtf8(process.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts).mid(2);
    EXPECT_EQ(lines.size(), fonts);
    for (const QString& line : lines) {
        // Type, encoding, embedded, a name as of a subset (Qt embeds the letters that occur under the font's own name),
        // with characters' Unicode.
        EXPECT_TRUE(line.contains(QRegularExpression(QStringLiteral("CID TrueType +Identity-H +yes +(yes|no) +yes "))))
            << line.toStdString();
    }
}

class EveryExport : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryExport, needsNoDisplay) {
    const QTemporaryDir folder;
    const std::string& name = GetParam();
    const QString view = QString::fromStdString(name);
    const QString scenario = writeScenario(folder, name == "drawn", name == "doctor");
    const auto run = [&](const QString& ending, const QStringList& more = {}) {
        return exportedFigure(scenario, view, folder.filePath(view + ending), more);
    };
    const QString picture = run(QStringLiteral(".png"), pictureSize());
    const QImage image(picture);
    EXPECT_EQ(image.width(), 400);
    EXPECT_GT(colorsIn(image), 8);
    // These two show measured times; charts_test.cpp and compare_test.cpp compare other figures of them.
    if (name != "charts" && name != "compare") expectGolden(picture, name);
    if (name == "slabs") return;
    // In English and dark, with the width of a column; for two views another scenario is used below.
    if (name != "charts" && name != "compare" && name != "formula" && name != "footprint" && name != "trace") {
        expectGolden(exportedFigure(scenario, view, folder.filePath(view + QStringLiteral("-english.png")),
                                    darkColumn(), "C.UTF-8"),
                     name + "-english");
    }
    const QByteArray svg = contents(run(QStringLiteral(".svg")));
    if (name == "result") {
        EXPECT_TRUE(svg.contains("<image"));
    } else {
        EXPECT_TRUE(hasCyrillic(svg));
        EXPECT_TRUE(svg.contains("<path") || svg.contains("<polyline") || svg.contains("<rect"));
    }
    const QByteArray pdf = contents(run(QStringLiteral(".pdf")));
    EXPECT_TRUE(pdf.startsWith("%PDF"));
    expectTrueType(pdf, folder.filePath(view + QStringLiteral(".pdf")));
}

// What each kind of method samples: nodes, voxels and spheres, round cones and square ones; from outside and in a
// cross-section.
TEST(Exports, sampledDataOfMethodsIsDrawnAsStored) {
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

// In English and dark: a descent of the paper's recursion, and the weights of an ellipse's texels.
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
        exportedFigure(file, QString::fromLatin1(view), path, pictureSize() + QStringList{QStringLiteral("--dark")},
                       "C.UTF-8");
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

// A figure with more pixels looks the same: lines cover the same share of it.
TEST(Exports, linesOnSlabsAreAsWideAtAnyResolution) {
    const QTemporaryDir folder;
    // The way of the ray between the levels is what has colours.
    const QString scenario = folder.filePath(QStringLiteral("walk.json"));
    relief::saveScenario(scenario.toStdString(), deepRay());
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
        constexpr int kColoured = 60;  // heights, frames and text are grey
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y).saturation() > kColoured ? 1 : 0;
        }
        return static_cast<double>(count) / image.width() / std::max(1, image.height());
    };
    const double coarse = covered("96"), fine = covered("288");
    EXPECT_GT(coarse, 0.002);
    // Antialiasing reduces the saturation of thin lines in the coarse figure; lines of twice the width would differ
    // much more.
    EXPECT_LT(fine / coarse, 1.4);
    EXPECT_GT(fine / coarse, 0.6);
}

// The legend is below the picture, which is unchanged; in vector formats its text is text.
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
        // The legend does not overlap the picture: its colours depend on the theme, those of the picture do not.
        const QImage dark(image(QString::fromLatin1(layer), QStringLiteral(".png"), {QStringLiteral("--dark")}));
        const QRect edge(0, plain.height() - 40, 60, 38);
        EXPECT_EQ(picture.copy(edge), dark.copy(edge)) << layer;
        EXPECT_NE(picture.copy(edge.translated(0, 40)), dark.copy(edge.translated(0, 40))) << layer;
        EXPECT_GT(colorsIn(picture.copy(0, plain.height() + 1, picture.width(), below - 1)), 8) << layer;
    }
    EXPECT_TRUE(hasCyrillic(contents(image(QStringLiteral("outcome"), QStringLiteral(".svg")))));
}

// The caption of a figure names pictures, method with its options, pixel and step, and only adds to the height.
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

// If there is nothing to draw, an error says what is missing, and no file is written.
TEST(Exports, nothingToDrawIsAnError) {
    const QTemporaryDir folder;
    relief::Scenario scenario = smallScenario();
    scenario.pixel.reset();
    scenario.comparison.others.clear();
    const QString file = folder.filePath(QStringLiteral("empty.json"));
    relief::saveScenario(file.toStdString(), scenario);
    const QString path = folder.filePath(QStringLiteral("figure.png"));
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
    for (const char* const view : {"profile", "footprint", "rows", "steps", "duel", "trace"}) {
        refused(QString::fromLatin1(view), pixel);
    }
    refused(QStringLiteral("compare"), QStringLiteral("--tracers A,B"));
    refused(QStringLiteral("drawn"), QString());
    scenario.camera.distance = 20;
    relief::saveScenario(file.toStdString(), scenario);
    refused(QStringLiteral("profile"), pixel, {QStringLiteral("--pixel"), QStringLiteral("0,0")});  // the sky
}

// Qt's writers of SVG and PDF report no failed write.
TEST(Exports, aFullDiskLeavesTheOldFigure) {
    const QTemporaryDir folder;
    const auto lines = paintedFigure(
        [](QPainter& painter, const Box& page, const Style&) {
            for (int i = 0; i < 20000; ++i) painter.drawLine(QLineF(0, i, page.width(), (i * 7919) % 1000));
        },
        {});
    relief::Work work;
    for (const char* const name : {"figure.svg", "figure.pdf", "figure.png"}) {
        const QString path = folder.filePath(QLatin1String(name));
        QFile old(path);
        ASSERT_TRUE(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
        old.close();
        {
            const relief::test::SmallDisk disk(20000);
            EXPECT_THROW(writeFigure(*lines, {}, path.toStdString(), work), relief::WorkError) << name;
        }
        EXPECT_EQ(contents(path), "old") << name;
        EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).count(QLatin1String(name)), 1);
    }
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 3) << "temporary files are left";
}

// Arguments choose pixel, methods and size; the result equals the picture of that size, also inside a PDF.
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
    relief::Scenario expected = scenario;
    expected.width = 320;
    expected.height = 240;
    EXPECT_EQ(shown.convertToFormat(QImage::Format_RGB32), SnapshotMaker().make({expected}, work)->picture);
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
          std::pair("--tracers", "exact,exact,exact,exact,exact"), std::pair("--pixels", "0x9"),
          std::pair("--pixels", "20000")}) {
        QString complaint;
        EXPECT_EQ(exportFigure({file, QStringLiteral("--export"), QStringLiteral("profile"), QStringLiteral("-o"),
                                folder.filePath(QStringLiteral("no.svg")), QString::fromLatin1(option),
                                QString::fromLatin1(value)},
                               &complaint),
                  2);
        EXPECT_TRUE(complaint.contains(QString::fromLatin1(option))) << complaint.toStdString();
    }
}

// The width in millimetres, with their sign, or by the name of a journal's width.
TEST(Exports, theWidthIsThatOfAJournal) {
    const QTemporaryDir folder;
    const QString scenario = writeScenario(folder, false);
    for (const auto& [width, mm] : {std::pair("column", 84), std::pair("60mm", 60)}) {
        const QString path = folder.filePath(QStringLiteral("figure.png"));
        exportedFigure(
            scenario, QStringLiteral("steps"), path,
            {QStringLiteral("--width"), QString::fromLatin1(width), QStringLiteral("--dpi"), QStringLiteral("254")});
        EXPECT_EQ(QImage(path).width(), 10 * mm) << width;
    }
    for (const char* const wrong : {"84cm", "5mm"}) {
        QString complaint;
        EXPECT_EQ(exportFigure({scenario, QStringLiteral("--export"), QStringLiteral("steps"), QStringLiteral("-o"),
                                folder.filePath(QStringLiteral("no.svg")), QStringLiteral("--width"),
                                QString::fromLatin1(wrong)},
                               &complaint),
                  2)
            << wrong;
        EXPECT_TRUE(complaint.contains(QStringLiteral("--width"))) << complaint.toStdString();
    }
}

TEST(Exports, theSlabsArePixelsAlone) {
    const QTemporaryDir folder;
    const QString scenario = writeScenario(folder, false);
    QString complaint;
    EXPECT_EQ(exportFigure({scenario, QStringLiteral("--export"), QStringLiteral("slabs"), QStringLiteral("-o"),
                            folder.filePath(QStringLiteral("slabs.svg"))},
                           &complaint),
              2);
    EXPECT_EQ(complaint.count('\n'), 1) << complaint.toStdString();
    EXPECT_TRUE(complaint.contains(QStringLiteral("png"))) << complaint.toStdString();
    EXPECT_FALSE(QFile::exists(folder.filePath(QStringLiteral("slabs.svg"))));
}

// Counts the pixels close to the colour.
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

// Exported from the panes of a window: the same picture at the requested size.
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
    // The ray is shaded by the light, but some of its pixels have its colour.
    EXPECT_GT(like(solid, {170, 74, 0, 255}), 100) << "the ray";
    // The slabs of the pyramid, from the current viewpoint.
    window_->pane<PyramidView>()->setStacked(true);
    grab(window_->pane<PyramidView>());
    const QString slabs = folder.filePath(QStringLiteral("slabs.png"));
    window_->pane<PyramidView>()->saveFigure({slabs, 900});
    EXPECT_EQ(QImage(slabs).width(), 900);
    EXPECT_GT(colorsIn(QImage(slabs)), 30);
    // They fill the height of the page, next to their titles.
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
    EXPECT_GT(ink.height(), 0.9 * page.height());
    // The tower is narrow and has gaps: it covers 0.113 of this page.
    constexpr double kSilhouette = 0.1;
    EXPECT_GT(inked, kSilhouette * page.width() * page.height());
    EXPECT_TRUE(page.rect().adjusted(2, 2, -2, -2).contains(ink));
    // The pane itself still draws.
    EXPECT_GT(colorsIn(grab(window_->pane<Trace3dView>())), 30);
    for (const QString& view : {QStringLiteral("result"), QStringLiteral("steps"), QStringLiteral("skipped")}) {
        const QString path = folder.filePath(view + QStringLiteral(".png"));
        window_->saveView(view, {path, 640});
        ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path); }, 10000));
        EXPECT_EQ(QImage(path).width(), 640) << view.toStdString();
        EXPECT_GT(colorsIn(QImage(path)), 8) << view.toStdString();
    }
    // The table marks the chosen step.
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

// A long export is cancelled together with all other background work; an existing file is unchanged.
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
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1) << "no other file remains";
}

// Another process writes pages; if it dies, that is said once.
TEST_F(WindowTest, AWriterThatDiesIsReportedOnce) {
    openWindow(smallScenario());
    QSignalSpy problems(workspace_.get(), &Workspace::problem);
    const QTemporaryDir folder;
    QProcess* const writer = startWriting(workspace_.get(), {QStringLiteral("--lesson")}, folder.path());
    writer->kill();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !problems.isEmpty(); }, kPatienceMs));
    QTest::qWait(50);
    EXPECT_EQ(problems.size(), 1);
    EXPECT_FALSE(cancelWriting(workspace_.get())) << "none is left";
}

// As after a change of language: the window that replaces another says how the writing ended.
TEST_F(WindowTest, AWriterOutlivesItsWindow) {
    openWindow(smallScenario());
    QSignalSpy problems(workspace_.get(), &Workspace::problem);
    startWriting(workspace_.get(), {QStringLiteral("--nonsense")}, QStringLiteral("page.html"));
    window_.reset();
    EXPECT_TRUE(problems.isEmpty()) << "the writer ended with the window";
    window_ = std::make_unique<MainWindow>(workspace_.get(), QString());
    window_->show();
    EXPECT_TRUE(QTest::qWaitFor([&] { return window_->messages()->isProblem(); }, kPatienceMs));
    EXPECT_EQ(problems.size(), 1);
}

// Messages refer to the window's controls, not to options of the command line.
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
    // Menus ask the panes for figures without expecting an error.
    for (const FigureView* const view : window_->findChildren<FigureView*>()) {
        EXPECT_NO_THROW(view->image(64)) << view->accessibleName().toStdString();
    }
}

}  // namespace

}  // namespace reliefui
