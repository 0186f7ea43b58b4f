#include "panes/formula/formula_drawing.h"

#include <algorithm>
#include <limits>

#include "painting/formula_text.h"

namespace reliefui {

namespace {

// Sizes in points.
constexpr double kLine = 13.5;
constexpr double kNoteLine = 12;
constexpr double kGap = 9;      // between items on one line
constexpr double kIndent = 10;  // of continuation lines
constexpr double kBetweenGroups = 9;
constexpr double kBetweenColumns = 20;
constexpr double kLeastColumn = 290;  // smallest width of a column if there are several
constexpr double kLeastSheet = 225;   // narrower sheets are scaled down
constexpr std::size_t kMostColumns = 3;
constexpr double kRowSize = kChartText;
constexpr double kNoteSize = 0.78;
// Allowance for fonts on the screen: their sizes are rounded to whole pixels, so text can be wider than measured.
constexpr double kRounding = 1.04;
constexpr double kTitleSize = 0.95;

std::string valueText(const FormulaValue& value) {
    return value.symbol + " = " + formulaNumber(value.number);
}

std::string wordsOf(const FormulaRow& row) {
    std::string words = row.formula;
    if (row.formula.empty()) {
        for (const FormulaValue& value : row.values) words += (words.empty() ? "" : ", ") + valueText(value);
    }
    if (!row.numbers.empty()) words += (row.result.empty() ? ": " : " = ") + row.numbers;
    if (!row.result.empty()) words += " = " + row.result;
    if (!row.source.empty()) words += " · " + row.source;
    return formulaWords(words);
}

// Lays out one group in a column of this width. All rows are measured first, so that they align.
class GroupSheet {
  public:
    GroupSheet(const FormulaGroup& group, double x, double width) : group_(group), x_(x), width_(width) { measure(); }

    // Lays out the group from y downwards; returns its lower end.
    double set(FormulaSheet& sheet, double y) {
        drawing_ = &sheet.drawing;
        y_ = y;
        words(group_.title, kTitleSize, Role::Title, 0, true, false);
        drawing_->add({}, Role::Frame, Polyline{{{x_, y_}, {x_ + width_, y_}}, false});
        y_ += 2;
        if (!group_.note.empty()) words(group_.note, kNoteSize, Role::Layer, 0, false, true);
        for (const FormulaRow& row : group_.rows) {
            const double top = y_;
            if (row.formula.empty()) {
                list(row);
            } else {
                equation(row);
            }
            sheet.places.push_back({{x_, top, x_ + width_, y_}, wordsOf(row)});
        }
        return y_;
    }

  private:
    // Width of a row's equation, and of its numbers.
    static double equationRoom(const FormulaRow& row) { return formulaWidth(row.formula, kRowSize) + kGap; }
    static double numbersRoom(const FormulaRow& row) {
        return row.numbers.empty() ? 0 : formulaWidth(numbersOf(row), kNoteSize) + kGap;
    }
    // Returns true if the row's numbers fit to the right of the equation, aligned with those of the group's other rows.
    bool onOneLine(const FormulaRow& row) const {
        return equationRoom(row) <= numbersAt_ && numbersAt_ + numbersRoom(row) <= resultAt_;
    }

    void measure() {
        measureLists(kRowSize, kGap);
        double all = 0;
        for (const double cell : cells_) all += cell;
        if (all > width_ / kRounding) measureLists(kNoteSize, kGap / 2);
        double equations = 0;
        for (const FormulaRow& row : group_.rows) {
            if (!row.source.empty()) sources_ = std::max(sources_, kGap + textWidth(row.source, kNoteSize));
            if (row.formula.empty()) continue;
            if (!row.result.empty()) equations = std::max(equations, equationRoom(row));
            results_ = std::max(results_, resultRoom(row));
        }
        const double room = width_ / kRounding - results_;
        double numbers = 0;
        for (const FormulaRow& row : group_.rows) {
            if (row.formula.empty() || equationRoom(row) + numbersRoom(row) > room - sources_) continue;
            numbersAt_ = std::max(numbersAt_, equationRoom(row));
            numbers = std::max(numbers, numbersRoom(row));
        }
        // Otherwise the numbers go on a line below the equation, and only the value stays next to it.
        if (numbersAt_ + numbers > room - sources_) numbersAt_ = numbers = 0;
        resultAt_ = numbersAt_ > 0 ? numbersAt_ + numbers : std::min(equations, room);
    }
    static double resultRoom(const FormulaRow& row) {
        return row.result.empty() ? 0 : formulaWidth("= " + row.result, kRowSize) + kGap;
    }
    void measureLists(double size, double gap) {
        listSize_ = size;
        cells_.clear();
        for (const FormulaRow& row : group_.rows) {
            if (!row.formula.empty()) continue;
            cells_.resize(std::max(cells_.size(), row.values.size()), 0);
            for (std::size_t c = 0; c < row.values.size(); ++c) {
                cells_[c] = std::max(cells_[c], formulaWidth(valueText(row.values[c]), size) + gap);
            }
        }
    }

    void label(double x, double y, const std::string& text, double size, Role role, Anchor anchor = Anchor::Left,
               bool bold = false, bool formula = true) {
        drawing_->add(
            {}, role,
            Label{.at = {x_ + x, y}, .text = plainText(text), .anchor = anchor, .size = size, .formula = formula},
            bold ? Emphasis::Strong : Emphasis::Normal);
    }
    // Adds wrapped text; returns the right end of the last line.
    double words(const std::string& text, double size, Role role, double indent, bool bold, bool formula) {
        const double high = size == kNoteSize ? kNoteLine : kLine;
        const auto wide = [&](const std::string& line) {
            return kRounding * (formula ? formulaWidth(line, size, bold) : textWidth(line, size, bold));
        };
        const auto lines = wrappedText(text, width_ - indent, wide);
        for (const std::string& line : lines) {
            label(indent, y_ + high / 2, line, size, role, Anchor::Left, bold, formula);
            y_ += high;
        }
        return indent + wide(lines.back());
    }
    // Adds the source at the right: on a line of the row if there is room, otherwise on a line of its own.
    void source(const FormulaRow& row, double y, double end, double lastEnd) {
        if (row.source.empty()) return;
        const double from = width_ - kRounding * textWidth(row.source, kNoteSize) - kGap / 2;
        if (end > from) {
            y = y_ - kNoteLine / 2;
            if (lastEnd > from) {
                y += kNoteLine;
                y_ += kNoteLine;
            }
        }
        label(width_, y, row.source, kNoteSize, Role::Layer, Anchor::Right, false, false);
    }

    void list(const FormulaRow& row) {
        double x = 0;
        for (std::size_t c = 0; c < row.values.size(); ++c) {
            if (x > 0 && x + cells_[c] > width_) {
                x = 0;
                y_ += kLine;
            }
            label(x, y_ + kLine / 2, valueText(row.values[c]), listSize_, Role::Label);
            x += cells_[c];
        }
        y_ += kLine;
        // Omitted if there is no room: the equations that use these values state their source as well.
        if (x + sources_ <= width_) source(row, y_ - kLine / 2, 0, 0);
    }

    void equation(const FormulaRow& row) {
        double at = y_ + kLine / 2;
        double end = equationRoom(row), lastEnd = 0;  // right ends of the line with the value, and of the last line
        if (onOneLine(row)) {
            label(0, at, row.formula, kRowSize, Role::Label);
            if (!row.numbers.empty()) label(numbersAt_, at, numbersOf(row), kNoteSize, Role::Layer);
            y_ += kLine;
            if (row.result.empty()) end = numbersAt_ + numbersRoom(row);
        } else {
            lastEnd = words(row.formula, kRowSize, Role::Label, 0, false, true);
            const bool beside = row.result.empty() || equationRoom(row) <= resultAt_;
            if (!row.numbers.empty()) lastEnd = words(numbersOf(row), kNoteSize, Role::Layer, kIndent, false, true);
            if (!beside && lastEnd + kGap <= resultAt_) {
                at = y_ - kNoteLine / 2;
            } else if (!beside) {
                at = y_ + kLine / 2;
                y_ += kLine;
            }
            if (!beside) lastEnd = resultAt_ + resultRoom(row);
        }
        if (!row.result.empty()) {
            label(resultAt_, at, "= " + row.result, kRowSize, Role::Label);
            end = resultAt_ + resultRoom(row);
        }
        source(row, at, kRounding * end, onOneLine(row) ? kRounding * end : lastEnd);
    }
    // In an inequality, the numbers are not preceded by "=".
    static std::string numbersOf(const FormulaRow& row) {
        return row.result.empty() ? row.numbers : "= " + row.numbers;
    }

    const FormulaGroup& group_;
    double x_;
    double width_;
    double results_ = 0, sources_ = 0;  // widths of the columns of results and sources
    std::vector<double> cells_;         // widths of the columns of lists
    double listSize_ = kRowSize;
    double numbersAt_ = 0, resultAt_ = 0;
    Drawing* drawing_ = nullptr;
    double y_ = 0;
};

// Division into columns: the index of the first group of each, and the height of the highest.
struct Columns {
    std::vector<std::size_t> first{0};
    double height = std::numeric_limits<double>::infinity();
};

double heightOf(const std::vector<double>& heights, std::size_t from, std::size_t to) {
    double height = 0;
    for (std::size_t g = from; g < to; ++g) height += heights[g] + (g > from ? kBetweenGroups : 0);
    return height;
}

// Splits the groups starting at `from` into `columns` columns such that the highest is as low as possible.
Columns split(const std::vector<double>& heights, std::size_t from, std::size_t columns) {
    Columns best;
    if (columns == 1 || from + 1 >= heights.size()) return {{from}, heightOf(heights, from, heights.size())};
    for (std::size_t next = from + 1; next < heights.size(); ++next) {
        Columns rest = split(heights, next, columns - 1);
        rest.height = std::max(rest.height, heightOf(heights, from, next));
        if (rest.height >= best.height) continue;
        rest.first.insert(rest.first.begin(), from);
        best = std::move(rest);
    }
    return best;
}

double columnWidth(double width, std::size_t columns) {
    return (width - kBetweenColumns * static_cast<double>(columns - 1)) / static_cast<double>(columns);
}

// Chooses the number of columns that gives the lowest sheet.
Columns columnsFor(const std::vector<FormulaGroup>& groups, double width, double& own) {
    Columns best;
    for (std::size_t n = 1; n <= std::min(kMostColumns, groups.size()); ++n) {
        const double column = columnWidth(width, n);
        if (n > 1 && column < kLeastColumn) break;
        std::vector<double> heights;
        for (const FormulaGroup& group : groups) {
            FormulaSheet tried;
            heights.push_back(GroupSheet(group, 0, column).set(tried, 0));
        }
        Columns columns = split(heights, 0, n);
        if (columns.height >= best.height) continue;
        best = std::move(columns);
        own = column;
    }
    return best;
}

void scale(FormulaSheet& sheet, double by) {
    for (Item& item : sheet.drawing.items) {
        if (auto* const label = std::get_if<Label>(&item.primitive)) {
            label->at = {label->at.x * by, label->at.y * by};
            label->size *= by;
        } else if (auto* const line = std::get_if<Polyline>(&item.primitive)) {
            for (Point& p : line->points) p = {p.x * by, p.y * by};
        }
    }
    const auto scaled = [&](const Box& b) { return Box{b.x0 * by, b.y0 * by, b.x1 * by, b.y1 * by}; };
    for (FormulaSheet::Place& place : sheet.places) place.box = scaled(place.box);
    sheet.drawing.bounds = scaled(sheet.drawing.bounds);
}

}  // namespace

FormulaSheet formulaSheet(const std::vector<FormulaGroup>& groups, double width) {
    const double set = std::max(width, kLeastSheet);
    double column = set;
    const Columns columns = columnsFor(groups, set, column);
    FormulaSheet sheet;
    double bottom = 0;
    for (std::size_t c = 0; c < columns.first.size(); ++c) {
        const std::size_t end = c + 1 < columns.first.size() ? columns.first[c + 1] : groups.size();
        const double x = static_cast<double>(c) * (column + kBetweenColumns);
        double y = 0;
        for (std::size_t g = columns.first[c]; g < end; ++g) {
            if (g > columns.first[c]) y += kBetweenGroups;
            y = GroupSheet(groups[g], x, column).set(sheet, y);
        }
        bottom = std::max(bottom, y);
    }
    sheet.drawing.bounds = {0, 0, set, bottom};
    if (width < set) scale(sheet, width / set);
    return sheet;
}

}  // namespace reliefui
