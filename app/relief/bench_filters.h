// relief bench filters: options and implementation.
#pragma once

#include "bench_output.h"
#include "measuring/bench/bench_filters.h"
#include "options_common.h"

namespace relief::app {

struct FilterBenchCommand {
    OptionText filters, scenes, pixelModels, size, samples, color;

    void add(CLI::App& parser);
    // Returns the exit status. pictures: the user's height maps, measured in place of the built-in scenes. The other
    // arguments are the options that all kinds of `relief bench` share.
    int run(const std::vector<Pictures>& pictures, const OptionText& elevations, const OptionText& reliefDepth,
            const OptionText& rounds, const OptionText& seed, BenchRun to, Session& session) const;
};

}  // namespace relief::app
