// The chosen step in words, as large as the room allows: nothing of it is cut.
#pragma once

#include <QLabel>

#include "workspace/workspace.h"

namespace reliefui {

class StepSentence : public QLabel {
    Q_OBJECT
  public:
    explicit StepSentence(Workspace* workspace, QWidget* parent = nullptr);

    // It takes the room it is given, whatever the text: what is around does not move from step to step.
    bool hasHeightForWidth() const override { return false; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    QString words() const;
    void refresh();
    void fit();

    Workspace* workspace_;
};

}  // namespace reliefui
