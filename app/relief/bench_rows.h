// relief bench rows: its options and its run.
#pragma once

#include "options_common.h"

namespace relief::app {

struct RowBenchCommand {
    OptionText variants, widths, precisions, pixels;

    void add(CLI::App& parser);
    // elevations, rounds, output: as bench has them for all kinds.
    int run(const OptionText& elevations, const OptionText& rounds, const OptionText& output, Session& session) const;
};

}  // namespace relief::app
