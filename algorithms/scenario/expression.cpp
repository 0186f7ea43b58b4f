#include "scenario/expression.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>

#include "relief/describe.h"
#include "relief/errors.h"
#include "scenario/step_sentence.h"

namespace relief {

struct Expression::Node {
    enum class Kind { Constant, Quantity, Function, Unary, Binary, Compare };
    Kind kind = Kind::Constant;
    ExpressionValue constant;
    // Of a quantity or function its name; otherwise the operator.
    std::string name;
    std::string place;
    // Of a comparison a third one is the tolerance.
    std::vector<std::shared_ptr<const Node>> parts;
};

namespace {

using Node = Expression::Node;
using NodePointer = std::shared_ptr<const Node>;

constexpr std::array<std::string_view, 6> kFunctions{"abs", "min", "max", "sqrt", "log2", "floor"};
// Parentheses and signs of an expression, nested or not; its length in bytes: both bound the recursion.
constexpr int kDeepest = 64;
constexpr std::size_t kLongest = 1000;

bool isFunction(const std::string& name) {
    return std::find(kFunctions.begin(), kFunctions.end(), name) != kFunctions.end();
}

class Parser {
  public:
    explicit Parser(const std::string& text) : text_(text), rest_(text) {}

    NodePointer whole() {
        if (text_.size() > kLongest) fail(MessageId::LessonWantShallow);
        NodePointer node = disjunction();
        skipSpace();
        if (!rest_.empty()) fail(MessageId::LessonWantEnd);
        return node;
    }

  private:
    [[noreturn]] void fail(MessageId wanted) const {
        throw InputError(text_, Message(MessageId::LessonExpression,
                                        {{"wanted", wanted}, {"place", text_.size() - rest_.size() + 1}}));
    }
    void skipSpace() {
        while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front())) != 0) rest_.remove_prefix(1);
    }
    bool take(std::string_view sign) {
        skipSpace();
        if (!rest_.starts_with(sign)) return false;
        rest_.remove_prefix(sign.size());
        return true;
    }
    static bool isWordLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
    bool takeWord(std::string_view word) {
        skipSpace();
        if (!rest_.starts_with(word)) return false;
        if (rest_.size() > word.size() && isWordLetter(rest_[word.size()])) return false;
        rest_.remove_prefix(word.size());
        return true;
    }
    bool takeNot() {
        skipSpace();
        return !rest_.starts_with("!=") && take("!");
    }
    // A pair of whole numbers, "480,300" or "4, -2": a text without spaces. std::nullopt among arguments, where a comma
    // separates them.
    std::optional<std::string> takePair() {
        skipSpace();
        if (arguments_ > 0) return std::nullopt;
        std::string pair;
        std::size_t at = 0;
        const auto whole = [&] {
            if (at < rest_.size() && rest_[at] == '-') pair += rest_[at++];
            const std::size_t first = at;
            while (at < rest_.size() && std::isdigit(static_cast<unsigned char>(rest_[at])) != 0) pair += rest_[at++];
            return at > first;
        };
        const auto space = [&] {
            while (at < rest_.size() && rest_[at] == ' ') ++at;
        };
        if (!whole()) return std::nullopt;
        space();
        if (at >= rest_.size() || rest_[at] != ',') return std::nullopt;
        pair += rest_[at++];
        space();
        if (!whole()) return std::nullopt;
        rest_.remove_prefix(at);
        return pair;
    }
    static NodePointer node(Node::Kind kind, std::string name, std::vector<NodePointer> parts) {
        auto made = std::make_shared<Node>();
        made->kind = kind;
        made->name = std::move(name);
        made->parts = std::move(parts);
        return made;
    }
    static NodePointer constant(ExpressionValue value) {
        auto made = std::make_shared<Node>();
        made->constant = std::move(value);
        return made;
    }

    NodePointer disjunction() {
        NodePointer left = conjunction();
        while (takeWord("or") || take("||")) left = node(Node::Kind::Binary, "or", {left, conjunction()});
        return left;
    }
    NodePointer conjunction() {
        NodePointer left = negation();
        while (takeWord("and") || take("&&")) left = node(Node::Kind::Binary, "and", {left, negation()});
        return left;
    }
    NodePointer negation() {
        if (takeWord("not") || takeNot()) return node(Node::Kind::Unary, "not", {comparison()});
        return comparison();
    }
    NodePointer comparison() {
        NodePointer left = sum();
        for (const char* const sign : {"<=", ">=", "==", "!=", "<", ">"}) {
            if (!take(sign)) continue;
            std::vector<NodePointer> parts{left, sum()};
            if (std::string_view(sign) == "==" && take("+-")) parts.push_back(sum());
            return node(Node::Kind::Compare, sign, std::move(parts));
        }
        return left;
    }
    NodePointer sum() {
        NodePointer left = product();
        for (;;) {
            skipSpace();
            if (rest_.starts_with("+-")) return left;  // a tolerance
            if (take("+")) {
                left = node(Node::Kind::Binary, "+", {left, product()});
            } else if (take("-")) {
                left = node(Node::Kind::Binary, "-", {left, product()});
            } else {
                return left;
            }
        }
    }
    NodePointer product() {
        NodePointer left = sign();
        for (;;) {
            if (take("*")) {
                left = node(Node::Kind::Binary, "*", {left, sign()});
            } else if (take("/")) {
                left = node(Node::Kind::Binary, "/", {left, sign()});
            } else {
                return left;
            }
        }
    }
    NodePointer sign() {
        if (std::optional<std::string> pair = takePair()) return constant(std::move(*pair));
        if (!take("-")) return operand();
        if (++depth_ > kDeepest) fail(MessageId::LessonWantShallow);
        return node(Node::Kind::Unary, "-", {sign()});
    }
    NodePointer operand() {
        skipSpace();
        if (rest_.empty()) fail(MessageId::LessonWantOperand);
        if (take("(")) {
            if (++depth_ > kDeepest) fail(MessageId::LessonWantShallow);
            NodePointer inside = disjunction();
            if (!take(")")) fail(MessageId::LessonWantClose);
            return inside;
        }
        if (rest_.front() == '\'') return quotedText();
        if (std::isdigit(static_cast<unsigned char>(rest_.front())) != 0 || rest_.front() == '.') return number();
        if (takeWord("true")) return constant(true);
        if (takeWord("false")) return constant(false);
        if (std::isalpha(static_cast<unsigned char>(rest_.front())) != 0) return named();
        fail(MessageId::LessonWantOperand);
    }
    NodePointer quotedText() {
        const std::size_t end = rest_.find('\'', 1);
        if (end == std::string_view::npos) fail(MessageId::LessonWantQuote);
        std::string text(rest_.substr(1, end - 1));
        rest_.remove_prefix(end + 1);
        return constant(std::move(text));
    }
    NodePointer number() {
        std::size_t length = 0;
        const auto digitsEnd = [&] {
            while (length < rest_.size() &&
                   (std::isdigit(static_cast<unsigned char>(rest_[length])) != 0 || rest_[length] == '.')) {
                ++length;
            }
        };
        digitsEnd();
        if (length < rest_.size() && rest_[length] == 'e') {
            ++length;
            if (length < rest_.size() && (rest_[length] == '-' || rest_[length] == '+')) ++length;
            digitsEnd();
        }
        const double value = parseNumber(rest_.substr(0, length), text_);
        rest_.remove_prefix(length);
        return constant(value);
    }
    std::string word() {
        std::size_t length = 0;
        while (length < rest_.size() && (isWordLetter(rest_[length]) || rest_[length] == '.')) ++length;
        std::string name(rest_.substr(0, length));
        rest_.remove_prefix(length);
        return name;
    }
    NodePointer named() {
        auto made = std::make_shared<Node>();
        made->name = word();
        made->kind = isFunction(made->name) ? Node::Kind::Function : Node::Kind::Quantity;
        if (take("(")) {
            if (++depth_ > kDeepest) fail(MessageId::LessonWantShallow);
            ++arguments_;
            do made->parts.push_back(disjunction());
            while (take(","));
            --arguments_;
            if (!take(")")) fail(MessageId::LessonWantClose);
        }
        if (made->kind == Node::Kind::Function) {
            const bool two = made->name == "min" || made->name == "max";
            if (made->parts.size() < (two ? 2U : 1U) || (!two && made->parts.size() > 1))
                fail(MessageId::LessonWantArguments);
            return made;
        }
        if (rest_.starts_with("@")) {
            rest_.remove_prefix(1);
            made->place = word();
            if (made->place.empty()) fail(MessageId::LessonWantPlace);
        }
        return made;
    }

    const std::string& text_;
    std::string_view rest_;
    int depth_ = 0;
    int arguments_ = 0;  // lists of arguments around this place
};

class Evaluator {
  public:
    Evaluator(const std::string& text, const QuantitySource& source) : text_(text), source_(source) {}

    ExpressionValue value(const Node& node) const {
        switch (node.kind) {
            case Node::Kind::Constant:
                return node.constant;
            case Node::Kind::Quantity:
                return source_(quantity(node));
            case Node::Kind::Function:
                return function(node);
            case Node::Kind::Unary:
                if (node.name == "not") return !truth(*node.parts[0]);
                return -number(*node.parts[0]);
            case Node::Kind::Binary:
                return binary(node);
            case Node::Kind::Compare:
                return compared(node);
        }
        return false;
    }
    double number(const Node& node) const { return asNumber(value(node)); }
    bool truth(const Node& node) const {
        const ExpressionValue found = value(node);
        if (const bool* const known = std::get_if<bool>(&found)) return *known;
        throw InputError(text_, Message(MessageId::LessonNoTruth, {{"value", expressionValueText(found)}}));
    }

  private:
    double asNumber(const ExpressionValue& found) const {
        if (const double* const known = std::get_if<double>(&found)) return *known;
        throw InputError(text_, Message(MessageId::LessonNoNumber, {{"value", expressionValueText(found)}}));
    }
    QuantityName quantity(const Node& node) const {
        QuantityName name{node.name, {}, node.place};
        for (const NodePointer& part : node.parts) name.arguments.push_back(value(*part));
        return name;
    }
    ExpressionValue function(const Node& node) const {
        double result = number(*node.parts[0]);
        if (node.name == "abs") return std::abs(result);
        if (node.name == "sqrt") return std::sqrt(result);
        if (node.name == "log2") return std::log2(result);
        if (node.name == "floor") return std::floor(result);
        for (std::size_t n = 1; n < node.parts.size(); ++n) {
            const double other = number(*node.parts[n]);
            result = node.name == "min" ? std::min(result, other) : std::max(result, other);
        }
        return result;
    }
    ExpressionValue binary(const Node& node) const {
        const Node &left = *node.parts[0], &right = *node.parts[1];
        if (node.name == "and") return truth(left) && truth(right);
        if (node.name == "or") return truth(left) || truth(right);
        const double a = number(left), b = number(right);
        switch (node.name[0]) {
            case '+':
                return a + b;
            case '-':
                return a - b;
            case '*':
                return a * b;
            default:
                return a / b;
        }
    }
    bool compared(const Node& node) const {
        const ExpressionValue left = value(*node.parts[0]), right = value(*node.parts[1]);
        if (left.index() != right.index()) {
            throw InputError(text_, Message(MessageId::LessonNoCompare, {{"value", expressionValueText(left)},
                                                                         {"other", expressionValueText(right)}}));
        }
        if (node.parts.size() == 2 && node.name == "==") return left == right;
        if (node.name == "!=") return left != right;
        const double a = asNumber(left), b = asNumber(right);
        if (node.parts.size() > 2) return std::abs(a - b) <= number(*node.parts[2]);
        if (node.name == "<") return a < b;
        if (node.name == "<=") return a <= b;
        return node.name == ">" ? a > b : a >= b;
    }

    const std::string& text_;
    const QuantitySource& source_;
};

void visit(const Node& node, const std::function<void(const Node&)>& body) {
    body(node);
    for (const NodePointer& part : node.parts) visit(*part, body);
}

}  // namespace

Expression::Expression(const std::string& text) : text_(text), root_(Parser(text).whole()) {}

ExpressionValue Expression::value(const QuantitySource& source) const {
    return Evaluator(text_, source).value(*root_);
}

double Expression::number(const QuantitySource& source) const {
    return Evaluator(text_, source).number(*root_);
}

bool Expression::holds(const QuantitySource& source) const {
    return Evaluator(text_, source).truth(*root_);
}

std::string Expression::explained(const QuantitySource& source) const {
    std::string sides;
    const Evaluator evaluator(text_, source);
    visit(*root_, [&](const Node& node) {
        if (node.kind != Node::Kind::Compare) return;
        sides += sides.empty() ? "" : ", ";
        sides += expressionValueText(evaluator.value(*node.parts[0])) + " " + node.name + " " +
                 expressionValueText(evaluator.value(*node.parts[1]));
        if (node.parts.size() > 2) sides += " +- " + expressionValueText(evaluator.value(*node.parts[2]));
    });
    return sides.empty() ? text_ : text_ + " (" + sides + ")";
}

void Expression::visitQuantities(const std::function<void(const QuantityName&)>& body) const {
    visit(*root_, [&](const Node& node) {
        if (node.kind != Node::Kind::Quantity) return;
        QuantityName name{node.name, {}, node.place};
        for (const NodePointer& part : node.parts) {
            if (part->kind == Node::Kind::Constant) name.arguments.push_back(part->constant);
        }
        body(name);
    });
}

std::string expressionValueText(const ExpressionValue& value, const std::string& format) {
    constexpr int kDigits = 4;
    constexpr int kMostDecimals = 9;
    const int decimals = format.size() == 2 && format[0] == '.' ? format[1] - '0' : 0;
    if (!format.empty() && format != "%" &&
        (format.size() != 2 || format[0] != '.' || decimals < 0 || decimals > kMostDecimals)) {
        throw InputError("", Message(MessageId::LessonNoFormat, {{"format", format}}));
    }
    if (const std::string* const text = std::get_if<std::string>(&value)) return *text;
    if (const bool* const truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
    double number = std::get<double>(value);
    if (std::isnan(number)) return "—";
    if (std::isinf(number)) return number > 0 ? "∞" : "−∞";
    if (format.empty()) {
        if (std::abs(number) >= 1000 && number == std::floor(number) && std::abs(number) < 1e15)
            return fixedText(number, 0);
        return numberText(number, kDigits);
    }
    if (format == "%") return fixedText(100 * number, 0) + "%";
    return fixedText(number, decimals);
}

}  // namespace relief
