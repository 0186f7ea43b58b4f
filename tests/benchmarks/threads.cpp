// relief_threads [--threads N,...] [--rounds N] [--side N]
//  Measures what more threads gain: hits, filter, shadows and light of a frame of 800 x 600 pixels, and builds of maps,
//  of a procedural relief of N x N texels. Efficiency is T(1) / (N T(N)), where T is the wall time of the shortest
//  round, since other programs only lengthen rounds. Processor time is that of all threads together over that of one
//  thread: what is above 1 the threads cost each other (memory, caches, distribution of tiles), however busy the
//  machine is.
#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "measuring/bench/machine.h"
#include "measuring/text_table.h"
#include "peer_rays.h"
#include "peer_table.h"
#include "relief/maps/distance_map.h"
#include "relief/reliefs.h"
#include "rendering/frame.h"

namespace {

using namespace relief;

double processorSeconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The shortest times of the rounds, in seconds.
struct Times {
    double wall = 1e300, processor = 1e300;
};

// A piece of work; it is done once with each number of threads in each round.
struct Task {
    std::string name;
    std::function<void(Work&)> run;
};

std::vector<Task> tasksOf(int side) {
    const auto heights = std::make_shared<const FloatImage>(makeRelief("bricks", side, side, 1));
    const HeightField field(heights, Surface::Bilinear, Address::Repeat, 0.1);
    const auto maps = std::make_shared<MapCache>();
    Work work;
    const std::shared_ptr<Tracer> tracer = makeTracer({"cone", {}}, field, *maps, work);
    const auto rays = std::make_shared<const RayBlock>(peers::perspectiveRays(field, 45, {}));
    const auto hits = std::make_shared<HitBlock>(rays->size());
    std::vector<Task> tasks;
    tasks.push_back({"hits, `cone`", [=](Work& w) {
                         NullSink none;
                         tracer->trace(*rays, *hits, none, w);
                     }});
    FrameRequest request{field};
    auto color = std::make_shared<ColorImage>(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const float h = (*heights)(x, y);
            (*color)(x, y) = {h, 1 - h, static_cast<float>((x / 4 + y / 4) % 2)};
        }
    }
    request.color = color;
    request.camera.elevation = 45;
    request.method = {"cone", {}};
    request.filter = parseFilter("elliptical-visible", "filter");
    request.shadows = true;
    // Each changes one thing, so that the renderer makes the stages that depend on it.
    const auto renderer = std::make_shared<FrameRenderer>(maps);
    const auto turned = std::make_shared<FrameRequest>(request);
    tasks.push_back({"frame: camera turned (all stages)", [=](Work& w) {
                         turned->camera.azimuth += 0.5;
                         renderer->render(*turned, w);
                     }});
    const auto filtering = std::make_shared<FrameRenderer>(maps);
    const auto filtered = std::make_shared<FrameRequest>(request);
    filtered->shadows = false;
    tasks.push_back({"frame: other filter (filter, light)", [=](Work& w) {
                         // Two filters in turn, both in one measurement.
                         for (const char* filter : {"elliptical-visible", "elliptical"}) {
                             filtered->filter = parseFilter(filter, "filter");
                             filtering->render(*filtered, w);
                         }
                     }});
    const auto lighting = std::make_shared<FrameRenderer>(maps);
    const auto lit = std::make_shared<FrameRequest>(request);
    tasks.push_back({"frame: light turned (shadows, light)", [=](Work& w) {
                         lit->light.azimuth += 0.5;
                         lighting->render(*lit, w);
                     }});
    tasks.push_back({"map of `cone`", [=](Work& w) { buildPackedCones(field, w); }});
    const auto map = [&](const std::string& method) {
        tasks.push_back({"map of `" + method + "`", [=](Work& w) {
                             MapCache fresh;
                             makeTracer(parseMethodChoice(method, "method"), field, fresh, w);
                         }});
    };
    for (const char* method : {"max-pyramid", "cone:layout=texel", "distance-conservative"}) map(method);
    return tasks;
}

void run(const std::vector<int>& threads, int rounds, int side) {
    std::vector<std::unique_ptr<Work>> works;
    for (const int count : threads) works.push_back(std::make_unique<Work>(count));
    std::cout << "| work | threads | ms | efficiency, % | processor time |\n| --- | --: | --: | --: | --: |\n";
    for (const Task& task : tasksOf(side)) {
        std::vector<Times> times(threads.size());
        for (int round = -1; round < rounds; ++round) {
            for (std::size_t n = 0; n < works.size(); ++n) {
                const auto begun = std::chrono::steady_clock::now();
                const double before = processorSeconds();
                task.run(*works[n]);
                if (round < 0) continue;  // a warm-up
                const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
                times[n].wall = std::min(times[n].wall, wall);
                times[n].processor = std::min(times[n].processor, processorSeconds() - before);
            }
        }
        for (std::size_t n = 0; n < times.size(); ++n) {
            const double gain = times[0].wall * threads[0] / times[n].wall / threads[n];
            std::cout << "| " << (n == 0 ? task.name : "") << " | " << threads[n] << " | "
                      << readable(1000 * times[n].wall, 3) << " | " << readable(100 * gain, 3) << " | "
                      << readable(times[n].processor / times[0].processor, 3) << " |\n"
                      << std::flush;
        }
    }
    std::cout << "\n(" << cpuText() << ", a relief of " << side << " x " << side << " texels, " << rounds << " rounds, "
              << compilerText() << ", sources " << commitText() << ")\n";
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<int> threads{1, 2};
    int rounds = 15, side = 1024;
    CLI::App app("What more threads gain, by stages of frames and by maps");
    app.add_option("--threads", threads, "numbers of threads, the first of which the others are compared with")
        ->delimiter(',')
        ->check(CLI::Range(1, 256));
    app.add_option("--rounds", rounds)->check(CLI::Range(1, 1000));
    app.add_option("--side", side, "texels")->check(CLI::Range(16, 8192));
    CLI11_PARSE(app, argc, argv);
    try {
        run(threads, rounds, side);
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
    return 0;
}
