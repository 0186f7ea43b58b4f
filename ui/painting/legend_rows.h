// Entries of a legend, one after the other, in as many rows as it takes. Points.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "painting/drawing.h"
#include "painting/step_body.h"

namespace reliefui {

class LegendRows {
  public:
    LegendRows(double width, relief::Language language) : width_(width), language_(language) {}

    // A sign that is given around (0, 0), and what it is. room: of the sign and the gap behind it. Where its middle is.
    Point sign(Role role, Primitive sign, const relief::Message& what, LevelTint tint = {},
               Emphasis emphasis = Emphasis::Normal, double room = kSign);
    // Words alone; in several lines where they are wider than the legend.
    void words(const relief::Message& message, double behind = kBetween);
    void wrapped(const relief::Message& message);
    // About the width of the text.
    double textRoom(const relief::Message& message) const;
    // A short line of this role, and what it is.
    void line(Role role, const relief::Message& what, LevelTint tint = {}, double length = 18);
    // A patch of its colour, on request hatched, and what it is.
    void swatch(Role role, const relief::Message& what, LevelTint tint = {}, bool hatched = false);
    // The colours of a map, and what they are of.
    void ramp(ColorMap map, const relief::Message& what);
    // What takes more than one row, before all others.
    void block(Drawing drawing);
    // What the steps' spheres or cones are, where there are any; and that a promise is broken, where one is that is
    // `drawn` (all of them, if it is empty). exact: the ray's first hit.
    void bodies(const std::vector<relief::Step>& steps, const relief::ViewRay& ray, const relief::Hit& exact,
                const std::function<bool(const StepBody&)>& drawn = {});
    // A mark of a decision, and its name; one entry for each that is `seen`.
    void decisions(const std::array<bool, relief::kDecisionNames.size()>& seen);

    // Entries of several signs: the place of an entry of this width at the middle of its row, its signs, and its words.
    Point place(double width);
    void add(Role role, Primitive primitive, LevelTint tint = {}, Emphasis emphasis = Emphasis::Normal);
    void text(Point at, relief::Message message);
    // What follows begins a row.
    void newRow();
    Drawing take();

    static constexpr double kSign = 14;
    static constexpr double kBetween = 9;

  private:
    double width_;
    relief::Language language_;
    double x_ = 0;
    double y_ = 0;
    double right_ = 0;
    Drawing drawing_;
};

// Which decisions occur in the steps, and the hit.
std::array<bool, relief::kDecisionNames.size()> decisionsSeen(const std::vector<relief::Step>* steps, bool hit);

}  // namespace reliefui
