#include "painting/range_legend.h"

#include <cmath>

#include <QCoreApplication>

#include "painting/chart.h"

namespace reliefui {

namespace {

class RangeText {
    Q_DECLARE_TR_FUNCTIONS(reliefui::RangeText)
};

constexpr double kText = 0.8;      // times the style's text size
constexpr double kLine = 11;       // line height in points
constexpr double kBarWidth = 150;  // in points; includes room for half a number at either end
constexpr double kBriefBar = 72;
constexpr double kSide = 13;
constexpr double kHistogram = 13;
constexpr double kBar = 8;
constexpr double kTick = 2.5;
constexpr double kBetween = 10;
constexpr double kEdge = 3;  // allowance in points, because the painter rounds font sizes
constexpr ItemId kColorBar{ItemKind::ColorBar, 0, 0, 0};

// Formats with three significant digits, but keeps all digits before the decimal point; very small and large numbers
// with a power of ten.
std::string numberOf(double value) {
    constexpr int kLeast = 3;
    constexpr int kMost = 7;
    const double size = std::max(std::abs(value), 1.0);
    const std::string text =
        relief::numberText(value, std::clamp(static_cast<int>(std::floor(std::log10(size))) + 1, kLeast, kMost));
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    return text.substr(0, e) + "×" + chart::powerOfTen(std::stoi(text.substr(e + 1)));
}

QString number(double value) {
    return QString::fromStdString(numberOf(value));
}

QString counted(const RangedValues& values, std::int64_t count) {
    const QString about = values.spread->exact() ? QString() : QStringLiteral("≈ ");
    // Reduces a count to an int with the same plural form for tr(); the text itself contains the full number.
    constexpr std::int64_t kSmall = 1000000;
    const auto form = static_cast<int>(count < kSmall ? count : kSmall + count % kSmall);
    const auto words = [&] {
        switch (values.counted) {
            case Counted::Texels:
                return RangeText::tr("%1 texels", nullptr, form);
            case Counted::Voxels:
                return RangeText::tr("%1 voxels", nullptr, form);
            case Counted::Pixels:
                break;
        }
        return RangeText::tr("%1 pixels", nullptr, form);
    };
    return about + words().arg(count);
}

QString withUnit(const RangedValues& values, double value) {
    const QString text = number(value);
    return values.unit.empty() ? text : text + QStringLiteral(" ") + QString::fromStdString(values.unit);
}

// How the ends of the range were chosen; empty for the plain case.
QString rangeText(const RangedValues& values) {
    const ColorRange& range = values.range;
    QString text;
    if (range.ends == RangeEnds::Own) text = RangeText::tr("custom range");
    if (range.ends == RangeEnds::Percentile) {
        const bool low = range.low > 0 && !values.scale.twoSided;
        text = low ? RangeText::tr("percentiles %1 to %2").arg(number(range.low)).arg(range.high, 0, 'g', 5)
                   : RangeText::tr("up to percentile %1").arg(range.high, 0, 'g', 5);
        if (values.scale.twoSided)
            text = RangeText::tr("up to percentile %1 of absolute values").arg(range.high, 0, 'g', 5);
    }
    if (!values.scale.logarithmic) return text;
    return text.isEmpty() ? RangeText::tr("logarithmic") : text + RangeText::tr(", logarithmic");
}

QString beyondText(const RangedValues& values) {
    const ColorScale& scale = values.scale;
    const ValueSpread& spread = *values.spread;
    if (spread.empty()) return {};
    QStringList parts;
    if (scale.twoSided) {
        if (spread.largestMagnitude() > scale.high) {
            const std::int64_t count = spread.above(scale.high) + spread.between(-HUGE_VAL, -scale.high);
            parts << RangeText::tr("beyond: %1, up to ±%2")
                         .arg(counted(values, count), number(spread.largestMagnitude()));
        }
        return parts.join(QString());
    }
    if (spread.largest() > scale.high) {
        parts << RangeText::tr("beyond: %1, up to %2")
                     .arg(counted(values, spread.above(scale.high)), number(spread.largest()));
    }
    if (spread.least() < scale.low) {
        parts << RangeText::tr("below: %1, down to %2")
                     .arg(counted(values, spread.between(-HUGE_VAL, scale.low)), number(spread.least()));
    }
    return parts.join(QStringLiteral("; "));
}

QString thresholdText(const RangedValues& values) {
    if (!values.scale.threshold || values.spread->empty()) return {};
    const double from = *values.scale.threshold;
    std::int64_t count = values.spread->above(from);
    if (values.scale.twoSided) count += values.spread->between(-HUGE_VAL, -from);
    const double share = 100.0 * static_cast<double>(count) /
                         static_cast<double>(values.whole > 0 ? values.whole : values.spread->count());
    return RangeText::tr("more than %1: %2% (%3)").arg(withUnit(values, from), number(share), counted(values, count));
}

// Values of the ticks below the bar; each gets a number if there is room.
std::vector<double> marksOf(const ColorScale& scale) {
    constexpr double kMostTicks = 4;
    std::vector<double> marks;
    const double from = scale.twoSided && !scale.logarithmic ? 0 : scale.low;
    if (!(scale.high > from)) return {from};
    if (scale.logarithmic) {
        for (const double n : chart::multiples(std::log10(from), std::log10(scale.high), 1)) {
            marks.push_back(std::pow(10.0, n));
        }
    } else {
        const double most = scale.twoSided ? kMostTicks / 2 : kMostTicks;
        marks = chart::multiples(from, scale.high, chart::niceStep(scale.high - from, most));
    }
    if (!scale.twoSided) return marks;
    // 0 comes first, so that it always gets its number. Values too close to 0 on the scale get no tick.
    std::vector<double> both{0};
    for (auto m = marks.rbegin(); m != marks.rend(); ++m) {
        if (scale.place(*m) > 0.51) both.insert(both.end(), {-*m, *m});
    }
    return both;
}

class Legend {
  public:
    Legend(const RangedValues& values, Box bar) : values_(values), bar_(bar) {}

    void colors() {
        add(Role::HeightFill, colorBar(bar_, values_.map, values_.scale));
        drawing_.add(kColorBar, Role::Frame, Rectangle{bar_, false, 0, 0});
    }

    // Draws the histogram above the bar.
    void histogram() {
        constexpr int kBins = 50;
        std::vector<std::int64_t> counts(kBins);
        std::int64_t most = 0;
        for (int i = 0; i < kBins; ++i) {
            const double from = values_.scale.value(static_cast<double>(i) / kBins);
            // The last bin includes its upper end.
            const double to =
                i + 1 < kBins ? values_.scale.value((i + 1.0) / kBins) : std::nextafter(values_.scale.high, HUGE_VAL);
            auto& count = counts[static_cast<std::size_t>(i)];
            count = values_.spread->between(from, to);
            most = std::max(most, count);
        }
        if (most == 0) return;
        Area area;
        area.base = bar_.y0 - 1;
        for (int i = 0; i < kBins; ++i) {
            const double part = static_cast<double>(counts[static_cast<std::size_t>(i)]) / static_cast<double>(most);
            const double y = area.base - part * (kHistogram - 2);
            area.line.push_back({bar_.x0 + i * bar_.width() / kBins, y});
            area.line.push_back({bar_.x0 + (i + 1) * bar_.width() / kBins, y});
        }
        drawing_.add(kColorBar, Role::Sample, std::move(area), Emphasis::Normal);
    }

    void threshold(double above) {
        if (!values_.scale.threshold) return;
        for (const double sign : {1.0, -1.0}) {
            if (sign < 0 && !values_.scale.twoSided) break;
            const double place = values_.scale.place(sign * *values_.scale.threshold);
            if (place < 0 || place > 1) continue;
            const double x = bar_.x0 + place * bar_.width();
            add(Role::Searched, Polyline{{{x, bar_.y0 - above}, {x, bar_.y1 + 1}}, false}, Emphasis::Strong);
        }
    }

    // Draws the ticks' numbers. "≤" and "≥" at the ends mark values outside the range.
    void numbers() {
        const ColorScale& scale = values_.scale;
        const ValueSpread& spread = *values_.spread;
        const bool more =
            !spread.empty() && (scale.twoSided ? spread.largestMagnitude() : spread.largest()) > scale.high;
        const bool less = scale.twoSided ? more : !spread.empty() && spread.least() < scale.low;
        const double low = scale.twoSided ? -scale.high : scale.low;
        if (!(scale.high > low)) {
            number(scale.twoSided ? 0.5 : 0, text(scale.high));
            return;
        }
        std::vector<std::pair<double, double>> taken{number(0, (less ? "≤ " : "") + text(low)),
                                                     number(1, (more ? "≥ " : "") + text(scale.high))};
        for (const double mark : marksOf(scale)) {
            constexpr double kApart = 3;
            const double place = scale.place(mark);
            if (place < 0 || place > 1) continue;
            const double x = bar_.x0 + place * bar_.width();
            add(Role::Frame, Polyline{{{x, bar_.y1}, {x, bar_.y1 + kTick}}, false});
            const double half = textWidth(text(mark), kText) / 2 + kApart;
            const bool room = std::none_of(taken.begin(), taken.end(), [&](const auto& other) {
                return x - half < other.second && x + half > other.first;
            });
            if (room) taken.push_back(number(place, text(mark)));
        }
    }

    void text(Point at, const std::string& words, Anchor anchor = Anchor::TopLeft) {
        add(Role::Legend, Label{.at = at, .text = plainText(words), .anchor = anchor, .size = kText});
    }

    Drawing take(double width, double height) {
        drawing_.bounds = {0, 0, width, height};
        return std::move(drawing_);
    }

    static std::string text(double value) { return numberOf(value); }

  private:
    void add(Role role, Primitive primitive, Emphasis emphasis = Emphasis::Normal) {
        drawing_.add({ItemKind::Legend, 0, 0, 0}, role, std::move(primitive), emphasis);
    }

    // Draws a number at this position of the bar (0 to 1); returns the horizontal interval that it covers.
    std::pair<double, double> number(double place, const std::string& words) {
        const double half = textWidth(words, kText) / 2;
        // Shifted to the right if it would extend beyond the left edge.
        const double x = std::max(bar_.x0 + place * bar_.width(), half);
        text({x, bar_.y1 + kTick}, words, Anchor::Top);
        return {x - half, x + half};
    }

    const RangedValues& values_;
    Box bar_;
    Drawing drawing_;
};

// Legend without histogram: the bar, followed by the lines of rangeTexts(), which continue in further rows if
// necessary.
Drawing briefLegend(const RangedValues& values, double width) {
    constexpr double kRow = 14;
    const std::string low = Legend::text(values.scale.twoSided ? -values.scale.high : values.scale.low);
    const std::string high = Legend::text(values.scale.high);
    const double before = textWidth(low, kText) + 3;
    const double after = textWidth(high, kText) + 3;
    Legend legend(values, {before, kRow / 2 - 5, before + kBriefBar, kRow / 2 + 5});
    legend.colors();
    legend.threshold(0);
    legend.text({0, kRow / 2}, low, Anchor::Left);
    legend.text({before + kBriefBar + 3, kRow / 2}, high, Anchor::Left);
    double x = before + kBriefBar + 3 + after + 3;
    double right = x;
    double y = 0;
    for (const std::string& line : rangeTexts(values)) {
        const double wide = textWidth(line, kText);
        if (x > 0 && x + wide > width) {
            x = 0;
            y += kRow;
        }
        legend.text({x, y + kRow / 2}, line, Anchor::Left);
        x += wide + kBetween;
        right = std::max(right, x - kBetween);
    }
    return legend.take(right, y + kRow);
}

}  // namespace

std::vector<std::string> rangeTexts(const RangedValues& values) {
    std::vector<std::string> lines{values.name};
    for (const QString& line : {rangeText(values), beyondText(values), thresholdText(values)}) {
        if (!line.isEmpty()) lines.push_back(line.toStdString());
    }
    return lines;
}

Drawing rangeLegend(const RangedValues& values, double width, bool brief) {
    if (brief) return briefLegend(values, width);
    const std::vector<std::string> lines = rangeTexts(values);
    double widest = 0;
    for (const std::string& line : lines) widest = std::max(widest, textWidth(line, kText));
    // The text stands to the right of the bar, or below it if there is no room.
    const bool beside = kBarWidth + kBetween + widest + kEdge <= width;
    Legend legend(values, {kSide, kHistogram, kBarWidth - kSide, kHistogram + kBar});
    legend.histogram();
    legend.colors();
    legend.threshold(kHistogram);
    legend.numbers();
    const double bar = kHistogram + kBar + kTick + kLine + 2;
    const double words = kLine * static_cast<double>(lines.size());
    const Point at = beside ? Point{kBarWidth + kBetween, std::max(0.0, (bar - words) / 2)} : Point{0, bar};
    for (std::size_t n = 0; n < lines.size(); ++n) {
        legend.text({at.x, at.y + kLine * static_cast<double>(n)}, lines[n]);
    }
    return legend.take((beside ? at.x : 0) + std::max(widest + kEdge, beside ? 0 : kBarWidth),
                       beside ? std::max(bar, words) : bar + words);
}

}  // namespace reliefui
