#include "painting/table_drawing.h"

#include <algorithm>

#include "painting/text_width.h"

namespace reliefui {

namespace {

// Sizes in points.
constexpr double kLine = 13;
constexpr double kTextSize = kChartText;
constexpr double kPad = 5;
constexpr double kMarkRoom = 12;
constexpr double kBelowSize = 1.15;
constexpr double kBelowLine = 16;
constexpr double kIndent = 8;  // of rows below a heading

// Breaks a text between words into lines of at most this width.
std::vector<std::string> wrapped(const std::string& text, double room, double size, bool bold = false) {
    return wrappedText(text, room, [&](const std::string& line) { return textWidth(line, size, bold); });
}

class Table {
  public:
    Table(const TableSource& source, double width) : source_(source), given_(width), width_(width) { share(); }

    Drawing take() {
        row(titles(), true);
        line();
        const bool headings =
            std::any_of(source_.rows.begin(), source_.rows.end(), [](const TableRow& r) { return r.heading; });
        for (const TableRow& r : source_.rows) {
            if (r.heading) {
                heading(r);
            } else {
                indent_ = headings ? kIndent : 0;
                row(r, false);
            }
        }
        indent_ = 0;
        line();
        below();
        drawing_.bounds = {0, 0, width_, y_};
        shrink(std::min(1.0, given_ / width_));
        return std::move(drawing_);
    }

  private:
    TableRow titles() const {
        TableRow row;
        row.cells = source_.titles;
        return row;
    }

    // Scales labels and markers, whose sizes are in points, for a page that is narrower than the table.
    void shrink(double by) {
        for (Item& item : drawing_.items) {
            if (auto* const label = std::get_if<Label>(&item.primitive)) label->size *= by;
            if (auto* const marker = std::get_if<Marker>(&item.primitive)) marker->size *= by;
        }
    }

    // Column widths: each column fits its longest text, the last one gets the remaining width.
    void share() {
        const std::size_t count = source_.titles.size();
        for (std::size_t c = 0; c < count; ++c) {
            double longest = textWidth(source_.titles[c], kTextSize, true);
            for (const TableRow& r : source_.rows) {
                if (r.heading || c >= r.cells.size()) continue;
                longest = std::max(longest, textWidth(r.cells[c], kTextSize, r.chosen));
            }
            const double marks = static_cast<int>(c) == source_.marked ? kMarkRoom : 0;
            widths_.push_back(longest + 2 * kPad + marks);
        }
        if (widths_.empty()) return;
        double before = 0;
        for (std::size_t c = 0; c + 1 < count; ++c) before += widths_[c];
        constexpr double kLeastLast = 60;
        const double last = std::max(std::min(widths_.back(), kLeastLast), width_ - before);
        widths_.back() = last;
        width_ = std::max(width_, before + last);
    }

    void text(Point at, Anchor anchor, const std::string& words, double size, Emphasis emphasis) {
        if (words.empty()) return;
        drawing_.add({}, Role::Label, Label{.at = at, .text = plainText(words), .anchor = anchor, .size = size},
                     emphasis);
    }

    void heading(const TableRow& row) {
        if (!row.cells.empty()) text({kPad, y_ + kLine / 2}, Anchor::Left, row.cells[0], kTextSize, Emphasis::Strong);
        y_ += kLine;
    }

    void row(const TableRow& row, bool strong) {
        const std::size_t count = widths_.size();
        const std::vector<std::string> last =
            row.cells.size() == count && count > 0
                ? wrapped(row.cells.back(), widths_.back() - 2 * kPad, kTextSize, strong || row.chosen)
                : std::vector<std::string>{};
        const double height = kLine * static_cast<double>(std::max<std::size_t>(1, last.size()));
        if (row.chosen) {
            drawing_.add({}, Role::Highlight, Rectangle{{0, y_, width_, y_ + height}, true, 0, 0}, Emphasis::Faint);
            drawing_.add({}, Role::Highlight, Rectangle{{0, y_, width_, y_ + height}, false, 0, 0});
        }
        const Emphasis emphasis = strong || row.chosen ? Emphasis::Strong : Emphasis::Normal;
        double x = 0;
        for (std::size_t c = 0; c < count && c < row.cells.size(); ++c) {
            const double y = y_ + kLine / 2;
            const bool right = c < source_.numbers.size() && source_.numbers[c];
            double from = x + kPad + (c == 0 ? indent_ : 0);
            if (static_cast<int>(c) == source_.marked) {
                if (row.mark) {
                    drawing_.add({}, roleOf(*row.mark), Marker{{from + 4, y}, shapeOf(*row.mark), 8});
                }
                from += kMarkRoom;
            }
            if (c + 1 == count && !right) {
                for (std::size_t l = 0; l < last.size(); ++l) {
                    text({from, y + kLine * static_cast<double>(l)}, Anchor::Left, last[l], kTextSize, emphasis);
                }
            } else {
                const double at = right ? x + widths_[c] - kPad : from;
                text({at, y}, right ? Anchor::Right : Anchor::Left, row.cells[c], kTextSize, emphasis);
            }
            x += widths_[c];
        }
        y_ += height;
    }

    void line() {
        drawing_.add({}, Role::Frame, Polyline{{{0, y_ + 1}, {width_, y_ + 1}}, false});
        y_ += 3;
    }

    void below() {
        if (source_.below.empty()) return;
        y_ += 4;
        // The painter rounds font sizes to whole pixels, so that text of a small table on a coarse page is wider than
        // measured.
        constexpr double kRoom = 0.92;
        for (const std::string& words : wrapped(source_.below, kRoom * (width_ - 2 * kPad), kBelowSize)) {
            text({kPad, y_ + kBelowLine / 2}, Anchor::Left, words, kBelowSize, Emphasis::Normal);
            y_ += kBelowLine;
        }
    }

    const TableSource& source_;
    double given_;
    double width_;  // at full size, before scaling
    std::vector<double> widths_;
    double indent_ = 0;
    double y_ = 0;
    Drawing drawing_;
};

}  // namespace

Drawing tableDrawing(const TableSource& source, double width) {
    return Table(source, width).take();
}

}  // namespace reliefui
