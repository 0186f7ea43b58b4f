// Makes snapshots: the frame, the layer, the pixel's trace and the pyramids of one scenario. Lives on the worker's
// thread; keeps what can be used again.
#pragma once

#include <memory>
#include <optional>

#include "rendering/progressive.h"
#include "workspace/snapshot.h"

namespace reliefui {

struct SnapshotOrder {
    relief::Scenario scenario;
    std::uint64_t version = 0;
    Layer layer = Layer::Color;
    bool moving = false;    // as coarse as a dragged frame's time asks for
    bool lastStep = false;  // the ray's last step is the chosen one, whatever the scenario says
    relief::PyramidKind levels = relief::PyramidKind::Max;  // what the pyramid's pane shows
};

class SnapshotMaker {
  public:
    explicit SnapshotMaker(relief::AssetStore store = {});

    // Loads the pictures; on an error nothing changes.
    relief::Assets load(const relief::Pictures& pictures, relief::Work& work) { return store_.load(pictures, work); }

    // Whether the full picture will take so long that a coarse one is worth drawing first. Throws as make() does.
    bool takesLong(const SnapshotOrder& order, relief::Work& work);

    // Throws InputError, Cancelled.
    std::shared_ptr<const Snapshot> make(const SnapshotOrder& order, relief::Work& work);
    // make() was stopped, its frame so long in the making. Whether a moving one is coarser the next time.
    bool gaveUp(double seconds);

  private:
    // What is shown, coarse and full: a settled picture is not computed again after a drag that came back to it.
    struct Shown {
        relief::ProgressiveRenderer::Picture drawn;
        std::optional<relief::Scenario> scenario;
        relief::Assets assets;
        QImage picture;
        LayerPicture layer;  // the one shown last
        std::optional<relief::BoundedError> bounded;
        double ellipseOff = 0;

        bool is(const relief::Scenario& other, const relief::Assets& of) const;
    };

    relief::FrameRequest request(const SnapshotOrder& order, const relief::Assets& assets);
    // Whether it was drawn, and not there already.
    bool draw(Shown& shown, const SnapshotOrder& order, const relief::FrameRequest& request,
              const relief::Assets& assets, relief::Work& work);
    // Its pyramids, of a small relief with what an edit leaves shared.
    void makePyramids(const relief::HeightField& field, relief::Work& work);
    void describe(Snapshot& snapshot, const SnapshotOrder& order, relief::Work& work);
    const OtherFiles* otherFiles(const relief::Scenario& scenario);

    relief::AssetStore store_;
    std::shared_ptr<relief::MapCache> maps_ = std::make_shared<relief::MapCache>();
    relief::ProgressiveRenderer renderer_;
    relief::MovingLevel level_;                // of the frame that was begun last
    std::shared_ptr<const OtherFiles> other_;  // that were read last
    Shown full_;
    Shown coarse_;
    FilteredPicture filtered_;
    struct Pyramids {
        std::shared_ptr<const relief::MaxPyramidMap> maxima;
        std::shared_ptr<const relief::Pyramid> minima, means;
    };
    Pyramids small_;  // of the small relief that was drawn last
};

}  // namespace reliefui
