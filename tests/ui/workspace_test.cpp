// Undo, refusals, files: window and scenario always agree.
#include <fstream>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QUrl>

#include "panes/number_control.h"
#include "window_fixture.h"
#include "windows/message_bar.h"
#include "windows/pictures_box.h"
#include "windows/seed_box.h"
#include "windows/top_bar.h"
#include "workspace/start_scenario.h"

namespace reliefui {

namespace {

void drop(QWidget* window, const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window, &event);
}

TEST_F(WindowTest, UndoAndRedoGiveTheSameBits) {
    openWindow(smallScenario());
    std::vector<QImage> pictures{snapshot()->picture};
    std::vector<relief::Scenario> scenarios{scenario()};
    const auto step = [&](const relief::Scenario& next) {
        workspace_->change(next, QStringLiteral("test"));
        waitForFull();
        pictures.push_back(snapshot()->picture);
        scenarios.push_back(scenario());
    };
    relief::Scenario next = scenario();
    next.reliefDepth = 0.3;
    step(next);
    next = scenario();
    next.pictures.recipe = "spikes";
    step(next);
    next = scenario();
    next.camera.azimuth = 30;
    step(next);
    next = scenario();
    next.method.name = "exact";
    step(next);
    EXPECT_NE(pictures[0], pictures[1]);
    EXPECT_NE(pictures[1], pictures[2]);
    EXPECT_NE(pictures[2], pictures[3]);
    EXPECT_EQ(pictures[3], pictures[4]) << "max-pyramid and exact are the same bits";
    for (std::size_t i = pictures.size() - 1; i-- > 0;) {
        workspace_->undo();
        waitForFull();
        EXPECT_EQ(snapshot()->picture, pictures[i]) << i;
        EXPECT_EQ(scenario(), scenarios[i]) << i;
    }
    EXPECT_FALSE(workspace_->canUndo());
    for (std::size_t i = 1; i < pictures.size(); ++i) {
        workspace_->redo();
        waitForFull();
        EXPECT_EQ(snapshot()->picture, pictures[i]) << i;
        EXPECT_EQ(scenario(), scenarios[i]) << i;
    }
    EXPECT_FALSE(workspace_->canRedo());
}

TEST_F(WindowTest, ABadFileIsReportedAndNothingChanges) {
    openWindow(smallScenario());
    const relief::Scenario before = scenario();
    const auto shown = snapshot();
    const QTemporaryDir folder;
    const QString broken = folder.filePath(QString::fromUtf8("зламана картинка.png"));
    std::ofstream(broken.toStdString()) << "this is not a picture";
    const QString badScenario = folder.filePath(QStringLiteral("bad.json"));
    std::ofstream(badScenario.toStdString()) << "{\"reliefscope\": 1, \"surprise\": true}";
    for (const QString& path : {broken, badScenario, folder.filePath(QStringLiteral("missing.png")), folder.path()}) {
        const QSignalSpy problems(workspace_.get(), &Workspace::problem);
        workspace_->open(path);
        waitForFull();
        ASSERT_EQ(problems.count(), 1) << path.toStdString();
        const QString text = problems.front().front().toString();
        EXPECT_FALSE(text.contains('\n'));
        EXPECT_TRUE(text.startsWith(path)) << text.toStdString();
        EXPECT_EQ(window_->messages()->text(), text);
        EXPECT_EQ(scenario(), before);
        EXPECT_EQ(snapshot(), shown);
        EXPECT_FALSE(workspace_->canUndo());
    }
    // A value outside its range is refused at once.
    relief::Scenario impossible = before;
    impossible.reliefDepth = -1;
    const QSignalSpy problems(workspace_.get(), &Workspace::problem);
    workspace_->change(impossible, QStringLiteral("test"));
    EXPECT_EQ(problems.count(), 1);
    EXPECT_EQ(scenario(), before);
}

TEST_F(WindowTest, AVanishedPictureDoesNotStopUndo) {
    openWindow(smallScenario());
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("heights.png"));
    relief::writeHeight(file.toStdString(), relief::FloatImage(16, 16, 0.5F));
    workspace_->open(file);
    waitForFull();
    relief::Scenario next = scenario();
    next.pictures = smallScenario().pictures;
    workspace_->change(next, QStringLiteral("test"));
    waitForFull();
    QFile::remove(file);
    const relief::Scenario before = scenario();
    const QSignalSpy problems(workspace_.get(), &Workspace::problem);
    workspace_->undo();
    waitForFull();
    EXPECT_EQ(problems.count(), 1);
    EXPECT_EQ(scenario(), before);
    EXPECT_TRUE(workspace_->canUndo());
}

TEST_F(WindowTest, ADroppedFileIsOpened) {
    openWindow(smallScenario());
    const QTemporaryDir folder;
    const QString file = folder.filePath(QString::fromUtf8("карта висот.png"));
    relief::FloatImage heights(32, 24, 0.25F);
    heights(5, 7) = 1;
    relief::writeHeight(file.toStdString(), heights);
    drop(window_.get(), file);
    waitForFull();
    EXPECT_EQ(scenario().pictures.height, file.toStdString());
    EXPECT_EQ(snapshot()->assets.heights->width(), 32);
    EXPECT_EQ(snapshot()->assets.heights->height(), 24);
    // Also a scenario, saved by the window.
    const QString saved = folder.filePath(QStringLiteral("scenario.json"));
    workspace_->save(saved);
    const relief::Scenario before = scenario();
    workspace_->undo();
    waitForFull();
    EXPECT_NE(scenario(), before);
    drop(window_.get(), saved);
    waitForFull();
    EXPECT_EQ(scenario(), before);
}

TEST_F(WindowTest, TheDepthSliderChangesThePicture) {
    openWindow(smallScenario());
    const QImage before = snapshot()->picture;
    QSlider* const slider = window_->topBar()->depth()->slider();
    slider->setSliderDown(true);
    slider->setValue(700);
    slider->setSliderDown(false);
    waitForFull();
    EXPECT_NEAR(scenario().reliefDepth, 4 * 0.7 * 0.7 * 0.7, 0.01);
    EXPECT_NE(snapshot()->picture, before);
    EXPECT_NEAR(window_->topBar()->depth()->value(), scenario().reliefDepth, 1e-9);
    workspace_->undo();
    waitForFull();
    EXPECT_EQ(snapshot()->picture, before);
}

TEST_F(WindowTest, AnEditOfAProceduralReliefChangesOnlyThatNumber) {
    relief::Scenario own = smallScenario();
    own.pictures.recipeHeight = 32;
    own.pictures.seed = 12345678901234567890U;
    own.pictures.reading.invert = true;
    workspace_ = std::make_unique<Workspace>();
    workspace_->start(own);
    waitForFull();
    PicturesBox box(workspace_.get());
    auto* const seed = box.findChild<SeedBox*>(QStringLiteral("recipe-seed"));
    EXPECT_EQ(seed->value(), own.pictures.seed);
    seed->stepBy(1);
    waitForFull();
    ++own.pictures.seed;
    EXPECT_EQ(scenario().pictures, own.pictures);
    box.findChild<QSpinBox*>(QStringLiteral("recipe-size"))->setValue(128);
    waitForFull();
    own.pictures.recipeWidth = 128;
    own.pictures.recipeHeight = 64;
    EXPECT_EQ(scenario().pictures, own.pictures);
    seed->findChild<QLineEdit*>()->setText(QStringLiteral("7"));
    Q_EMIT seed->editingFinished();
    waitForFull();
    own.pictures.seed = 7;
    EXPECT_EQ(scenario().pictures, own.pictures);
    auto* const recipe = box.findChild<QComboBox*>(QStringLiteral("recipe"));
    Q_EMIT recipe->activated(recipe->currentIndex());
    EXPECT_FALSE(workspace_->busy()) << "it is chosen already";
}

TEST_F(WindowTest, MethodsAreChosen) {
    openWindow(smallScenario());
    const QImage before = snapshot()->picture;
    QComboBox* const methods = window_->topBar()->method();
    // The list also contains a separator and a heading before the methods that do not search.
    ASSERT_EQ(methods->count(), static_cast<int>(relief::tracerList().size()) + 2);
    const int exact = methods->findData(QStringLiteral("exact"));
    methods->setCurrentIndex(exact);
    Q_EMIT methods->activated(exact);
    waitForFull();
    EXPECT_EQ(scenario().method.name, "exact");
    EXPECT_EQ(snapshot()->picture, before);
    ASSERT_NE(snapshot()->maxima, nullptr);
    ASSERT_NE(snapshot()->means, nullptr);
}

TEST_F(WindowTest, CopyAsCommand) {
    openWindow(smallScenario());
    window_->copyCommand();
    const QString text = QApplication::clipboard()->text();
    EXPECT_EQ(text.toStdString(), relief::traceCommand(scenario()));
    EXPECT_TRUE(text.startsWith(QStringLiteral("relief trace "))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("--pixel 90,80"))) << text.toStdString();
}

TEST_F(WindowTest, ThePictureIsSaved) {
    openWindow(smallScenario());
    const QTemporaryDir folder;
    const QString file = folder.filePath(QString::fromUtf8("результат 1.png"));
    window_->savePicture(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(file); }, 5000));
    EXPECT_EQ(QImage(file).convertToFormat(QImage::Format_RGB32), snapshot()->picture);
    const QSignalSpy problems(workspace_.get(), &Workspace::problem);
    window_->savePicture(folder.filePath(QStringLiteral("no-folder/result.png")));
    EXPECT_TRUE(QTest::qWaitFor([&] { return problems.count() == 1; }, 5000));
}

TEST_F(WindowTest, APictureBeyondMemoryIsRefused) {
    openWindow(smallScenario());
    relief::Scenario huge = scenario();
    huge.width = huge.height = relief::kMaxPictureSide;
    const QSignalSpy problems(workspace_.get(), &Workspace::problem);
    workspace_->change(huge, QStringLiteral("test"));
    EXPECT_EQ(problems.count(), 1);
    EXPECT_EQ(scenario().width, 200);
}

TEST_F(WindowTest, CancelTakesBackWhatIsNotThere) {
    openWindow(smallScenario());
    const relief::Scenario before = scenario();
    relief::Scenario slow = before;
    slow.width = 2000;
    slow.height = 2000;
    slow.method.name = "exact";
    workspace_->change(slow, QStringLiteral("test"));
    EXPECT_TRUE(workspace_->busy());
    workspace_->cancel();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !workspace_->busy(); }, 10000));
    // Either the coarse picture had already been shown and is kept, or everything is as before.
    relief::Scenario shown = snapshot()->scenario;
    shown.step = scenario().step;
    EXPECT_EQ(scenario(), shown);
    if (!snapshot()->coarse) {
        EXPECT_EQ(scenario(), before);
        EXPECT_FALSE(workspace_->canUndo());
    }
}

TEST_F(WindowTest, ClosingDuringWorkIsQuick) {
    openWindow(smallScenario());
    relief::Scenario slow = scenario();
    slow.width = 2000;
    slow.height = 2000;
    slow.method.name = "exact";
    workspace_->change(slow, QStringLiteral("test"));
    QTest::qWait(20);
    QElapsedTimer clock;
    clock.start();
    window_->close();
    window_.reset();
    workspace_.reset();
    EXPECT_LT(clock.elapsed(), 5000);
}

TEST_F(WindowTest, TheFirstPictureExplainsItself) {
    openWindow(startScenario(RELIEF_DATASETS));
    const PixelTrace& trace = snapshot()->trace;
    ASSERT_TRUE(trace.onRelief);
    EXPECT_EQ(trace.hit.outcome, relief::Outcome::Hit);
    std::set<int> skipped;
    int ascents = 0;
    for (const relief::Step& step : trace.steps) {
        if (step.decision == relief::Decision::Skip) skipped.insert(step.level);
        if (step.decision == relief::Decision::Ascend) ++ascents;
    }
    EXPECT_GE(skipped.size(), 4U);
    EXPECT_GE(ascents, 1);
    const auto chosen = static_cast<std::size_t>(scenario().step);
    ASSERT_LT(chosen, trace.steps.size());
    EXPECT_EQ(trace.steps[chosen].decision, relief::Decision::Ascend);
}

}  // namespace

}  // namespace reliefui
