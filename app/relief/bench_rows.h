// relief bench rows: options and implementation.
#pragma once

#include "bench_output.h"
#include "options_common.h"

namespace relief::app {

struct RowBenchCommand {
    OptionText variants, widths, precisions, pixels, rows;

    void add(CLI::App& parser);
    // Returns the exit status. elevations, rounds, to: the options that all kinds of `relief bench` share.
    int run(const OptionText& elevations, const OptionText& rounds, BenchRun to, Session& session) const;
};

}  // namespace relief::app
