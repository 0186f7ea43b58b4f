#include "layout_laws.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QMainWindow>
#include <QStatusBar>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>

#include "panes/steps/step_sentence.h"

namespace reliefui {

namespace {

class Faults {
  public:
    std::vector<std::string> lines;

    void add(const QWidget& at, const QString& what) {
        QString place = at.metaObject()->className();
        for (const QWidget* up = &at; up != nullptr; up = up->parentWidget()) {
            if (!up->objectName().isEmpty() && !up->objectName().startsWith(QLatin1String("qt_"))) {
                place += QStringLiteral(" in ") + up->objectName();
            }
        }
        lines.push_back((place + QStringLiteral(": ") + what).toStdString());
    }
};

// A scrolling widget may be cut by its frame.
bool scrolls(const QWidget& widget) {
    for (const QWidget* up = widget.parentWidget(); up != nullptr; up = up->parentWidget()) {
        if (qobject_cast<const QAbstractScrollArea*>(up) != nullptr) return true;
    }
    return false;
}

// Returns the pixels that the widget's text needs, 0 if it has none; sets *room to those available.
int needed(const QWidget& widget, int* room) {
    const QFontMetrics metrics = widget.fontMetrics();
    *room = widget.width();
    if (const auto* const button = qobject_cast<const QAbstractButton*>(&widget)) {
        return metrics.size(Qt::TextShowMnemonic, button->text()).width();
    }
    if (const auto* const list = qobject_cast<const QComboBox*>(&widget)) {
        QStyleOptionComboBox option;
        option.initFrom(list);
        *room = list->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, list).width();
        return metrics.horizontalAdvance(list->currentText());
    }
    if (qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr) {
        const auto* const line = widget.findChild<const QLineEdit*>();
        *room = line->width();
        return line->fontMetrics().horizontalAdvance(line->text());
    }
    const auto* const label = qobject_cast<const QLabel*>(&widget);
    if (label == nullptr || label->wordWrap() || label->textFormat() == Qt::RichText) return 0;
    return metrics.size(0, label->text()).width();
}

void checkText(const QWidget& widget, Faults& faults) {
    int room = 0;
    const int width = needed(widget, &room);
    if (width > room) {
        faults.add(
            widget,
            QStringLiteral("%1 pixels of text in %2: %3").arg(width).arg(room).arg(widget.property("text").toString()));
    }
    const auto* const label = qobject_cast<const QLabel*>(&widget);
    if (label == nullptr || !label->wordWrap()) return;
    const int margin = label->margin();
    const QRect inside = label->contentsRect().adjusted(margin, margin, -margin, -margin);
    const int high = qobject_cast<const StepSentence*>(label) != nullptr
                         ? label->fontMetrics()
                               .boundingRect(QRect(0, 0, inside.width(), 1 << 20), Qt::TextWordWrap, label->text())
                               .height()
                         : label->heightForWidth(label->width()) - 2 * margin;
    if (high > inside.height()) {
        faults.add(widget,
                   QStringLiteral("%1 pixels of lines in %2: %3").arg(high).arg(inside.height()).arg(label->text()));
    }
}

void checkTabs(const QTabBar& bar, Faults& faults) {
    for (int n = 0; n < bar.count(); ++n) {
        const int width = bar.fontMetrics().horizontalAdvance(bar.tabText(n));
        if (width > bar.tabRect(n).width()) faults.add(bar, QStringLiteral("the tab %1 is cut").arg(bar.tabText(n)));
        // The front tab is a pixel higher than its bar, so only the horizontal extent is checked.
        if (bar.tabRect(n).left() < 0 || bar.tabRect(n).right() >= bar.width()) {
            faults.add(bar, QStringLiteral("the tab %1 is out of the bar").arg(bar.tabText(n)));
        }
        if (bar.tabToolTip(n).isEmpty())
            faults.add(bar, QStringLiteral("the tab %1 has no tool tip").arg(bar.tabText(n)));
    }
}

// Widgets in one layout must not overlap.
void checkOverlaps(const QWidget& parent, Faults& faults) {
    const QLayout* const layout = parent.layout();
    if (layout == nullptr || layout->inherits("QStackedLayout")) return;
    std::vector<const QWidget*> placed;
    for (int n = 0; n < layout->count(); ++n) {
        const QWidget* const child = layout->itemAt(n)->widget();
        if (child != nullptr && child->isVisible()) placed.push_back(child);
    }
    for (std::size_t a = 0; a < placed.size(); ++a) {
        if (!scrolls(*placed[a]) && !parent.rect().contains(placed[a]->geometry())) {
            faults.add(*placed[a], QStringLiteral("is cut by what is around it"));
        }
        for (std::size_t b = a + 1; b < placed.size(); ++b) {
            if (placed[a]->geometry().intersects(placed[b]->geometry())) {
                faults.add(*placed[a], QStringLiteral("lies over ") + placed[b]->objectName());
            }
        }
    }
}

}  // namespace

std::vector<std::string> layoutFaults(QMainWindow& window, const QSize& size) {
    Faults faults;
    if (window.size() != size) {
        const QSize least = window.minimumSizeHint();
        faults.add(window, QStringLiteral("is %1 x %2, at least %3 x %4")
                               .arg(window.width())
                               .arg(window.height())
                               .arg(least.width())
                               .arg(least.height()));
        for (const QWidget* const part : window.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            if (part->isVisible()) {
                faults.add(*part, QStringLiteral("is at least %1 wide").arg(part->minimumSizeHint().width()));
            }
        }
    }
    const QStatusBar* const status = window.statusBar();
    if (!status->isVisible() || !window.rect().contains(status->geometry())) {
        faults.add(*status, QStringLiteral("is not inside the window"));
    }
    for (const QWidget* const widget : window.findChildren<QWidget*>()) {
        if (widget->window() != &window || !widget->isVisible()) continue;
        if (widget->objectName() == QLatin1String("qt_toolbar_ext_button")) {
            faults.add(*widget, QStringLiteral("a bar has no room for all"));
        }
        if (widget->visibleRegion().isEmpty()) continue;
        checkText(*widget, faults);
        if (const auto* const bar = qobject_cast<const QTabBar*>(widget)) checkTabs(*bar, faults);
        if (widget != &window) checkOverlaps(*widget, faults);
    }
    return faults.lines;
}

}  // namespace reliefui
