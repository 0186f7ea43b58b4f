// A scalar type that counts the operations on it. The operation counts in tables and tests come from running the
// kernels themselves with this type.
//
// Each operand carries a pointer to its counter, so several counts can run independently. Values without a counter
// (loop indices, literals) are counted only when combined with a value that has one. A subtraction counts as an
// addition; negation, comparison and conversion are free.
#pragma once

#include <cmath>
#include <cstdint>

#include "mapping/rows/row_terms.h"

namespace relief {

struct OperationCounts {
    std::int64_t mul = 0;
    std::int64_t add = 0;
    std::int64_t div = 0;
    bool operator==(const OperationCounts&) const = default;
};

class Counted {
  public:
    Counted() = default;
    explicit Counted(double value, OperationCounts* counts = nullptr) : value_(value), counts_(counts) {}

    double value() const { return value_; }

    friend Counted operator+(Counted a, Counted b) { return done(a, b, a.value_ + b.value_, &OperationCounts::add); }
    friend Counted operator-(Counted a, Counted b) { return done(a, b, a.value_ - b.value_, &OperationCounts::add); }
    friend Counted operator*(Counted a, Counted b) { return done(a, b, a.value_ * b.value_, &OperationCounts::mul); }
    friend Counted operator/(Counted a, Counted b) { return done(a, b, a.value_ / b.value_, &OperationCounts::div); }
    Counted operator-() const { return Counted(-value_, counts_); }
    Counted& operator+=(Counted other) { return *this = *this + other; }
    Counted& operator-=(Counted other) { return *this = *this - other; }
    friend auto operator<=>(Counted a, Counted b) { return a.value_ <=> b.value_; }
    friend bool operator==(Counted a, Counted b) { return a.value_ == b.value_; }

  private:
    static Counted done(Counted a, Counted b, double value, std::int64_t OperationCounts::*what) {
        OperationCounts* counts = a.counts_ != nullptr ? a.counts_ : b.counts_;
        if (counts != nullptr) ++(counts->*what);
        return Counted(value, counts);
    }

    double value_ = 0;
    OperationCounts* counts_ = nullptr;
};

// The wide type of Counted is Counted itself.
template <>
struct WideOf<Counted> {
    using type = Counted;
};

}  // namespace relief
