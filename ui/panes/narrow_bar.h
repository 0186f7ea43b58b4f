// A row of controls that does not ask for its whole width: where the pane is narrower, a button at either end goes
// along it. It is as high whether it has them or not, so that what lies below stays where it is.
#pragma once

#include <QHBoxLayout>
#include <QScrollArea>

class QToolButton;

namespace reliefui {

class NarrowBar : public QScrollArea {
    Q_DECLARE_TR_FUNCTIONS(reliefui::NarrowBar)
  public:
    explicit NarrowBar(QWidget* parent);
    // The controls go here.
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
