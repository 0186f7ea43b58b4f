// What the last frame did not compute: the lossless ledger and the bounded one, a row a kind: how many, and why.
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
