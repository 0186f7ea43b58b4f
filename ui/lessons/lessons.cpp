#include "lessons/lessons.h"

#include <QCoreApplication>
#include <QFile>

#include "scenario/scenario.h"

// Resources of a static library have to be initialised explicitly, outside any namespace.
static void initLessons() {
    Q_INIT_RESOURCE(lessons);
}

namespace reliefui {

namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(reliefui::Lessons)
};

Lesson lesson(const char* name, const QString& title, const QString& about, const char* pane,
              std::optional<relief::Departure> departure = std::nullopt) {
    return {QLatin1String(name), title, about, QLatin1String(pane), departure};
}

}  // namespace

std::vector<Lesson> lessons() {
    using relief::Departure;
    constexpr const char* kDuel = "duel";
    return {
        lesson("vain_descent", Texts::tr("A search in vain: a hit is possible but not confirmed ([MIP18])"),
               Texts::tr("The maximum of a texel of a higher level lies above the ray, so the search goes down a "
                         "level. There no texel lies above the ray: the hit is not confirmed, and the search comes up "
                         "again. The keys “,” and “.” go from step to step."),
               "profile"),
        lesson("missed_spike", Texts::tr("Missed spike: layers against the maximum pyramid"),
               Texts::tr("With sixteen layers the surface is read at sixteen points of the ray only: a spike between "
                         "two of them goes unnoticed. The maximum pyramid misses no hit."),
               kDuel, Departure::MissedSpike),
        lesson("not_refined", Texts::tr("Not refined: the last layer is the answer"),
               Texts::tr("The hit lies between two layers. The method of layers answers with the second of them; "
                         "bisection narrows the interval down to the hit."),
               kDuel, Departure::NotRefined),
        lesson("interpolation_leak", Texts::tr("Interpolation leak: a secant over a drop in height"),
               Texts::tr("Between the last two layers the surface is replaced by a straight line; at a sharp drop in "
                         "height the point that is found does not lie on the surface."),
               kDuel, Departure::InterpolationLeak),
        lesson("stopped_early", Texts::tr("Stopped early: one step of parallax offset"),
               Texts::tr("The offset is computed from one height; where the relief changes, the ray is still above the "
                         "surface at the point that is found."),
               kDuel, Departure::StoppedEarly),
        lesson("unsafe_map", Texts::tr("Unsafe map: relaxed cones"),
               Texts::tr("In a relaxed cone the ray may enter the relief once, so steps are longer; at a narrow ledge "
                         "it has already come out behind it, and the hit is lost. A plain cone is always empty."),
               kDuel, Departure::UnsafeMap),
        lesson("unsafe_distance", Texts::tr("Unsafe map: interpolated distances"),
               Texts::tr("Distances are stored for the centres of voxels and interpolated between them; near a wall "
                         "the interpolated distance is larger than the true one. The conservative map holds for the "
                         "whole volume of a voxel."),
               kDuel, Departure::UnsafeMap),
        lesson("grazing_rays", Texts::tr("Grazing rays: more steps, and layers become visible ([DIST17])"),
               Texts::tr("At six degrees to the ground neighbouring layers meet the ray many texels apart. Compare the "
                         "methods, and look at the number of steps (choose “Steps” in the result)."),
               "compare", Departure::MissedSpike),
        lesson("hidden_texels", Texts::tr("Footprint: texels that the relief hides"),
               Texts::tr(
                   "The ellipse, the projection of the pixel on the slanted relief, covers texels that cannot be seen "
                   "as well; the filter elliptical-visible finds them by tracing back and leaves them out ([TEX])."),
               "footprint"),
        lesson(
            "paper_march", Texts::tr("Distance map: each step is as long as the stored distance"),
            Texts::tr("The slice shows how far each voxel is from the surface. At every stop the ray goes on by that "
                      "distance: five steps to the floor, and with the refined map of the next lesson four. The last "
                      "circle reaches below the floor: between the centres of voxels distances are interpolated."),
            "distance"),
        lesson("paper_walls", Texts::tr("Refined distance: 3 texels or 4"),
               Texts::tr("Point C is 3 texels from the left wall. Rays from above that would meet that wall within 4 "
                         "texels of C hit the right wall before they reach C; the nearest hit of all others is on the "
                         "floor, 4 texels below: the refined distance. Ctrl+click asks about another point."),
               "distance"),
    };
}

relief::Scenario lessonScenario(const QString& name) {
    initLessons();
    const QString path = QStringLiteral(":/lessons/%1.json").arg(name);
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        throw relief::InputError(path.toStdString(), relief::Message(relief::MessageId::FileMissing));
    }
    return relief::parseScenario(file.readAll().toStdString(), path.toStdString());
}

}  // namespace reliefui
