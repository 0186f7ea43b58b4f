// Annotations: where they are drawn, in figures and on the screen, and how the mouse and keys change them.
#include <cmath>

#include <QDialog>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QTemporaryDir>

#include "panes/annotation_layer.h"
#include "panes/distance/distance_state.h"
#include "panes/drawing_canvas.h"
#include "panes/profile/profile_figure.h"
#include "panes/profile/profile_view.h"
#include "window_fixture.h"
#include "windows/pane_list.h"
#include "workspace/annotation_state.h"
#include "workspace/pane_store.h"

namespace reliefui {

namespace {

Annotation note(AnnotationKind kind, const std::string& view, Point at, const std::string& text, Point to = {}) {
    return {kind, view, at, to, text, "", "text"};
}

// A drawing of `scale` units per unit of data, which starts at the origin and is 100 units of data wide.
AnnotationFrame frameOf(double scale, double unit = 1) {
    return {"profile",
            [scale](Point p) {
                return Point{p.x * scale, p.y * scale};
            },
            [scale](Point p) {
                return Point{p.x / scale, p.y / scale};
            },
            {0, 0, 100 * scale, 100 * scale},
            unit};
}

template <class Primitive>
std::vector<Primitive> all(const Drawing& drawing) {
    std::vector<Primitive> found;
    for (const Item& item : drawing.items) {
        if (const auto* const one = std::get_if<Primitive>(&item.primitive)) found.push_back(*one);
    }
    return found;
}

TEST(Annotations, aTipStaysAtItsDataAtAnyScale) {
    const Annotation arrow = note(AnnotationKind::Arrow, "profile", {30, 40}, "hit", {60, 20});
    for (const double scale : {1.0, 3.0, 10.0}) {
        const auto lines = all<Polyline>(annotationDrawing({arrow}, frameOf(scale), relief::Language::English));
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_TRUE(lines[0].arrow);
        EXPECT_NEAR(lines[0].points.back().x, 60 * scale, 1e-9);
        EXPECT_NEAR(lines[0].points.back().y, 20 * scale, 1e-9);
    }
}

TEST(Annotations, theyAreDrawnOnlyOnTheirViewAndWhereTheirPlaceIsSeen) {
    const auto items = [](const Annotation& one) {
        return annotationDrawing({one}, frameOf(2), relief::Language::English).items.size();
    };
    EXPECT_GT(items(note(AnnotationKind::Label, "profile", {50, 50}, "a")), 0U);
    EXPECT_EQ(items(note(AnnotationKind::Label, "result", {50, 50}, "a")), 0U);
    EXPECT_EQ(items(note(AnnotationKind::Label, "profile", {150, 50}, "a")), 0U);
    EXPECT_EQ(items(note(AnnotationKind::Arrow, "profile", {50, 50}, "a", {150, 50})), 0U);
    EXPECT_GT(items(note(AnnotationKind::Arrow, "profile", {150, 50}, "a", {50, 50})), 0U);
    EXPECT_GT(items(note(AnnotationKind::Bracket, "profile", {-50, 50}, "a", {150, 50})), 0U);
}

TEST(Annotations, textsStayWithinThePlot) {
    const AnnotationFrame frame = frameOf(3);
    for (const Point& at : {Point{0, 0}, Point{100, 0}, Point{0, 100}, Point{100, 100}, Point{50, 50}}) {
        const auto shape =
            annotationShape(note(AnnotationKind::Label, "profile", at, "some words"), frame, relief::Language::English);
        ASSERT_TRUE(shape.shown);
        EXPECT_EQ(shape.plate.cut(frame.seen), shape.plate) << at.x << ", " << at.y;
    }
}

TEST(Annotations, aBracketOpensToTheRightAndItsTextStandsAtTheLeft) {
    const Annotation bracket = note(AnnotationKind::Bracket, "profile", {20, 50}, "step", {80, 50});
    const auto shape = annotationShape(bracket, frameOf(4, 2), relief::Language::English);
    ASSERT_EQ(shape.line.size(), 4U);
    EXPECT_GT(shape.line.front().y, 200) << "downwards, on the way to the right";
    EXPECT_EQ(shape.line[1], (Point{80, 200}));
    EXPECT_EQ(shape.line[2], (Point{320, 200}));
    EXPECT_LT(shape.plate.y1, 200) << "above the bracket";
    EXPECT_NEAR(shape.plate.center().x, 200, 1e-9);
}

TEST(Annotations, aTextIsThatOfTheLanguage) {
    Annotation both = note(AnnotationKind::Label, "profile", {50, 50}, "hit");
    EXPECT_EQ(both.textIn(relief::Language::Ukrainian), "hit");
    both.ukrainian = "влучання";
    EXPECT_EQ(both.textIn(relief::Language::Ukrainian), "влучання");
    EXPECT_EQ(both.textIn(relief::Language::English), "hit");
}

class AnnotationsTest : public WindowTest {
  protected:
    std::vector<Annotation> notes() const { return stateOf<AnnotationState>(scenario()).list; }
    ProfileView* profile() const { return window_->pane<ProfileView>(); }
    DrawingCanvas* canvas() const { return profile()->canvas(); }
    AnnotationLayer* layer() const { return canvas()->findChild<AnnotationLayer*>(); }
    // The widget's point over a place of the profile.
    QPoint over(Point data) const {
        return canvas()->toWidget(profileAnnotations(profile()->frame()).toDrawing(data)).toPoint();
    }
    // The middle of the profile's plot, in the numbers of its axes.
    Point middle() const {
        const AnnotationFrame frame = profileAnnotations(profile()->frame());
        return frame.toData(frame.seen.center());
    }
    void openProfile(const relief::Scenario& of) {
        openWindow(of);
        QTest::keyClick(window_.get(), Qt::Key_6);
        QTest::qWait(300);
        canvas()->setFocus();
    }
    static void drag(QWidget* widget, QPoint from, QPoint to) {
        QTest::mousePress(widget, Qt::LeftButton, Qt::NoModifier, from);
        for (const QPoint& at : {(from + to) / 2, to}) {
            QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                             Qt::NoModifier);
            QApplication::sendEvent(widget, &move);
        }
        QTest::mouseRelease(widget, Qt::LeftButton, Qt::NoModifier, to);
    }
    // Chooses an entry of the menu that is open.
    static void chooseEntry(int number) {
        auto* const menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        ASSERT_NE(menu, nullptr);
        QAction* const entry = menu->actions().at(number);
        ASSERT_TRUE(entry->isEnabled());
        menu->close();
        entry->trigger();
    }
    void answer(const QString& text) {
        auto* const dialog = window_->findChild<QDialog*>(QStringLiteral("annotation-dialog"));
        ASSERT_NE(dialog, nullptr);
        dialog->findChild<QLineEdit*>(QStringLiteral("annotation-text"))->setText(text);
        dialog->accept();
        QTest::qWait(10);
    }
};

TEST_F(AnnotationsTest, KeysAddMoveEditAndRemoveAndUndoBringsBack) {
    openProfile(smallScenario());
    const int step = scenario().step;
    QTest::keyClick(canvas(), Qt::Key_Insert);
    ASSERT_NO_FATAL_FAILURE(chooseEntry(1));  // a label
    ASSERT_NO_FATAL_FAILURE(answer(QStringLiteral("wall")));
    ASSERT_EQ(notes().size(), 1U);
    const Annotation added = notes()[0];
    EXPECT_EQ(added.kind, AnnotationKind::Label);
    EXPECT_EQ(added.view, "profile");
    EXPECT_EQ(added.text, "wall");
    ASSERT_EQ(layer()->chosen(), 0);
    QTest::keyClick(canvas(), Qt::Key_Right, Qt::ShiftModifier);
    QTest::keyClick(canvas(), Qt::Key_Up);
    EXPECT_NEAR(over(notes()[0].at).x() - over(added.at).x(), 10, 1.01);
    EXPECT_NEAR(over(notes()[0].at).y() - over(added.at).y(), -1, 1.01);
    EXPECT_EQ(scenario().pixel, smallScenario().pixel) << "the arrows move no pixel";
    QTest::keyClick(canvas(), Qt::Key_Return);
    ASSERT_NO_FATAL_FAILURE(answer(QStringLiteral("a wall")));
    EXPECT_EQ(notes()[0].text, "a wall");
    QTest::keyClick(canvas(), Qt::Key_Delete);
    EXPECT_TRUE(notes().empty());
    EXPECT_EQ(scenario().step, step);
    workspace_->undo();
    ASSERT_EQ(notes().size(), 1U);
    EXPECT_EQ(notes()[0].text, "a wall");
    workspace_->undo();
    EXPECT_EQ(notes()[0].text, "wall");
    workspace_->undo();
    EXPECT_EQ(notes()[0], added) << "the moves by arrows are one step of undo";
    workspace_->undo();
    EXPECT_TRUE(notes().empty());
    // Without a chosen annotation, arrows act on the window again.
    QTest::keyClick(canvas(), Qt::Key_Insert, Qt::ShiftModifier);
    EXPECT_EQ(layer()->chosen(), -1);
}

TEST_F(AnnotationsTest, NumbersCount) {
    openProfile(smallScenario());
    for (int n = 0; n < 2; ++n) {
        QTest::keyClick(canvas(), Qt::Key_Insert);
        ASSERT_NO_FATAL_FAILURE(chooseEntry(3));
    }
    ASSERT_EQ(notes().size(), 2U);
    EXPECT_EQ(notes()[0].text, "1");
    EXPECT_EQ(notes()[1].text, "2");
    // The moves of each are a step of undo of their own.
    QTest::keyClick(canvas(), Qt::Key_Right);
    QTest::keyClick(canvas(), Qt::Key_Insert, Qt::ShiftModifier);
    ASSERT_EQ(layer()->chosen(), 0);
    const std::vector<Annotation> before = notes();
    QTest::keyClick(canvas(), Qt::Key_Right);
    EXPECT_NE(notes(), before);
    workspace_->undo();
    EXPECT_EQ(notes(), before);
}

TEST_F(AnnotationsTest, TheMouseMovesOneOrItsEnd) {
    openProfile(smallScenario());
    const Point at = middle();
    const Annotation arrow = note(AnnotationKind::Arrow, "profile", {at.x / 2, at.y}, "", at);
    workspace_->change(withState(scenario(), AnnotationState{{arrow}}), {});
    QTest::qWait(50);
    drag(canvas(), over(arrow.to), over(arrow.to) + QPoint(20, 15));
    ASSERT_EQ(notes().size(), 1U);
    EXPECT_EQ(notes()[0].at, arrow.at) << "only its tip is moved";
    EXPECT_NEAR(over(notes()[0].to).x(), over(arrow.to).x() + 20, 1.01);
    EXPECT_NEAR(over(notes()[0].to).y(), over(arrow.to).y() + 15, 1.01);
    workspace_->undo();
    EXPECT_EQ(notes()[0], arrow) << "a drag is one step of undo";
    const QPoint between = (over(arrow.at) + over(arrow.to)) / 2;
    drag(canvas(), between, between + QPoint(0, -12));
    EXPECT_NEAR(over(notes()[0].at).y(), over(arrow.at).y() - 12, 1.01);
    EXPECT_NEAR(over(notes()[0].to).y(), over(arrow.to).y() - 12, 1.01);
}

TEST_F(AnnotationsTest, OnTheScreenItStaysAtItsDataWhenThePaneIsZoomed) {
    openProfile(smallScenario());
    const Point at = middle();
    workspace_->change(withState(scenario(), AnnotationState{{note(AnnotationKind::Label, "profile", at, "here")}}),
                       {});
    for (const double zoom : {1.0, 2.5}) {
        if (zoom > 1) {
            const Point drawn = profileAnnotations(profile()->frame()).toDrawing(at);
            canvas()->zoomTo({drawn.x - 60, drawn.y - 30, drawn.x + 60, drawn.y + 40});
        }
        const QImage with = grab(canvas());
        layer()->hide();
        const QImage without = grab(canvas());
        layer()->show();
        QRect changed;
        for (int y = 0; y < with.height(); ++y) {
            for (int x = 0; x < with.width(); ++x) {
                if (with.pixel(x, y) != without.pixel(x, y)) changed |= QRect(x, y, 1, 1);
            }
        }
        ASSERT_FALSE(changed.isEmpty());
        EXPECT_LE((changed.center() - over(at)).manhattanLength(), 4) << zoom;
    }
}

// A place that the view's figure of this snapshot shows.
Point placeOn(const std::string& view, const Snapshot& shown) {
    const relief::Hit& hit = shown.trace.hit;
    if (view == "result") return {shown.scenario.pixel->x + 0.5, shown.scenario.pixel->y + 0.5};
    if (view == "profile") {
        return {hit.lambda * std::hypot(shown.trace.ray.a, shown.trace.ray.b), 1 - hit.lambda};
    }
    if (view == "footprint") {
        const PixelFootprint& f = *shown.footprint;
        return {f.centre().x / f.perHeight.x, f.centre().y / f.perHeight.y};
    }
    if (view == "distance-x") return {hit.t, 1 - hit.lambda};
    return {hit.s, view == "distance-y" ? 1 - hit.lambda : hit.t};
}

TEST_F(AnnotationsTest, EveryViewOfTheListShowsThemInEveryFormat) {
    openWindow(smallScenario());
    const QTemporaryDir folder;
    for (const std::string_view name : kAnnotatedViews) {
        const std::string view(name);
        const std::string figure = view.substr(0, view.find('-'));
        DistancePane slice;
        if (figure == "distance") slice.axis = view.back();
        const relief::Scenario bare = withState(scenario(), slice);
        const Point at = placeOn(view, *snapshot());
        const relief::Scenario with = withState(bare, AnnotationState{{note(AnnotationKind::Label, view, at, "Zq7")}});
        const auto written = [&](const char* ending) {
            const QString path = folder.filePath(QString::fromStdString(view + ending));
            relief::Work work;
            writeFigure(*figureKind(figure).make(snapshot(), with), {}, path.toStdString(), work);
            QFile file(path);
            EXPECT_TRUE(file.open(QIODevice::ReadOnly));
            return QString::fromUtf8(file.readAll());
        };
        EXPECT_TRUE(written(".svg").contains(QStringLiteral("Zq7"))) << view;
        EXPECT_TRUE(written(".tikz").contains(QStringLiteral("Zq7"))) << view;
        const auto picture = [&](const relief::Scenario& of) {
            relief::Work work;
            return figureImage(*figureKind(figure).make(snapshot(), of), {}, 500, work);
        };
        EXPECT_NE(picture(with), picture(bare)) << view;
    }
}

}  // namespace
}  // namespace reliefui
