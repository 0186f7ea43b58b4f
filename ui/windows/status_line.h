// The status bar: the chosen pixel and its hit, the frame's time and skipped work, and the progress of running work.
#pragma once

#include <QElapsedTimer>
#include <QStatusBar>
#include <QTimer>

#include "workspace/workspace.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace reliefui {

class StatusLine : public QStatusBar {
    Q_OBJECT
  public:
    explicit StatusLine(Workspace* workspace, QWidget* parent = nullptr);

    QString pixelText() const;
    QString frameText() const;
    // Shows a message for `ms` milliseconds, shortened in the middle if there is no room for all of it.
    void say(const QString& message, int ms = 4000);
    bool eventFilter(QObject* watched, QEvent* event) override;

  Q_SIGNALS:
    // The frame's text was clicked, to show what was skipped in full.
    void ledgerRequested();

  private:
    void refresh();
    void refreshWalk();
    void takeWalk();
    void showLedger();
    void showProgress(const QString& what, double fraction);
    bool busy() const;
    void takeBusy();
    void showBusy(bool busy);

    Workspace* workspace_;
    QLabel* pixel_;
    QLabel* frame_;
    QLabel* what_;
    QProgressBar* bar_;
    QToolButton* cancel_;
    QToolButton* walk_;
    QTimer busyDelay_;  // delays the progress display, so that short work shows none
};

}  // namespace reliefui
