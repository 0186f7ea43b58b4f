// An example for app/recorder/relief_recorder.h: a small tracer on its own, which marches through 16 layers and answers
// with the first one below the surface. It shares nothing with the library.
//
//     relief_marcher make MAP.pgm                               writes a height map of waves
//     relief_marcher trace MAP.pgm RAYS.csv HITS.csv STEPS.csv  traces the rays and records them
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "relief_recorder.h"

namespace {

struct Map {
    int width = 0, height = 0;
    std::vector<double> heights;

    double texel(int i, int j) const {
        i = ((i % width) + width) % width;
        j = ((j % height) + height) % height;
        return heights[static_cast<std::size_t>(j * width + i)];
    }
    double at(double s, double t) const {
        const double x = std::floor(s - 0.5), y = std::floor(t - 0.5);
        const double u = s - 0.5 - x, v = t - 0.5 - y;
        const int i = static_cast<int>(x), j = static_cast<int>(y);
        return (texel(i, j) * (1 - u) + texel(i + 1, j) * u) * (1 - v) +
               (texel(i, j + 1) * (1 - u) + texel(i + 1, j + 1) * u) * v;
    }
};

void makeMap(const std::string& path) {
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) throw std::runtime_error(path + ": cannot be written");
    constexpr int kWidth = 96, kHeight = 64;
    std::fprintf(file, "P5\n%d %d\n65535\n", kWidth, kHeight);
    for (int j = 0; j < kHeight; ++j) {
        for (int i = 0; i < kWidth; ++i) {
            const double x = 2 * 3.14159265358979 * i / kWidth, y = 2 * 3.14159265358979 * j / kHeight;
            const double height =
                0.5 + 0.2 * std::sin(3 * x + std::cos(2 * y)) + 0.2 * std::sin(5 * y + 1 + std::sin(x));
            const auto code = static_cast<unsigned>(height * 65535);
            std::fputc(static_cast<int>(code >> 8U), file);
            std::fputc(static_cast<int>(code & 255U), file);
        }
    }
    std::fclose(file);
}

Map readMap(const std::string& path) {
    std::FILE* const file = std::fopen(path.c_str(), "rb");
    Map map;
    if (file == nullptr || std::fscanf(file, "P5 %d %d 65535", &map.width, &map.height) != 2) {
        throw std::runtime_error(path + ": cannot be read");
    }
    std::fgetc(file);
    for (int n = 0; n < map.width * map.height; ++n) {
        const int high = std::fgetc(file);
        map.heights.push_back((high * 256 + std::fgetc(file)) / 65535.0);
    }
    std::fclose(file);
    return map;
}

void trace(const Map& map, const std::string& rays, const std::string& hits, const std::string& steps) {
    constexpr int kLayers = 16;
    relief_recorder::Recorder recorder(hits, steps, map.width, map.height, {"gap"});
    for (const relief_recorder::Ray& ray : relief_recorder::readRays(rays)) {
        recorder.ray(ray);
        double lambda = 0;
        bool below = false;
        for (int n = 1; n <= kLayers && !below; ++n) {
            const double next = static_cast<double>(n) / kLayers;
            const double height = map.at(ray.s0 + next * ray.a, ray.t0 + next * ray.b);
            recorder.step(lambda, next, height, {height - (1 - next)});
            lambda = next;
            below = height >= 1 - next;
        }
        if (below) {
            recorder.hit(lambda);
        } else {
            recorder.limit();
        }
    }
    recorder.close();
}

}  // namespace

int main(int count, char** arguments) {
    try {
        if (count == 3 && std::strcmp(arguments[1], "make") == 0) {
            makeMap(arguments[2]);
            return 0;
        }
        if (count == 6 && std::strcmp(arguments[1], "trace") == 0) {
            trace(readMap(arguments[2]), arguments[3], arguments[4], arguments[5]);
            return 0;
        }
        std::fputs("usage: relief_marcher make MAP | trace MAP RAYS HITS STEPS\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
    }
    return 2;
}
