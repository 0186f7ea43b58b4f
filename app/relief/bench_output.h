// What every benchmark does with its rows: a journal beside the output, then the file; else a table on a terminal, CSV
// elsewhere.
#pragma once

#include <unistd.h>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "journal.h"
#include "options_common.h"
#include "output.h"

namespace relief::app {

// How one kind of row is written.
template <class Row>
struct BenchTexts {
    std::string (*header)();
    std::string (*line)(const Row&);
    std::string (*json)(std::span<const Row>);
    std::string (*table)(std::span<const Row>);

    std::string file(const std::vector<Row>& rows, bool asJson) const {
        if (asJson) return json(rows);
        std::string text = header();
        for (const Row& row : rows) text += line(row);
        return text;
    }
};

// measure: measures all rows, telling of each as it comes. Returns the exit status.
template <class Row>
int runBenchTo(const OptionText& output, const BenchTexts<Row>& texts, Session& session,
               const std::function<std::vector<Row>(std::function<void(const Row&)>)>& measure) {
    std::optional<Journal> journal;
    if (output) journal.emplace(*output, texts.header());
    const std::vector<Row> rows = measure([&](const Row& row) {
        if (journal) journal->write(texts.line(row));
    });
    session.eraseBar();
    if (output) {
        TextOutput file(*output, session.stop());
        file.write(texts.file(rows, fileEnding(*output) == "json"));
        file.commit();
        journal->remove();
    } else {
        const bool terminal = isatty(STDOUT_FILENO) == 1;
        writeStandardOutput(terminal ? texts.table(rows) : texts.file(rows, false), session.stop());
    }
    return 0;
}

}  // namespace relief::app
