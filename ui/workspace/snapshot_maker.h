// Computes snapshots: the frame, the layer, the pixel's trace and the pyramids of a scenario. Lives on the worker's
// thread and reuses what has not changed.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "rendering/progressive.h"
#include "workspace/snapshot.h"

namespace reliefui {

struct SnapshotOrder {
    relief::Scenario scenario;
    std::uint64_t version = 0;
    Layer layer = Layer::Color;
    bool moving = false;                                    // draw as coarsely as the time budget of a drag requires
    bool lastStep = false;                                  // choose the ray's last step instead of the scenario's
    relief::PyramidKind levels = relief::PyramidKind::Max;  // shown in the pyramid pane
    std::uint64_t renewed = 0;                              // how often the other tracer's files were to be read again
};

class SnapshotMaker {
  public:
    explicit SnapshotMaker(relief::AssetStore store = {});

    // Loads the pictures; a height map that has a bound on memory is opened by tiles. Throws on an error and then
    // changes nothing.
    relief::Assets load(const relief::Pictures& pictures, relief::Work& work) {
        return store_.load(pictures, work, true);
    }

    // Returns true if the full picture is expected to take so long that a coarse one should be drawn first. Throws as
    // make() does.
    bool takesLong(const SnapshotOrder& order, relief::Work& work);

    // Computes the snapshot. Throws InputError, Cancelled.
    std::shared_ptr<const Snapshot> make(const SnapshotOrder& order, relief::Work& work);
    // Reports that make() was cancelled after its frame had been drawn for this time. Returns true if the next frame of
    // a drag will be coarser.
    bool gaveUp(double seconds);

  private:
    // The last picture of either kind (coarse, full), so that the full one need not be drawn again after a drag that
    // returned to it.
    struct Shown {
        relief::ProgressiveRenderer::Picture drawn;
        std::optional<relief::Scenario> scenario;
        relief::Assets assets;
        std::map<Layer, LayerPicture> layers;  // those made of this frame, the colours among them
        std::optional<relief::BoundedError> bounded;
        std::optional<double> ellipseOff;

        bool is(const relief::Scenario& other, const relief::Assets& of) const;
        // Drops what depends on stages that the frame drawn does not share with the one before, which is null if there
        // was none. normals: whether both have the same normal map.
        void dropStale(const relief::Frame* before, bool normals);
    };

    relief::FrameRequest request(const SnapshotOrder& order, const relief::Assets& assets);
    // Draws the picture unless `shown` already holds it; returns whether it was drawn.
    bool draw(Shown& shown, const SnapshotOrder& order, const relief::FrameRequest& request,
              const relief::Assets& assets, relief::Work& work);
    // Returns a layer of the frame shown, which is made when first needed.
    LayerPicture& layerOf(Shown& shown, Layer layer, relief::Work& work);
    // Builds the pyramids of a small relief; after an edit, unchanged levels are shared with the previous ones.
    void makePyramids(const relief::HeightField& field, relief::Work& work);
    void describe(Snapshot& snapshot, const SnapshotOrder& order, relief::Work& work);
    // Sets the files of the other tracer, which are read when the scenario names others, and again when the order's
    // `renewed` differs. Throws InputError only for other files: of the same ones, those read last are kept.
    void readFiles(const SnapshotOrder& order, const relief::HeightField& field);

    relief::AssetStore store_;
    std::shared_ptr<relief::MapCache> maps_ = std::make_shared<relief::MapCache>();
    relief::ProgressiveRenderer renderer_;
    relief::MovingLevel level_;                               // level of the last frame that was begun
    std::shared_ptr<const OtherFiles> other_;                 // the open files
    std::shared_ptr<const relief::InputError> otherProblem_;  // why they could not be read again
    std::uint64_t renewed_ = 0;                               // of the order for which they were read last
    Shown full_;
    Shown coarse_;
    FilteredPicture filtered_;
    struct Pyramids {
        std::shared_ptr<const relief::MaxPyramidMap> maxima;
        std::shared_ptr<const relief::Pyramid> minima, means;
    };
    Pyramids small_;  // pyramids of the last small relief
};

}  // namespace reliefui
