// Makes snapshots: the frame, the layer, the pixel's trace and the pyramids of one scenario. Lives on the worker's
// thread; keeps what can be used again.
#pragma once

#include <memory>
#include <optional>

#include "workspace/snapshot.h"

namespace reliefui {

struct SnapshotOrder {
    relief::Scenario scenario;
    std::uint64_t version = 0;
    Layer layer = Layer::Color;
    int factor = 1;         // the picture is made so many times smaller
    bool lastStep = false;  // the ray's last step is the chosen one, whatever the scenario says
    relief::PyramidKind levels = relief::PyramidKind::Max;  // what the pyramid's pane shows
};

class SnapshotMaker {
  public:
    explicit SnapshotMaker(relief::AssetStore store = {}) : store_(std::move(store)) {}

    // Loads the pictures; on an error nothing changes.
    relief::Assets load(const relief::Pictures& pictures, relief::Work& work) { return store_.load(pictures, work); }

    // By how much the picture has to be made smaller to be drawn within a dragged frame's time; 1: not at all.
    int coarseFactor(const relief::Scenario& scenario) const;

    // Throws InputError, Cancelled.
    std::shared_ptr<const Snapshot> make(const SnapshotOrder& order, relief::Work& work);

  private:
    // Coarse and full frames each keep their own buffers: a settled picture is not computed again after a drag that
    // came back to it.
    struct Size {
        std::unique_ptr<relief::FrameRenderer> renderer;
        std::optional<relief::Scenario> scenario;
        relief::Assets assets;
        std::shared_ptr<const relief::Frame> frame;
        QImage picture;
        LayerPicture layer;  // the one shown last
        std::optional<relief::BoundedError> bounded;
    };

    void render(Size& size, const relief::Scenario& scenario, const relief::FrameRequest& request,
                const relief::Assets& assets, relief::Work& work);
    void learn(const relief::Frame& frame, bool coarse, bool lightOnly);
    const OtherFiles* otherFiles(const relief::Scenario& scenario);

    relief::AssetStore store_;
    std::shared_ptr<relief::MapCache> maps_ = std::make_shared<relief::MapCache>();
    std::shared_ptr<const OtherFiles> other_;  // that were read last
    Size full_;
    Size coarse_;
    FilteredPicture filtered_;
    double secondsPerPixel_ = 0;   // of a frame whose rays were traced; 0: not known yet
    int coarser_ = 0;              // than the estimate says, as coarse frames have shown
    double lightPerPixel_ = 2e-8;  // of a frame of which only the light changed
};

}  // namespace reliefui
