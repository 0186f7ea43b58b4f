#include "panes/annotation_layer.h"

#include <algorithm>
#include <cmath>

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>

#include "painting/painter.h"
#include "panes/annotation_dialog.h"
#include "panes/drawing_canvas.h"
#include "workspace/annotation_state.h"
#include "workspace/change_name.h"
#include "workspace/pane_store.h"
#include "workspace/workspace.h"

namespace reliefui {

namespace {

constexpr double kReach = 7;        // largest distance of a press from an end, in pixels
constexpr int kFarPixels = 10;      // that Shift with an arrow moves
constexpr double kStart = 3;        // length, in pixels, from which a press with movement is a drag
constexpr double kNewArrow = 42;    // sides of a new arrow, in points
constexpr double kNewBracket = 36;  // half the length of a new bracket, in points

double distance(QPointF a, QPointF b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

double distanceToLine(QPointF p, QPointF a, QPointF b) {
    const QPointF d = b - a;
    const double length2 = QPointF::dotProduct(d, d);
    const double t = length2 > 0 ? std::clamp(QPointF::dotProduct(p - a, d) / length2, 0.0, 1.0) : 0;
    return distance(p, a + t * d);
}

// Direction of an arrow key; null for other keys.
QPoint wayOf(int key) {
    switch (key) {
        case Qt::Key_Left:
            return {-1, 0};
        case Qt::Key_Right:
            return {1, 0};
        case Qt::Key_Up:
            return {0, -1};
        case Qt::Key_Down:
            return {0, 1};
        default:
            return {};
    }
}

// Rounds to the last decimal that a tenth of a pixel needs, so that files stay readable.
double rounded(double value, double perPixel) {
    if (!(perPixel > 0) || !std::isfinite(perPixel)) return value;
    const double unit = std::pow(10, -std::floor(std::log10(perPixel / 10)));
    return std::isfinite(unit) ? std::round(value * unit) / unit : value;
}

}  // namespace

AnnotationLayer::AnnotationLayer(Workspace* workspace, QWidget* face, FrameNow frame)
    : QWidget(face), workspace_(workspace), face_(face), frame_(std::move(frame)) {
    setObjectName(QStringLiteral("annotations"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    face_->installEventFilter(this);
    connect(workspace_, &Workspace::panesChanged, this, &AnnotationLayer::adopt);
    connect(workspace_, &Workspace::snapshotChanged, this, &AnnotationLayer::adopt);
    setGeometry(face_->rect());
    hide();
    adopt();
}

AnnotationLayer::AnnotationLayer(Workspace* workspace, DrawingCanvas* canvas, FrameNow frame)
    : AnnotationLayer(workspace, static_cast<QWidget*>(canvas), std::move(frame)) {
    canvas_ = canvas;
}

void AnnotationLayer::adopt() {
    std::vector<Annotation> now = stateOf<AnnotationState>(workspace_->scenario()).list;
    if (now == notes_) return;
    notes_ = std::move(now);
    chosen_ = -1;
    // Panes are repainted faster without a layer over them.
    setVisible(!notes_.empty());
    update();
}

relief::Language AnnotationLayer::language() const {
    return workspace_->style().language;
}

std::optional<AnnotationFrame> AnnotationLayer::frame() const {
    std::optional<AnnotationFrame> now = frame_();
    if (now && canvas_ != nullptr) now->unit = 1 / canvas_->zoom();
    if (now && (now->seen.empty() || !std::isfinite(now->unit))) now.reset();
    return now;
}

QPointF AnnotationLayer::toWidget(Point drawing) const {
    return canvas_ != nullptr ? canvas_->toWidget(drawing) : QPointF(drawing.x, drawing.y);
}

Point AnnotationLayer::toDrawing(QPointF widget) const {
    return canvas_ != nullptr ? canvas_->toDrawing(widget) : Point{widget.x(), widget.y()};
}

// The place in the view's data, std::nullopt outside the part that shows them.
std::optional<Point> AnnotationLayer::dataAt(QPointF widget) const {
    const auto now = frame();
    const Point at = toDrawing(widget);
    if (!now || !now->seen.contains(at)) return std::nullopt;
    return now->toData(at);
}

void AnnotationLayer::paintEvent(QPaintEvent*) {
    const auto now = frame();
    if (!now) return;
    const Style& style = workspace_->style();
    Drawing drawing = annotationDrawing(notes_, *now, style.language);
    if (chosen_ >= 0) {
        const Annotation& note = notes_[static_cast<std::size_t>(chosen_)];
        const AnnotationShape shape = annotationShape(note, *now, style.language);
        if (shape.shown && !shape.plate.empty()) {
            drawing.add({}, Role::Highlight, Rectangle{shape.plate.grown(2 * now->unit)});
        }
        for (const Point& end : {note.at, note.to}) {
            if (shape.shown && note.hasEnd()) drawing.add({}, Role::Highlight, Ring{now->toDrawing(end), 4});
        }
    }
    const QPointF origin = toWidget({0, 0});
    const ViewMap map{toWidget({1, 0}).x() - origin.x(), origin.x(), origin.y()};
    QPainter painter(this);
    reliefui::paint(painter, drawing, map, style, {0, 0, double(width()), double(height())});
}

AnnotationLayer::Part AnnotationLayer::partAt(const Annotation& note, QPointF widget) const {
    const auto now = frame();
    if (!now) return Part::None;
    const AnnotationShape shape = annotationShape(note, *now, language());
    if (!shape.shown) return Part::None;
    const bool bracket = note.kind == AnnotationKind::Bracket;
    const auto near = [&](Point data) { return distance(widget, toWidget(now->toDrawing(data))) <= kReach; };
    if (note.hasEnd() && near(note.to)) return Part::To;
    if (bracket && near(note.at)) return Part::At;
    if (!shape.plate.empty() && shape.plate.contains(toDrawing(widget))) return bracket ? Part::Both : Part::At;
    if (near(note.at)) return Part::At;
    for (std::size_t k = 1; k < shape.line.size(); ++k) {
        if (distanceToLine(widget, toWidget(shape.line[k - 1]), toWidget(shape.line[k])) <= kReach) return Part::Both;
    }
    return Part::None;
}

AnnotationLayer::Grip AnnotationLayer::gripAt(QPointF widget) const {
    for (int n = static_cast<int>(notes_.size()) - 1; n >= 0; --n) {
        const Part part = partAt(notes_[static_cast<std::size_t>(n)], widget);
        if (part != Part::None) return {n, part};
    }
    return {};
}

// Where keys act: at the pointer, or in the middle if it is elsewhere.
QPointF AnnotationLayer::pointer() const {
    const QPointF at = face_->mapFromGlobal(QCursor::pos());
    if (face_->underMouse() && dataAt(at)) return at;
    const auto now = frame();
    return now ? toWidget(now->seen.center()) : QPointF(face_->rect().center());
}

void AnnotationLayer::choose(int note) {
    if (note != chosen_) workspace_->finishInteraction();  // the moves of each are an undo step of their own
    chosen_ = note;
    update();
}

void AnnotationLayer::chooseNext() {
    const auto now = frame();
    const int count = static_cast<int>(notes_.size());
    for (int k = 1; now && k <= count; ++k) {
        const int n = (chosen_ + k) % count;
        if (annotationShape(notes_[static_cast<std::size_t>(n)], *now, language()).shown) return choose(n);
    }
}

// series: merge key of changes that are one step of undo.
void AnnotationLayer::store(std::vector<Annotation> notes, const QString& what, int choice, const char* series) {
    workspace_->change(withState(workspace_->scenario(), AnnotationState{std::move(notes)}), what,
                       QString::fromLatin1(series));
    adopt();
    chosen_ = std::min(choice, static_cast<int>(notes_.size()) - 1);  // not choose(), which would end the series
    update();
}

// The data at a point, without decimals that do not matter there.
Point AnnotationLayer::roundedPlace(const AnnotationFrame& frame, QPointF widget) const {
    const Point here = frame.toData(toDrawing(widget));
    const Point next = frame.toData(toDrawing(widget + QPointF(1, 1)));
    return {rounded(here.x, std::abs(next.x - here.x)), rounded(here.y, std::abs(next.y - here.y))};
}

void AnnotationLayer::add(AnnotationKind kind, QPointF widget) {
    const auto now = frame();
    if (!now || !dataAt(widget)) return;
    const double point = workspace_->style().pixelsPerPoint();
    const QPointF middle = toWidget(now->seen.center());
    const auto place = [&](QPointF at) { return roundedPlace(*now, at); };
    Annotation note;
    note.kind = kind;
    note.view = now->view;
    note.at = place(widget);
    if (kind == AnnotationKind::Arrow) {
        // The tip is at the chosen point, the tail towards the middle, where there is room.
        const double side = kNewArrow * point;
        note.to = note.at;
        note.at =
            place(widget + QPointF(widget.x() < middle.x() ? side : -side, widget.y() < middle.y() ? side : -side));
    } else if (kind == AnnotationKind::Bracket) {
        note.at = place(widget - QPointF(kNewBracket * point, 0));
        note.to = place(widget + QPointF(kNewBracket * point, 0));
    }
    const auto keep = [this](const Annotation& done) {
        std::vector<Annotation> notes = notes_;
        notes.push_back(done);
        const auto last = static_cast<int>(notes.size()) - 1;
        store(std::move(notes), changeName([] { return tr("Add an annotation"); }), last);
    };
    if (kind != AnnotationKind::Number) return ask(note, keep);
    int number = 1;
    for (const Annotation& other : notes_) {
        if (other.kind == kind && other.view == note.view) number = std::max(number, std::atoi(other.text.c_str()) + 1);
    }
    note.text = std::to_string(std::min(number, 999));
    keep(note);
}

void AnnotationLayer::ask(const Annotation& note, const std::function<void(const Annotation&)>& done) {
    auto* const dialog = new AnnotationDialog(note, face_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [dialog, done] { done(dialog->annotation()); });
    connect(dialog, &QDialog::finished, face_, [this] { face_->setFocus(Qt::OtherFocusReason); });
    dialog->open();
}

void AnnotationLayer::edit(int note) {
    if (note < 0) return;
    choose(note);
    ask(notes_[static_cast<std::size_t>(note)], [this, before = notes_, note](const Annotation& done) {
        if (notes_ != before) return;  // undone or removed in the meantime
        std::vector<Annotation> notes = notes_;
        notes[static_cast<std::size_t>(note)] = done;
        store(std::move(notes), changeName([] { return tr("Edit an annotation"); }), note);
    });
}

void AnnotationLayer::remove(int note) {
    if (note < 0) return;
    std::vector<Annotation> notes = notes_;
    notes.erase(notes.begin() + note);
    store(std::move(notes), changeName([] { return tr("Remove an annotation"); }), -1);
}

// Moves the chosen annotation to where `from` would be, moved by so many pixels.
void AnnotationLayer::move(const Annotation& from, Part part, QPointF by) {
    const auto now = frame();
    if (!now || chosen_ < 0) return;
    std::vector<Annotation> notes = notes_;
    Annotation& moving = notes[static_cast<std::size_t>(chosen_)];
    const auto shift = [&](const Point& start, Point& place) {
        const Point there = roundedPlace(*now, toWidget(now->toDrawing(start)) + by);
        if (std::max(std::abs(there.x), std::abs(there.y)) <= kFarthestAnnotation) place = there;
    };
    if (part != Part::To) shift(from.at, moving.at);
    if (moving.hasEnd() && part != Part::At) shift(from.to, moving.to);
    if (notes == notes_) return;
    store(std::move(notes), changeName([] { return tr("Move an annotation"); }), chosen_, "annotation");
}

void AnnotationLayer::addKinds(QMenu& menu, QPointF at) {
    const bool here = dataAt(at).has_value() && notes_.size() < kMostAnnotations;
    const auto entry = [&](const QString& text, AnnotationKind kind) {
        menu.addAction(text, this, [this, kind, at] { add(kind, at); })->setEnabled(here);
    };
    entry(tr("Add an arrow here…"), AnnotationKind::Arrow);
    entry(tr("Add a label here…"), AnnotationKind::Label);
    entry(tr("Add a bracket here…"), AnnotationKind::Bracket);
    entry(tr("Add a number here"), AnnotationKind::Number);
}

void AnnotationLayer::addToMenu(QMenu& menu) {
    QMenu* const kinds = menu.addMenu(tr("Annotate"));
    kinds->setObjectName(QStringLiteral("annotate"));
    addKinds(*kinds, menuAt_);
    kinds->addSeparator();
    const int note = chosen_;
    QAction* const change = kinds->addAction(tr("Edit the annotation…"), this, [this, note] { edit(note); });
    QAction* const away = kinds->addAction(tr("Remove the annotation"), this, [this, note] { remove(note); });
    for (QAction* const action : {change, away}) action->setEnabled(note >= 0);
    menu.addSeparator();
}

bool AnnotationLayer::pressed(QPointF at) {
    drag_ = gripAt(at);
    moved_ = false;
    pressed_ = at;
    if (chosen_ != drag_.note) choose(drag_.note);
    if (drag_.note < 0) return false;
    before_ = notes_[static_cast<std::size_t>(drag_.note)];
    face_->setFocus(Qt::MouseFocusReason);
    workspace_->finishInteraction();  // each drag is a step of undo of its own
    return true;
}

bool AnnotationLayer::dragged(QPointF at) {
    if (drag_.note < 0) return false;
    moved_ = moved_ || distance(at, pressed_) >= kStart;
    if (moved_ && drag_.note == chosen_) move(before_, drag_.part, at - pressed_);
    return true;
}

// Keys that act on annotations rather than on the pane.
bool AnnotationLayer::takes(int key, Qt::KeyboardModifiers modifiers) const {
    const bool shift = (modifiers & Qt::ShiftModifier) != 0;
    const auto now = frame();
    if ((modifiers & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0 || !now) return false;
    if (key == Qt::Key_Insert) return true;
    if (chosen_ < 0) return false;
    const AnnotationShape shape = annotationShape(notes_[static_cast<std::size_t>(chosen_)], *now, language());
    if (!shape.shown) return false;
    if (!wayOf(key).isNull()) return true;
    return !shift && (key == Qt::Key_Delete || key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Escape);
}

bool AnnotationLayer::keyPressed(int key, bool shift) {
    if (const QPoint way = wayOf(key); !way.isNull()) {
        move(notes_[static_cast<std::size_t>(chosen_)], Part::Both, way * (shift ? kFarPixels : 1));
    } else if (key == Qt::Key_Insert && shift) {
        chooseNext();
    } else if (key == Qt::Key_Insert) {
        const QPointF at = pointer();
        auto* const menu = new QMenu(face_);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        menu->setObjectName(QStringLiteral("annotate"));
        addKinds(*menu, at);
        menu->popup(face_->mapToGlobal(at.toPoint()));
    } else if (key == Qt::Key_Delete) {
        remove(chosen_);
    } else if (key == Qt::Key_Escape) {
        choose(-1);
    } else {
        edit(chosen_);
    }
    return true;
}

bool AnnotationLayer::eventFilter(QObject* watched, QEvent* event) {
    if (watched != face_) return false;
    auto* const mouse = dynamic_cast<QMouseEvent*>(event);
    auto* const key = dynamic_cast<QKeyEvent*>(event);
    const bool left = mouse != nullptr && mouse->button() == Qt::LeftButton;
    switch (event->type()) {
        case QEvent::Resize:
            setGeometry(face_->rect());
            return false;
        case QEvent::MouseButtonPress:
            return left && mouse->modifiers() == Qt::NoModifier && pressed(mouse->localPos());
        case QEvent::MouseMove:
            return dragged(mouse->localPos());
        case QEvent::MouseButtonRelease:
            if (!left || drag_.note < 0) return false;
            drag_ = {};
            workspace_->finishInteraction();
            return true;
        case QEvent::MouseButtonDblClick:
            if (!left || gripAt(mouse->localPos()).note < 0) return false;
            edit(gripAt(mouse->localPos()).note);
            return true;
        case QEvent::ContextMenu: {
            const auto* const request = static_cast<QContextMenuEvent*>(event);
            menuAt_ = request->reason() == QContextMenuEvent::Keyboard ? pointer() : QPointF(request->pos());
            const int under = gripAt(menuAt_).note;
            if (under >= 0) choose(under);
            return false;
        }
        case QEvent::ShortcutOverride:
            if (!takes(key->key(), key->modifiers())) return false;
            event->accept();
            return true;
        case QEvent::KeyPress:
            return takes(key->key(), key->modifiers()) &&
                   keyPressed(key->key(), (key->modifiers() & Qt::ShiftModifier) != 0);
        default:
            return false;
    }
}

}  // namespace reliefui
