// relief bench filters: its options and its run.
#pragma once

#include "bench_output.h"
#include "measuring/bench/bench_filters.h"
#include "options_common.h"

namespace relief::app {

struct FilterBenchCommand {
    OptionText filters, scenes, pixelModels, size, samples, color;

    void add(CLI::App& parser);
    // pictures: height maps that were given, instead of the scenes. elevations, reliefDepth, rounds, seed, to: as bench
    // has them for all kinds.
    int run(const std::vector<Pictures>& pictures, const OptionText& elevations, const OptionText& reliefDepth,
            const OptionText& rounds, const OptionText& seed, BenchRun to, Session& session) const;
};

}  // namespace relief::app
