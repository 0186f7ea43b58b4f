// Files of one session of the window, so that a crash loses only seconds of work. They are stored next to the settings,
// as unfinished-ID with these extensions:
//
//   json       the scenario as last saved; an ordinary scenario file
//   ini        the layout of the panes
//   lock       names the process while it runs: a window never touches the files of another running one
//   starting   exists until the program has shown the last state for some seconds
//
// A clean exit removes them; files whose process no longer runs are from a crash. For use on one thread.
#pragma once

#include <memory>
#include <vector>

#include <QDateTime>
#include <QLockFile>
#include <QString>

namespace reliefui {

class SessionFiles {
  public:
    // Creates the files of this session. If nothing can be written, held() is false.
    static SessionFiles begin();
    // Sessions that did not end cleanly and left a scenario, newest first; only the newest are kept. They are locked:
    // other windows do not offer them while these objects exist. If a session ended while it was opening the last state
    // (lastState()), that state becomes its scenario, so that the next start does not open it again without asking.
    static std::vector<SessionFiles> leftBehind();

    // Acquires the lock if it is free; returns held().
    bool take();
    bool held() const { return lock_->isLocked(); }
    QString scenarioFile() const { return base_ + QStringLiteral(".json"); }
    QString layoutFile() const { return base_ + QStringLiteral(".ini"); }
    QDateTime savedAt() const;
    // Returns true if the session ended while opening the last state.
    bool failedToStart() const { return failedToStart_; }
    void setStarting(bool starting);
    void remove();

  private:
    explicit SessionFiles(const QString& base);
    QString startingFile() const { return base_ + QStringLiteral(".starting"); }

    QString base_;  // path without extension
    std::unique_ptr<QLockFile> lock_;
    bool failedToStart_ = false;
};

}  // namespace reliefui
