// One picture of `relief render`, made whole or in bands of its rows; its inputs are loaded once.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "json_line.h"
#include "options_common.h"
#include "rendering/ellipse_error.h"
#include "rendering/skip_ledger.h"
#include "session.h"

namespace relief::app {

class OnePicture {
  public:
    // Wall-clock time of the command's stages.
    struct Seconds {
        double load = 0;
        double render = 0;
        double count = 0;  // counting steps and reads, for reports and the layer of steps
        double write = 0;  // includes making the layers
    };

    // Loads the scenario's pictures and the stored map. layers: of an OpenEXR file; empty: only the picture. reports:
    // report() will be called.
    OnePicture(const ScenarioOptions& options, Scenario scenario, std::vector<std::string> layers, bool reports,
               Session& session);

    int width() const { return request_->width; }
    int height() const { return request_->height; }
    // Names of the numbers of a pixel, in their order.
    std::vector<std::string> channels() const;
    // Throws MemoryError unless these rows can be made and written; empty: the whole picture. tiled: in tiles.
    void requireMemory(RowRange rows, bool tiled) const;
    // Returns the identity of the run: everything that the picture depends on. Input pictures are identified by
    // content, not by name, which may differ between machines.
    Json run() const;

    // Makes these rows and writes them as a picture; empty: the whole picture. text: see writeColor().
    void write(const std::string& output, RowRange rows, const std::string& text, Work& work);
    // Makes these rows and returns their numbers, the channels of a pixel interleaved. floats: colours as linear
    // floats, not as 8-bit sRGB.
    std::vector<std::byte> numbers(RowRange rows, bool floats, Work& work);

    // Prints what was read of a map that is read by tiles.
    void noteTilesRead();
    // Writes the report. To be called after write() of the whole picture.
    void report(const std::string& path);

  private:
    std::vector<NamedPlane> make(RowRange rows, Work& work);

    std::vector<std::string> layers_;
    bool reports_;
    Session& session_;
    Scenario scenario_;
    std::string map_;  // a hash of the stored map
    Seconds seconds_;
    AssetStore store_;
    Assets assets_;
    std::shared_ptr<MapCache> maps_ = std::make_shared<MapCache>();
    FrameRenderer renderer_{maps_};
    std::optional<FrameRequest> request_;
    BoundedSums bounded_;
    double ellipseError_ = 0;
    std::shared_ptr<const Frame> frame_;
};

}  // namespace relief::app
