#include "windows/bookmarks.h"
#include "workspace/change_name.h"

#include <algorithm>

#include <QDialogButtonBox>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

namespace reliefui {

namespace {

// Bookmarks 1 to 9 can be chosen from the menu with one key.
constexpr std::size_t kNumbered = 9;

QString titleOf(const relief::Bookmark& bookmark) {
    return BookmarkMenu::tr("%1 – pixel (%2, %3), step %4")
        .arg(QString::fromStdString(bookmark.name))
        .arg(bookmark.pixel.x)
        .arg(bookmark.pixel.y)
        .arg(bookmark.step + 1);
}

}  // namespace

BookmarkMenu::BookmarkMenu(Workspace* workspace, QMenu* menu, QObject* parent)
    : QObject(parent), workspace_(workspace), menu_(menu), fixed_(menu->actions().size()) {
    connect(menu_, &QMenu::aboutToShow, this, &BookmarkMenu::fill);
}

void BookmarkMenu::fill() {
    const QList<QAction*> actions = menu_->actions();
    for (int k = fixed_; k < actions.size(); ++k) {
        menu_->removeAction(actions[k]);
        actions[k]->deleteLater();
    }
    const auto& all = workspace_->scenario().bookmarks;
    if (!all.empty()) menu_->addSeparator();
    for (std::size_t n = 0; n < all.size(); ++n) {
        QString text = titleOf(all[n]).replace('&', QStringLiteral("&&"));
        if (n < kNumbered) text = QStringLiteral("&%1  %2").arg(n + 1).arg(text);
        connect(menu_->addAction(text), &QAction::triggered, workspace_,
                [workspace = workspace_, bookmark = all[n]] { workspace->goTo(bookmark); });
    }
}

void BookmarkMenu::addHere() {
    const relief::Scenario& now = workspace_->scenario();
    if (!now.pixel) return;
    std::vector<relief::Bookmark> all = now.bookmarks;
    relief::Bookmark bookmark;
    bookmark.pixel = *now.pixel;
    bookmark.camera = now.camera;
    bookmark.step = now.step;
    // Find a number that no other bookmark uses.
    for (std::size_t n = all.size() + 1; bookmark.name.empty(); ++n) {
        const std::string name = tr("bookmark %1").arg(n).toStdString();
        const bool taken = std::any_of(all.begin(), all.end(), [&](const auto& other) { return other.name == name; });
        if (!taken) bookmark.name = name;
    }
    all.push_back(std::move(bookmark));
    workspace_->setBookmarks(std::move(all), changeName([] { return tr("Add bookmark"); }));
}

void BookmarkMenu::next() {
    const auto& all = workspace_->scenario().bookmarks;
    if (all.empty()) return;
    std::size_t to = 0;
    // The search begins at the bookmark reached last, because several may be at the same place.
    for (std::size_t n = 0; n < all.size(); ++n) {
        const std::size_t here = (last_ + n) % all.size();
        if (!workspace_->isAt(all[here])) continue;
        to = (here + 1) % all.size();
        break;
    }
    last_ = to;
    workspace_->goTo(relief::Bookmark(all[to]));
}

BookmarkDialog::BookmarkDialog(Workspace* workspace, QWidget* parent)
    : QDialog(parent), workspace_(workspace), list_(new QListWidget(this)) {
    setWindowTitle(tr("Bookmarks"));
    list_->setAccessibleName(tr("Bookmarks"));
    list_->setToolTip(tr("Enter goes to the bookmark, F2 renames it"));
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
    auto* const column = new QVBoxLayout(this);
    column->addWidget(list_);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    auto* const goButton = buttons->addButton(tr("&Go there"), QDialogButtonBox::ActionRole);
    auto* const removeButton = buttons->addButton(tr("&Remove"), QDialogButtonBox::ActionRole);
    removeButton->setAutoDefault(false);
    goButton->setDefault(true);
    column->addWidget(buttons);
    connect(goButton, &QPushButton::clicked, this, &BookmarkDialog::go);
    connect(removeButton, &QPushButton::clicked, this, &BookmarkDialog::remove);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(list_, &QListWidget::itemDoubleClicked, this, &BookmarkDialog::go);
    connect(list_, &QListWidget::itemChanged, this, &BookmarkDialog::rename);
    connect(workspace_, &Workspace::notesChanged, this, &BookmarkDialog::refresh);
    connect(workspace_, &Workspace::scenarioChanged, this, &BookmarkDialog::refresh);
    refresh();
    list_->setCurrentRow(0);
}

void BookmarkDialog::refresh() {
    filling_ = true;
    const int row = list_->currentRow();
    list_->clear();
    for (const relief::Bookmark& bookmark : workspace_->scenario().bookmarks) {
        auto* const item = new QListWidgetItem(QString::fromStdString(bookmark.name), list_);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setToolTip(titleOf(bookmark));
    }
    list_->setCurrentRow(std::min(row, list_->count() - 1));
    filling_ = false;
}

void BookmarkDialog::go() {
    const int row = list_->currentRow();
    if (row >= 0) workspace_->goTo(relief::Bookmark(workspace_->scenario().bookmarks[static_cast<std::size_t>(row)]));
}

void BookmarkDialog::remove() {
    const int row = list_->currentRow();
    if (row < 0) return;
    std::vector<relief::Bookmark> all = workspace_->scenario().bookmarks;
    all.erase(all.begin() + row);
    workspace_->setBookmarks(std::move(all), changeName([] { return tr("Remove bookmark"); }));
}

void BookmarkDialog::rename() {
    const int row = list_->currentRow();
    if (filling_ || row < 0) return;
    std::vector<relief::Bookmark> all = workspace_->scenario().bookmarks;
    const QString name = list_->item(row)->text().trimmed();
    if (!name.isEmpty()) all[static_cast<std::size_t>(row)].name = name.toStdString();
    workspace_->setBookmarks(std::move(all), changeName([] { return tr("Rename bookmark"); }));
    // An empty or refused name is replaced by the old one. This must not happen within the list's own signal, so it is
    // queued.
    QMetaObject::invokeMethod(this, &BookmarkDialog::refresh, Qt::QueuedConnection);
}

}  // namespace reliefui
