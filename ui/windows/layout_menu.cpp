#include "windows/layout_menu.h"

#include <QInputDialog>
#include <QMenu>
#include <QSettings>

#include "windows/main_window.h"

namespace reliefui {

namespace {

QString layoutsKey() {
    return QStringLiteral("layouts");
}

QVariantMap kept() {
    return QSettings().value(layoutsKey()).toMap();
}

// Escapes "&" in a name, which would otherwise mark a mnemonic.
QString entry(QString name) {
    return name.replace(QLatin1Char('&'), QStringLiteral("&&"));
}

}  // namespace

LayoutMenu::LayoutMenu(MainWindow* window, QMenu* menu) : QObject(window), window_(window), menu_(menu) {
    fixed_ = menu_->actions().size();
    connect(menu_, &QMenu::aboutToShow, this, &LayoutMenu::fill);
}

QStringList LayoutMenu::names() {
    return kept().keys();
}

void LayoutMenu::save(const QString& name) {
    QVariantMap layouts = kept();
    layouts[name] = window_->arrangement();
    QSettings().setValue(layoutsKey(), layouts);
}

void LayoutMenu::choose(const QString& name) {
    const QVariantMap layouts = kept();
    if (layouts.contains(name)) window_->takeArrangement(layouts[name].toMap());
}

void LayoutMenu::remove(const QString& name) {
    QVariantMap layouts = kept();
    layouts.remove(name);
    QSettings().setValue(layoutsKey(), layouts);
}

void LayoutMenu::askName() {
    bool accepted = false;
    const QString name = QInputDialog::getText(window_, tr("Save layout"), tr("Name of the layout:"), QLineEdit::Normal,
                                               tr("Layout %1").arg(names().size() + 1), &accepted)
                             .trimmed();
    if (accepted && !name.isEmpty()) save(name);
}

void LayoutMenu::fill() {
    const QList<QAction*> now = menu_->actions();
    for (int n = fixed_; n < now.size(); ++n) {
        menu_->removeAction(now[n]);
        now[n]->deleteLater();
    }
    const QStringList all = names();
    if (all.isEmpty()) return;
    menu_->addSeparator();
    for (const QString& name : all) {
        connect(menu_->addAction(entry(name)), &QAction::triggered, this, [this, name] { choose(name); });
    }
    QMenu* const gone = menu_->addMenu(tr("&Delete"));
    for (const QString& name : all) {
        connect(gone->addAction(entry(name)), &QAction::triggered, this, [this, name] { remove(name); });
    }
}

}  // namespace reliefui
