// Lays out the entries of a legend, one after the other, in as many rows as needed. Lengths are in points.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "painting/drawing.h"
#include "painting/step_body.h"

namespace reliefui {

class LegendRows {
  public:
    static constexpr double kLine = 18;
    static constexpr double kSign = 14;
    static constexpr double kBetween = 9;

    LegendRows(double width, relief::Language language) : width_(width), language_(language) {}

    // Adds a symbol, given relative to (0, 0), followed by its explanation. room: width of the symbol and the gap after
    // it. Returns the position of the symbol's centre.
    Point sign(Role role, Primitive sign, const relief::Message& what, LevelTint tint = {},
               Emphasis emphasis = Emphasis::Normal, double room = kSign);
    // Adds text without a symbol, broken into several lines if it is wider than the legend.
    void words(const relief::Message& message, double behind = kBetween);
    // Approximate width of the text.
    double textRoom(const relief::Message& message) const;
    // Adds a short line of this role and its explanation.
    void line(Role role, const relief::Message& what, LevelTint tint = {}, double length = kLine,
              Emphasis emphasis = Emphasis::Normal);
    // Adds a colour patch, optionally hatched, and its explanation.
    void swatch(Role role, const relief::Message& what, LevelTint tint = {}, bool hatched = false);
    // Adds a colour bar of the map and its explanation.
    void ramp(ColorMap map, const relief::Message& what);
    // Adds a drawing of more than one row's height; must precede all other entries.
    void block(Drawing drawing);
    // Adds the explanation of the steps' spheres or cones, if there are any, and of violated ones, if at least one that
    // is `drawn` (an empty function means all) contains the exact hit. exact: the ray's first hit.
    void bodies(const std::vector<relief::Step>& steps, const relief::ViewRay& ray, const relief::Hit& exact,
                const std::function<bool(const StepBody&)>& drawn = {});
    // Adds the marker and name of each decision that is set in `seen`.
    void decisions(const std::array<bool, relief::kDecisionNames.size()>& seen);

    // For entries composed of several symbols: place() reserves an entry of this width and returns the vertical middle
    // of its left end; add() adds a symbol and text() the explanation.
    Point place(double width);
    void add(Role role, Primitive primitive, LevelTint tint = {}, Emphasis emphasis = Emphasis::Normal);
    void text(Point at, relief::Message message);
    // Starts a new row for the next entry.
    void newRow();
    Drawing take();

  private:
    double width_;
    relief::Language language_;
    double x_ = 0;
    double y_ = 0;
    double right_ = 0;
    Drawing drawing_;
};

// Flags the decisions that occur in the steps; `hit` adds that of the final hit.
std::array<bool, relief::kDecisionNames.size()> decisionsSeen(const std::vector<relief::Step>* steps, bool hit);

}  // namespace reliefui
