// The lists of methods and filters: title, source and identifier stand in columns of their own.
#include "windows/method_list.h"

#include <QAbstractItemDelegate>
#include <QAbstractItemView>
#include <QComboBox>
#include <QImage>
#include <QPainter>
#include <QStyleOptionViewItem>

#include "window_fixture.h"

namespace reliefui {

namespace {

// Numbers of pixels of the blank strips, at least `least` wide, between the ink of all rows drawn over each other. end:
// receives the right end of the ink.
std::vector<int> blanksOf(const QComboBox& list, int least, int& end) {
    QImage image(1600, 32, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    QStyleOptionViewItem option;
    option.rect = image.rect();
    option.font = list.font();
    option.palette = QPalette(Qt::black, Qt::white, Qt::white, Qt::black, Qt::gray, Qt::black, Qt::white);
    for (int row = 0; row < list.count(); ++row) {
        const QModelIndex index = list.model()->index(row, 0);
        if (!index.data(Qt::UserRole).toString().isEmpty()) list.itemDelegate()->paint(&painter, option, index);
    }
    painter.end();
    std::vector<int> blanks;
    int blank = 0;
    for (int x = 0; x < image.width(); ++x) {
        bool ink = false;
        for (int y = 0; y < image.height(); ++y) ink |= image.pixel(x, y) != qRgb(255, 255, 255);
        if (ink && blank >= least) blanks.push_back(blank);
        blank = ink ? 0 : blank + 1;
        if (ink) end = x + 1;
    }
    return blanks;
}

}  // namespace

TEST(MethodList, ColumnsDoNotOverlap) {
    constexpr int kLeastBlank = 12;  // pixels: of the gap between columns, less what letters overhang
    for (const auto fill : {&fillMethods, &fillFilters}) {
        QComboBox list;
        fill(&list);
        int end = 0;
        EXPECT_EQ(blanksOf(list, kLeastBlank, end).size(), 2U);
        list.ensurePolished();
        EXPECT_GE(list.view()->minimumWidth(), end) << "the open list shows all columns";
    }
}

}  // namespace reliefui
