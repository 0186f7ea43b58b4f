// Title bar of a pane: its name, its key, and room for its controls. A double click makes the pane fill the window, or
// brings the others back.
#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;

namespace reliefui {

class PaneTitle : public QWidget {
    Q_OBJECT
  public:
    PaneTitle(const QString& title, const QString& shortcut, const QString& help, QWidget* parent = nullptr);

    // Adds a control of the pane at the right.
    void addControl(QWidget* control);
    // Shows the close button, for panes that can be moved.
    void setClosable();
    // Shows a note after the name.
    void setNote(const QString& note);
    // Takes no room of the pane while hidden.
    QSize sizeHint() const override { return isHidden() ? QSize(0, 0) : QWidget::sizeHint(); }

  signals:
    void fillRequested();
    void closeRequested();

  protected:
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void fitNote();

    QString title_;
    QString text_;
    QHBoxLayout* row_;
    QLabel* note_;
};

}  // namespace reliefui
