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
               Texts::tr("With sixteen layers the surface is sampled at only seventeen points of the ray, so a spike "
                         "between two of them goes unnoticed. The maximum pyramid misses no hit."),
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
        lesson(
            "unsafe_map", Texts::tr("Unsafe map: relaxed cones"),
            Texts::tr("In a relaxed cone the ray may enter the relief once, so steps are longer. Behind a narrow ledge "
                      "it has already left the relief again, and the hit is lost. A plain cone is always empty."),
            kDuel, Departure::UnsafeMap),
        lesson("unsafe_distance", Texts::tr("Unsafe map: interpolated distances"),
               Texts::tr("Distances are stored for the centres of voxels and interpolated between them; near a wall "
                         "the interpolated distance is larger than the true one. The conservative map holds for the "
                         "whole volume of a voxel."),
               kDuel, Departure::UnsafeMap),
        lesson("grazing_rays", Texts::tr("Grazing rays: more steps, and layers become visible ([DIST17])"),
               Texts::tr("At six degrees to the ground the ray meets neighbouring layers many texels apart. Compare "
                         "the methods and their numbers of steps (choose “Steps” in the result)."),
               "compare", Departure::MissedSpike),
        lesson("hidden_texels", Texts::tr("Footprint: texels that the relief hides"),
               Texts::tr("The ellipse, which is the projection of the pixel on the slanted relief, also covers texels "
                         "that cannot be seen; the filter elliptical-visible finds them by back-tracing and leaves "
                         "them out ([TEX])."),
               "footprint"),
        lesson("paper_march", Texts::tr("Distance map: each step is as long as the stored distance"),
               Texts::tr("The slice shows the distance of each voxel from the surface. At every step the ray advances "
                         "by that distance: it takes five steps to the floor, and four with the refined map of the "
                         "next lesson. The last circle reaches below the floor, because distances are interpolated "
                         "between the centres of voxels."),
               "distance"),
        lesson("paper_walls", Texts::tr("Refined distance: 3 texels or 4"),
               Texts::tr(
                   "Point C is 3 texels from the left wall. Rays from above that would meet that wall within 4 texels "
                   "of C hit the right wall before they reach C. The nearest hit of all other rays is on the floor, 4 "
                   "texels below; this is the refined distance. Ctrl+click shows the distances at another point."),
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
