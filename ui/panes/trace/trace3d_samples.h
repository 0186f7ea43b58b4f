// Objects that the 3-D trace draws for steps that sample the surface at points of the ray: layers as sheets, heights as
// stems between ray and surface, a shift as an arrow. Chosen by the steps' subjects and decisions.
#pragma once

#include <optional>
#include <vector>

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "panes/step_colors.h"
#include "panes/trace/trace3d_scene.h"

namespace reliefui {

// Lambda at which step `index` read its value.
double readAt(const std::vector<relief::Step>& steps, std::size_t index);

// Lambdas of the sheets: those of the layers that the ray reached, uniformly thinned to at most `kMostSheets`, without
// the chosen step's, which is drawn separately.
inline constexpr std::size_t kMostSheets = 16;
std::vector<double> sheetLambdas(const std::vector<relief::Step>& steps, std::size_t chosen);

// Opacities, and radii relative to that of the ray or stem.
inline constexpr double kSheetOpacity = 0.05;
inline constexpr double kChosenSheetOpacity = 0.22;
inline constexpr double kRim = 0.25;  // outline of a sheet
inline constexpr double kChosenRim = 0.6;
inline constexpr double kStem = 0.35;
inline constexpr double kStemBall = 1.5;
inline constexpr double kShift = 1.2;

// What the steps up to the chosen one sampled; empty if no step samples a point.
struct SampleShapes {
    struct Stem {  // from the ray to the height read below it
        Place from{}, to{};
        double radius = 0;
        Rgba color;
    };
    std::vector<double> sheets;    // lambdas
    std::optional<double> chosen;  // lambda of the chosen step's sheet
    Rgba color;                    // of the chosen step
    std::vector<Stem> stems;
    std::optional<Stem> shift;  // arrow from the height read to the hit

    bool empty() const { return sheets.empty() && !chosen && stems.empty() && !shift; }
};
SampleShapes sampleShapes(const TraceScene& scene, const std::vector<relief::Step>& steps, std::size_t chosen,
                          const StepPaint& paint, const Style& style, double radius);
// Corners of a sheet.
std::vector<Place> sheetCorners(const TraceScene& scene, double lambda);

// Objects for the steps up to and around the chosen one; empty if no step samples a point.
std::vector<vtkSmartPointer<vtkActor>> sampleMarks(const TraceScene& scene, const std::vector<relief::Step>& steps,
                                                   std::size_t chosen, const StepPaint& paint, const Style& style,
                                                   double radius);

}  // namespace reliefui
