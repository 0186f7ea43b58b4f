// A combo box as wide as its current entry, not as the longest one: the entry is never cut off, and panes may be
// narrow.
#pragma once

#include <algorithm>

#include <QAbstractItemView>
#include <QComboBox>
#include <QStyleOptionComboBox>

namespace reliefui {

class NameBox : public QComboBox {
  public:
    explicit NameBox(QWidget* parent = nullptr) : QComboBox(parent) {
        connect(this, &QComboBox::currentTextChanged, this, [this] { updateGeometry(); });
    }

    QSize sizeHint() const override {
        QStyleOptionComboBox option;
        initStyleOption(&option);
        const QSize text(fontMetrics().horizontalAdvance(currentText()) + kRoom, fontMetrics().height());
        return {style()->sizeFromContents(QStyle::CT_ComboBox, &option, text, this).width(),
                QComboBox::sizeHint().height()};
    }
    QSize minimumSizeHint() const override { return sizeHint(); }
    void showPopup() override {
        const int longest = view()->sizeHintForColumn(0) + style()->pixelMetric(QStyle::PM_ScrollBarExtent) + kRoom;
        view()->setMinimumWidth(std::max(view()->minimumWidth(), longest));
        QComboBox::showPopup();
    }

  private:
    static constexpr int kRoom = 4;  // allowance in pixels, so that rounding never cuts off the last letter
};

}  // namespace reliefui
