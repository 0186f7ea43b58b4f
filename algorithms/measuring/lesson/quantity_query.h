// What the lists of quantities share (quantities_scene.cpp, quantities_ray.cpp, quantities_frame.cpp).
#pragma once

#include <cmath>
#include <concepts>
#include <string>
#include <variant>
#include <vector>

#include "measuring/lesson/quantities.h"

namespace relief {

// A quantity with its arguments, and what it is measured with.
struct Query {
    const QuantityName& name;
    const Scenario& scenario;
    SceneCache& scenes;
    Work& work;

    MeasuredScene& scene() const { return scenes.scene(scenario); }
    const LoggedRay& ray() const { return scene().ray(work); }
    const Frame& frame() const { return scene().frame(work); }

    [[noreturn]] void fail(std::size_t index, const Message& why) const {
        throw InputError(name.name, Message(MessageId::LessonArgument, {{"number", index + 1}, {"why", why}}));
    }
    bool has(std::size_t index) const { return index < name.arguments.size(); }
    double number(std::size_t index) const {
        if (const double* const value = std::get_if<double>(&name.arguments[index])) return *value;
        fail(index, Message(MessageId::WantANumber));
    }
    std::string text(std::size_t index) const {
        if (const std::string* const value = std::get_if<std::string>(&name.arguments[index])) return *value;
        fail(index, Message(MessageId::WantAText));
    }
    // A number in [low, high].
    double number(std::size_t index, double low, double high) const {
        const double value = number(index);
        if (!(value >= low && value <= high)) failRange(index, low, high);
        return value;
    }
    // A whole number in [low, high].
    int whole(std::size_t index, double low, double high) const {
        const double value = number(index, low, high);
        if (value != std::floor(value)) failRange(index, low, high);
        return static_cast<int>(value);
    }

  private:
    [[noreturn]] void failRange(std::size_t index, double low, double high) const {
        fail(index, Message(MessageId::NumberOutOfRange, {{"value", number(index)}, {"range", rangeOf(low, high)}}));
    }
};

// Makes a Measure of a function of a Query.
template <auto Function>
inline constexpr Quantity::Measure measured =
    [](const QuantityName& name, const Scenario& scenario, SceneCache& scenes, Work& work) {
        return ExpressionValue(Function(Query{name, scenario, scenes, work}));
    };

template <std::integral T>
double asNumber(T value) {
    return static_cast<double>(value);
}

// Makes a Quantity whose value is the expression, in which q is the Query.
#define RELIEF_QUANTITY(name, least, most, ...)                                 \
    Quantity {                                                                  \
        name, least, most, measured<[](const Query& q) { return __VA_ARGS__; }> \
    }

// The quantities of the scene and its maps, of the ray and footprint of the pixel, and of the picture.
std::vector<Quantity> sceneQuantities();
std::vector<Quantity> rayQuantities();
std::vector<Quantity> frameQuantities();

}  // namespace relief
