// What the last frame did not need to compute: the lossless ledger and the bounded one, with one row per kind of
// skipped work: the amount and the reason.
#pragma once

#include <QTreeWidget>

#include "workspace/workspace.h"

namespace reliefui {

class SkippedPanel : public QTreeWidget {
    Q_OBJECT
  public:
    explicit SkippedPanel(Workspace* workspace, QWidget* parent = nullptr);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void refresh();
    void shareWidth();

    Workspace* workspace_;
};

}  // namespace reliefui
