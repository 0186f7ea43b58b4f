// The columns of a ray's steps by name, which breakpoints, watched values and tracks read: those of step files,
// derived ones, and further ones of another program's file. FORMATS.md, "Columns of steps", describes them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "relief/step_log.h"
#include "scenario/expression.h"

namespace relief {

// A column of another program's steps file that is none of ours: a cell for each step, as in the file.
struct FurtherColumn {
    std::string name;
    std::vector<std::string> cells;
    bool operator==(const FurtherColumn&) const = default;
};
// Returns the cells as numbers, NaN where a cell is empty; std::nullopt if any other cell is no finite number.
std::optional<std::vector<double>> columnNumbers(const FurtherColumn& column);

// A ray's steps with their columns; holds references. further: may be null. pixel: of the ray; none for a ray from
// files. ray: its number in the files.
class StepColumns {
  public:
    StepColumns(const std::vector<Step>& steps, const std::vector<FurtherColumn>* further = nullptr,
                std::optional<std::array<int, 2>> pixel = {}, std::size_t ray = 0);

    std::size_t steps() const { return steps_->size(); }
    // Returns the names of all columns that the steps have.
    std::vector<std::string> names() const;
    // Returns the values of one step by name: numbers, NaN where the step has none; texts (phase, decision, kind,
    // pixel, and further columns of which a cell is no number). The words of phase, decision and kind are names for
    // themselves, so that `decision == hit` needs no quotes. column('NAME') is a column whose name is no word. Throws
    // InputError for other names.
    QuantitySource at(std::size_t step) const;

  private:
    ExpressionValue value(const QuantityName& name, std::size_t step) const;
    std::optional<ExpressionValue> own(const std::string& name, std::size_t step) const;
    std::optional<ExpressionValue> further(const std::string& name, std::size_t step) const;

    const std::vector<Step>* steps_;
    const std::vector<FurtherColumn>* further_;
    std::optional<std::array<int, 2>> pixel_;
    std::size_t ray_;
    std::vector<std::optional<std::vector<double>>> numbers_;  // of further columns
};

// The values of an expression at all steps.
struct WatchedValues {
    std::vector<ExpressionValue> values;
    // Returns a number for each value, for a graph: texts are numbered in the order in which they first occur.
    std::vector<double> heights() const;
    bool changes(std::size_t a, std::size_t b) const;
    // Returns the next step after `from` whose value differs from that of `from`, or the nearest one before it;
    // std::nullopt if there is none.
    std::optional<std::size_t> nextChange(std::size_t from, bool forward) const;
};
// Throws InputError for what is no expression, for unknown columns, and for values that do not fit the operators.
WatchedValues watchedValues(const std::string& expression, const StepColumns& columns);

}  // namespace relief
