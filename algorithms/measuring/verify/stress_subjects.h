// The functions that relief stress tests in addition to the tracers; by default the program's own. Tests substitute a
// faulty function for each of them, to check that the fault is reported.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "measuring/verify/stress_cases.h"
#include "measuring/verify/stress_part_checks.h"

namespace relief {

struct StressSubjects {
    // May be called by several threads at once, if stress() is.
    std::function<std::unique_ptr<AnyHitQuery>(const MethodChoice&, const HeightField&, MapCache&, Work&)> query =
        makeAnyHit;
    std::function<std::shared_ptr<const Frame>(const FrameRequest&, const std::shared_ptr<MapCache>&, Work&)> frame =
        [](const FrameRequest& request, const std::shared_ptr<MapCache>& maps, Work& work) {
            return FrameRenderer(maps).render(request, work);
        };
    std::vector<StressCameraFamily> cameras = stressCameraFamilies();  // of frames, homographies and rows
    std::function<Homography(const Homography&)> inverse = [](const Homography& map) { return map.inverse(); };
    std::function<DerivativeTerms<double>(const Homography&)> derivatives = [](const Homography& map) {
        return derivativeTerms<double>(map);
    };
    RowEvaluator<float> floatRow = evaluateRow<float>;
    RowEvaluator<double> doubleRow = evaluateRow<double>;
    std::function<void(const Homography&, const RowBlock&, const RowOptions&, TexelRows<float>&, Work&)> rowBlock =
        evaluateRows<float>;
};

}  // namespace relief
