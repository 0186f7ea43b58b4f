// relief_changes [--rounds N]
//  Measures what a change in the window computes: for each kind of change the stages that were made again, counts of
//  the work, and the median processor time until the window has its new state, compared with that of a new picture.
//  Prints the table `changes` of RESULTS.md.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <QCoreApplication>

#include "../ui/changes.h"
#include "measuring/bench/machine.h"
#include "measuring/quantiles.h"
#include "workspace/start_scenario.h"
#include "workspace/workspace.h"

namespace {

using namespace reliefui;
using relief::MessageId;

constexpr int kSide = 32;  // texels of the relief by hand

// Processor time of all threads since `begin`, which other processes on the machine hardly change.
double milliseconds(std::clock_t begin) {
    return 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

double counted(const std::map<MessageId, double>& counters, MessageId what) {
    const auto found = counters.find(what);
    return found == counters.end() ? 0 : found->second;
}

std::string readable(double count) {
    return count == 0 ? "" : std::to_string(static_cast<long long>(count));
}

// One change in all rounds.
struct Measured {
    std::string stages;
    double tiles = 0, rays = 0, texels = 0, shadows = 0, maps = 0;
    std::vector<double> taken, anew;  // milliseconds
};

std::string stageNames(std::uint32_t stages) {
    std::string names;
    for (std::size_t s = 0; s < relief::kStages; ++s) {
        if ((stages & (1U << s)) == 0) continue;
        names += (names.empty() ? "" : ", ") +
                 std::string(messageTemplate(relief::kStageNames[s], relief::Language::English));
    }
    return names.empty() ? "none" : names;
}

void note(Measured& row, const Snapshot& before, const Snapshot& now, relief::Work& work) {
    const std::uint32_t made = stagesMade(before, now);
    row.stages = stageNames(made);
    const auto& counters = now.frame->counters;
    row.maps = counted(work.counters().values(), MessageId::CountMapBytes);
    if (made == kNoStage || now.frame == before.frame) return;
    const double tiles = relief::tilesAcross(now.frame->width) * relief::tilesDown(now.frame->height);
    row.tiles = tiles - counted(counters, MessageId::CountTilesKept);
    if (relief::has(made, relief::Stage::Hits)) row.rays = counted(counters, MessageId::CountRaysTraced);
    if (relief::has(made, relief::Stage::Color)) row.texels = counted(counters, MessageId::CountTexelsRead);
    if (relief::has(made, relief::Stage::Shadows)) row.shadows = counted(counters, MessageId::CountHitsLit);
}

void measure(const relief::Scenario& first, const std::vector<Change>& changes, int rounds,
             std::vector<std::pair<std::string, Measured>>& rows) {
    const std::size_t begin = rows.size();
    for (const Change& change : changes) rows.emplace_back(change.name, Measured{});
    for (int round = 0; round < rounds; ++round) {
        SnapshotMaker maker;
        SnapshotOrder order{first};
        relief::Work start;
        auto before = maker.make(order, start);
        // The maps that pay only after some frames are built before anything is measured.
        for (int n = 0; n < 4; ++n) {
            order.scenario.camera.azimuth += n % 2 == 0 ? 1 : -1;
            before = maker.make(order, start);
        }
        for (std::size_t n = 0; n < changes.size(); ++n) {
            changes[n].apply(order);
            Measured& row = rows[begin + n].second;
            relief::Work work;
            std::clock_t at = std::clock();
            const auto now = maker.make(order, work);
            row.taken.push_back(milliseconds(at));
            note(row, *before, *now, work);
            before = now;
            // A new picture of the same scenario, its files being loaded and its maps built.
            SnapshotMaker other;
            relief::Work again;
            other.make(order, again);
            SnapshotOrder away = order;
            away.scenario.camera.azimuth += 1;
            other.make(away, again);
            at = std::clock();
            other.make(order, again);
            row.anew.push_back(milliseconds(at));
        }
    }
}

// Returns the number of requests to the worker, and of new states, after changes that should cause neither.
int requestsWithoutNeed(const relief::Scenario& first) {
    Workspace workspace;
    workspace.start(first);
    while (!workspace.snapshot() || workspace.busy()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
    }
    int requests = 0;
    QObject::connect(&workspace, &Workspace::busyChanged, [&] { ++requests; });
    QObject::connect(&workspace, &Workspace::snapshotChanged, [&] { ++requests; });
    workspace.change(workspace.scenario(), QStringLiteral("nothing"));
    workspace.chooseStep(workspace.scenario().step + 1);
    Style style = workspace.style();
    style.theme = style.theme == Theme::Dark ? Theme::Light : Theme::Dark;
    workspace.setStyle(style);
    style.language = relief::Language::Ukrainian;
    workspace.setStyle(style);
    const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
    while (std::chrono::steady_clock::now() < until) QCoreApplication::processEvents(QEventLoop::AllEvents, 50);
    return requests;
}

void print(const std::vector<std::pair<std::string, Measured>>& rows) {
    std::printf(
        "| change | stages made | tiles | rays traced | texels read | hits with shadow queries | maps, KB | processor "
        "ms | "
        "of a new picture |\n| --- | --- | --: | --: | --: | --: | --: | --: | --: |\n");
    for (const auto& [name, row] : rows) {
        std::printf("| %s | %s | %s | %s | %s | %s | %s | %.1f | %.1f |\n", name.c_str(), row.stages.c_str(),
                    readable(row.tiles).c_str(), readable(row.rays).c_str(), readable(row.texels).c_str(),
                    readable(row.shadows).c_str(), readable(std::ceil(row.maps / 1024)).c_str(),
                    relief::quantile(row.taken, 0.5), relief::quantile(row.anew, 0.5));
    }
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    int rounds = 5;
    CLI::App app("What a change in the window computes");
    app.add_option("--rounds", rounds, "of all changes")->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);
    try {
        relief::Scenario scene = startScenario(RELIEF_DATASETS);
        scene.filter.name = "elliptical";
        scene.shadows = true;
        relief::Scenario drawn = drawnScenario(kSide);
        drawn.pixel = relief::PixelChoice{400, 300};
        drawn.camera.elevation = 45;
        std::vector<std::pair<std::string, Measured>> rows;
        measure(scene, sceneChanges(), rounds, rows);
        measure(drawn, editChanges(), rounds, rows);
        print(rows);
        relief::Work work;
        std::printf(
            "\nChosen step, theme, language and a change to the same values: %d requests of a picture.\n\n(%s, %d "
            "thread(s), %s, sources %s, medians of %d rounds)\n",
            requestsWithoutNeed(scene), relief::cpuText().c_str(), work.threads().size(),
            relief::compilerText().c_str(), relief::commitText().c_str(), rounds);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
