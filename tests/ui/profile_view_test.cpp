// The profile pane, operated as by a person; and figures exported without a display.
#include <algorithm>
#include <set>

#include <QDockWidget>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QToolButton>
#include <QXmlStreamReader>

#include "panes/drawing_canvas.h"
#include "panes/profile/profile_view.h"
#include "scenario/scenario.h"
#include "window_fixture.h"

namespace reliefui {

namespace {

class ProfileTest : public WindowTest {
  protected:
    void openProfile(const relief::Scenario& scenario) {
        openWindow(scenario);
        QTest::keyClick(window_.get(), Qt::Key_6);
        QTest::qWait(100);
        ASSERT_TRUE(view()->isVisible());
    }
    ProfileView* view() { return window_->pane<ProfileView>(); }
    DrawingCanvas* canvas() { return view()->canvas(); }
    QPointF onRay(double lambda) { return canvas()->toWidget(view()->frame().onRay(lambda)); }
};

TEST_F(ProfileTest, AClickOnAMarkChoosesItsStep) {
    openProfile(deepRay());
    grab(canvas());
    const auto& steps = snapshot()->trace.steps;
    ASSERT_GT(steps.size(), 4u);
    std::set<int> chosen;
    // Clicks on a grid of points: each mark that is hit chooses its own step.
    for (int y = 6; y < canvas()->height(); y += 6) {
        for (int x = 6; x < canvas()->width(); x += 6) {
            const ItemId id = canvas()->itemAt(QPointF(x, y));
            if (id.kind != ItemKind::Step && id.kind != ItemKind::Hit) continue;
            QTest::mouseClick(canvas(), Qt::LeftButton, Qt::NoModifier, QPoint(x, y));
            const int expected = id.kind == ItemKind::Hit ? static_cast<int>(steps.size()) - 1 : static_cast<int>(id.i);
            EXPECT_EQ(scenario().step, expected);
            chosen.insert(scenario().step);
        }
    }
    EXPECT_EQ(chosen.size(), steps.size());
    const int last = scenario().step;
    workspace_->undo();
    EXPECT_NE(scenario().step, last);
}

TEST_F(ProfileTest, AClickOnAPlateauChoosesAStepAboutItsTexel) {
    relief::Scenario scenario = deepRay();
    scenario.pictures.recipe = "city";
    scenario.camera.elevation = 40;
    scenario.pixel = relief::PixelChoice{90, 95};
    openProfile(scenario);
    window_->findChild<QDockWidget*>(QStringLiteral("profile-pane"))
        ->titleBarWidget()
        ->findChild<QToolButton*>(QStringLiteral("pane-fill"))
        ->click();
    QTest::qWait(100);
    grab(canvas());
    const auto& steps = snapshot()->trace.steps;
    int rows = 0;  // of clicks on texels that share their column with another one
    for (const relief::Step& step : steps) {
        const auto inColumn = [&](const relief::Step& s) { return s.level == step.level && s.i == step.i; };
        for (const double part : {0.2, 0.5, 0.8}) {
            const double lambda = step.lambdaIn + part * (step.lambdaOut - step.lambdaIn);
            const QPoint at = canvas()->toWidget(view()->frame().at(lambda, step.value)).toPoint();
            const ItemId id = canvas()->itemAt(at);
            if (id.kind != ItemKind::Texel || id.level != step.level || id.i != step.i || id.j != step.j) continue;
            QTest::mouseClick(canvas(), Qt::LeftButton, Qt::NoModifier, at);
            const relief::Step& now = steps[static_cast<std::size_t>(this->scenario().step)];
            EXPECT_TRUE(inColumn(now) && now.j == step.j) << idText(id);
            rows += std::any_of(steps.begin(), steps.end(),
                                [&](const relief::Step& s) { return inColumn(s) && s.j != step.j; });
        }
    }
    EXPECT_GT(rows, 2);
}

TEST_F(ProfileTest, ItFollowsTheStepBarAndTheTheme) {
    openProfile(smallScenario());
    workspace_->chooseStep(1);
    const QImage second = grab(canvas());
    EXPECT_GT(colorsIn(second), 50);
    workspace_->chooseStep(static_cast<int>(snapshot()->trace.steps.size()) - 1);
    const QImage last = grab(canvas());
    EXPECT_NE(second, last);
    window_->setLightTheme(true);
    EXPECT_GT(grab(canvas()).pixelColor(2, 2).lightness(), 200);
    window_->setLightTheme(false);
}

TEST_F(ProfileTest, BehindAnotherTabItCatchesUp) {
    openProfile(smallScenario());
    workspace_->chooseStep(1);
    const QImage before = grab(canvas());
    QTest::keyClick(window_.get(), Qt::Key_3);  // the pyramid, in a tab of the same dock area
    QTest::qWait(100);
    ASSERT_TRUE(canvas()->visibleRegion().isEmpty());
    const double run = view()->frame().run;
    workspace_->choosePixel(60, 50);
    waitForFull();
    EXPECT_EQ(view()->frame().run, run) << "a hidden pane is not drawn";
    QTest::keyClick(window_.get(), Qt::Key_6);
    // A busy machine needs some time to paint.
    EXPECT_TRUE(QTest::qWaitFor([&] { return view()->frame().run != run; }, 5000));
    const QImage after = grab(canvas());
    EXPECT_NE(before, after);
    EXPECT_GT(colorsIn(after), 50);
}

TEST_F(ProfileTest, WheelZoomsAtThePointerAndRComesBack) {
    openProfile(smallScenario());
    const QImage home = grab(canvas());
    const double lambda = view()->frame().lambdaEnd / 2;
    const QPointF at = onRay(lambda);
    QWheelEvent wheel(at, canvas()->mapToGlobal(at.toPoint()), {}, QPoint(0, 480), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(canvas(), &wheel);
    EXPECT_NEAR(onRay(lambda).x(), at.x(), 1e-6);
    EXPECT_NEAR(onRay(lambda).y(), at.y(), 1e-6);
    EXPECT_GT(view()->frame().zoom, 2);
    EXPECT_NE(grab(canvas()), home);
    QTest::keyClick(canvas(), Qt::Key_R);
    EXPECT_EQ(view()->frame().zoom, 1);
    EXPECT_EQ(grab(canvas()), home);
}

TEST_F(ProfileTest, HoverReadsOut) {
    openProfile(smallScenario());
    QTest::mouseMove(canvas(), onRay(view()->frame().lambdaEnd / 2).toPoint());
    QTest::qWait(50);
    EXPECT_TRUE(view()->readout().contains(QStringLiteral("surface"))) << view()->readout().toStdString();
    EXPECT_TRUE(view()->readout().contains(QStringLiteral("step"))) << view()->readout().toStdString();
}

TEST_F(ProfileTest, TheSkyHasNoProfile) {
    relief::Scenario scenario = smallScenario();
    scenario.scene = relief::SceneKind::Cube;
    scenario.camera.distance = 4;
    openProfile(scenario);
    workspace_->choosePixel(0, 0);
    waitForFull();
    ASSERT_FALSE(snapshot()->trace.onRelief);
    const QImage shown = grab(canvas());
    EXPECT_GT(colorsIn(shown), 1) << "it says so";
    workspace_->choosePixel(100, 75);
    waitForFull();
    EXPECT_GT(colorsIn(grab(canvas())), 50);
}

// --- Figures that the program exports without a display

struct Exported {
    int status = -1;
    QString err;
};

Exported exportFigure(const QStringList& arguments) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("DISPLAY"));
    environment.insert(QStringLiteral("LC_ALL"), QStringLiteral("C.UTF-8"));
    environment.insert(QStringLiteral("ASAN_OPTIONS"), QStringLiteral("detect_leaks=0"));
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(RELIEFSCOPE), arguments);
    process.waitForFinished(60000);
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            QString::fromUtf8(process.readAllStandardError())};
}

QString savedScenario(const QTemporaryDir& folder, const char* method) {
    relief::Scenario scenario = smallScenario();
    scenario.pictures = {};
    scenario.pictures.recipe = "paper8x8";
    scenario.pictures.recipeWidth = scenario.pictures.recipeHeight = 8;
    scenario.method.name = method;
    const QString path = folder.filePath(QStringLiteral("scenario.json"));
    relief::saveScenario(path.toStdString(), scenario);
    return path;
}

TEST(Figure, EveryViewInEveryFormatIsWellFormedAndNotBlank) {
    const QTemporaryDir folder;
    for (const char* const method : {"max-pyramid-paper", "layers", "offset"}) {
        const QString scenario = savedScenario(folder, method);
        for (const QString& view : {QStringLiteral("profile"), QStringLiteral("pyramid"), QStringLiteral("result")}) {
            for (const QString& ending : {QStringLiteral("svg"), QStringLiteral("pdf"), QStringLiteral("png")}) {
                const QString file = folder.filePath(view + '.' + ending);
                const Exported ran = exportFigure({scenario, QStringLiteral("--export"), view, QStringLiteral("-o"),
                                                   file, QStringLiteral("--width"), QStringLiteral("120"),
                                                   QStringLiteral("--dpi"), QStringLiteral("127")});
                ASSERT_EQ(ran.status, 0) << ran.err.toStdString();
                EXPECT_EQ(ran.err.toStdString(), "");
                QFile bytes(file);
                ASSERT_TRUE(bytes.open(QIODevice::ReadOnly));
                const QByteArray content = bytes.readAll();
                if (ending == QStringLiteral("png")) {
                    const QImage image = QImage::fromData(content);
                    EXPECT_EQ(image.width(), 600) << "120 mm at 127 dots an inch";
                    EXPECT_GT(colorsIn(image), 30) << view.toStdString();
                } else if (ending == QStringLiteral("pdf")) {
                    EXPECT_TRUE(content.startsWith("%PDF-") && content.trimmed().endsWith("%%EOF"));
                    EXPECT_GT(content.size(), 3000);
                } else {
                    QXmlStreamReader xml(content);
                    int texts = 0;
                    int shapes = 0;
                    while (!xml.atEnd()) {
                        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
                        texts += xml.name() == QStringLiteral("text") ? 1 : 0;
                        shapes += xml.name() != QStringLiteral("g") ? 1 : 0;
                    }
                    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
                    EXPECT_GE(texts, view == QStringLiteral("result") ? 0 : 9) << view.toStdString() << " " << method;
                    EXPECT_GT(shapes, view == QStringLiteral("result") ? 0 : 30);
                }
            }
        }
    }
}

TEST(Figure, DarkIsDark) {
    const QTemporaryDir folder;
    const QString scenario = savedScenario(folder, "max-pyramid");
    for (const bool dark : {false, true}) {
        const QString file = folder.filePath(QStringLiteral("profile.png"));
        QStringList arguments{scenario, QStringLiteral("--export"), QStringLiteral("profile"), QStringLiteral("-o"),
                              file};
        if (dark) arguments << QStringLiteral("--dark");
        ASSERT_EQ(exportFigure(arguments).status, 0);
        EXPECT_EQ(QImage(file).pixelColor(2, 2).lightness() < 100, dark);
    }
}

TEST(Figure, FaultsAreSaidInOneLine) {
    const QTemporaryDir folder;
    const QString scenario = savedScenario(folder, "max-pyramid");
    const QString good = folder.filePath(QStringLiteral("a.svg"));
    const auto figure = [&](const QString& view, const QString& file, const QStringList& more = {}) {
        return QStringList{scenario, QStringLiteral("--export"), view, QStringLiteral("-o"), file} + more;
    };
    const QString profile = QStringLiteral("profile");
    const QList<QPair<QStringList, int>> cases{
        {figure(QStringLiteral("nonsense"), good), 2},
        {figure(profile, folder.filePath(QStringLiteral("a.gif"))), 2},
        {figure(profile, folder.filePath(QStringLiteral("missing/a.svg"))), 1},
        {figure(profile, good, {QStringLiteral("--width"), QStringLiteral("3")}), 2},
        {figure(profile, good, {QStringLiteral("--width"), QStringLiteral("wide")}), 2},
        {figure(profile, good, {QStringLiteral("--dpi"), QStringLiteral("1e9")}), 2},
        {{scenario, QStringLiteral("--export"), profile}, 2},
        {{scenario, QStringLiteral("-o"), good}, 2},
    };
    for (const auto& [arguments, status] : cases) {
        const Exported ran = exportFigure(arguments);
        EXPECT_EQ(ran.status, status) << arguments.join(' ').toStdString();
        EXPECT_TRUE(ran.err.startsWith(QStringLiteral("reliefscope: ")) && ran.err.count('\n') == 1)
            << ran.err.toStdString();
        EXPECT_FALSE(QFile::exists(good));
    }
}

}  // namespace

}  // namespace reliefui
