// One line at the top of the window that says what went wrong, or what was done; it is in nobody's way.
#pragma once

#include <QFrame>

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace reliefui {

class MessageBar : public QFrame {
    Q_OBJECT
  public:
    explicit MessageBar(QWidget* parent = nullptr);

    void showProblem(const QString& text) { showText(text, true); }
    void showNotice(const QString& text) { showText(text, false); }
    QString text() const;
    // A button beside the text.
    QPushButton* addAnswer(const QString& answer, const QString& help);

  signals:
    void closed();

  private:
    void showText(const QString& text, bool problem);

    QHBoxLayout* row_;
    QLabel* sign_;
    QLabel* label_;
};

}  // namespace reliefui
