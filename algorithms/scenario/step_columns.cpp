#include "scenario/step_columns.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "relief/errors.h"
#include "scenario/step_cells.h"

namespace relief {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kDerived[] = {"delta_lambda", "pixel", "pixel_x", "pixel_y"};

template <std::size_t N>
bool isOneOf(const std::array<std::string_view, N>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool sameValue(const ExpressionValue& a, const ExpressionValue& b) {
    const double* const x = std::get_if<double>(&a);
    const double* const y = std::get_if<double>(&b);
    return a == b || (x != nullptr && y != nullptr && std::isnan(*x) && std::isnan(*y));
}

}  // namespace

std::optional<std::vector<double>> columnNumbers(const FurtherColumn& column) {
    std::vector<double> numbers;
    numbers.reserve(column.cells.size());
    for (const std::string& cell : column.cells) {
        double value = kNone;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        const bool whole = error == std::errc() && end == cell.data() + cell.size() && std::isfinite(value);
        if (!cell.empty() && !whole) return std::nullopt;
        numbers.push_back(cell.empty() ? kNone : value);
    }
    return numbers;
}

StepColumns::StepColumns(const std::vector<Step>& steps, const std::vector<FurtherColumn>* further,
                         std::optional<std::array<int, 2>> pixel, std::size_t ray)
    : steps_(&steps), further_(further), pixel_(pixel), ray_(ray) {
    if (further == nullptr) return;
    for (const FurtherColumn& column : *further) numbers_.push_back(columnNumbers(column));
}

std::vector<std::string> StepColumns::names() const {
    std::vector<std::string> names;
    const auto take = [&](std::string_view name, auto) { names.emplace_back(name); };
    forEachColumn(Step(), 0, 1, take, take);
    for (const std::string_view name : kSubjectColumns) names.emplace_back(name);
    names.insert(names.end(), std::begin(kDerived), std::end(kDerived));
    if (further_ != nullptr) {
        for (const FurtherColumn& column : *further_) names.push_back(column.name);
    }
    return names;
}

std::optional<ExpressionValue> StepColumns::own(const std::string& name, std::size_t step) const {
    const Step& at = (*steps_)[step];
    std::optional<ExpressionValue> found;
    forEachColumn(
        at, ray_, step + 1,
        [&](std::string_view column, auto value) {
            if (column == name) found = static_cast<double>(value);
        },
        [&](std::string_view column, std::string_view text) {
            if (column == name) found = std::string(text);
        });
    if (found) return found;
    const auto column = std::find(kSubjectColumns.begin(), kSubjectColumns.end(), name);
    if (column == kSubjectColumns.begin()) return std::string(subjectName(at.subject));
    if (column == kSubjectColumns.end()) return std::nullopt;
    return subjectValues(at)[static_cast<std::size_t>(column - kSubjectColumns.begin()) - 1].value_or(kNone);
}

std::optional<ExpressionValue> StepColumns::further(const std::string& name, std::size_t step) const {
    for (std::size_t c = 0; c < numbers_.size(); ++c) {
        const FurtherColumn& column = (*further_)[c];
        if (column.name != name) continue;
        if (numbers_[c]) return (*numbers_[c])[step];
        return column.cells[step];
    }
    return std::nullopt;
}

ExpressionValue StepColumns::value(const QuantityName& name, std::size_t step) const {
    const bool quoted = name.name == "column" && name.arguments.size() == 1 &&
                        std::holds_alternative<std::string>(name.arguments.front());
    const std::string& column = quoted ? std::get<std::string>(name.arguments.front()) : name.name;
    if (name.place.empty() && (quoted || name.arguments.empty())) {
        if (const auto found = own(column, step)) return *found;
        // A column of a file precedes a derived one of the same name.
        if (const auto found = further(column, step)) return *found;
        if (column == "delta_lambda") return (*steps_)[step].lambdaAfter - (*steps_)[step].lambdaIn;
        const auto pixel = [&](std::size_t axis) { return pixel_ ? static_cast<double>((*pixel_)[axis]) : kNone; };
        if (column == "pixel_x") return pixel(0);
        if (column == "pixel_y") return pixel(1);
        if (column == "pixel" && !pixel_) return std::string();
        if (column == "pixel") return std::to_string((*pixel_)[0]) + "," + std::to_string((*pixel_)[1]);
        if (isOneOf(kDecisionNames, column) || isOneOf(kPhaseNames, column) || isOneOf(kSubjectNames, column)) {
            return column;
        }
    }
    throw InputError("", unknownName({"what", MessageId::WordStepColumn}, column, commaList(names())));
}

QuantitySource StepColumns::at(std::size_t step) const {
    return [this, step](const QuantityName& name) { return value(name, step); };
}

std::vector<double> WatchedValues::heights() const {
    std::vector<double> heights;
    std::vector<std::string> words;
    for (const ExpressionValue& value : values) {
        if (const double* const number = std::get_if<double>(&value)) {
            heights.push_back(*number);
        } else if (const bool* const truth = std::get_if<bool>(&value)) {
            heights.push_back(*truth ? 1 : 0);
        } else {
            const auto& word = std::get<std::string>(value);
            const auto found = std::find(words.begin(), words.end(), word);
            heights.push_back(static_cast<double>(found - words.begin()));
            if (found == words.end()) words.push_back(word);
        }
    }
    return heights;
}

bool WatchedValues::changes(std::size_t a, std::size_t b) const {
    return !sameValue(values[a], values[b]);
}

std::optional<std::size_t> WatchedValues::nextChange(std::size_t from, bool forward) const {
    for (std::size_t k = from; forward ? ++k < values.size() : k-- > 0;) {
        if (changes(from, k)) return k;
    }
    return std::nullopt;
}

WatchedValues watchedValues(const std::string& expression, const StepColumns& columns) {
    const Expression parsed(expression);
    WatchedValues watched;
    watched.values.reserve(columns.steps());
    for (std::size_t k = 0; k < columns.steps(); ++k) watched.values.push_back(parsed.value(columns.at(k)));
    return watched;
}

}  // namespace relief
