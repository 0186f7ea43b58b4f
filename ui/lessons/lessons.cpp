#include "lessons/lessons.h"

#include <QCoreApplication>
#include <QFile>

#include "workspace/pane_states.h"

// Resources of a static library have to be asked for, outside any namespace.
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
        lesson("vain_descent", Texts::tr("A descent in vain: the maximum pyramid"),
               Texts::tr("The maximum of a coarse texel lies above the ray, so it goes down; none of the finer texels "
                         "holds it, and it comes up again. Step through it with , and ."),
               "profile"),
        lesson("missed_spike", Texts::tr("Missed spike: layers against the maximum pyramid"),
               Texts::tr("Sixteen layers look at the surface at sixteen places; a spike that stands between two of "
                         "them is passed. The maximum pyramid passes nothing."),
               kDuel, Departure::MissedSpike),
        lesson("not_refined", Texts::tr("Not refined: the last layer is the answer"),
               Texts::tr("The hit lies between two layers; plain layers answer with the second one, bisection looks "
                         "for it."),
               kDuel, Departure::NotRefined),
        lesson("interpolation_leak", Texts::tr("Interpolation leak: a secant over an edge"),
               Texts::tr("Between the last two layers the surface is taken for a straight line; at an edge the answer "
                         "lies where there is no surface."),
               kDuel, Departure::InterpolationLeak),
        lesson("stopped_early", Texts::tr("Stopped early: one step of parallax offset"),
               Texts::tr("One sample is taken for the answer; where the relief changes, the ray is still in the air."),
               kDuel, Departure::StoppedEarly),
        lesson("unsafe_map", Texts::tr("Unsafe map: relaxed cones"),
               Texts::tr("A relaxed cone may enter the relief once, so that steps are long; at an edge it comes out "
                         "again behind it. Plain cones never enter."),
               kDuel, Departure::UnsafeMap),
        lesson(
            "unsafe_distance", Texts::tr("Unsafe map: interpolated distances"),
            Texts::tr("Distances are stored for the middles of voxels and interpolated between them; near a wall that "
                      "promises more room than there is. The conservative map holds for whole voxels."),
            kDuel, Departure::UnsafeMap),
        lesson("grazing_rays", Texts::tr("Grazing rays: steps grow, layers tear"),
               Texts::tr("Six degrees above the ground the layers lie many texels apart along the ray. Compare the "
                         "methods, and look at the layer of steps in the result."),
               "compare", Departure::MissedSpike),
        lesson("hidden_texels", Texts::tr("Footprint: texels that the relief hides"),
               Texts::tr("A pixel's ellipse on a slanted relief covers texels that the eye does not see; the filter "
                         "elliptical-visible leaves them out."),
               "footprint"),
        lesson(
            "paper_march", Texts::tr("Distance map: on by the distance that it stores"),
            Texts::tr("The slice shows how far each voxel is from the surface. At every stop the ray goes on by that "
                      "distance: five steps to the floor, and with the refined map of the next lesson four. The "
                      "last circle reaches below the floor: between the middles of voxels distances are "
                      "interpolated."),
            "distance"),
        lesson("paper_walls", Texts::tr("Refined distance: 3 texels or 4"),
               Texts::tr("Point C is 3 texels from the left wall. Rays from above that would meet that wall within "
                         "4 texels of C hit the right wall before they reach C; the nearest hit of all others is on "
                         "the floor, 4 texels below: the refined distance. Ctrl+click asks about another point."),
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
    return parseWindowScenario(file.readAll().toStdString(), path.toStdString());
}

}  // namespace reliefui
