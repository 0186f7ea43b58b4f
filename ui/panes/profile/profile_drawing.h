// The profile: the relief cut along the chosen ray. Across: the distance from where the ray enters the slab, texels
// (under repeat unwrapped), or the descent, if the ray is vertical; upwards: the height. The surface, the maxima of the
// pyramid's texels that the ray crosses, layers, and the steps, numbered. [DIST17] figs. 1 and 2, [MIP18] figs. 4
// and 5.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "painting/drawing.h"
#include "painting/step_body.h"
#include "panes/point_query.h"
#include "relief/height_field.h"
#include "relief/maps/max_pyramid_map.h"
#include "relief/ray.h"
#include "relief/step_log.h"

namespace reliefui {

// What is drawn; referred to, not copied.
struct ProfileSource {
    const relief::HeightField* field = nullptr;
    std::shared_ptr<const relief::MaxPyramidMap> maxima;
    bool hasRay = false;
    relief::ViewRay ray;
    relief::Hit hit;
    relief::Hit exact;  // the first hit; Unset: not known
    const std::vector<relief::Step>* steps = nullptr;
    std::shared_ptr<const PointQuery> point;  // whose distances are shown; null: none

    // Whether its steps looked at the surface at points of the ray only, not at cells and not at a map.
    bool atPoints() const;
    // Equal layers that they cut the slab into; 0: they do not.
    int layers() const;
};

// Of which levels the maxima are shown: of those that the log names, of all.
enum class LevelsShown : std::uint8_t { None, Visited, All };
struct ProfileOptions {
    LevelsShown levels = LevelsShown::Visited;
    bool trueAspect = false;  // a texel is as long across as upwards
    bool nearRay = false;     // only the heights that the ray comes through
    // Somebody is to guess where the ray hits; or has guessed this lambda, and the answer stands beside it.
    bool guessing = false;
    std::optional<double> guess;
};

// How a log's steps are shown; the decision gives colour and shape. The next kinds of method add theirs. Body: a
// sphere or cone that a map promises free. Mark: nothing but its mark on the ray.
enum class StepShape : std::uint8_t { Plateau, Point, Layer, Body, Mark };
StepShape stepShape(const relief::Step& step);

// Where what lies on the drawing. `visible` is the part that is seen, `zoom` points of the screen a unit of it: what is
// thinned out, and where the axes stand, depends on them.
struct ProfileFrame {
    Box plot;
    double lambdaEnd = 1;  // at the plot's right side; 0 at the left
    double low = 0;        // heights of its lower and upper side
    double high = 1;
    double run = 0;  // texels a unit of lambda
    bool vertical = false;
    Box whole;
    Box visible;
    double zoom = 1;

    double xAt(double lambda) const { return plot.x0 + lambda / lambdaEnd * plot.width(); }
    double yAt(double height) const { return plot.y1 - (height - low) / (high - low) * plot.height(); }
    Point at(double lambda, double height) const { return {xAt(lambda), yAt(height)}; }
    Point onRay(double lambda) const { return at(lambda, 1 - lambda); }
    double lambdaAt(double x) const { return (x - plot.x0) / plot.width() * lambdaEnd; }
    double heightAt(double y) const { return low + (plot.y1 - y) / plot.height() * (high - low); }
    // What is written at the axis there.
    double across(double lambda) const { return vertical ? lambda : lambda * run; }
    // The part of the plot that is seen.
    Box seen() const { return plot.cut(visible); }
};
// width, height: room in points; all of it is seen.
ProfileFrame profileFrame(const ProfileSource& source, const ProfileOptions& options, double width, double height);

// The relief: surface, maxima, layers.
Drawing profileRelief(const ProfileSource& source, const ProfileOptions& options, const ProfileFrame& frame);
// The ray and its steps, and the point with its distances. Steps after the chosen one are drawn faintly; where there is
// no room for all marks and numbers, those near the chosen one and the first come first.
Drawing profileMarks(const ProfileSource& source, const ProfileOptions& options, const ProfileFrame& frame, int step);
// Spheres and cones of the steps; part of the marks.
void addBodies(Drawing& drawing, const ProfileSource& source, const ProfileFrame& frame, std::size_t chosen);
// What is asked of who guesses, or the guess and how far the answer is from it; part of the marks.
void addGuess(Drawing& drawing, const ProfileSource& source, const ProfileOptions& options, const ProfileFrame& frame);
// How far a guess is from the answer along the ray, at least the descent itself, texels; infinite where nothing is hit.
double guessError(const ProfileSource& source, double guess);
// Numbers and units, at the edges of what is seen.
Drawing profileAxes(const ProfileSource& source, const ProfileFrame& frame);
// In at most `width` points; only what occurs. brief: all levels in one entry, and without the decisions, whose marks
// have their names in the table of steps.
Drawing profileLegend(const ProfileSource& source, const ProfileOptions& options, double width,
                      relief::Language language, bool brief = false);

// What is under a point of the drawing.
struct ProfileReading {
    bool inside = false;  // of the plot
    double lambda = 0;
    double across = 0;
    double rayHeight = 0;
    bool onRelief = true;  // not beyond the picture's edge
    double surface = 0;
    std::int64_t i = 0;  // the texel, unwrapped
    std::int64_t j = 0;
    int step = -1;  // the last one, the finest, whose stretch holds the point
};
ProfileReading profileReading(const ProfileSource& source, const ProfileFrame& frame, Point at);

// Levels whose maxima are shown, fine to coarse.
std::vector<int> profileLevels(const ProfileSource& source, const ProfileOptions& options);

// The plane of the ray; refers to the frame. None: a vertical ray has none.
std::optional<PointPlane> pointPlane(const PointQuery& query, const ProfileSource& source, const ProfileFrame& frame);

}  // namespace reliefui
