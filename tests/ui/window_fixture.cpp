#include "window_fixture.h"

#include <set>

#include <QApplication>
#include <QFile>
#include <QXmlStreamReader>

#include "windows/pane_list.h"
#include "workspace/start_scenario.h"

namespace reliefui {

namespace {

constexpr int kPatienceMs = 120000;
constexpr int kDrawMs = 250;

}  // namespace

bool& haveDisplay() {
    static bool have = false;
    return have;
}

relief::Scenario smallScenario() {
    relief::Scenario scenario = startScenario({});
    scenario.pictures.recipeWidth = scenario.pictures.recipeHeight = 64;
    scenario.width = 200;
    scenario.height = 150;
    scenario.pixel = relief::PixelChoice{90, 80};
    return scenario;
}

relief::Scenario deepRay() {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"max-pyramid-paper", {}};
    return scenario;
}

void WindowTest::SetUp() {
    if (!haveDisplay()) GTEST_SKIP() << "no display: the window is not tested";
}

void WindowTest::TearDown() {
    window_.reset();
    workspace_.reset();
}

void WindowTest::openWindow(const relief::Scenario& scenario) {
    workspace_ = std::make_unique<Workspace>(std::make_shared<const StateReaders>(stateReaders()));
    workspace_->start(scenario);
    window_ = std::make_unique<MainWindow>(workspace_.get(), QStringLiteral(RELIEF_DATASETS));
    window_->resize(1500, 900);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    ASSERT_NO_FATAL_FAILURE(waitForFull());
    // There is no window manager to activate the window.
    QApplication::setActiveWindow(window_.get());
}

void WindowTest::waitForFull() {
    const bool done = QTest::qWaitFor([&] { return snapshot() && !workspace_->busy(); }, kPatienceMs);
    ASSERT_TRUE(done) << "no picture in time";
    ASSERT_FALSE(snapshot()->coarse);
    ASSERT_EQ(snapshot()->version, workspace_->version());
}

QImage WindowTest::grab(QWidget* widget) {
    QTest::qWait(kDrawMs);
    return widget->grab().toImage().convertToFormat(QImage::Format_RGB32);
}

void WindowTest::saveFigure(FigureView* view, const QString& path, int pixels) {
    view->saveFigure({path, pixels});
    EXPECT_TRUE(QTest::qWaitFor([&] { return !view->saving(); }, kPatienceMs)) << path.toStdString();
}

int colorsIn(const QImage& image) {
    std::set<QRgb> colors;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) colors.insert(image.pixel(x, y));
    }
    return static_cast<int>(colors.size());
}

bool validFigure(const QString& file) {
    if (file.endsWith(QStringLiteral("png"))) return colorsIn(QImage(file)) > 20;
    QFile data(file);
    if (!data.open(QIODevice::ReadOnly)) return false;
    const QByteArray bytes = data.readAll();
    if (file.endsWith(QStringLiteral("pdf"))) return bytes.startsWith("%PDF") && bytes.trimmed().endsWith("%%EOF");
    QXmlStreamReader xml(bytes);
    int texts = 0;
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QStringLiteral("text")) ++texts;
        if (xml.name() == QStringLiteral("image")) return false;
    }
    return !xml.hasError() && texts > 10;
}

}  // namespace reliefui
