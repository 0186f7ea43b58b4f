// The parts of a stress case, each over the case's map. Their violations and counts go into the case's result.
#pragma once

#include "measuring/verify/stress_case.h"
#include "measuring/verify/stress_subjects.h"

namespace relief::stress_detail {

// The rays of a family over a case, and what `exact` finds.
struct Asked {
    std::string_view family;
    std::vector<ViewRay> rays;
    std::vector<Hit> truth;
};

// What the parts of one case share.
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

// Random numbers of the n-th try of a part in this case: the same whichever other parts run.
Random partRandom(const CaseRun& run, StressPart part, std::uint64_t n);

// All throw Cancelled.
// Every any-hit query on every ray from its entry to the bottom of the slab, held against the exact hit.
void stressAnyHit(const CaseRun& run, const std::vector<Asked>& asked);
// Small frames with filters, shadows and cameras at their ends, with and without skipping, by one thread and several.
void stressFrames(const CaseRun& run);
// The maps of the polygons that such cameras see: there and back, derivatives against differences.
void stressHomographies(const CaseRun& run);
// Every row variant on rows of such cameras and on rows whose bounds are stated; rows-parallel also as a block.
void stressRows(const CaseRun& run);

}  // namespace relief::stress_detail
