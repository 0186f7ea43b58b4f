#include "bench_output.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "measuring/bench_columns.h"
#include "measuring/machine.h"
#include "measuring/measured_method.h"

namespace relief::app {

namespace {

// Of the bar, a cell.
constexpr std::int64_t kPermille = 1000;

BenchValue valueOf(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    if (value.is_number_integer()) return value.get<std::int64_t>();
    return value.is_number() ? value.get<double>() : std::nan("");
}

}  // namespace

std::string contentText(const FloatImage& heights) {
    // FNV-1a over the bits.
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const float height : heights.pixels()) {
        hash ^= std::bit_cast<std::uint32_t>(height);
        hash *= 0x100000001b3ULL;
    }
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

void addMachine(Json& rows) {
    for (Json& row : rows) {
        for (const auto& [name, text] : {std::pair<const char*, std::string (*)()>{"compiler", compilerText},
                                         {"cpu", cpuText},
                                         {"commit", commitText}}) {
            if (!row.contains(name)) row[name] = text();
        }
    }
}

std::string csvOfRows(const Json& rows, const std::string& header) {
    if (rows.empty()) return header;
    std::string text;
    for (const auto& [name, value] : rows.front().items()) text += (text.empty() ? "" : ",") + name;
    text += "\n";
    for (const Json& row : rows) {
        std::string line;
        bool first = true;
        for (const auto& [name, value] : row.items()) {
            if (!first) line += ',';
            line += benchField(valueOf(value));
            first = false;
        }
        text += line + "\n";
    }
    return text;
}

// Rows that the first version measured have no form: it measured the fastest there was.
void addForm(Json& rows) {
    for (Json& row : rows) {
        if (!row.contains("error_mean") || row.contains("form")) continue;
        Json whole = Json::object();
        for (const auto& [name, value] : row.items()) {
            whole[name] = value;
            if (name != "method") continue;
            const std::string options = row.value("options", std::string());
            whole["form"] = formName(methodForm(
                splitMethodChoice(value.get<std::string>() + (options.empty() ? "" : ":" + options), "form")));
        }
        row = std::move(whole);
    }
}

void overCells(std::string_view what, std::size_t cells, Session& session,
               const std::function<int(std::size_t)>& threads, const std::function<std::size_t()>& next,
               const std::function<std::size_t()>& done, const std::function<void(std::size_t, Work&)>& measure) {
    Progress& bar = session.work().progress();
    const std::size_t before = done();
    bar.begin(what, static_cast<std::int64_t>(cells - before) * kPermille);
    std::int64_t told = 0;
    const auto tell = [&](std::int64_t permille) {
        if (permille <= told) return;
        bar.advance(permille - told);
        told = permille;
    };
    while (true) {
        const std::size_t cell = next();
        // Others may have done some meanwhile.
        const auto base = static_cast<std::int64_t>(done() - before) * kPermille;
        tell(base);
        if (cell == kNoCell) return;
        // Stages inside a cell begin anew: the furthest counts.
        Work work(threads(cell) > 0 ? threads(cell) : session.threads(), session.stop(),
                  [&](std::string_view, double fraction) {
                      tell(base + static_cast<std::int64_t>(fraction * static_cast<double>(kPermille - 1)));
                  });
        measure(cell, work);
    }
}

void overParts(std::string_view what, SharedWork& shared, Session& session,
               const std::function<int(std::size_t)>& threads, const std::function<void(std::size_t, Work&)>& measure) {
    const bool speaks = shared.launch().rank == 0;
    const std::size_t before = shared.done();
    if (before > 0 && speaks) {
        session.note(shared.path(), Message(MessageId::SweepResumed, {{"done", before}, {"total", shared.parts()}}));
    }
    if (shared.lockError() != 0) {
        session.note(shared.path(), Message(MessageId::LocksMissing, {{"why", std::strerror(shared.lockError())}}));
    }
    try {
        overCells(
            what, shared.parts(), session, threads, [&] { return shared.take().value_or(kNoCell); },
            [&] { return shared.done(); }, measure);
    } catch (const Cancelled&) {
        const MessageId said = shared.done() > 0 ? MessageId::SweepStopped : MessageId::SweepStoppedEmpty;
        if (speaks) session.note(shared.path(), Message(said, {{"done", shared.done()}, {"total", shared.parts()}}));
        throw;
    }
    session.eraseBar();
}

void sweepTo(const BenchRun& run, const std::vector<std::string>& names, const std::string& header, Session& session,
             const std::function<int(std::size_t)>& threads, const std::function<Json(std::size_t, Work&)>& measure) {
    const Json what{{"options", run.what}, {"cells", names}};
    SharedWork shared(*run.output, what, names.size(), run.earlier, launched(), session.stop());
    overParts("bench", shared, session, threads, [&](std::size_t cell, Work& work) {
        Json rows = measure(cell, work);
        addMachine(rows);
        shared.put(cell, rows);
    });
    const auto results = shared.collect();
    if (!results) return;
    Json rows = Json::array();
    for (const Json& cell : *results) rows.insert(rows.end(), cell.begin(), cell.end());
    addForm(rows);
    TextOutput file(*run.output, session.stop());
    file.write(fileEnding(*run.output) == "json" ? rows.dump(1) + "\n" : csvOfRows(rows, header));
    file.commit();
    shared.finish();
}

}  // namespace relief::app
