// Expressions of lessons: grammar, values, faults.
#include "scenario/expression.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "relief/errors.h"

namespace relief::test {
namespace {

// a: 2; b: 3; word: 'left'; sum(...): the sum of its arguments; the place "far" adds 100.
ExpressionValue quantity(const QuantityName& name) {
    if (name.name == "word") return std::string("left");
    if (name.name == "yes") return true;
    double value = name.name == "a" ? 2 : name.name == "b.c" ? 3 : 0;
    if (name.name == "sum") {
        for (const ExpressionValue& argument : name.arguments) value += std::get<double>(argument);
    }
    return value + (name.place == "far" ? 100 : 0);
}

double numberOf(const std::string& text) {
    return std::get<double>(Expression(text).value(quantity));
}
bool holds(const std::string& text) {
    return Expression(text).holds(quantity);
}

TEST(LessonExpression, HasTheUsualOrderOfOperations) {
    const std::map<std::string, double> expected{{"1 + 2 * 3", 7},
                                                 {"(1 + 2) * 3", 9},
                                                 {"8 / 4 / 2", 1},
                                                 {"5 - 2 - 1", 2},
                                                 {"-a + 5", 3},
                                                 {"2 * -3", -6},
                                                 {"a@far", 102},
                                                 {"b.c * a", 6},
                                                 {"sum(1, a, 3)", 6},
                                                 {"sum(1, 2)@far / 103", 1},
                                                 {"max(1, a, b.c)", 3},
                                                 {"min(4, a)", 2},
                                                 {"abs(1 - a) + sqrt(9)", 4},
                                                 {"log2(8) + 1e1", 13},
                                                 {"floor(2.9)", 2}};
    for (const auto& [text, value] : expected) EXPECT_EQ(numberOf(text), value) << text;
}

TEST(LessonExpression, Compares) {
    for (const char* const text : {"a < b.c",
                                   "a <= 2",
                                   "b.c > a",
                                   "b.c >= 3",
                                   "a == 2",
                                   "a != b.c",
                                   "word == 'left'",
                                   "word != 'right'",
                                   "yes",
                                   "yes == true",
                                   "not a > 3",
                                   "a == 3 or b.c == 3",
                                   "a == 2 and b.c == 3",
                                   "a == 2.5 +- 0.5",
                                   "a > 3 or yes and a < 3",
                                   "not (a > 1 and a > 2)",
                                   "a > 3 || yes && a < 3",
                                   "!(a > 1 && a > 2)",
                                   "! a > 3",
                                   "'4,-5' == 4, -5",
                                   "sum(4,5) == 9",
                                   "-2,3 != 2,3",
                                   "nothing == 0"}) {
        EXPECT_TRUE(holds(text)) << text;
    }
    for (const char* const text :
         {"a > b.c", "a == 2.6 +- 0.5", "word == 'right'", "yes and a > 2", "not yes", "a < 1 or a > 2"}) {
        EXPECT_FALSE(holds(text)) << text;
    }
    EXPECT_EQ(Expression("a < 2 * b.c").explained(quantity), "a < 2 * b.c (2 < 6)");
    EXPECT_EQ(Expression("a == 3 +- 0.5").explained(quantity), "a == 3 +- 0.5 (2 == 3 +- 0.5)");
}

TEST(LessonExpression, RefusesWhatIsNone) {
    for (const char* const text : {"", "1 +", "(1", "1)", "a b", "'open", "a @", "a@", "1 < 2 < 3", "sum(1", "min(1)",
                                   "abs(1, 2)", "* 2", "a ==", "1.2.3", "#"}) {
        EXPECT_THROW(Expression{text}, InputError) << text;
    }
    EXPECT_THROW(Expression(std::string(200, '(') + "1" + std::string(200, ')')), InputError) << "too deep";
    EXPECT_THROW(Expression(std::string(200, '-') + "1"), InputError) << "too deep";
    std::string sum = "1";
    while (sum.size() < 999) sum += "+1";
    EXPECT_NO_THROW(Expression{sum});
    EXPECT_THROW(Expression(sum + "+1"), InputError) << "too long";
    for (const char* const text : {"word + 1", "not 1", "1 and 2", "word < 1", "yes == 1", "-word", "abs(word)"}) {
        EXPECT_THROW(Expression(text).value(quantity), InputError) << text;
    }
    EXPECT_THROW(holds("a"), InputError) << "a number is no claim";
}

TEST(LessonExpression, FormatsValues) {
    EXPECT_EQ(expressionValueText(0.123456), "0.1235");
    EXPECT_EQ(expressionValueText(12345.0), "12345");
    EXPECT_EQ(expressionValueText(1.5, ".2"), "1.50");
    EXPECT_EQ(expressionValueText(0.256, "%"), "26%");
    EXPECT_EQ(expressionValueText(INFINITY), "∞");
    EXPECT_EQ(expressionValueText(std::string("hit")), "hit");
    for (const char* const format : {".", ".x", "2", "%%", ".22"})
        EXPECT_THROW(expressionValueText(1.0, format), InputError) << format;
}

}  // namespace
}  // namespace relief::test
