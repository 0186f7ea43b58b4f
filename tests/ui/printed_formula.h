// Evaluates a formula from its printed numbers, as a reader would. The result is an interval, because printed numbers
// are rounded.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace reliefui {

struct Range {
    double low = 0;
    double high = 0;
    bool meets(const Range& other) const { return low <= other.high && other.low <= high; }
};

class PrintedFormula {
  public:
    static Range value(std::string_view text) {
        PrintedFormula formula(text);
        const Range range = formula.sum();
        EXPECT_TRUE(formula.rest_.empty()) << text << ": not understood from " << formula.rest_;
        return range;
    }
    // Returns the number at the beginning of the text.
    static Range leading(std::string_view text) {
        PrintedFormula formula(text);
        return formula.term();
    }

  private:
    explicit PrintedFormula(std::string_view text) : rest_(text) {}

    void skip() {
        while (rest_.starts_with(" ")) rest_.remove_prefix(1);
    }
    bool take(std::string_view sign) {
        skip();
        if (!rest_.starts_with(sign)) return false;
        rest_.remove_prefix(sign.size());
        return true;
    }
    static Range hull(std::initializer_list<double> ends) { return {std::min(ends), std::max(ends)}; }
    static Range times(Range a, Range b) {
        return hull({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    }

    Range sum() {
        Range all = term();
        for (;;) {
            if (take("+")) {
                const Range next = term();
                all = {all.low + next.low, all.high + next.high};
            } else if (take("−")) {
                const Range next = term();
                all = {all.low - next.high, all.high - next.low};
            } else {
                return all;
            }
        }
    }
    Range term() {
        Range all = factor();
        for (;;) {
            skip();
            if (take("·") || rest_.starts_with("(")) {
                all = times(all, factor());
            } else if (take("/")) {
                const Range by = factor();
                EXPECT_GT(by.low * by.high, 0) << "division by a value that may be zero";
                all = times(all, hull({1 / by.low, 1 / by.high}));
            } else {
                return all;
            }
        }
    }
    Range factor() {
        if (take("−")) {
            const Range own = factor();
            return {-own.high, -own.low};
        }
        Range own = primary();
        if (take("²")) {
            const Range square = times(own, own);
            own = {own.low * own.high > 0 ? square.low : 0, square.high};
        }
        return own;
    }
    Range primary() {
        if (take("√")) {
            const Range of = primary();
            return {std::sqrt(std::max(of.low, 0.0)), std::sqrt(of.high)};
        }
        for (const std::string_view name : {"min", "max", "exp"}) {
            if (!take(std::string(name) + "(")) continue;
            Range all = sum();
            if (name == "exp") all = {std::exp(all.low), std::exp(all.high)};
            while (take(",")) {
                const Range next = sum();
                all = name == "min" ? Range{std::min(all.low, next.low), std::min(all.high, next.high)}
                                    : Range{std::max(all.low, next.low), std::max(all.high, next.high)};
            }
            EXPECT_TRUE(take(")"));
            return all;
        }
        if (take("(")) {
            const Range inner = sum();
            EXPECT_TRUE(take(")"));
            return inner;
        }
        return number();
    }
    Range number() {
        skip();
        const std::size_t end = std::min(rest_.find_first_not_of("0123456789."), rest_.size());
        EXPECT_GT(end, 0U) << rest_;
        if (end == 0) {
            rest_ = {};
            return {};
        }
        const std::string digits(rest_.substr(0, end));
        rest_.remove_prefix(end);
        const std::size_t point = digits.find('.');
        const double value = std::stod(digits);
        // Small integers are exact: 1, 2, layer 3 of 8.
        double half = value < 1000 ? 0 : 0.5;
        if (point != std::string::npos) half = 0.5 * std::pow(10.0, -static_cast<double>(digits.size() - point - 1));
        double scale = 1;
        if (take("×10^{")) {
            const double sign = take("−") ? -1 : 1;
            const std::size_t close = rest_.find('}');
            scale = std::pow(10.0, sign * std::stod(std::string(rest_.substr(0, close))));
            rest_.remove_prefix(close + 1);
        }
        return {(value - half) * scale, (value + half) * scale};
    }

    std::string_view rest_;
};

}  // namespace reliefui
