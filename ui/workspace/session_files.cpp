#include "workspace/session_files.h"

#include <algorithm>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSet>

#include "workspace/last_state.h"

namespace reliefui {

namespace {

constexpr std::size_t kMostKept = 8;

QString prefix() {
    return QStringLiteral("unfinished-");
}

}  // namespace

SessionFiles::SessionFiles(const QString& base)
    : base_(base), lock_(std::make_unique<QLockFile>(base + QStringLiteral(".lock"))) {
    lock_->setStaleLockTime(0);  // locks never expire: a window may be open for days
}

SessionFiles SessionFiles::begin() {
    const QString id =
        QStringLiteral("%1-%2").arg(QDateTime::currentMSecsSinceEpoch()).arg(QCoreApplication::applicationPid());
    SessionFiles files(settingsFolder() + '/' + prefix() + id);
    files.take();
    return files;
}

std::vector<SessionFiles> SessionFiles::leftBehind() {
    const QDir folder(settingsFolder());
    QSet<QString> bases;
    for (const QFileInfo& file : folder.entryInfoList({prefix() + '*'}, QDir::Files)) {
        bases << file.path() + '/' + file.completeBaseName();
    }
    std::vector<SessionFiles> found;
    for (const QString& base : bases) {
        SessionFiles files(base);
        if (!files.take()) continue;
        if (QFile::exists(files.startingFile())) {
            files.failedToStart_ = QFile::rename(lastStateFile(), files.scenarioFile());
            files.setStarting(false);
        }
        if (QFile::exists(files.scenarioFile())) {
            found.push_back(std::move(files));
        } else {
            files.remove();
        }
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.savedAt() > b.savedAt(); });
    for (; found.size() > kMostKept; found.pop_back()) found.back().remove();
    return found;
}

bool SessionFiles::take() {
    return held() || (QDir().mkpath(QFileInfo(base_).path()) && lock_->tryLock(0));
}

QDateTime SessionFiles::savedAt() const {
    return QFileInfo(scenarioFile()).lastModified();
}

void SessionFiles::setStarting(bool starting) {
    if (starting) {
        QFile(startingFile()).open(QIODevice::WriteOnly);
    } else {
        QFile::remove(startingFile());
    }
}

// The lock is removed last: other windows take files without a lock for those of a crashed one.
void SessionFiles::remove() {
    QFile::remove(scenarioFile());
    QFile::remove(layoutFile());
    setStarting(false);
    lock_->unlock();
}

}  // namespace reliefui
