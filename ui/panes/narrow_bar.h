// A row of controls that does not require its full width: in a narrower pane, buttons at both ends scroll it. Its
// height is the same with and without the buttons, so that the widgets below do not move.
#pragma once

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QScrollArea>

class QToolButton;

namespace reliefui {

class NarrowBar : public QScrollArea {
    Q_DECLARE_TR_FUNCTIONS(reliefui::NarrowBar)
  public:
    explicit NarrowBar(QWidget* parent);
    // The layout to which the controls are added.
    QHBoxLayout* row() const { return row_; }

    QSize sizeHint() const override { return minimumSizeHint(); }
    QSize minimumSizeHint() const override;

  protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QToolButton* addEnd(Qt::ArrowType arrow, const QString& help);
    void fitHeight();
    void placeEnds();
    void go(int pixels);

    QHBoxLayout* row_;
    QToolButton* back_ = nullptr;
    QToolButton* on_ = nullptr;
};

}  // namespace reliefui
