// Expressions: claims of lessons, values to be filled into their texts, conditions of breakpoints, watched values.
// FORMATS.md, "Expressions", describes them.
//
//     or  := and { ( or || ) and }   and := not { ( and && ) not }   not := [ not ! ] comparison
//     comparison := sum [ ( < <= > >= == != ) sum [ "+-" sum ] ]
//     sum := product { ( + - ) product }      product := sign { ( * / ) sign }      sign := [ "-" ] operand
//     operand := number | 'text' | true | false | ( or ) | NAME [ ( or, ... ) ] [ @PLACE ] | pair
//     pair := whole number, whole number (a text; not among arguments)
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace relief {

using ExpressionValue = std::variant<bool, double, std::string>;

// A measured quantity as it stands in an expression: frame.error.at(10, 20)@twice. place: empty without @.
struct QuantityName {
    std::string name;
    std::vector<ExpressionValue> arguments;
    std::string place;
};
// Returns the value of a quantity; throws InputError if there is none.
using QuantitySource = std::function<ExpressionValue(const QuantityName&)>;

class Expression {
  public:
    // Throws InputError, whose subject is the text, if it is no expression.
    explicit Expression(const std::string& text);

    const std::string& text() const { return text_; }
    // Throws InputError if the values do not fit the operators, and what the source throws.
    ExpressionValue value(const QuantitySource& source) const;
    // Returns the value of an expression that gives a number. Throws InputError also if it is none.
    double number(const QuantitySource& source) const;
    // Returns whether a claim is true. Throws InputError also if it is neither true nor false.
    bool holds(const QuantitySource& source) const;
    // Returns the claim's text with the values of both sides of its comparisons: "a < 0.5 * b (0.4 < 0.3)".
    std::string explained(const QuantitySource& source) const;
    // Calls visit for each quantity, with arguments that are constants; others are left out.
    void visitQuantities(const std::function<void(const QuantityName&)>& visit) const;

    struct Node;

  private:
    std::string text_;
    std::shared_ptr<const Node> root_;
};

// Formats a value for a text: numbers with four significant digits; or, by `format`, ".2" with two decimals, "%" in per
// cent without decimals. Infinity: "∞". Throws InputError for an unknown format.
std::string expressionValueText(const ExpressionValue& value, const std::string& format = {});

}  // namespace relief
