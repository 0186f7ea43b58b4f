// Compares our elliptical filter with OpenImageIO's TextureSystem (anisotropic 16), in one process with interleaved
// rounds and one thread: rate, and error against a Gaussian pixel (sigma 0.5) that is integrated over the exact
// perspective of the plane.
//  relief_filter_peers [--size N] [--width N] [--height N] [--rounds N] [--pictures zone,bricks,checker]
//                      [--elevations 60,25,8] [--azimuth A] [--seed N] [-o FILE.csv|json]
// OpenImageIO receives the same derivatives, with each of the multipliers below, and a tiled float texture with its own
// pyramid, all in its cache; it is measured with single lookups and with batches of 16 (blur and width set in each
// lane). Its rate is the best of those in the same round, its error the smallest of all. In the file, error is the RMSE
// in linear light.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include "filtering/filters/filters.h"
#include "mapping/rows/row_lanes.h"
#include "measuring/bench/bench_filters.h"
#include "measuring/bench/machine.h"
#include "measuring/quantiles.h"
#include "peer_table.h"
#include "relief/errors.h"
#include "rendering/frame.h"

namespace relief {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSigma = 0.5;  // pixels
constexpr int kSamples = 33;    // along each side of 3 sigma
constexpr int kCounted = 4000;  // pixels whose error is measured, uniformly distributed
constexpr std::size_t kTile = 1024;
const std::vector<float> kWidths{0.6F, 0.8F, 1.0F, 1.2F, 1.4F, 1.7F, 2.0F};

struct Settings {
    int size = 1024, width = 640, height = 480, rounds = 7;
    double azimuth = 25;
    std::uint64_t seed = 11;
    std::vector<std::string> pictures{"zone", "bricks", "checker"};
    std::vector<double> elevations{60, 25, 8};
    std::string output;
};

std::shared_ptr<const ColorImage> pictureOf(const std::string& name, const Settings& settings) {
    if (name != "zone") return filterScene(name, settings.size, settings.seed).color;
    // Rings that become finer towards the rim, up to one cycle in four texels.
    auto picture = std::make_shared<ColorImage>(settings.size, settings.size);
    const double middle = 0.5 * settings.size;
    for (int y = 0; y < settings.size; ++y) {
        for (int x = 0; x < settings.size; ++x) {
            const double r2 = (x - middle) * (x - middle) + (y - middle) * (y - middle);
            const double phase = std::numbers::pi * r2 / (4 * middle);
            (*picture)(x, y) = Color(static_cast<float>(0.5 + 0.45 * std::cos(phase)));
        }
    }
    return picture;
}

struct View {
    FilterBlock all;
    std::vector<FilterBlock> blocks;
    std::vector<std::size_t> counted;
    std::vector<Color> truth;
};

// A plane at the top of the slab, so that positions are exact perspective.
View viewOf(const std::shared_ptr<const ColorImage>& picture, const Settings& settings, double elevation, Work& work) {
    FrameRequest request(HeightField(std::make_shared<const FloatImage>(picture->width(), picture->height(), 1.0F)));
    request.width = settings.width;
    request.height = settings.height;
    request.camera.elevation = elevation;
    request.camera.azimuth = settings.azimuth;
    request.camera.distance = 1.4;
    FrameRenderer renderer(std::make_shared<MapCache>());
    const auto frame = renderer.render(request, work);
    const VisiblePolygons visible = frame->visible(request);
    const ColorLevels levels(picture, work);
    View view;
    std::vector<glm::ivec2> pixels;
    for (int y = 0; y < request.height; ++y) {
        for (int x = 0; x < request.width; ++x) {
            const auto query = filterQuery(*frame, request, visible, x, y);
            if (!query) continue;
            if (view.all.size() % kTile == 0) view.blocks.emplace_back();
            view.all.push(*query);
            view.blocks.back().push(*query);
            pixels.emplace_back(x, y);
        }
    }
    const Homography& map = visible.polygons.front().texelFromScreen;
    const std::size_t step = std::max<std::size_t>(1, pixels.size() / kCounted);
    for (std::size_t i = 0; i < pixels.size(); i += step) {
        glm::dvec3 sum(0);
        double total = 0;
        for (int y = 0; y < kSamples; ++y) {
            for (int x = 0; x < kSamples; ++x) {
                const double dx = ((x + 0.5) / kSamples * 2 - 1) * 3 * kSigma;
                const double dy = ((y + 0.5) / kSamples * 2 - 1) * 3 * kSigma;
                const TexelPoint at = map.at(pixels[i].x + 0.5 + dx, pixels[i].y + 0.5 + dy);
                if (!(at.q > 0)) continue;
                const double w = std::exp(-(dx * dx + dy * dy) / (2 * kSigma * kSigma));
                sum += w * glm::dvec3(levels.bilinear(0, {at.s, at.t}, Address::Repeat));
                total += w;
            }
        }
        view.counted.push_back(i);
        view.truth.emplace_back(sum / total);
    }
    return view;
}

double errorOf(const View& view, const std::vector<Color>& colors) {
    double sum = 0;
    for (std::size_t n = 0; n < view.counted.size(); ++n) {
        const glm::dvec3 d = glm::dvec3(colors[view.counted[n]]) - glm::dvec3(view.truth[n]);
        sum += d.x * d.x + d.y * d.y + d.z * d.z;
    }
    return std::sqrt(sum / (3 * static_cast<double>(view.counted.size())));
}

// The texture, in a file that is removed with the object.
class Peer {
  public:
    explicit Peer(const ColorImage& picture) : width_(picture.width()), height_(picture.height()) {
        file_ =
            (std::filesystem::temp_directory_path() / ("relief_peer_" + std::to_string(getpid()) + ".tif")).string();
        OIIO::ImageBuf image(OIIO::ImageSpec(width_, height_, 3, OIIO::TypeDesc::FLOAT));
        image.set_pixels(image.roi(), OIIO::TypeDesc::FLOAT, picture.data());
        OIIO::ImageSpec config;
        config.attribute("wrapmodes", "periodic,periodic");
        std::ostringstream said;
        if (!OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, image, file_, config, &said)) {
            throw std::runtime_error(file_ + ": " + said.str());
        }
        system_ = OIIO::TextureSystem::create(false);
        system_->attribute("max_memory_MB", 4096.0F);
        system_->attribute("gray_to_rgb", 1);
        handle_ = system_->get_texture_handle(OIIO::ustring(file_));
        thread_ = system_->get_perthread_info();
    }
    ~Peer() {
        OIIO::TextureSystem::destroy(system_, true);
        std::filesystem::remove(file_);
    }
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;

    void single(const FilterBlock& block, float width, std::vector<Color>& colors) const {
        OIIO::TextureOpt options;
        options.swrap = options.twrap = OIIO::TextureOpt::WrapPeriodic;
        options.mipmode = OIIO::TextureOpt::MipModeAniso;
        options.interpmode = OIIO::TextureOpt::InterpBilinear;
        options.anisotropic = 16;
        options.swidth = options.twidth = width;
        for (std::size_t i = 0; i < block.size(); ++i) {
            system_->texture(handle_, thread_, options, s(block.s[i]), t(block.t[i]), s(block.ux[i]), t(block.vx[i]),
                             s(block.uy[i]), t(block.vy[i]), 3, &colors[i].x);
        }
    }

    void batched(const FilterBlock& block, float width, std::vector<Color>& colors) const {
        constexpr auto kBatch = static_cast<std::size_t>(OIIO::Tex::BatchWidth);
        OIIO::TextureOptBatch options;
        options.swrap = options.twrap = OIIO::Tex::Wrap::Periodic;
        options.mipmode = OIIO::Tex::MipMode::Aniso;
        options.interpmode = OIIO::Tex::InterpMode::Bilinear;
        options.anisotropic = 16;
        for (std::size_t k = 0; k < kBatch; ++k) {
            options.sblur[k] = options.tblur[k] = 0;
            options.swidth[k] = options.twidth[k] = width;
        }
        for (std::size_t first = 0; first < block.size(); first += kBatch) {
            const std::size_t count = std::min(kBatch, block.size() - first);
            alignas(64) float in[6][kBatch] = {};
            alignas(64) float out[3][kBatch];
            for (std::size_t k = 0; k < count; ++k) {
                const std::size_t i = first + k;
                in[0][k] = s(block.s[i]), in[1][k] = t(block.t[i]);
                in[2][k] = s(block.ux[i]), in[3][k] = t(block.vx[i]);
                in[4][k] = s(block.uy[i]), in[5][k] = t(block.vy[i]);
            }
            const OIIO::Tex::RunMask mask = count == kBatch ? OIIO::Tex::RunMaskOn : (1ULL << count) - 1;
            system_->texture(handle_, thread_, options, mask, in[0], in[1], in[2], in[3], in[4], in[5], 3, out[0]);
            for (std::size_t k = 0; k < count; ++k) colors[first + k] = {out[0][k], out[1][k], out[2][k]};
        }
    }

  private:
    float s(double texels) const { return static_cast<float>(texels / width_); }
    float t(double texels) const { return static_cast<float>(texels / height_); }

    int width_, height_;
    std::string file_;
    OIIO::TextureSystem* system_ = nullptr;
    OIIO::TextureSystem::TextureHandle* handle_ = nullptr;
    OIIO::TextureSystem::Perthread* thread_ = nullptr;
};

struct Runner {
    std::string name;
    bool ours = false;
    std::function<void(std::vector<Color>&)> run;
    double error = 0;
    std::vector<double> rates;
};

std::vector<Runner> runnersOf(const View& view, const Peer& peer, const TextureFilter& lanes,
                              const TextureFilter& scalar, Work& work) {
    std::vector<Runner> runners;
    const auto ours = [&view, &work](const TextureFilter& filter, std::int64_t target) {
        return [&, target](std::vector<Color>& colors) {
            forceLaneTarget(target);
            FootprintCounts counts;
            std::size_t at = 0;
            for (const FilterBlock& block : view.blocks) {
                filter.colors(block, {colors.data() + at, block.size()}, counts, work);
                at += block.size();
            }
            forceLaneTarget(0);
        };
    };
    for (const std::int64_t target : laneTargets()) {
        runners.push_back({std::string("lanes ") + laneTargetName(target), true, ours(lanes, target), 0, {}});
    }
    runners.push_back({"scalar", true, ours(scalar, 0), 0, {}});
    for (const float width : kWidths) {
        char text[32];
        std::snprintf(text, sizeof text, "OIIO/width %.1f", static_cast<double>(width));
        runners.push_back({text, false, [&, width](auto& colors) { peer.single(view.all, width, colors); }, 0, {}});
    }
    runners.push_back({"OIIO/batched 1.0", false, [&](auto& colors) { peer.batched(view.all, 1, colors); }, 0, {}});
    return runners;
}

std::vector<peers::PeerRow> measure(const std::string& name, double elevation, const Settings& settings, Work& work) {
    const auto picture = pictureOf(name, settings);
    const View view = viewOf(picture, settings, elevation, work);
    const HeightField field(std::make_shared<const FloatImage>(picture->width(), picture->height(), 1.0F));
    MapCache maps;
    const Peer peer(*picture);
    const auto lanes = makeFilter({"elliptical", {}}, {picture, nullptr, field}, maps, work);
    const auto scalar =
        makeFilter({"elliptical", {{"implementation", "scalar"}}}, {picture, nullptr, field}, maps, work);
    std::vector<Runner> runners = runnersOf(view, peer, *lanes, *scalar, work);
    std::vector<Color> colors(view.all.size());
    for (Runner& runner : runners) {
        runner.run(colors);
        runner.error = errorOf(view, colors);
    }
    for (int round = 0; round < settings.rounds; ++round) {
        for (Runner& runner : runners) {
            const auto begun = Clock::now();
            runner.run(colors);
            const double seconds = std::chrono::duration<double>(Clock::now() - begun).count();
            runner.rates.push_back(static_cast<double>(view.all.size()) / seconds);
        }
    }
    std::vector<const std::vector<double>*> peers;
    double least = 1e9;
    for (const Runner& runner : runners) {
        if (runner.ours) continue;
        peers.push_back(&runner.rates);
        least = std::min(least, runner.error);
    }
    const std::vector<double> fastest = peers::fastestOf(peers);
    std::printf("%s, %g degrees, %zu pixels: OpenImageIO's best rate %.2f Mpixels/s, least error %.2f\n", name.c_str(),
                elevation, view.all.size(), quantile(fastest, 0.5) * 1e-6, least * 1e3);
    std::printf("  %-18s %12s %6s %10s %6s %12s %12s\n", "", "Mpixels/s", "+-%", "ratio", "+-%", "error x1000",
                "of the least");
    std::vector<peers::PeerRow> rows;
    for (const Runner& runner : runners) {
        peers::PeerRow row{name, std::to_string(settings.size), numberText(elevation), runner.name};
        peers::setRates(row, runner.rates);
        peers::setRatios(row, runner.rates, fastest);
        row.error = runner.error;
        rows.push_back(row);
        std::printf("  %-18s %12.2f %6.1f %10.2f %6.1f %12.3f %12.2f\n", row.method.c_str(), row.rate * 1e-6,
                    100 * row.spread, row.ratio, 100 * row.ratioSpread, row.error * 1e3, row.error / least);
    }
    std::fflush(stdout);
    return rows;
}

int run(const Settings& settings) {
    Work work(1);
    std::vector<peers::PeerRow> rows;
    std::cout << "size " << settings.size << ", seed " << settings.seed << ", " << settings.rounds << " rounds\n";
    for (const std::string& picture : settings.pictures) {
        for (const double elevation : settings.elevations) {
            const auto measured = measure(picture, elevation, settings, work);
            rows.insert(rows.end(), measured.begin(), measured.end());
        }
    }
    if (!settings.output.empty()) peers::writePeerRows(settings.output, rows);
    return 0;
}

}  // namespace
}  // namespace relief

int main(int argc, char** argv) {
    relief::Settings settings;
    CLI::App app("Our elliptical filter beside OpenImageIO's, rounds interleaved, one thread");
    app.add_option("--size", settings.size, "texels of the picture")->check(CLI::Range(16, 16384));
    app.add_option("--width", settings.width, "pixels")->check(CLI::Range(1, 16384));
    app.add_option("--height", settings.height, "pixels")->check(CLI::Range(1, 16384));
    app.add_option("--rounds", settings.rounds)->check(CLI::PositiveNumber);
    app.add_option("--pictures", settings.pictures, "of zone, bricks, checker")->delimiter(',');
    app.add_option("--elevations", settings.elevations, "degrees")->delimiter(',')->check(CLI::Range(1.0, 90.0));
    app.add_option("--azimuth", settings.azimuth, "degrees");
    app.add_option("--seed", settings.seed);
    app.add_option("-o", settings.output, "table to write, csv or json");
    CLI11_PARSE(app, argc, argv);
    try {
        return relief::run(settings);
    } catch (const std::exception& error) {
        std::cerr << "relief_filter_peers: " << error.what() << '\n';
        return 2;
    }
}
