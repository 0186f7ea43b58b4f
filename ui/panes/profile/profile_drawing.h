// The profile: the relief cut along the chosen ray. The x axis is the distance from the ray's entry into the slab, in
// texels (unwrapped if the picture repeats), or the descent if the ray is vertical; the y axis is the height. It shows
// the surface, the maxima of the pyramid's texels that the ray crosses, layers, and the numbered steps. [DIST17] figs.
// 1 and 2, [MIP18] figs. 4 and 5.
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
#include "scenario/step_columns.h"

namespace reliefui {

// Input of the drawing; holds references, not copies.
struct ProfileSource {
    const relief::HeightField* field = nullptr;
    std::shared_ptr<const relief::MaxPyramidMap> maxima;
    bool hasRay = false;
    relief::ViewRay ray;
    relief::Hit hit;
    relief::Hit exact;  // first hit of the ray; Unset: not known
    const std::vector<relief::Step>* steps = nullptr;
    std::shared_ptr<const PointQuery> point;  // point whose distances are shown; null: none
    // Columns of another program's steps, shown as tracks below the profile; may be null.
    const std::vector<relief::FurtherColumn>* further = nullptr;

    // Returns true if all steps examine the surface at points of the ray, not cells or a map.
    bool atPoints() const;
    // Number of equal layers into which the steps divide the slab; 0: none.
    int layers() const;
};

// Levels whose maxima are shown: those that occur in the log, or all.
enum class LevelsShown : std::uint8_t { None, Visited, All };
struct ProfileOptions {
    LevelsShown levels = LevelsShown::Visited;
    bool trueAspect = false;  // same scale horizontally and vertically
    bool nearRay = false;     // show only the range of heights that the ray traverses
    // The user is to guess where the ray hits; `guess` is the guessed lambda, shown together with the answer.
    bool guessing = false;
    std::optional<double> guess;
};

// How a step is drawn; its decision gives colour and marker. Body: a sphere or cone that a map guarantees to be empty.
// Mark: only a mark on the ray.
enum class StepShape : std::uint8_t { Plateau, Point, Layer, Body, Mark };
StepShape stepShape(const relief::Step& step);

// Layout of the drawing. `visible` is the part on the screen, `zoom` the scale in points of the screen per unit; they
// determine how much is thinned out, and where the axes stand.
struct ProfileFrame {
    Box plot;
    double lambdaEnd = 1;  // lambda at the plot's right side; 0 at the left
    double low = 0;        // heights of the lower and upper sides
    double high = 1;
    double run = 0;  // texels per unit of lambda
    bool vertical = false;
    Box whole;
    Box visible;
    double zoom = 1;
    double tracks = 0;  // height of the tracks below the axis, in points

    double xAt(double lambda) const { return plot.x0 + lambda / lambdaEnd * plot.width(); }
    double yAt(double height) const { return plot.y1 - (height - low) / (high - low) * plot.height(); }
    Point at(double lambda, double height) const { return {xAt(lambda), yAt(height)}; }
    Point onRay(double lambda) const { return at(lambda, 1 - lambda); }
    double lambdaAt(double x) const { return (x - plot.x0) / plot.width() * lambdaEnd; }
    double heightAt(double y) const { return low + (plot.y1 - y) / plot.height() * (high - low); }
    // Value at the x axis.
    double across(double lambda) const { return vertical ? lambda : lambda * run; }
    // The visible part of the plot.
    Box seen() const { return plot.cut(visible); }
};
// width, height: available room in points; all of it is visible.
ProfileFrame profileFrame(const ProfileSource& source, const ProfileOptions& options, double width, double height);

// The relief: surface, maxima, layers.
Drawing profileRelief(const ProfileSource& source, const ProfileOptions& options, const ProfileFrame& frame);
// The ray and its steps, and the queried point with its distances. Steps after the chosen one are drawn faintly. If
// there is no room for all marks and numbers, those near the chosen step and the first ones have priority.
Drawing profileMarks(const ProfileSource& source, const ProfileOptions& options, const ProfileFrame& frame, int step);
// Adds spheres and cones of the steps; part of profileMarks().
void addBodies(Drawing& drawing, const ProfileSource& source, const ProfileFrame& frame, std::size_t chosen);
// Adds the prompt for a guess, or the guess and its distance from the answer; part of profileMarks().
void addGuess(Drawing& drawing, const ProfileSource& source, const ProfileOptions& options, const ProfileFrame& frame);
// Distance of a guess from the answer along the ray, in texels, at least the difference in depth; infinite without a
// hit.
double guessError(const ProfileSource& source, double guess);
// Adds a graph of each further column that has numbers, below the axis: over the part of the ray that the step is
// about, with the column's name and its value at the current step. Part of profileMarks().
void addTracks(Drawing& drawing, const ProfileSource& source, const ProfileFrame& frame, int step);
// Height of the tracks in a room of this height, in points; 0 if there are none.
double tracksHeight(const ProfileSource& source, double height);
// Width of the step's name above the plot's right end, "step 8: λ 0.61 → 0.61", in points.
inline constexpr double kStepTitle = 110;
// Numbers and units, at the edges of the visible part. reserved: width, in points, that the title of the left axis
// leaves free at the right.
Drawing profileAxes(const ProfileSource& source, const ProfileFrame& frame, double reserved = kStepTitle);
// Legend of what occurs, at most `width` points wide. brief: one entry for all levels and none for the decisions, which
// are named in the table of steps.
Drawing profileLegend(const ProfileSource& source, const ProfileOptions& options, double width,
                      relief::Language language, bool brief = false);

// What is under a point of the drawing.
struct ProfileReading {
    bool inside = false;  // inside the plot
    double lambda = 0;
    double across = 0;
    double rayHeight = 0;
    bool onRelief = true;  // not beyond the edge of the height map
    double surface = 0;
    std::int64_t i = 0;  // texel, unwrapped
    std::int64_t j = 0;
    int step = -1;  // the last (finest) step whose part of the ray contains the point
};
ProfileReading profileReading(const ProfileSource& source, const ProfileFrame& frame, Point at);

// Levels whose maxima are shown, from fine to coarse.
std::vector<int> profileLevels(const ProfileSource& source, const ProfileOptions& options);

// The plane of the ray; holds a reference to the frame. std::nullopt for a vertical ray, which has no plane.
std::optional<PointPlane> pointPlane(const PointQuery& query, const ProfileSource& source, const ProfileFrame& frame);

}  // namespace reliefui
