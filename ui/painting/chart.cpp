#include "painting/chart.h"

#include <algorithm>
#include <cmath>

#include "scenario/step_sentence.h"

namespace reliefui::chart {

namespace {

using relief::Message;

constexpr double kGap = 8;          // between numbers in a row
constexpr double kLine = 11;        // height of a line
constexpr double kSmallest = 0.65;  // times the charts' size; smaller text is illegible
constexpr double kRounding = 1e-6;

// Preferred minimum distance between the numbers of an axis, in points. It grows with the axis, so that long axes are
// not crowded.
double apart(Side side, double length) {
    constexpr double kNumbers = 8;  // target count
    return side == Side::Below ? std::clamp(length / kNumbers, 30.0, 52.0) : std::clamp(length / kNumbers, 15.0, 22.0);
}

// Returns true if no number overlaps or touches the one before it.
bool clear(const std::vector<Tick>& all, Side side, double unit) {
    for (std::size_t n = 1; n < all.size(); ++n) {
        const double between = std::abs(all[n].at - all[n - 1].at) / unit;
        const double room = side == Side::Left ? kLine : (textWidth(all[n].text) + textWidth(all[n - 1].text)) / 2;
        if (between < room + (side == Side::Left ? 0 : kGap)) return false;
    }
    return true;
}

std::vector<Tick> plainTicks(const Scale& scale, double step) {
    std::vector<Tick> all;
    for (const double value : multiples(scale.low, scale.high, step)) {
        all.push_back({scale.at(value), tickText(value, step)});
    }
    return all;
}

// Ticks at 1, 2 and 5 times each power of ten (every = 0), or at every `every`-th power of ten.
std::vector<Tick> logarithmicTicks(const Scale& scale, int every) {
    std::vector<Tick> all;
    const double low = scale.low - kRounding, high = scale.high + kRounding;
    const int first = every == 0 ? static_cast<int>(std::floor(low)) : static_cast<int>(std::ceil(low));
    for (int n = first; n <= high; n += std::max(every, 1)) {
        for (const double factor : {1.0, 2.0, 5.0}) {
            const double power = n + std::log10(factor);
            if (power < low || power > high) continue;
            const double value = factor * std::pow(10.0, n);
            all.push_back({scale.at(value), scale.numbers == Numbers::Powers ? powerOfTen(n) : tickText(value, value)});
            if (every > 0) break;
        }
    }
    return all;
}

}  // namespace

double niceStep(double range, double most) {
    const double rough = range / std::max(most, 1.0);
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= rough) return factor * power;
    }
    return 10 * power;
}

std::string tickText(double value, double step) {
    const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 9);
    return relief::fixedText(value, decimals);
}

std::vector<double> multiples(double low, double high, double step) {
    std::vector<double> all;
    constexpr double kMost = 200;
    const double first = std::ceil(low / step - kRounding);
    for (double n = first; n * step <= high + kRounding * step && n - first < kMost; ++n) all.push_back(n * step);
    return all;
}

std::string powerOfTen(int n) {
    static const char* const kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    if (n == 0) return "1";
    if (n == 1) return "10";
    std::string text = n < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(n))) text += kDigits[digit - '0'];
    return text;
}

double Scale::at(double value) const {
    const double own = numbers == Numbers::Plain ? value : std::log10(value);
    return from + (own - low) / (high - low) * (to - from);
}

double Scale::valueAt(double place) const {
    const double own = low + (place - from) / (to - from) * (high - low);
    return numbers == Numbers::Plain ? own : std::pow(10.0, own);
}

std::vector<Tick> ticks(const Scale& scale, Side side, double unit) {
    const double length = std::abs(scale.to - scale.from) / unit;
    const double range = scale.high - scale.low;
    if (!(range > 0) || !(length > 0)) return {};
    const double most = std::max(1.0, length / apart(side, length));
    if (scale.numbers == Numbers::Plain) {
        for (double step = std::max(niceStep(range, most), scale.leastStep);; step = niceStep(2 * step, 1)) {
            std::vector<Tick> all = plainTicks(scale, step);
            if (clear(all, side, unit)) return all;
        }
    }
    int every = std::max(1, static_cast<int>(std::ceil(range / most)));
    if (scale.numbers == Numbers::Decades && every == 1) every = 0;
    for (;; ++every) {
        std::vector<Tick> all = logarithmicTicks(scale, every);
        if (clear(all, side, unit)) return all;
    }
}

Box plotIn(const Box& room, const Margins& margins) {
    constexpr double kLeastSide = 10;
    const double x = room.x0 + margins.left, y = room.y0 + margins.top;
    return {x, y, std::max(room.x1 - margins.right, x + kLeastSide),
            std::max(room.y1 - margins.bottom, y + kLeastSide)};
}

double widthOf(const Message& message) {
    double width = 0;
    for (const relief::Language language : {relief::Language::English, relief::Language::Ukrainian}) {
        width = std::max(width, textWidth(relief::sentence(message, language)));
    }
    return width;
}

double fittingSize(double width, double room) {
    return kTextSize * std::clamp(room / std::max(width, 1.0), kSmallest, 1.0);
}

void line(Drawing& drawing, Point from, Point to, Role role) {
    drawing.add({}, role, Polyline{{from, to}});
}

void text(Drawing& drawing, Point at, Message message, Anchor anchor, Point offset, Role role, Emphasis emphasis) {
    drawing.add({}, role,
                Label{.at = at, .text = std::move(message), .anchor = anchor, .size = kTextSize, .offset = offset},
                emphasis);
}

void Axes::tick(Point from, Point to, Role role) const {
    line(drawing_, from, to, role);
}

void Axes::left(const Scale& scale, bool lines) const {
    const double room = (plot_.x0 - room_.x0) / unit_ - kTick - 2;
    for (const Tick& t : ticks(scale, Side::Left, unit_)) {
        if (lines) tick({plot_.x0, t.at}, {plot_.x1, t.at}, Role::Grid);
        tick({plot_.x0 - kTick * unit_, t.at}, {plot_.x0, t.at});
        if (textWidth(t.text) * kSmallest > room) continue;
        drawing_.add({}, Role::Legend,
                     Label{.at = {plot_.x0, t.at},
                           .text = plainText(t.text),
                           .anchor = Anchor::Right,
                           .size = fittingSize(textWidth(t.text), room),
                           .offset = {-kTick - 2, 0}});
    }
}

void Axes::below(const Scale& scale, const std::optional<Message>& title) const {
    const bool low = (room_.y1 - plot_.y1) / unit_ < kBottom - 1;
    // Centred on its tick, but shifted to lie within the room.
    const auto place = [&](double at, double width) {
        const double half = width / 2 * unit_;
        return std::clamp(at, std::min(room_.x0 + half, room_.center().x), std::max(room_.x1 - half, room_.center().x));
    };
    // In a low drawing the title shares the row with the numbers; it is added first, so that the numbers yield to it.
    if (title) {
        const double room = ((low ? plot_.x1 : room_.x1) - room_.x0) / unit_;
        const double width = std::min(widthOf(*title), room);
        drawing_.add({}, Role::Legend,
                     Label{.at = {low ? plot_.x1 : place(plot_.center().x, width), plot_.y1},
                           .text = *title,
                           .anchor = low ? Anchor::Right : Anchor::Top,
                           .size = fittingSize(widthOf(*title), room),
                           .offset = {0, low ? kTick + 6 : kTick + 12}});
    }
    double before = room_.x0 - kGap * unit_;  // right end of the previous number
    for (const Tick& t : ticks(scale, Side::Below, unit_)) {
        tick({t.at, plot_.y1}, {t.at, plot_.y1 + kTick * unit_});
        const double width = textWidth(t.text);
        const double middle = place(t.at, width);
        if (middle - width / 2 * unit_ < before + kGap / 2 * unit_) continue;
        before = middle + width / 2 * unit_;
        drawing_.add({}, Role::Legend,
                     Label{.at = {middle, plot_.y1},
                           .text = plainText(t.text),
                           .anchor = Anchor::Top,
                           .size = kTextSize,
                           .offset = {0, kTick + 1},
                           .yields = low});
    }
}

void Axes::corner(Message title, double reserved) const {
    const double x = std::max(room_.x0, plot_.x0 - kLeft * unit_);
    const double size = fittingSize(widthOf(title), (room_.x1 - x) / unit_ - 4 - reserved);
    drawing_.add({}, Role::Legend,
                 Label{.at = {x, plot_.y0},
                       .text = std::move(title),
                       .anchor = Anchor::BottomLeft,
                       .size = size,
                       .offset = {2, -6},
                       .yields = true});
}

void Axes::sides() const {
    line(drawing_, {plot_.x0, plot_.y0}, {plot_.x0, plot_.y1});
    line(drawing_, {plot_.x0, plot_.y1}, {plot_.x1, plot_.y1});
}

int title(Drawing& drawing, Message message, const Box& room, Role role) {
    constexpr double kSmall = 0.9;  // times the charts' size; a title that would be smaller is split into two lines
    Label label{
        .at = {room.x0, room.y0}, .text = std::move(message), .anchor = Anchor::TopLeft, .size = 1, .offset = {2, 0}};
    const auto size = [&](int part) {
        label.part = part;
        double width = 0;
        for (const relief::Language language : {relief::Language::English, relief::Language::Ukrainian}) {
            width = std::max(width, textWidth(labelText(label, language)));
        }
        return fittingSize(width, room.width() - 4);
    };
    label.part = 1;
    const bool two = size(-1) < kSmall * kTextSize && !labelText(label, relief::Language::English).empty();
    const double both = two ? std::min(size(0), size(1)) : size(-1);
    for (int part = two ? 0 : -1; part < (two ? 2 : 0); ++part) {
        label.size = both;
        label.part = part;
        label.offset.y = part > 0 ? kTitleLine : 0;
        drawing.add({}, role, label);
    }
    return two ? 2 : 1;
}

}  // namespace reliefui::chart
