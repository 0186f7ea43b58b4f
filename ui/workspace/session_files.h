// The files of one run of the window, so that a crash costs seconds of work. They lie beside the settings and are
// called unfinished-ID with these endings:
//
//   json       the scenario, as saved last; an ordinary scenario file
//   ini        where the panes were
//   lock       names the process while it runs: a window never touches the files of another one that is running
//   starting   there while the program opens the last state and has not shown it for some seconds
//
// A clean end removes them; those of a process that is gone were left by a crash. For one thread.
#pragma once

#include <memory>
#include <vector>

#include <QDateTime>
#include <QLockFile>
#include <QString>

namespace reliefui {

class SessionFiles {
  public:
    // Of this run. Where nothing can be written, held() is false.
    static SessionFiles begin();
    // Of runs that did not end cleanly and left a scenario, the newest first. They are locked: no other window offers
    // them as long as these objects live. Of many only the newest are kept. If one ended while it was opening the last
    // state (lastState()), that state becomes its scenario: the next start does not try it again unasked.
    static std::vector<SessionFiles> leftBehind();

    // Takes the lock if it is free; returns held().
    bool take();
    bool held() const { return lock_->isLocked(); }
    QString scenarioFile() const { return base_ + QStringLiteral(".json"); }
    QString layoutFile() const { return base_ + QStringLiteral(".ini"); }
    QDateTime savedAt() const;
    // The run was opening the last state when it ended.
    bool failedToStart() const { return failedToStart_; }
    void setStarting(bool starting);
    void remove();

  private:
    explicit SessionFiles(const QString& base);
    QString startingFile() const { return base_ + QStringLiteral(".starting"); }

    QString base_;  // path without its ending
    std::unique_ptr<QLockFile> lock_;
    bool failedToStart_ = false;
};

}  // namespace reliefui
