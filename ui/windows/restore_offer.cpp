#include "windows/restore_offer.h"

#include <utility>

#include <QPushButton>
#include <QSettings>

#include "relief/errors.h"
#include "windows/main_window.h"
#include "windows/message_bar.h"
#include "windows/pane_list.h"
#include "workspace/change_name.h"
#include "workspace/pane_store.h"
#include "workspace/state_keeper.h"
#include "workspace/workspace.h"

namespace reliefui {

RestoreOffer::RestoreOffer(MainWindow* window, Workspace* workspace, StateKeeper* keeper,
                           std::vector<SessionFiles> left)
    : QObject(window), window_(window), workspace_(workspace), keeper_(keeper), left_(std::move(left)) {
    QPushButton* const yes = window_->question()->addAnswer(
        tr("Restore"), tr("Open that session again, with its bookmarks and panes; can be undone"));
    QPushButton* const no = window_->question()->addAnswer(tr("Discard"), tr("Delete the saved session"));
    yes->setObjectName(QStringLiteral("restore"));
    no->setObjectName(QStringLiteral("discard"));
    connect(yes, &QPushButton::clicked, this, &RestoreOffer::restore);
    connect(no, &QPushButton::clicked, this, &RestoreOffer::discard);
    offer();
}

std::vector<SessionFiles> RestoreOffer::unanswered() {
    if (window_->question()->isHidden()) left_.clear();
    return std::exchange(left_, {});
}

void RestoreOffer::offer() {
    window_->question()->hide();
    while (!left_.empty() && window_->question()->isHidden()) {
        try {
            scenario_ = loadWindowScenario(left_.front().scenarioFile().toStdString(), stateReaders());
        } catch (const relief::InputError&) {
            // The file is damaged, or was written by a newer version, which can still read it; so it is skipped, not
            // deleted.
            left_.erase(left_.begin());
            continue;
        }
        const QString when = left_.front().savedAt().toString(QStringLiteral("yyyy-MM-dd HH:mm"));
        window_->question()->showNotice(
            left_.front().failedToStart()
                ? tr("The last start ended before its first picture was drawn. Its session was not opened again; it "
                     "can be restored.")
                : tr("Reliefscope ended unexpectedly; the session can be restored as it was on %1.").arg(when));
    }
    window_->showMessages();
}

void RestoreOffer::restore() {
    if (left_.empty()) return;
    QVariantMap layout;
    const QSettings kept(left_.front().layoutFile(), QSettings::IniFormat);
    for (const QString& key : kept.allKeys()) layout[key] = kept.value(key);
    if (!layout.isEmpty()) window_->takeLayout(layout);
    workspace_->show(scenario_, changeName([] { return tr("Restore"); }));
    keeper_->adopt(std::move(left_.front()), scenario_);
    left_.erase(left_.begin());
    window_->question()->hide();
    window_->showMessages();
}

void RestoreOffer::discard() {
    if (left_.empty()) return;
    left_.front().remove();
    left_.erase(left_.begin());
    offer();
}

}  // namespace reliefui
