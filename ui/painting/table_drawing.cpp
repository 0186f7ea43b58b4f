#include "painting/table_drawing.h"

#include <algorithm>
#include <numeric>

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
constexpr double kRounding = 1e-6;

// Breaks a text between words into lines of at most this width.
std::vector<std::string> wrapped(const std::string& text, double room, double size, bool bold = false) {
    return wrappedText(text, room, [&](const std::string& line) { return textWidth(line, size, bold); });
}

class Table {
  public:
    Table(const TableSource& source, double width)
        : source_(source),
          given_(width),
          width_(width),
          headings_(std::any_of(source.rows.begin(), source.rows.end(), [](const TableRow& r) { return r.heading; })) {
        share();
    }
    // Factor by which the table is scaled to fit the page.
    double scale() const { return std::min(1.0, given_ / width_); }

    Drawing take() {
        row(titles(), true);
        line();
        for (const TableRow& r : source_.rows) {
            if (r.heading) {
                heading(r);
            } else {
                indent_ = headings_ ? kIndent : 0;
                row(r, false);
            }
        }
        indent_ = 0;
        line();
        below();
        drawing_.bounds = {0, 0, width_, y_};
        shrink(scale());
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

    bool isText(std::size_t column) const { return column >= source_.numbers.size() || !source_.numbers[column]; }
    bool isMarked(std::size_t column) const { return static_cast<int>(column) == source_.marked; }
    // Width of a column besides its text.
    double blank(std::size_t column) const {
        return 2 * kPad + (isMarked(column) ? kMarkRoom : 0) + (column == 0 && headings_ ? kIndent : 0);
    }

    // Column widths: each column fits its longest text. If the page is narrower, titles and texts are wrapped, between
    // words. The last column gets the remaining width.
    void share() {
        std::vector<double> least;  // fits the longest word, or number
        for (std::size_t c = 0; c < source_.titles.size(); ++c) {
            double longest = textWidth(source_.titles[c], kTextSize, true);
            double word = longestWord(source_.titles[c], true);
            for (const TableRow& r : source_.rows) {
                if (r.heading || c >= r.cells.size()) continue;
                const double whole = textWidth(r.cells[c], kTextSize, r.chosen);
                longest = std::max(longest, whole);
                word = std::max(word, isText(c) ? longestWord(r.cells[c], r.chosen) : whole);
            }
            widths_.push_back(longest + blank(c));
            least.push_back(word + blank(c));
        }
        if (widths_.empty()) return;
        const auto sum = [](const std::vector<double>& all) { return std::accumulate(all.begin(), all.end(), 0.0); };
        const double wanted = sum(widths_), needed = sum(least);
        if (wanted > width_ && wanted > needed) {
            const double part = std::clamp((width_ - needed) / (wanted - needed), 0.0, 1.0);
            for (std::size_t c = 0; c < least.size(); ++c) widths_[c] = least[c] + part * (widths_[c] - least[c]);
        }
        width_ = std::max(width_, sum(widths_));
        widths_.back() += width_ - sum(widths_);
    }

    static double longestWord(const std::string& text, bool bold) {
        double longest = 0;
        for (const std::string& word : wrapped(text, 0, kTextSize, bold)) {
            longest = std::max(longest, textWidth(word, kTextSize, bold));
        }
        return longest;
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
        const std::size_t count = std::min(widths_.size(), row.cells.size());
        const bool bold = strong || row.chosen;
        std::vector<std::vector<std::string>> cells;
        std::size_t lines = 1;
        for (std::size_t c = 0; c < count; ++c) {
            const double room = widths_[c] - blank(c) + kRounding;
            cells.push_back(isText(c) || strong ? wrapped(row.cells[c], room, kTextSize, bold)
                                                : std::vector<std::string>{row.cells[c]});
            lines = std::max(lines, cells.back().size());
        }
        const double height = kLine * static_cast<double>(lines);
        if (row.chosen) {
            drawing_.add({}, Role::Highlight, Rectangle{{0, y_, width_, y_ + height}, true, 0, 0}, Emphasis::Faint);
            drawing_.add({}, Role::Highlight, Rectangle{{0, y_, width_, y_ + height}, false, 0, 0});
        }
        const Emphasis emphasis = bold ? Emphasis::Strong : Emphasis::Normal;
        double x = 0;
        for (std::size_t c = 0; c < count; ++c) {
            const double y = y_ + kLine / 2;
            const bool right = c < source_.numbers.size() && source_.numbers[c];
            double from = x + kPad + (c == 0 ? indent_ : 0);
            if (isMarked(c)) {
                if (row.mark) {
                    drawing_.add({}, roleOf(*row.mark), Marker{{from + 4, y}, shapeOf(*row.mark), 8});
                }
                from += kMarkRoom;
            }
            for (std::size_t l = 0; l < cells[c].size(); ++l) {
                text({right ? x + widths_[c] - kPad : from, y + kLine * static_cast<double>(l)},
                     right ? Anchor::Right : Anchor::Left, cells[c][l], kTextSize, emphasis);
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
    bool headings_;
    std::vector<double> widths_;
    double indent_ = 0;
    double y_ = 0;
    Drawing drawing_;
};

void removeSpareColumn(TableSource& table) {
    const int column = table.spare.front();
    table.spare.erase(table.spare.begin());
    const auto erase = [column](auto& cells) {
        if (static_cast<std::size_t>(column) < cells.size()) cells.erase(cells.begin() + column);
    };
    erase(table.titles);
    erase(table.numbers);
    for (TableRow& row : table.rows) {
        if (!row.heading) erase(row.cells);
    }
    for (int& other : table.spare) other -= static_cast<int>(other > column);
    table.marked -= static_cast<int>(table.marked > column);
}

}  // namespace

Drawing tableDrawing(const TableSource& source, double width) {
    constexpr double kLegible = 0.85;
    TableSource narrowed = source;
    while (!narrowed.spare.empty() && Table(narrowed, width).scale() < kLegible) removeSpareColumn(narrowed);
    return Table(narrowed, width).take();
}

}  // namespace reliefui
