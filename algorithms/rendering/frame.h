// Frames: the request that says what to draw, the buffers of a drawn frame, and the renderer, which recomputes only
// what changed.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "filtering/filters/filters.h"
#include "mapping/rows/rows.h"
#include "relief/camera.h"
#include "relief/files.h"
#include "relief/maps/baked_normals.h"
#include "relief/tracers.h"
#include "rendering/lighting.h"
#include "rendering/scene.h"
#include "rendering/stages.h"
#include "rendering/visible_polygons.h"

namespace relief {

class PackedConeHits;
class FlatGround;
class HorizonBounds;
struct FrameBuffers;
struct FrameSetup;
struct HeightBoundsMap;

// Largest side of a picture, pixels; and of a procedural relief that is made in memory, texels.
inline constexpr int kMaxPictureSide = 1 << 16;
inline constexpr int kMaxReliefSide = 1 << 15;
inline constexpr double kMaxBounded = 4;

// All inputs of a frame, by value; pictures are shared and immutable.
struct FrameRequest {
    int width = 800;
    int height = 600;
    HeightField field;
    MethodChoice method;
    std::shared_ptr<const ColorImage> color;          // null: the heights are drawn in grey
    std::shared_ptr<const Image<glm::vec3>> normals;  // null: the height field's own normals
    FilterChoice filter;
    SceneKind scene = SceneKind::Floor;
    Camera camera;
    Light light;
    bool shadows = false;
    // Whether steps and reads of every ray are counted; the rays are then traced a second time, with the same hits.
    bool counts = false;
    // How texture coordinates are computed along the rows (visiblePolygons()).
    RowOptions mapping = kDirectRows;
    // Whether work that cannot change a bit is skipped. False: all of it is done, to verify that the bits are equal.
    bool skip = true;
    // Largest hit error, in texels, allowed to save work; footprints no longer than this are filtered with the plain
    // filter. [0, kMaxBounded]; 0 disables all approximations.
    double bounded = 0;
    Color sky{0.55F, 0.65F, 0.8F};  // linear
    // For parts of a larger picture: sample: position of the view ray within its pixel's square, [0, 1]^2. margin: by
    // how many pixels the frame extends beyond the camera's picture on every side (included in width and height).
    glm::dvec2 sample{0.5, 0.5};
    int margin = 0;

    explicit FrameRequest(HeightField heightField) : field(std::move(heightField)) {}
};

// Returns the request's camera in the pixels of its frame, shifted so that rays through pixel centres pass through the
// request's sample position. Throws InputError("--camera", ...).
PinholeCamera requestCamera(const FrameRequest& request);

// Polygon number of pixels that no polygon covers.
inline constexpr std::uint8_t kNoPolygon = 255;

struct RayStage {
    RayBlock rays;                      // one per pixel, rows top-down
    std::vector<std::uint8_t> polygon;  // kNoPolygon: sky
    std::vector<float> inverseDepth;    // 1 / camera depth of the entry, 1 / world units
};
// How a hit was found. Traced: by the method. FlatGround: in the one cell that the ray can meet, with the same bits.
// LittleParallax: at the mean of the lowest and the highest height within reach.
enum class HitBy : std::uint8_t { Traced, FlatGround, LittleParallax };
struct HitStage {
    std::vector<HitBy> by;  // one per pixel
    HitBlock hits;          // steps and reads are empty until they are counted
    bool counted() const { return hits.steps.size() == hits.size(); }
};
struct ColorStage {
    ColorImage color;  // linear, unlit
};
struct ShadowStage {
    std::vector<std::uint8_t> shadowed;  // one per pixel, 1: in shadow; empty: shadows are off
};
struct LightStage {
    ColorImage color;  // linear, lit: the picture
};

// What one stage contributed to a frame.
struct StageReport {
    bool reused = false;  // its inputs had not changed
    double seconds = 0;   // summed over all threads, where computed
};

// Rows [begin, end) of a picture.
struct RowRange {
    int begin = 0, end = 0;

    int count() const { return end - begin; }
    bool empty() const { return begin == end; }
    // Returns these rows, or all of `height` rows if there are none.
    RowRange orAll(int height) const { return empty() ? RowRange{0, height} : *this; }
};

struct Frame {
    int width = 0;
    int height = 0;
    // rows: those of this frame, all but in the parts that FrameRenderer::picture() hands out. stored: those whose
    // stages are in the buffers.
    RowRange rows, stored;
    std::shared_ptr<const RayStage> rays;
    std::shared_ptr<const HitStage> hits;
    std::shared_ptr<const ColorStage> color;
    std::shared_ptr<const ShadowStage> shadows;
    std::shared_ptr<const LightStage> light;
    std::vector<TexturedQuad> polygons;
    double slabTexels = 0;
    double colorPerTexel = 1;  // texels of the colour picture per texel of the heights, along the denser axis
    std::shared_ptr<const TextureFilter> filter;       // null: heights in grey, sampled at the hit
    std::shared_ptr<const TextureFilter> plainFilter;  // of tiny footprints; null: all footprints use `filter`
    bool exactHits = false;                            // found by an exact method on the unfiltered heights
    // Name of the method that found the hits: `cone` where that is faster than the request's own method and gives the
    // same hits. Steps and reads are always the request's method's.
    std::string tracedBy;
    double mappingOff = 0;  // largest distance between the texture coordinates and those of direct mapping, texels
    ShadingNormal shading = ShadingNormal::Relief;
    // set where the method shades by a normal map and the request has none
    std::shared_ptr<const BakedNormals> bakedNormals;
    PinholeCamera camera;
    std::array<StageReport, kStages> stages;
    std::map<MessageId, double> counters;  // by the messages Count...; only those that apply to this frame
    double seconds = 0;
    double countSeconds = 0;  // time taken by counting steps and reads
    RowRange lit;             // rows that the light stage holds: all, except with PictureParts::onlyRows

    // Index in the stages' buffers of a pixel of the rows `stored`.
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - stored.begin) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
    // Returns the view ray of a pixel exactly as it was traced; std::nullopt if no polygon covers the pixel.
    std::optional<ViewRay> ray(int x, int y) const;
    // Returns the distance from the eye to the hit along the camera's forward direction, world units; NaN without a
    // hit.
    double depth(int x, int y) const;
    // Returns the visible polygons as this frame was rendered with them.
    VisiblePolygons visible(const FrameRequest& request) const;
    // Returns the unit normal, in world space, that the method shades the surface with; zero without a hit.
    glm::vec3 normal(int x, int y, const FrameRequest& request) const;
    // Returns true if that normal is the relief's own, not a normal map's or the plane's.
    bool shadedByRelief(const FrameRequest& request) const;
};

// What picture() makes besides the colours.
struct PictureParts {
    // Whether steps and reads of every ray are counted, as by FrameRenderer::counted().
    bool counts = false;
    // Called in the calling thread for the parts of the picture in order, from the top, with all stages of part.rows;
    // light is without supersampling. The part is valid only during the call.
    std::function<void(const Frame& part)> done{};
    // Rows of a part, a multiple of 32; 0: enough to keep all threads busy.
    int rows = 0;
    // The rows of the picture to make, with the same bits as in the whole picture; empty: all. The light stage holds
    // these rows alone; of the other stages up to 31 more rows on either side are made.
    RowRange onlyRows{};
};

// Returns the largest number of bytes that FrameRenderer::picture() takes, without maps and the filter's levels.
// threads: number of threads of its Work. rows: PictureParts::onlyRows.
std::uint64_t pictureBytes(const FrameRequest& request, int threads, RowRange rows = {});

// Keeps the buffers of the last frame and computes only the stages whose inputs changed. Use one renderer per window
// pane or command; it must not be used by several threads at once (the work inside is parallel). Frames stay valid as
// long as a shared pointer holds them.
class FrameRenderer {
  public:
    // partOfMore: the caller renders several frames as one task; it reports progress and counters and has checked the
    // memory.
    explicit FrameRenderer(std::shared_ptr<MapCache> maps, bool partOfMore = false)
        : maps_(std::move(maps)), partOfMore_(partOfMore) {}

    // Called with the estimate after `done` of `total` sample passes, in the calling thread; the estimate is valid only
    // during the call.
    using Snapshot = std::function<void(const ColorImage& estimate, int done, int total)>;

    // Renders a frame. With the filter `supersample` the light stage is the mean of samples (supersample.h) and all
    // other stages are those of pixel centres; snapshot then receives estimates. Throws InputError (unknown names,
    // degenerate camera) and Cancelled (no frame is published and the buffers of the last frame are kept). The bits do
    // not depend on the number of threads or on what was reused.
    std::shared_ptr<const Frame> render(const FrameRequest& request, Work& work, const Snapshot& snapshot = {});

    // Renders the request's picture for one use: the same bits as render(), but only the light stage remains; the
    // others are made and discarded band by band. Peak memory: pictureBytes(). Throws what render() throws, and
    // MemoryError.
    std::shared_ptr<const Frame> picture(const FrameRequest& request, Work& work, const PictureParts& parts = {});

    // Returns the last frame of render() with the steps and reads of every ray and the counters that need them, or the
    // frame itself if it has them already. Throws Cancelled.
    std::shared_ptr<const Frame> counted(Work& work);

    // The tracer of the last frame, to replay a pixel with a log.
    std::shared_ptr<const Tracer> tracer() const { return tracer_; }

  private:
    std::shared_ptr<MapCache> maps_;
    bool partOfMore_;
    std::shared_ptr<const Tracer> tracer_;
    using Clock = std::chrono::steady_clock;

    std::uint32_t changedSince(const FrameRequest& request) const;
    std::unique_ptr<FrameSetup> madeSetup(const FrameRequest& request, std::uint32_t changed, std::uint32_t stale,
                                          Work& work);
    // Sets the frame's time since `begin`, and adds its counters to the work's unless the frame is part of a larger
    // task.
    void finish(Frame& frame, Clock::time_point begin, Work& work) const;
    std::shared_ptr<const TextureFilter> madeFilter(const FrameRequest& request, Work& work);
    std::shared_ptr<const TextureFilter> madePlainFilter(const FrameRequest& request, Work& work);
    std::unique_ptr<const FlatGround> madeGround(const FrameRequest& request, const Tracer& tracer, Work& work);
    std::unique_ptr<const PackedConeHits> madeConeHits(const FrameRequest& request, const Tracer& tracer,
                                                       bool readsNeighbours, Work& work);
    std::vector<std::shared_ptr<const HorizonBounds>> madeHorizons(const FrameRequest& request, const Frame& frame,
                                                                   const VisiblePolygons& visible, Work& work);
    void reportMaps(Frame& frame, const FrameRequest& request, const Tracer& tracer, Work& work);

    std::optional<FrameRequest> last_;
    std::shared_ptr<const Frame> frame_;
    // The buffers of frame_, and those of the frame before it, which are reused if no other owner holds them.
    std::shared_ptr<FrameBuffers> current_;
    std::shared_ptr<FrameBuffers> spare_;
    // The band's buffers of picture(), and the light stage of the last picture.
    std::shared_ptr<FrameBuffers> band_;
    // The mean pyramid of the last filtered picture; greyOf_: the heights that it was made from, if it is grey.
    std::shared_ptr<const ColorLevels> levels_;
    std::shared_ptr<const void> greyOf_;
    // Height bounds of the last traced heights; groundOf_: those heights.
    std::shared_ptr<const HeightBoundsMap> ground_;
    std::shared_ptr<const void> groundOf_;
    // Number of rays traced so far over the heights tracedOf_.
    std::size_t traced_ = 0;
    std::shared_ptr<const void> tracedOf_;
    // Bounds of the horizon of the last frame's polygons, and the number of pixels drawn over its heights in its light.
    std::vector<std::shared_ptr<const HorizonBounds>> horizons_;
    std::size_t litPixels_ = 0;
};

// Returns the filter's query for the pixel; std::nullopt without a hit.
std::optional<FilterQuery> filterQuery(const Frame& frame, const FrameRequest& request, const VisiblePolygons& visible,
                                       int x, int y);

// Returns true if the pixel's footprint, from its centre to its farthest point, is at most request.bounded texels of
// the colour picture long.
bool tinyFootprint(const FilterQuery& query, const Frame& frame, const FrameRequest& request);

// Returns the view ray of a single pixel without rendering a frame, as `relief trace --pixel` does; std::nullopt if no
// polygon covers the pixel. Same bits as Frame::ray. Throws InputError for pixels outside the picture.
std::optional<ViewRay> pixelRay(const FrameRequest& request, int x, int y);

// Returns the planes of the named layers: color (R, G, B), depth, uv (u, v), normal (X, Y, Z), steps (of a counted
// frame), outcome (0 none, 1 hit, 2 miss, 3 limit), error (texels and kind: error_layer.h), footprint (semi-axes of the
// circle of radius 1 pixel in texels of the height map), hidden (share of the texels under the filter that the relief
// hides; for the forms rays and grid, which test points instead of texels, the texels of form=plane). The last three
// are computed only if they are named. Throws InputError("--layers", ...) for unknown names, Cancelled.
std::vector<NamedPlane> layerPlanes(const Frame& frame, const FrameRequest& request,
                                    const std::vector<std::string>& layers, MapCache& maps, Work& work);

// Layer planes of a picture that is made in parts (FrameRenderer::picture()).
class LayerPlanes {
  public:
    // rows: the rows that the planes hold, PictureParts::onlyRows; empty: all. Throws InputError("--layers", ...) for
    // unknown names. Keeps a reference to maps.
    LayerPlanes(const FrameRequest& request, const std::vector<std::string>& layers, MapCache& maps,
                RowRange rows = {});
    ~LayerPlanes();
    LayerPlanes(const LayerPlanes&) = delete;
    LayerPlanes& operator=(const LayerPlanes&) = delete;

    // Fills those of part.rows that the planes hold, in all layers except color. Throws Cancelled.
    void add(const Frame& part, const FrameRequest& request, Work& work);
    // Moves out all planes; color is taken from the frame's light stage.
    std::vector<NamedPlane> take(const Frame& frame);
    // Returns the peak bytes of this number of rows: the planes' own size, and as much again while they are written.
    static std::uint64_t bytes(const FrameRequest& request, const std::vector<std::string>& layers, int rows);

  private:
    struct Tools;

    std::vector<std::string> layers_;
    MapCache& maps_;
    std::unique_ptr<Tools> tools_;
    RowRange rows_;
    std::vector<NamedPlane> planes_;
};
// Returns the names of the layers' planes, in their order. Throws InputError("--layers", ...).
std::vector<std::string> layerPlaneNames(const std::vector<std::string>& layers);
// Returns the names of all layers.
const std::vector<std::string>& layerNames();

}  // namespace relief
