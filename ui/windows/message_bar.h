// A message at the top of the window, in as many lines as it needs: a problem, or a notice of what was done. It does
// not block the window.
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
    bool isProblem() const { return problem_; }
    // Hides the message, as its close button does.
    void close();
    // Adds a button to the right of the text.
    QPushButton* addAnswer(const QString& answer, const QString& help);

  signals:
    void closed();

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void fitHeight();
    void showText(const QString& text, bool problem);

    QHBoxLayout* row_;
    QLabel* sign_;
    QLabel* label_;
    bool problem_ = false;
};

}  // namespace reliefui
