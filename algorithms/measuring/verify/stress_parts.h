// The parts of a stress case, each over the case's map. Their violations and counts are added to the case's result.
#pragma once

#include "measuring/verify/stress_case.h"
#include "measuring/verify/stress_subjects.h"

namespace relief::stress_detail {

// The rays of a family over a case, and the answers of `exact`.
struct FamilyRays {
    std::string_view family;
    std::vector<ViewRay> rays;
    std::vector<Hit> truth;
    // Further rays, which are traced as blocks only; see StressOptions::moreRays.
    RayBlock more;
    HitBlock moreTruth;
};

// Data that the parts of one case share.
struct CaseRun {
    const Case& of;
    const StressOptions& options;
    const std::vector<MethodGroup>& groups;
    const StressSubjects& subjects;
    std::shared_ptr<MapCache> maps;
    Watched& watched;
    CaseResult& result;
    Work& work;
};

// Returns the random numbers of the n-th try of a part in this case, which do not depend on the other parts.
Random partRandom(const CaseRun& run, StressPart part, std::uint64_t n);

// Each of these throws Cancelled.
// stressAnyHit: every any-hit query on every ray, from its entry to the bottom of the slab, compared with the exact
// hit.
void stressAnyHit(const CaseRun& run, const std::vector<FamilyRays>& familyRays);
// Every ray decided in rational arithmetic (rational_hit.h), compared with the hit of `exact`.
void stressOracle(const CaseRun& run, const std::vector<FamilyRays>& familyRays);
// Small frames with filters, shadows and extreme cameras, with and without skipping, with one thread and several.
void stressFrames(const CaseRun& run);
// The homographies of the polygons that such cameras see: round trips, and derivatives compared with differences.
void stressHomographies(const CaseRun& run);
// Every row variant on rows of such cameras and on rows for which error bounds are stated; rows-parallel also as a
// block.
void stressRows(const CaseRun& run);

}  // namespace relief::stress_detail
