// A row of controls that does not ask for its whole width: where the pane is narrower, it scrolls.
#pragma once

#include <QHBoxLayout>
#include <QScrollArea>

namespace reliefui {

class NarrowBar : public QScrollArea {
  public:
    explicit NarrowBar(QWidget* parent);
    // The controls go here.
    QHBoxLayout* row() const { return row_; }

    QSize sizeHint() const override { return minimumSizeHint(); }
    QSize minimumSizeHint() const override;

  protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void fitHeight();

    QHBoxLayout* row_;
};

}  // namespace reliefui
