// Our Euclidean distance map beside vtkImageEuclideanDistance, in one process, the rounds interleaved, one thread each
// (VTK's works on one). Both are exact and find the distance of each voxel's centre to the nearest solid centre.
//   relief_distance_peers [--maps NAME,...] [--sizes WxL,...] [--rounds N] [--threads N]
// VTK is given the binary volume, made outside its timing; ours begins with the heights, as a tracer would, and takes
// roots besides. Exit status 1 if the two disagree.
#include <chrono>
#include <cmath>
#include <iostream>

#include <vtkImageData.h>
#include <vtkImageEuclideanDistance.h>
#include <vtkNew.h>
#include <vtkVersion.h>

#include "images/reliefs.h"
#include "measuring/machine.h"
#include "measuring/quantiles.h"
#include "measuring/text_table.h"
#include "relief/maps/distance_map.h"

namespace relief::peers {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kReliefDepth = 0.1;
// Texels: ours are roots of floats of squares of up to some thousand texels.
constexpr double kAgree = 1e-3;

struct Settings {
    std::vector<std::string> maps{"bricks", "fractal", "spikes"};
    std::vector<std::pair<int, int>> sizes{{256, 32}, {512, 64}};  // side, layers
    int rounds = 5;
    int threads = 1;
};

double secondsSince(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

// 0 where solid, 1 elsewhere, with a layer below the slab, where all is solid.
vtkNew<vtkImageData> volumeOf(const HeightField& field, int layers) {
    vtkNew<vtkImageData> volume;
    volume->SetDimensions(field.width(), field.height(), layers + 1);
    volume->SetSpacing(1, 1, field.slabTexels() / layers);
    volume->AllocateScalars(VTK_DOUBLE, 1);
    auto* out = static_cast<double*>(volume->GetScalarPointer());
    for (int k = -1; k < layers; ++k) {
        for (int y = 0; y < field.height(); ++y) {
            for (int x = 0; x < field.width(); ++x) {
                const bool solid = k <= std::floor(field.at(x + 0.5, y + 0.5) * layers - 0.5);
                *out++ = solid ? 0 : 1;
            }
        }
    }
    return volume;
}

double largestDifference(const DistanceMap& ours, vtkImageData* squares) {
    double worst = 0;
    for (int k = 0; k < ours.layers(); ++k) {
        for (int y = 0; y < ours.ny(); ++y) {
            for (int x = 0; x < ours.nx(); ++x) {
                const double square = *static_cast<double*>(squares->GetScalarPointer(x, y, k + 1));
                worst = std::max(worst, std::abs(std::sqrt(square) - static_cast<double>(ours.at(x, y, k, 0))));
            }
        }
    }
    return worst;
}

bool compare(const Settings& settings, std::ostream& out) {
    Work work(settings.threads);
    std::vector<TableRow> rows{
        {"map", "voxels", "ours, s", "+-%", "VTK, s", "+-%", "VTK / ours", "+-%", "differ, texels"}};
    bool agree = true;
    for (const std::string& name : settings.maps) {
        for (const auto& [side, layers] : settings.sizes) {
            const HeightField field(std::make_shared<FloatImage>(makeRelief(name, side, side, 1)), Surface::Bilinear,
                                    Address::Clamp, kReliefDepth);
            DistanceParameters parameters;
            parameters.layers = layers;
            const vtkNew<vtkImageData> volume = volumeOf(field, layers);
            std::vector<double> ours;
            std::vector<double> theirs;
            std::vector<double> ratios;
            double differ = 0;
            for (int round = -1; round < settings.rounds; ++round) {
                auto begun = Clock::now();
                const DistanceMap map = buildDistanceMap(DistanceKind::Euclidean, parameters, field, work);
                const double our = secondsSince(begun);
                vtkNew<vtkImageEuclideanDistance> filter;
                filter->SetInputData(volume);
                filter->SetAlgorithmToSaito();
                filter->ConsiderAnisotropyOn();
                filter->InitializeOn();
                begun = Clock::now();
                filter->Update();
                const double their = secondsSince(begun);
                if (round < 0) {
                    differ = largestDifference(map, filter->GetOutput());
                    continue;
                }
                ours.push_back(our);
                theirs.push_back(their);
                ratios.push_back(their / our);
            }
            agree = agree && differ <= kAgree;
            rows.push_back({name, std::to_string(side) + " x " + std::to_string(side) + " x " + std::to_string(layers),
                            readable(quantile(ours, 0.5), 3), readable(100 * relativeSpread(ours), 2),
                            readable(quantile(theirs, 0.5), 3), readable(100 * relativeSpread(theirs), 2),
                            readable(quantile(ratios, 0.5), 3), readable(100 * relativeSpread(ratios), 2),
                            readable(differ, 2)});
        }
    }
    out << textTable(rows, 2) << "\nMedians of " << settings.rounds << " rounds, +-: (p75 - p25) / median. "
        << settings.threads << " thread(s) of ours, one of VTK " << vtkVersion::GetVTKVersion() << "; " << cpuText()
        << ", " << compilerText() << ", " << commitText() << "\n";
    return agree;
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> all(1);
    for (const char c : text) {
        if (c == separator) {
            all.emplace_back();
        } else {
            all.back() += c;
        }
    }
    return all;
}

Settings parse(int argc, char** argv) {
    Settings settings;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string word = argv[i];
        const std::string value = argv[i + 1];
        if (word == "--maps") {
            settings.maps = split(value, ',');
        } else if (word == "--sizes") {
            settings.sizes.clear();
            for (const std::string& size : split(value, ',')) {
                const auto parts = split(size, 'x');
                settings.sizes.emplace_back(static_cast<int>(parseNumber(parts.front(), word)),
                                            static_cast<int>(parseNumber(parts.back(), word)));
            }
        } else if (word == "--rounds") {
            settings.rounds = static_cast<int>(parseNumber(value, word));
        } else if (word == "--threads") {
            settings.threads = static_cast<int>(parseNumber(value, word));
        } else {
            throw InputError(word, Message(MessageId::UnknownName,
                                           {{"what", "option"}, {"name", word}, {"known", "see distance_peers.cpp"}}));
        }
    }
    return settings;
}

}  // namespace
}  // namespace relief::peers

int main(int argc, char** argv) {
    try {
        return relief::peers::compare(relief::peers::parse(argc, argv), std::cout) ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
