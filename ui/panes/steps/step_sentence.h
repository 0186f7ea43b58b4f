// The chosen step in words, in the largest font that fits; the text is never cut off.
#pragma once

#include <QLabel>

#include "workspace/workspace.h"

namespace reliefui {

class StepSentence : public QLabel {
    Q_OBJECT
  public:
    explicit StepSentence(Workspace* workspace, QWidget* parent = nullptr);

    // The height does not depend on the text, so that surrounding widgets do not move from step to step.
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
