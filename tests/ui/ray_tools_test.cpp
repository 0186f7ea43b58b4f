// Finding interesting pixels, bookmarks, guessing, steps of an external tracer.
#include <cmath>
#include <fstream>

#include <QApplication>
#include <QInputDialog>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QTimer>

#include "panes/drawing_canvas.h"
#include "panes/profile/profile_view.h"
#include "panes/steps/step_table.h"
#include "panes/trace/trace3d_view.h"
#include "relief/files.h"
#include "scenario/ray_files.h"
#include "window_fixture.h"
#include "windows/bookmarks.h"
#include "windows/other_bar.h"
#include "windows/time_pane.h"
#include "workspace/pixel_finder.h"

namespace reliefui {

namespace {

relief::Scenario coarseLayers() {
    relief::Scenario scenario = smallScenario();
    scenario.method = {"layers", {{"layers", "6"}}};
    scenario.comparison.others.clear();
    return scenario;
}

TEST_F(WindowTest, PixelsWorthSeeingAreVisitedOneByOne) {
    openWindow(coarseLayers());
    QSignalSpy reported(window_->finder(), &PixelFinder::reported);
    const auto press = [&](Qt::Key key) {
        QTest::keyClick(window_.get(), key, Qt::ShiftModifier);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window_->finder()->busy(); }, 20000));
        waitForFull();
    };
    relief::Work work;
    const relief::ErrorLayer errors =
        relief::errorAgainstExact(*snapshot()->frame, *snapshot()->request, *snapshot()->maps, work);
    press(Qt::Key_E);
    const auto& found = window_->finder()->found();
    ASSERT_GT(found.size(), 1U);
    EXPECT_EQ(found.front().value, static_cast<float>(errors.largest));
    EXPECT_EQ(scenario().pixel, (relief::PixelChoice{found[0].x, found[0].y}));
    EXPECT_NEAR(snapshot()->trace.judgement.texels, errors.largest, 1e-5 * errors.largest);
    press(Qt::Key_E);
    EXPECT_EQ(scenario().pixel, (relief::PixelChoice{found[1].x, found[1].y})) << "again: the next";
    press(Qt::Key_O);
    EXPECT_TRUE(snapshot()->trace.judgement.overshoot);
    press(Qt::Key_S);
    EXPECT_EQ(window_->finder()->found().front().value, static_cast<double>(snapshot()->trace.steps.size()));
    press(Qt::Key_D);
    EXPECT_GT(window_->finder()->found().front().value, 0);
    EXPECT_TRUE(reported.last().first().toString().contains(QStringLiteral("exact")));
    // Compared with another method, other pixels of the same picture are found.
    const auto asExact = window_->finder()->found();
    relief::Scenario rival = scenario();
    rival.comparison.others = {{"layers", {{"layers", "7"}}}};
    workspace_->change(rival, QStringLiteral("test"));
    waitForFull();
    press(Qt::Key_D);
    EXPECT_TRUE(reported.last().first().toString().contains(QStringLiteral("layers")))
        << reported.last().first().toString().toStdString();
    EXPECT_NE(window_->finder()->found().front().value, asExact.front().value);
    // Each is one step of undo.
    const auto here = scenario().pixel;
    workspace_->undo();
    EXPECT_NE(scenario().pixel, here);
    // An exact method has no errors.
    relief::Scenario exact = scenario();
    exact.method = {"max-pyramid", {}};
    workspace_->change(exact, QStringLiteral("test"));
    waitForFull();
    press(Qt::Key_E);
    EXPECT_TRUE(window_->finder()->found().empty());
    // An exact method is not compared with another exact one, since they agree everywhere.
    exact = scenario();
    exact.comparison.others = {{"exact", {}}};
    workspace_->change(exact, QStringLiteral("test"));
    waitForFull();
    press(Qt::Key_D);
    EXPECT_FALSE(window_->finder()->found().empty());
    EXPECT_TRUE(reported.last().first().toString().contains(QStringLiteral("layers")));
}

TEST_F(WindowTest, EachPixelOfAMenuIsAStepOfUndo) {
    openWindow(smallScenario());
    // The menu and the dialog run event loops of their own.
    const auto fromMenu = [this](int x, int y) {
        QTimer user;
        QObject::connect(&user, &QTimer::timeout, [] {
            QWidget* const popup = QApplication::activePopupWidget();
            if (popup == nullptr) return;
            const auto* const menu = qobject_cast<QMenu*>(popup);
            EXPECT_NE(menu, nullptr);
            for (QAction* const action : menu != nullptr ? menu->actions() : QList<QAction*>()) {
                if (action->text() == QStringLiteral("Choose this pixel")) action->trigger();
            }
            popup->close();
        });
        user.start(20);
        Q_EMIT window_->result()->menuRequested(window_->result()->mapToGlobal(onScreen(x, y)));
        return *scenario().pixel;
    };
    const relief::PixelChoice menu = fromMenu(60, 70);
    EXPECT_EQ(menu, (relief::PixelChoice{60, 70}));
    QTimer user;
    QObject::connect(&user, &QTimer::timeout, [] {
        QWidget* const modal = QApplication::activeModalWidget();
        if (modal == nullptr) return;
        auto* const dialog = qobject_cast<QInputDialog*>(modal);
        EXPECT_NE(dialog, nullptr);
        if (dialog == nullptr) return void(modal->close());
        dialog->setTextValue(QStringLiteral("20, 30"));
        dialog->accept();
    });
    user.start(20);
    for (QAction* const action : window_->findChildren<QAction*>()) {
        if (action->shortcut() == QKeySequence(QStringLiteral("Ctrl+G"))) action->trigger();
    }
    user.stop();
    const relief::PixelChoice typed = *scenario().pixel;
    EXPECT_EQ(typed, (relief::PixelChoice{20, 30}));
    EXPECT_EQ(fromMenu(100, 90), (relief::PixelChoice{100, 90}));
    workspace_->undo();
    EXPECT_EQ(scenario().pixel, typed);
    workspace_->undo();
    EXPECT_EQ(scenario().pixel, menu);
}

TEST_F(WindowTest, BookmarksKeepPixelCameraAndStep) {
    openWindow(smallScenario());
    workspace_->chooseStep(2);
    const relief::Scenario marked = scenario();
    const QImage picture = snapshot()->picture;
    QTest::keyClick(window_.get(), Qt::Key_B, Qt::ControlModifier);
    ASSERT_EQ(scenario().bookmarks.size(), 1U);
    relief::Scenario elsewhere = scenario();
    elsewhere.camera.azimuth += 25;
    elsewhere.pixel = relief::PixelChoice{20, 100};
    workspace_->change(elsewhere, QStringLiteral("test"));
    waitForFull();
    EXPECT_NE(snapshot()->picture, picture);
    QTest::keyClick(window_.get(), Qt::Key_B, Qt::ControlModifier);
    ASSERT_EQ(scenario().bookmarks.size(), 2U);
    EXPECT_NE(scenario().bookmarks[0].name, scenario().bookmarks[1].name);
    QTest::keyClick(window_.get(), Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
    waitForFull();
    EXPECT_EQ(scenario().camera, marked.camera);
    EXPECT_EQ(scenario().pixel, marked.pixel);
    EXPECT_EQ(scenario().step, 2) << "not the ray's last step";
    EXPECT_EQ(snapshot()->picture, picture) << "the same bits";
    // The list shows and removes bookmarks; undo restores them.
    BookmarkDialog dialog(workspace_.get());
    ASSERT_EQ(dialog.list()->count(), 2);
    dialog.list()->setCurrentRow(0);
    dialog.list()->item(0)->setText(QString::fromUtf8("шпиль"));
    EXPECT_EQ(scenario().bookmarks[0].name, std::string("шпиль"));
    const relief::Scenario named = scenario();
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("marks.json"));
    workspace_->save(path);
    dialog.list()->setCurrentRow(0);
    dialog.remove();
    EXPECT_EQ(scenario().bookmarks.size(), 1U);
    workspace_->undo();
    EXPECT_EQ(scenario(), named);
    workspace_->undo();
    workspace_->open(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return scenario() == named; }, 5000));
    waitForFull();
    // The menu lists them.
    window_->bookmarks()->fill();
    bool offered = false;
    for (QAction* const action : window_->findChildren<QAction*>()) {
        offered = offered || action->text().contains(QString::fromUtf8("шпиль"));
    }
    EXPECT_TRUE(offered);
    // Enter goes there, as the list's tip says.
    BookmarkDialog opened(workspace_.get());
    opened.show();
    opened.list()->setCurrentRow(1);
    QTest::keyClick(opened.list(), Qt::Key_Return);
    EXPECT_EQ(scenario().pixel, elsewhere.pixel);
    waitForFull();
    // Of a ray with fewer steps the last one is chosen; the next bookmark is found from there.
    const relief::Camera camera = scenario().camera;
    const relief::Bookmark longer{"b", {90, 80}, camera, 10000};
    workspace_->setBookmarks(
        {{"a", {60, 50}, camera, 0}, longer, {"c", {90, 80}, camera, 20000}, {"d", {30, 40}, camera, 0}},
        QStringLiteral("test"));
    for (const auto& pixel : std::vector<relief::PixelChoice>{{60, 50}, {90, 80}, {90, 80}, {30, 40}}) {
        window_->bookmarks()->next();
        waitForFull();
        EXPECT_EQ(scenario().pixel, pixel);
    }
    for (int n = 0; n < 2; ++n) {
        workspace_->goTo(longer);
        waitForFull();
        EXPECT_EQ(scenario().step, static_cast<int>(snapshot()->trace.steps.size()) - 1);
    }
}

TEST_F(WindowTest, WhoGuessesSeesNoAnswerUntilTheClick) {
    openWindow(smallScenario());
    const relief::Hit hit = snapshot()->trace.hit;
    const std::size_t steps = snapshot()->trace.steps.size();
    ASSERT_EQ(hit.outcome, relief::Outcome::Hit);
    QTest::keyClick(window_.get(), Qt::Key_6);
    QTest::qWait(200);
    const int step = scenario().step;
    QTest::keyClick(window_.get(), Qt::Key_G);
    EXPECT_TRUE(workspace_->guessing());
    EXPECT_TRUE(snapshot()->trace.steps.empty());
    EXPECT_NE(snapshot()->trace.hit.outcome, relief::Outcome::Hit);
    EXPECT_EQ(window_->time()->table()->table()->model()->rowCount(), 0);
    const auto* const status = window_->findChild<QLabel*>(QStringLiteral("status-pixel"));
    EXPECT_FALSE(status->text().contains(QString::number(hit.lambda, 'f', 3)));
    workspace_->chooseStep(0);
    EXPECT_EQ(scenario().step, step);
    // Escape ends a search for pixels, which then chooses none, and not the guessing as well.
    const auto pixel = scenario().pixel;
    QSignalSpy reported(window_->finder(), &PixelFinder::reported);
    const auto search = [&] { QTest::keyClick(window_.get(), Qt::Key_S, Qt::ShiftModifier); };
    const auto searched = [&] { return QTest::qWaitFor([&] { return !window_->finder()->busy(); }, 20000); };
    search();
    EXPECT_TRUE(window_->finder()->busy());
    QTest::keyClick(window_.get(), Qt::Key_Escape);
    ASSERT_TRUE(searched());
    EXPECT_EQ(reported.last().first().toString(), QStringLiteral("The search was cancelled"));
    EXPECT_TRUE(window_->finder()->found().empty());
    EXPECT_EQ(scenario().pixel, pixel);
    EXPECT_TRUE(workspace_->guessing());
    reported.clear();
    search();
    ASSERT_TRUE(searched());
    EXPECT_EQ(reported.size(), 2) << "that it begins, and the pixel";
    const auto& found = window_->finder()->found();
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(scenario().pixel, (relief::PixelChoice{found[0].x, found[0].y}));
    workspace_->choosePixel(pixel->x, pixel->y);
    waitForFull();
    ProfileView* const profile = window_->pane<ProfileView>();
    QTest::qWait(200);
    // A click at two thirds of the way to the hit.
    const double guess = hit.lambda * 2 / 3;
    const QPoint at = profile->canvas()->toWidget(profile->frame().onRay(guess)).toPoint();
    QTest::mouseClick(profile->canvas(), Qt::LeftButton, Qt::NoModifier, at);
    EXPECT_FALSE(workspace_->guessing());
    EXPECT_EQ(snapshot()->trace.steps.size(), steps);
    EXPECT_EQ(snapshot()->trace.hit.lambda, hit.lambda);
    ASSERT_TRUE(profile->options().guess);
    const double texel = profile->frame().run > 0 ? 1 / profile->frame().run : 0.01;
    EXPECT_NEAR(*profile->options().guess, guess, texel) << "within one pixel of the screen";
    // For another ray there is no guess.
    workspace_->choosePixel(30, 100);
    waitForFull();
    QTest::qWait(100);
    EXPECT_FALSE(profile->options().guess);
}

TEST_F(WindowTest, AGuessInAPaneThatIsBeingHiddenShowsTheAnswer) {
    openWindow(smallScenario());
    ProfileView* const profile = window_->pane<ProfileView>();
    QTest::keyClick(window_.get(), Qt::Key_6);
    workspace_->setGuessing(true);
    QTest::qWait(200);
    const QPointF at = profile->canvas()->toWidget(profile->frame().onRay(0.3));
    QMouseEvent press(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier);
    QMouseEvent release(QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(profile->canvas(), &press);
    profile->hide();
    QApplication::sendEvent(profile->canvas(), &release);
    EXPECT_FALSE(workspace_->guessing());
    EXPECT_EQ(scenario().step, static_cast<int>(snapshot()->trace.steps.size()) - 1);
}

// Files as another program would write them, here with the steps of one of our methods.
struct OtherFilesOnDisk {
    QTemporaryDir folder;
    QString rays = folder.filePath(QStringLiteral("rays.csv"));
    QString steps = folder.filePath(QStringLiteral("steps.csv"));
    std::vector<std::vector<relief::Step>> logs;

    void write(const QString& path, const std::string& text) const {
        std::ofstream(path.toStdString(), std::ios::binary) << text;
    }
    explicit OtherFilesOnDisk(const Snapshot& snapshot) {
        relief::Work work;
        relief::RayBlock block;
        block.push(snapshot.trace.ray);
        block.push({10.5, 20.25, 31, -7});
        relief::HitBlock hits;
        relief::StepLog log;
        relief::makeTracer({"layers", {{"layers", "5"}}}, snapshot.request->field, *snapshot.maps, work)
            ->trace(block, hits, log, work);
        std::string rayText = std::string(relief::kRaysHeader) + "\n";
        std::string stepText = std::string(relief::kStepsHeader) + "\n";
        for (std::size_t r = 0; r < block.size(); ++r) {
            for (const double value : {block[r].s0, block[r].t0, block[r].a, block[r].b}) {
                rayText += relief::numberText(value, 17) + ",";
            }
            rayText.back() = '\n';
            relief::appendStepLines(stepText, log, r, r);
            const auto first = log.steps.begin() + static_cast<std::ptrdiff_t>(log.begin[r]);
            logs.emplace_back(first, log.steps.begin() + static_cast<std::ptrdiff_t>(log.begin[r + 1]));
        }
        write(rays, rayText);
        write(steps, stepText);
    }
};

TEST_F(WindowTest, AnotherTracersStepsFillThePanes) {
    openWindow(smallScenario());
    const relief::Scenario before = scenario();
    const std::vector<relief::Step> own = snapshot()->trace.steps;
    const OtherFilesOnDisk files(*snapshot());
    EXPECT_FALSE(window_->time()->other()->isVisible());
    window_->time()->other()->open(files.rays, files.steps);
    waitForFull();
    ASSERT_TRUE(snapshot()->other);
    EXPECT_EQ(snapshot()->trace.steps, files.logs[0]);
    EXPECT_TRUE(snapshot()->trace.fromFile);
    EXPECT_TRUE(window_->time()->other()->isVisible());
    EXPECT_EQ(window_->time()->table()->table()->model()->rowCount(), static_cast<int>(files.logs[0].size()));
    EXPECT_EQ(snapshot()->trace.hit.lambda, files.logs[0].back().lambdaAfter);
    EXPECT_GT(colorsIn(grab(window_->pane<Trace3dView>())), 50);
    // The next ray of the file, then our own steps on that ray.
    window_->time()->other()->findChild<QSpinBox*>(QStringLiteral("other-ray"))->setValue(1);
    waitForFull();
    EXPECT_EQ(snapshot()->trace.steps, files.logs[1]);
    EXPECT_EQ(snapshot()->trace.ray, (relief::ViewRay{10.5, 20.25, 31, -7}));
    relief::Scenario ours = scenario();
    ours.other.shown = false;
    workspace_->change(ours, QStringLiteral("test"));
    waitForFull();
    EXPECT_FALSE(snapshot()->trace.fromFile);
    EXPECT_EQ(snapshot()->trace.ray, (relief::ViewRay{10.5, 20.25, 31, -7}));
    EXPECT_EQ(snapshot()->other->steps, files.logs[1]);
    // Saved, opened, undone.
    const QString path = files.folder.filePath(QStringLiteral("other.json"));
    const relief::Scenario set = scenario();
    workspace_->save(path);
    while (workspace_->canUndo()) workspace_->undo();
    waitForFull();
    EXPECT_EQ(scenario(), before);
    EXPECT_EQ(snapshot()->trace.steps, own);
    EXPECT_FALSE(window_->time()->other()->isVisible());
    workspace_->open(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return scenario() == set; }, 5000));
    waitForFull();
    EXPECT_EQ(snapshot()->other->steps, files.logs[1]);
}

// While the other tracer is writing, what was read stays, and so does what is changed meanwhile.
TEST_F(WindowTest, AnotherTracerThatIsWritingUndoesNothing) {
    openWindow(smallScenario());
    const OtherFilesOnDisk files(*snapshot());
    relief::Scenario opened = scenario();
    opened.other = {files.rays.toStdString(), files.steps.toStdString(), 1, true};
    workspace_->change(opened, QStringLiteral("test"));
    waitForFull();
    QSignalSpy problems(workspace_.get(), &Workspace::problem);
    const std::string rays = relief::readTextFile(files.rays.toStdString());
    const std::string text = relief::readTextFile(files.steps.toStdString());
    const auto turn = [&] {
        relief::Scenario turned = scenario();
        turned.camera.azimuth += 5;
        workspace_->change(turned, QStringLiteral("test"));
        waitForFull();
        EXPECT_EQ(scenario(), turned);
        EXPECT_EQ(snapshot()->other->steps, files.logs[1]);
    };
    files.write(files.steps, text.substr(0, text.size() / 2) + "oops");
    turn();
    EXPECT_TRUE(problems.empty());
    workspace_->renew();
    waitForFull();
    EXPECT_EQ(problems.size(), 1);
    turn();
    EXPECT_EQ(problems.size(), 1) << "reported once";
    // A file without the chosen ray.
    files.write(files.steps, text.substr(0, text.find("\n1,") + 1));
    files.write(files.rays, rays.substr(0, rays.rfind('\n', rays.size() - 2) + 1));
    workspace_->renew();
    waitForFull();
    EXPECT_EQ(problems.size(), 2);
    turn();
    files.write(files.rays, rays);
    files.write(files.steps, text);
    workspace_->renew();
    waitForFull();
    EXPECT_FALSE(snapshot()->otherProblem);
}

TEST_F(WindowTest, BadStepsOfAnotherTracerAreRefusedWithTheLine) {
    openWindow(smallScenario());
    const relief::Scenario before = scenario();
    const std::vector<relief::Step> own = snapshot()->trace.steps;
    const OtherFilesOnDisk files(*snapshot());
    QSignalSpy problems(workspace_.get(), &Workspace::problem);
    const auto refused = [&](const QString& rays, const QString& steps) {
        problems.clear();
        window_->time()->other()->open(rays, steps);
        EXPECT_TRUE(QTest::qWaitFor([&] { return !problems.empty(); }, 5000));
        EXPECT_TRUE(QTest::qWaitFor([&] { return !workspace_->busy(); }, 5000));
        EXPECT_EQ(scenario(), before);
        EXPECT_EQ(snapshot()->trace.steps, own);
        return problems.empty() ? QString() : problems.first().first().toString();
    };
    const QString broken = files.folder.filePath(QStringLiteral("broken.csv"));
    files.write(broken, std::string(relief::kStepColumns) + "\n0,1,search,0,0,0,0,0,oops,1,1,0,start,0\n");
    QString text = refused(files.rays, broken);
    EXPECT_TRUE(text.contains(QStringLiteral("broken.csv"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("2"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("oops"))) << text.toStdString();
    text = refused(files.steps, files.steps);
    EXPECT_TRUE(text.contains(QStringLiteral("s0,t0,a,b"))) << text.toStdString();
    text = refused(files.folder.filePath(QStringLiteral("none.csv")), files.steps);
    EXPECT_TRUE(text.contains(QStringLiteral("none.csv"))) << text.toStdString();
    // A texel outside this picture.
    files.write(broken, std::string(relief::kStepColumns) + "\n0,1,search,0,900,0,0,0,0.5,1,0.5,0,test,0.5\n");
    text = refused(files.rays, broken);
    EXPECT_TRUE(text.contains(QStringLiteral("900"))) << text.toStdString();
}

}  // namespace

}  // namespace reliefui
