// Frames: what to draw, the buffers of a drawn frame, and the renderer that computes only what changed.
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
struct FrameBuffers;
struct FrameSetup;
struct HeightBoundsMap;

inline constexpr int kMaxPictureSide = 1 << 15;
inline constexpr double kMaxBounded = 4;

// Everything a frame depends on, by value; pictures are shared and immutable.
struct FrameRequest {
    int width = 800;
    int height = 600;
    HeightField field;
    MethodChoice method;
    std::shared_ptr<const ColorImage> color;          // null: the heights in grey
    std::shared_ptr<const Image<glm::vec3>> normals;  // null: the height field's own
    FilterChoice filter;
    SceneKind scene = SceneKind::Floor;
    Camera camera;
    Light light;
    bool shadows = false;
    // Steps and reads of every ray, too: the rays are traced once more for them, with the same hits.
    bool counts = false;
    // How texture coordinates are made along the rows (visiblePolygons()).
    RowOptions mapping = kDirectRows;
    // Whether work is left out that cannot change a bit. False: all of it is done, to show that it cannot.
    bool skip = true;
    // Texels, [0, kMaxBounded]: work is left out that changes hits by at most so much, and tiny footprints. 0: none.
    double bounded = 0;
    Color sky{0.55F, 0.65F, 0.8F};  // linear
    // For parts of a bigger picture: where in its square a pixel is looked at, [0, 1]^2, and by how many pixels the
    // frame reaches beyond the camera's picture on every side (counted in width and height).
    glm::dvec2 sample{0.5, 0.5};
    int margin = 0;

    explicit FrameRequest(HeightField heightField) : field(std::move(heightField)) {}
};

// The request's camera in the pixels of its frame, moved so that pixel centres are where the request looks.
// Throws InputError("--camera", ...).
PinholeCamera requestCamera(const FrameRequest& request);

// No polygon covers the pixel.
inline constexpr std::uint8_t kNoPolygon = 255;

struct RayStage {
    RayBlock rays;                      // one a pixel, rows top-down
    std::vector<std::uint8_t> polygon;  // kNoPolygon: sky
    std::vector<float> inverseDepth;    // 1 / camera depth of the entry, per world unit
};
// Traced: by the method. FlatGround: by the one cell that the ray can meet, the same bits. LittleParallax: half way
// between the lowest and the highest height within reach.
enum class HitBy : std::uint8_t { Traced, FlatGround, LittleParallax };
struct HitStage {
    std::vector<HitBy> by;  // one a pixel
    HitBlock hits;          // steps and reads are empty until they are counted
    bool counted() const { return hits.steps.size() == hits.size(); }
};
struct ColorStage {
    ColorImage color;  // linear, unlit
};
struct ShadowStage {
    std::vector<std::uint8_t> shadowed;  // one a pixel, 1 where the light does not reach; empty: no shadows wanted
};
struct LightStage {
    ColorImage color;  // linear, lit; what the picture shows
};

// One stage's part in a frame.
struct StageReport {
    bool reused = false;  // its inputs had not changed
    double seconds = 0;   // of all threads together, where computed
};

// Rows [begin, end) of a picture.
struct RowRange {
    int begin = 0, end = 0;
};

struct Frame {
    int width = 0;
    int height = 0;
    // All rows but in the parts that FrameRenderer::picture() hands out: the rows of the part, and those whose stages
    // are in the buffers (the light stage always has the whole picture).
    RowRange rows, stored;
    std::shared_ptr<const RayStage> rays;
    std::shared_ptr<const HitStage> hits;
    std::shared_ptr<const ColorStage> color;
    std::shared_ptr<const ShadowStage> shadows;
    std::shared_ptr<const LightStage> light;
    std::vector<TexturedQuad> polygons;
    double slabTexels = 0;
    double colorPerTexel = 1;  // texels of the colour picture per texel of the heights, along the denser axis
    std::shared_ptr<const TextureFilter> filter;       // null: heights in grey, read at the hit
    std::shared_ptr<const TextureFilter> plainFilter;  // of tiny footprints; null: there are none
    bool exactHits = false;                            // by an exact method, of the heights themselves
    // Name of the method whose walk has found the hits: `cone` where that is faster than the request's own, which gives
    // the same hits. Steps and reads are always the request's method's.
    std::string tracedBy;
    double mappingOff = 0;  // the largest distance of coordinates from those of direct, texels
    ShadingNormal shading = ShadingNormal::Relief;
    std::shared_ptr<const BakedNormals> bakedNormals;  // where the method shades by a normal map and none is given
    PinholeCamera camera;
    std::array<StageReport, kStages> stages;
    std::map<MessageId, double> counters;  // by the messages Count..., only those that the frame has
    double seconds = 0;
    double countSeconds = 0;  // of them, for steps and reads

    // Place of a pixel of `stored` in the stages' buffers.
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y - stored.begin) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
    // The ray of a pixel, the very one that was traced; nothing where no polygon is seen.
    std::optional<ViewRay> ray(int x, int y) const;
    // Distance from the eye along the camera's forward direction to the hit, world units; NaN without a hit.
    double depth(int x, int y) const;
    // The polygons as this frame saw them.
    VisiblePolygons visible(const FrameRequest& request) const;
    // Unit normal of the lit surface in world space, whichever the method shades by; zero without a hit.
    glm::vec3 normal(int x, int y, const FrameRequest& request) const;
    // Whether that is the relief's own, and no map's or plane's.
    bool shadedByRelief(const FrameRequest& request) const;
};

// What a picture is made with beyond its colours.
struct PictureParts {
    // Steps and reads of every ray, as FrameRenderer::counted().
    bool counts = false;
    // Called in the calling thread for one part of the picture after the other, from the top, with all stages of
    // part.rows; light is without supersampling. The part is valid during the call.
    std::function<void(const Frame& part)> done{};
    // Rows of a part, a multiple of 32; 0: as many as keep all threads busy.
    int rows = 0;
    // The rows of the picture that are wanted, to the same bits as in the whole picture; empty: all. Up to 31 rows on
    // either side are made, too; what the light stage and layers hold of all others is not defined. The light stage has
    // the whole picture's size all the same.
    RowRange wanted{};
};

// Bytes that FrameRenderer::picture() takes at most, maps and the filter's levels apart; threads: of its work.
std::uint64_t pictureBytes(const FrameRequest& request, int threads);

// Keeps the buffers of the last frame and computes only the stages whose inputs changed. One renderer a window pane or
// command; not shared between threads (the work inside is parallel). Frames stay valid as long as somebody holds them.
class FrameRenderer {
  public:
    // partOfMore: what the frame belongs to reports progress and counts, and has asked whether there is memory.
    explicit FrameRenderer(std::shared_ptr<MapCache> maps, bool partOfMore = false)
        : maps_(std::move(maps)), partOfMore_(partOfMore) {}

    // The estimate after so many of all sample passes, in the calling thread; valid during the call.
    using Snapshot = std::function<void(const ColorImage& estimate, int done, int total)>;

    // With the filter `supersample` the light stage is the mean of samples (supersample.h), all others are those of
    // pixel centres; snapshot is then told of estimates.
    // Throws InputError (unknown names, degenerate camera), Cancelled (nothing is published, the buffers of the last
    // frame stay). Same bits for any number of threads and whatever was reused.
    std::shared_ptr<const Frame> render(const FrameRequest& request, Work& work, const Snapshot& snapshot = {});

    // The request's picture for one use: the same bits as render(), but of the stages only light is left; the others
    // are made and given up band by band. Peak memory: pictureBytes(). Throws MemoryError, too.
    std::shared_ptr<const Frame> picture(const FrameRequest& request, Work& work, const PictureParts& parts = {});

    // The last frame of render() with the steps and reads of every ray, and the counters that need them; the frame
    // itself if it has them. Throws Cancelled.
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
    // Seconds since `begin`, and the counters where they are the work's.
    void finish(Frame& frame, Clock::time_point begin, Work& work) const;
    std::shared_ptr<const TextureFilter> madeFilter(const FrameRequest& request, Work& work);
    std::shared_ptr<const TextureFilter> madePlainFilter(const FrameRequest& request, Work& work);
    std::unique_ptr<const FlatGround> madeGround(const FrameRequest& request, const Tracer& tracer, Work& work);
    std::unique_ptr<const PackedConeHits> madeConeHits(const FrameRequest& request, const Tracer& tracer,
                                                       bool readsNeighbours, Work& work);
    void reportMaps(Frame& frame, const FrameRequest& request, const Tracer& tracer, Work& work);

    std::optional<FrameRequest> last_;
    std::shared_ptr<const Frame> frame_;
    // The buffers of frame_, and those that the frame before it left, to be written again if nobody holds them.
    std::shared_ptr<FrameBuffers> current_;
    std::shared_ptr<FrameBuffers> spare_;
    // Those of picture(): of a band, and the light of the last one.
    std::shared_ptr<FrameBuffers> band_;
    // The mean pyramid of the picture that was filtered last, and the heights that it was made of, if it is grey.
    std::shared_ptr<const ColorLevels> levels_;
    std::shared_ptr<const FloatImage> greyOf_;
    // Where the ground is even, of the heights that were traced last.
    std::shared_ptr<const HeightBoundsMap> ground_;
    std::shared_ptr<const FloatImage> groundOf_;
    // Rays asked for over the same heights.
    std::size_t traced_ = 0;
    std::shared_ptr<const FloatImage> tracedOf_;
};

// What the filter is asked for the pixel; nothing where it has no hit.
std::optional<FilterQuery> filterQuery(const Frame& frame, const FrameRequest& request, const VisiblePolygons& visible,
                                       int x, int y);

// Whether the pixel's footprint, from its middle to its farthest point, is at most request.bounded texels of the colour
// picture long.
bool tinyFootprint(const FilterQuery& query, const Frame& frame, const FrameRequest& request);

// The view rays of single pixels without a frame: what `relief trace --pixel` asks. Throws InputError outside the
// picture. Same bits as Frame::ray.
std::optional<ViewRay> pixelRay(const FrameRequest& request, int x, int y);

// Planes of the named layers: color (R, G, B), depth, uv (u, v), normal (X, Y, Z), steps (of a counted frame), outcome
// (0 none, 1 hit, 2 miss, 3 limit), error (texels and kind: error_layer.h), footprint (semi-axes of the circle of
// radius 1 pixel in texels of the height map), hidden (share of the texels under the filter that the relief hides; of
// its forms that look at points instead, rays and grid, the texels of form=plane). The last three are computed only
// when they are asked for. Throws InputError("--layers", ...) for unknown names, Cancelled.
std::vector<NamedPlane> layerPlanes(const Frame& frame, const FrameRequest& request,
                                    const std::vector<std::string>& layers, MapCache& maps, Work& work);

// The same of a picture that comes in parts (FrameRenderer::picture()).
class LayerPlanes {
  public:
    // Throws InputError("--layers", ...) for unknown names. maps is kept.
    LayerPlanes(const FrameRequest& request, const std::vector<std::string>& layers, MapCache& maps);
    ~LayerPlanes();
    LayerPlanes(const LayerPlanes&) = delete;
    LayerPlanes& operator=(const LayerPlanes&) = delete;

    // Fills part.rows, but for the layer color. Throws Cancelled.
    void add(const Frame& part, const FrameRequest& request, Work& work);
    // All planes; color is the frame's light.
    std::vector<NamedPlane> take(const Frame& frame);
    // Bytes that the planes take, and as much again while they are written.
    static std::uint64_t bytes(const FrameRequest& request, const std::vector<std::string>& layers);

  private:
    struct Tools;

    std::vector<std::string> layers_;
    MapCache& maps_;
    std::unique_ptr<Tools> tools_;
    std::vector<NamedPlane> planes_;
};
const std::vector<std::string>& layerNames();

}  // namespace relief
