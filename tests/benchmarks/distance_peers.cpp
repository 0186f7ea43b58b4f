// Compares our Euclidean distance map with vtkImageEuclideanDistance and, if it is installed, ITK's Maurer transform,
// in one process with interleaved rounds. All are exact and compute the distance of each voxel's centre to the nearest
// solid one.
//  relief_distance_peers [--maps NAME,...] [--sizes WxL,...] [--rounds N] [--threads N] [-o FILE.csv|json]
// The other programs receive the binary volume, which is made outside their timing; ours starts from the heights, as a
// tracer would. VTK uses one thread, whatever number is requested. Rates are in maps per second; error is the largest
// difference from our result, in texels. Exit status 1 if a result differs.
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <optional>

#include <vtkImageData.h>
#include <vtkImageEuclideanDistance.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkVersion.h>

#include "measuring/bench/machine.h"
#include "measuring/quantiles.h"
#include "measuring/text_table.h"
#include "peer_table.h"
#include "relief/maps/distance_map.h"
#include "relief/reliefs.h"

#ifdef RELIEF_ITK
#include "itk_peer.h"
#endif

namespace relief::peers {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kReliefDepth = 0.1;
// Texels: our distances are square roots, in float, of squares of up to some thousand texels.
constexpr double kAgree = 1e-3;

struct Settings {
    std::vector<std::string> maps{"bricks", "fractal", "spikes"};
    std::vector<std::pair<int, int>> sizes{{256, 32}, {512, 64}};  // side, layers
    int rounds = 5;
    int threads = 1;
    std::string output;
};

double secondsSince(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

// Returns a volume with 0 where solid and 1 elsewhere, and an additional solid layer below the slab.
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

// at(x, y, k): the other program's distance.
template <class At>
double largestDifference(const DistanceMap& ours, const At& at) {
    double worst = 0;
    for (int k = 0; k < ours.layers(); ++k) {
        for (int y = 0; y < ours.ny(); ++y) {
            for (int x = 0; x < ours.nx(); ++x) {
                worst = std::max(worst, std::abs(at(x, y, k) - static_cast<double>(ours.at(x, y, k, 0))));
            }
        }
    }
    return worst;
}

double timed(const std::function<void()>& body) {
    const auto begun = Clock::now();
    body();
    return secondsSince(begun);
}

struct Contender {
    std::string method;
    int threads = 1;
    std::function<void()> build;
    std::function<double(const DistanceMap&)> differs;  // largest difference from ours, after the build
    std::vector<double> rates;
    double difference = 0;
};

// The contenders of one cell of the table, ours first.
class Cell {
  public:
    Cell(const std::string& name, int side, int layers, int threads)
        : work_(threads),
          field_(std::make_shared<FloatImage>(makeRelief(name, side, side, 1)), Surface::Bilinear, Address::Clamp,
                 kReliefDepth),
          volume_(volumeOf(field_, layers)) {
        parameters_.layers = layers;
        parameters_.to = DistanceTo::Voxel;  // as the other programs measure it
        contenders.push_back({"euclidean",
                              threads,
                              [this] { ours_ = buildDistanceMap(DistanceKind::Euclidean, parameters_, field_, work_); },
                              [](const DistanceMap&) { return 0.0; },
                              {},
                              0});
        contenders.push_back({"VTK/Saito",
                              1,
                              [this] { buildVtk(); },
                              [this](const DistanceMap& map) {
                                  return largestDifference(map, [this](int x, int y, int k) {
                                      return std::sqrt(
                                          *static_cast<double*>(vtk_->GetOutput()->GetScalarPointer(x, y, k + 1)));
                                  });
                              },
                              {},
                              0});
#ifdef RELIEF_ITK
        const auto* binary = static_cast<const double*>(volume_->GetScalarPointer());
        const auto voxels = static_cast<std::size_t>(volume_->GetNumberOfPoints());
        std::vector<unsigned char> solid(voxels);
        for (std::size_t i = 0; i < voxels; ++i) solid[i] = binary[i] == 0 ? 1 : 0;
        itk_ = std::make_unique<ItkDistance>(solid.data(), side, side, layers, field_.slabTexels() / layers, threads);
        contenders.push_back({"ITK/Maurer",
                              threads,
                              [this] { itk_->build(); },
                              [this](const DistanceMap& map) {
                                  return largestDifference(map,
                                                           [this](int x, int y, int k) { return itk_->at(x, y, k); });
                              },
                              {},
                              0});
#endif
    }

    void run(int rounds) {
        for (int round = -1; round < rounds; ++round) {
            for (Contender& contender : contenders) {
                const double seconds = timed(contender.build);
                if (round < 0) {
                    contender.difference = contender.differs(*ours_);
                } else {
                    contender.rates.push_back(1 / seconds);
                }
            }
        }
    }

    std::vector<Contender> contenders;

  private:
    void buildVtk() {
        vtk_ = vtkSmartPointer<vtkImageEuclideanDistance>::New();
        vtk_->SetInputData(volume_);
        vtk_->SetAlgorithmToSaito();
        vtk_->ConsiderAnisotropyOn();
        vtk_->InitializeOn();
        vtk_->Update();
    }

    Work work_;
    HeightField field_;
    DistanceParameters parameters_;
    std::optional<DistanceMap> ours_;
    vtkNew<vtkImageData> volume_;
    vtkSmartPointer<vtkImageEuclideanDistance> vtk_;
#ifdef RELIEF_ITK
    std::unique_ptr<ItkDistance> itk_;
#endif
};

bool compare(const Settings& settings, std::ostream& out) {
    std::vector<TableRow> shown{
        {"map", "voxels", "method", "threads", "s", "+-%", "of the fastest peer", "+-%", "differs, texels"}};
    std::vector<PeerRow> rows;
    bool agree = true;
    for (const std::string& name : settings.maps) {
        for (const auto& [side, layers] : settings.sizes) {
            Cell cell(name, side, layers, settings.threads);
            cell.run(settings.rounds);
            std::vector<const std::vector<double>*> peers;
            for (std::size_t i = 1; i < cell.contenders.size(); ++i) peers.push_back(&cell.contenders[i].rates);
            const std::vector<double> fastest = fastestOf(peers);
            for (const Contender& contender : cell.contenders) {
                PeerRow row{name, std::to_string(side) + "x" + std::to_string(layers), "", contender.method,
                            contender.threads};
                setRates(row, contender.rates);
                setRatios(row, contender.rates, fastest);
                row.error = contender.difference;
                agree = agree && row.error <= kAgree;
                rows.push_back(row);
                shown.push_back({row.what, row.size, row.method, std::to_string(row.threads), readable(1 / row.rate, 3),
                                 readable(100 * row.spread, 2), readable(row.ratio, 3),
                                 readable(100 * row.ratioSpread, 2), readable(row.error, 2)});
            }
        }
    }
    out << textTable(shown, 3) << "\nMedians of " << settings.rounds << " rounds, +-: (p75 - p25) / median. VTK "
        << vtkVersion::GetVTKVersion();
#ifdef RELIEF_ITK
    out << ", ITK " << ItkDistance::version();
#endif
    out << "; " << cpuText() << ", " << compilerText() << ", " << commitText() << "\n";
    if (!settings.output.empty()) writePeerRows(settings.output, rows);
    return agree;
}

Settings parse(int argc, char** argv) {
    Settings settings;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string word = argv[i];
        const std::string value = argv[i + 1];
        if (word == "--maps") {
            settings.maps = partsOf(value);
        } else if (word == "--sizes") {
            settings.sizes.clear();
            for (const std::string& size : partsOf(value)) {
                const auto parts = partsOf(size, 'x');
                settings.sizes.emplace_back(static_cast<int>(parseNumber(parts.front(), word)),
                                            static_cast<int>(parseNumber(parts.back(), word)));
            }
        } else if (word == "--rounds") {
            settings.rounds = static_cast<int>(parseNumber(value, word));
        } else if (word == "--threads") {
            settings.threads = static_cast<int>(parseNumber(value, word));
        } else if (word == "-o") {
            settings.output = value;
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
