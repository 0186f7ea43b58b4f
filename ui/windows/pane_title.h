// The title of a pane: its name, the key that goes there, room for its own controls. A double click fills the window
// with the pane, and brings the others back.
#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;

namespace reliefui {

class PaneTitle : public QWidget {
    Q_OBJECT
  public:
    PaneTitle(const QString& title, const QString& shortcut, const QString& help, QWidget* parent = nullptr);

    // Controls of the pane, at the right.
    void addControl(QWidget* control);
    // Of a pane that can be moved: shows the button that closes it.
    void setClosable();
    // A line beside the name.
    void setNote(const QString& note);
    // Hidden, it takes no room of its pane.
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
