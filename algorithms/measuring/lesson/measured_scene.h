// Measurements of a scenario for lessons: the picture, its errors, the ray of the chosen pixel, its footprint, the
// certificate of its map. Each is computed when it is first needed, and kept.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "images/pyramid.h"
#include "mapping/rows/coefficients.h"
#include "measuring/bench/bench_rows.h"
#include "measuring/bench/child_counts.h"
#include "measuring/compare/logged_ray.h"
#include "measuring/compare/picture_error.h"
#include "measuring/verify/certificate.h"
#include "relief/tracers/point_distances.h"
#include "rendering/error_layer.h"
#include "rendering/frame.h"
#include "rendering/skip_ledger.h"
#include "scenario/scenario.h"

namespace relief {

struct SceneFootprint {
    FootprintLog log;
    FootprintCounts counts;
    double major = 0, minor = 0;  // semi-axes, texels of the colour picture
};

// Maps and pictures that scenes share.
class SceneStore {
  public:
    Assets assets(const Pictures& pictures, Work& work);
    const std::shared_ptr<MapCache>& maps() const { return maps_; }

  private:
    // The pictures loaded last; each store keeps one set.
    static constexpr std::size_t kKept = 4;
    std::vector<std::pair<Pictures, AssetStore>> kept_;
    std::shared_ptr<MapCache> maps_ = std::make_shared<MapCache>();
};

// For one thread. All members throw InputError - also where the scenario has no such thing, such as a chosen pixel that
// does not show the relief - and Cancelled.
class MeasuredScene {
  public:
    MeasuredScene(Scenario scenario, SceneStore& store) : scenario_(std::move(scenario)), store_(store) {}

    const Scenario& scenario() const { return scenario_; }
    // Number of pixels of the frame; 0 before it is rendered.
    std::uint64_t pixels() const { return frame_ ? frame_->light->color.size() : 0; }
    const HeightField& field(Work& work) { return request(work).field; }
    const FrameRequest& request(Work& work);
    const Frame& frame(Work& work);    // with counted steps
    const Tracer& tracer(Work& work);  // that made the frame
    const ErrorLayer& errors(Work& work);
    // The ray that the window shows: of the chosen pixel, or of another tracer's files.
    const LoggedRay& ray(Work& work);
    const PixelCoefficients& coefficients(Work& work);
    const SceneFootprint& footprint(Work& work);
    const std::vector<SkipRow>& skipped(Work& work);
    const ChildCounts& children(Work& work);
    const Certificate& certificate(std::uint64_t rays, Work& work);
    const Pyramid& pyramid(PyramidKind kind, Work& work);
    PointDistances point(double s, double t, double z, Work& work);
    // truth: the supersampled picture of the same view.
    PictureError pictureError(const ColorImage& truth, Work& work);

  private:
    Scenario scenario_;
    SceneStore& store_;
    std::optional<FrameRequest> request_;
    std::shared_ptr<const Frame> frame_;
    std::shared_ptr<const Tracer> tracer_;
    std::optional<ErrorLayer> errors_;
    std::optional<LoggedRay> ray_;
    std::optional<PixelCoefficients> coefficients_;
    std::optional<SceneFootprint> footprint_;
    std::optional<std::vector<SkipRow>> skipped_;
    std::optional<ChildCounts> children_;
    std::map<std::uint64_t, Certificate> certificates_;
    std::map<PyramidKind, Pyramid> pyramids_;
};

// The latest scenes, by scenario, and measurements of rows, which need no scene. References to the last two scenes stay
// valid.
class SceneCache {
  public:
    MeasuredScene& scene(const Scenario& scenario);
    // The same view, supersampled with samples x samples exactly traced rays a pixel.
    const ColorImage& truth(const Scenario& scenario, int samples, PixelModel model, Work& work);
    const RowBenchRow& rows(const std::string& variant, std::int64_t width, double elevation, RowPrecision precision,
                            Work& work);

  private:
    // Largest number of scenes, and of the pixels of their frames, each of which takes about a hundred bytes. Two
    // scenes are kept whatever their size, because a value may need a picture and its truth.
    static constexpr std::size_t kKept = 12, kSurelyKept = 2;
    static constexpr std::uint64_t kKeptPixels = 1 << 22;
    SceneStore store_;
    std::vector<std::pair<std::string, std::unique_ptr<MeasuredScene>>> scenes_;  // the latest one last
    std::map<std::tuple<std::string, std::int64_t, double, RowPrecision>, RowBenchRow> rows_;
};

}  // namespace relief
