#include "windows/method_list.h"

#include <algorithm>

#include <QAbstractItemView>
#include <QComboBox>
#include <QEvent>
#include <QPainter>
#include <QStandardItemModel>
#include <QStyledItemDelegate>

#include "filtering/filters/filter_choice.h"
#include "panes/core_texts.h"
#include "relief/describe.h"
#include "relief/reliefs.h"
#include "windows/top_bar.h"
#include "workspace/workspace.h"

namespace reliefui {

namespace {

constexpr int kSourceRole = Qt::UserRole + 1;
constexpr int kGap = 16;
constexpr double kSmall = 0.85;

QFont small(QFont font) {
    font.setPointSizeF(font.pointSizeF() * kSmall);
    return font;
}

QString identifier(const QModelIndex& index) {
    return index.data(Qt::UserRole).toString();
}

// Widths of the three columns in pixels: title, source, identifier.
struct Columns {
    int title = 0;
    int source = 0;
    int name = 0;

    Columns(const QAbstractItemModel& model, const QFont& font) {
        const QFontMetrics large(font);
        const QFontMetrics fine(small(font));
        for (int row = 0; row < model.rowCount(); ++row) {
            const QModelIndex index = model.index(row, 0);
            if (identifier(index).isEmpty()) continue;
            title = std::max(title, large.horizontalAdvance(index.data().toString()));
            source = std::max(source, fine.horizontalAdvance(index.data(kSourceRole).toString()));
            name = std::max(name, fine.horizontalAdvance(identifier(index)));
        }
    }
    int width() const { return title + source + name + 4 * kGap; }
};

class MethodDelegate : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        if (identifier(index).isEmpty()) return;
        const Columns columns(*index.model(), option.font);
        const bool chosen = (option.state & QStyle::State_Selected) != 0;
        QColor faint = option.palette.color(chosen ? QPalette::HighlightedText : QPalette::Text);
        if (!chosen) faint.setAlpha(170);
        painter->save();
        painter->setPen(faint);
        painter->setFont(small(option.font));
        QRect place = option.rect.adjusted(columns.title + 2 * kGap, 0, 0, 0);
        painter->drawText(place, Qt::AlignLeft | Qt::AlignVCenter, index.data(kSourceRole).toString());
        place.setLeft(place.left() + columns.source + kGap);
        painter->drawText(place, Qt::AlignLeft | Qt::AlignVCenter, identifier(index));
        painter->restore();
    }
};

class MethodBox : public QObject {
  public:
    explicit MethodBox(QComboBox* list) : QObject(list), list_(list) { list->installEventFilter(this); }

  protected:
    // Sets the width of the open list whenever its font changes.
    bool eventFilter(QObject* watched, QEvent* event) override {
        const bool type = event->type() == QEvent::FontChange || event->type() == QEvent::Polish;
        if (type) list_->view()->setMinimumWidth(Columns(*list_->model(), list_->font()).width());
        return QObject::eventFilter(watched, event);
    }

  private:
    QComboBox* list_;
};

void addNamed(QComboBox* list, const std::string& name, const std::string& title, const std::string& help,
              const std::string& source = {}) {
    list->addItem(titleText(title), QString::fromStdString(name));
    list->setItemData(list->count() - 1, QString::fromStdString(source), kSourceRole);
    list->setItemData(list->count() - 1, coreText(help), Qt::ToolTipRole);
}

void showColumns(QComboBox* list) {
    list->setItemDelegate(new MethodDelegate(list));
    new MethodBox(list);
}

void addMethods(QComboBox* list, bool tracers) {
    for (const relief::MethodDescription& method : relief::tracerList()) {
        const bool searches = method.kind == relief::MethodKind::Tracer;
        if (searches != tracers || method.kind == relief::MethodKind::AnyHit) continue;
        addNamed(list, method.name, method.title, method.help, method.source);
    }
}

}  // namespace

void fillMethods(QComboBox* list) {
    addMethods(list, true);
    list->insertSeparator(list->count());
    list->addItem(TopBar::tr("no search"));
    // Makes the entry a heading that cannot be selected.
    if (auto* const items = qobject_cast<QStandardItemModel*>(list->model())) {
        items->item(list->count() - 1)->setFlags(Qt::NoItemFlags);
    }
    addMethods(list, false);
    showColumns(list);
}

void fillFilters(QComboBox* list) {
    for (const relief::FilterDescription& filter : relief::filterList()) {
        addNamed(list, filter.name, filter.title, filter.help, filter.source);
    }
    showColumns(list);
}

void addRecipes(QComboBox* list) {
    for (const relief::ReliefRecipe& recipe : relief::reliefRecipes()) {
        addNamed(list, std::string(recipe.name), std::string(recipe.title), std::string(recipe.help));
    }
    showColumns(list);
}

}  // namespace reliefui
