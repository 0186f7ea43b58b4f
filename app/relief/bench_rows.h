// relief bench rows: its options and its run.
#pragma once

#include "bench_output.h"
#include "options_common.h"

namespace relief::app {

struct RowBenchCommand {
    OptionText variants, widths, precisions, pixels, rows;

    void add(CLI::App& parser);
    // elevations, rounds, to: as bench has them for all kinds.
    int run(const OptionText& elevations, const OptionText& rounds, BenchRun to, Session& session) const;
};

}  // namespace relief::app
