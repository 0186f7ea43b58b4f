#include "embree_peer.h"

#include <embree3/rtcore.h>
#include <pmmintrin.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/parallel.h"

namespace relief::peers {

namespace {

// Rays start above the slab's top by this share of its height: otherwise Embree would miss surfaces in the top plane by
// rounding.
constexpr double kAbove = 1.0 / 1024;
// Rays per task, a tile of a frame.
constexpr std::size_t kGrain = 1024;

bool countBytes(void* total, ssize_t bytes, bool) {
    *static_cast<std::atomic<std::int64_t>*>(total) += bytes;
    return true;
}

// Sets the processor's flush-to-zero flags, as Embree's manual requires while tracing.
class FlushDenormals {
  public:
    FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040U); }
    ~FlushDenormals() { _mm_setcsr(before_); }
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

  private:
    unsigned before_;
};

// Coordinates of the vertices along one axis.
struct Places {
    std::vector<float> at;
    std::vector<std::int64_t> texel;
};

Places placesOf(const HeightField& field, int size, int first, int last) {
    Places places;
    const auto add = [&](double at, std::int64_t texel) {
        places.at.push_back(static_cast<float>(at));
        places.texel.push_back(texel);
    };
    const bool border = field.address() == Address::Border;
    if (border) {
        first = 0;
        last = size - 1;
        add(0, 0);
    }
    for (int i = first; i <= last; ++i) add(i + 0.5, i);
    if (border) add(size, size - 1);
    return places;
}

template <class RayHit>
void setLane(RayHit& packet, int lane, const EmbreeRays& rays, std::size_t i) {
    packet.ray.org_x[lane] = rays.s[i];
    packet.ray.org_y[lane] = rays.t[i];
    packet.ray.org_z[lane] = rays.top;
    packet.ray.dir_x[lane] = rays.a[i];
    packet.ray.dir_y[lane] = rays.b[i];
    packet.ray.dir_z[lane] = rays.down;
    packet.ray.tnear[lane] = 0;
    packet.ray.tfar[lane] = static_cast<float>(1 + 2 * kAbove);
    packet.ray.time[lane] = 0;
    packet.ray.mask[lane] = ~0U;
    packet.ray.id[lane] = 0;
    packet.ray.flags[lane] = 0;
    packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
}

float lambdaOf(float distance, unsigned geometry) {
    return geometry == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::quiet_NaN()
                                               : distance - static_cast<float>(kAbove);
}

struct Piece {
    std::size_t first, last;
};

void traceSingles(RTCScene scene, RTCIntersectContext& context, const EmbreeRays& rays, Piece piece, float* lambda) {
    for (std::size_t i = piece.first; i < piece.last; ++i) {
        RTCRayHit one;
        one.ray = {
            rays.s[i], rays.t[i], rays.top, 0, rays.a[i], rays.b[i], rays.down, 0, static_cast<float>(1 + 2 * kAbove),
            ~0U,       0,         0};
        one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        one.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context, &one);
        lambda[i] = lambdaOf(one.ray.tfar, one.hit.geomID);
    }
}

template <int kLanes, class RayHit, class Intersect>
void tracePackets(const EmbreeRays& rays, Piece piece, float* lambda, const Intersect& intersect) {
    for (std::size_t begin = piece.first; begin < piece.last; begin += kLanes) {
        const int count = static_cast<int>(std::min<std::size_t>(kLanes, piece.last - begin));
        alignas(64) RayHit packet;
        alignas(64) int valid[kLanes];
        // Lanes beyond the end repeat the last ray, and are masked out.
        for (int lane = 0; lane < kLanes; ++lane) {
            valid[lane] = lane < count ? -1 : 0;
            setLane(packet, lane, rays, begin + static_cast<std::size_t>(std::min(lane, count - 1)));
        }
        intersect(valid, packet);
        for (int lane = 0; lane < count; ++lane) {
            lambda[begin + static_cast<std::size_t>(lane)] = lambdaOf(packet.ray.tfar[lane], packet.hit.geomID[lane]);
        }
    }
}

}  // namespace

struct EmbreeScene::Held {
    EmbreeShape shape{};
    std::atomic<std::int64_t> bytes{0};
    double seconds = 0;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    ~Held() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }
};

std::vector<EmbreeVariant> embreeVariants(const std::vector<EmbreeShape>& shapes) {
    std::vector<EmbreeVariant> all;
    for (const EmbreeShape shape : shapes) {
        all.push_back({shape, 1, false});
        for (const int packet : {8, 16}) {
            for (const bool coherent : {false, true}) all.push_back({shape, packet, coherent});
        }
    }
    return all;
}

EmbreeRays embreeRays(const HeightField& field, const RayBlock& rays) {
    EmbreeRays out;
    const auto slab = static_cast<float>(field.slabTexels());
    out.top = slab * static_cast<float>(1 + kAbove);
    out.down = -slab;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        out.s.push_back(static_cast<float>(rays.s0[i] - kAbove * rays.a[i]));
        out.t.push_back(static_cast<float>(rays.t0[i] - kAbove * rays.b[i]));
        out.a.push_back(static_cast<float>(rays.a[i]));
        out.b.push_back(static_cast<float>(rays.b[i]));
    }
    return out;
}

EmbreeScene::EmbreeScene(const HeightField& field, EmbreeShape shape, const MeshExtent& extent, int threads,
                         const std::string& config)
    : held_(std::make_unique<Held>()) {
    Held& h = *held_;
    h.shape = shape;
    const std::string settings = "threads=" + std::to_string(threads) + (config.empty() ? "" : "," + config);
    h.device = rtcNewDevice(settings.c_str());
    if (h.device == nullptr) throw WorkError("embree", Message(MessageId::InternalError, {{"why", settings}}));
    rtcSetDeviceMemoryMonitorFunction(h.device, countBytes, &h.bytes);
    const auto begun = std::chrono::steady_clock::now();
    const Places s = placesOf(field, field.width(), extent.i0, extent.i1);
    const Places t = placesOf(field, field.height(), extent.j0, extent.j1);
    const std::size_t columns = s.at.size();
    const std::size_t rows = t.at.size();
    const RTCGeometry geometry =
        rtcNewGeometry(h.device, shape == EmbreeShape::Grid ? RTC_GEOMETRY_TYPE_GRID : RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), columns * rows));
    const auto slab = static_cast<float>(field.slabTexels());
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            float* vertex = vertices + 3 * (j * columns + i);
            vertex[0] = s.at[i];
            vertex[1] = t.at[j];
            vertex[2] = slab * field.texel(s.texel[i], t.texel[j]);
        }
    }
    if (shape == EmbreeShape::Grid) {
        auto* grid = static_cast<RTCGrid*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_GRID, 0, RTC_FORMAT_GRID, sizeof(RTCGrid), 1));
        *grid = {0, static_cast<unsigned>(columns), static_cast<unsigned short>(columns),
                 static_cast<unsigned short>(rows)};
    } else {
        auto* index =
            static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                           3 * sizeof(unsigned), 2 * (columns - 1) * (rows - 1)));
        for (std::size_t j = 0; j + 1 < rows; ++j) {
            for (std::size_t i = 0; i + 1 < columns; ++i) {
                const auto corner = static_cast<unsigned>(j * columns + i);
                const auto below = static_cast<unsigned>(corner + columns);
                for (const unsigned v : {corner, corner + 1, below, corner + 1, below + 1, below}) *index++ = v;
            }
        }
    }
    rtcCommitGeometry(geometry);
    h.scene = rtcNewScene(h.device);
    rtcAttachGeometry(h.scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(h.scene);
    h.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    if (const RTCError error = rtcGetDeviceError(h.device); error != RTC_ERROR_NONE) {
        throw WorkError("embree",
                        Message(MessageId::InternalError, {{"why", std::to_string(static_cast<int>(error))}}));
    }
}

EmbreeScene::~EmbreeScene() = default;

EmbreeShape EmbreeScene::shape() const {
    return held_->shape;
}

std::size_t EmbreeScene::bytes() const {
    return static_cast<std::size_t>(held_->bytes.load());
}

double EmbreeScene::buildSeconds() const {
    return held_->seconds;
}

void EmbreeScene::trace(const EmbreeVariant& variant, const EmbreeRays& rays, std::vector<float>& lambda,
                        Work& work) const {
    const RTCScene scene = held_->scene;
    const auto tile = [&](std::size_t number) {
        const FlushDenormals flush;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = variant.coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
        const Piece piece{number * kGrain, std::min((number + 1) * kGrain, rays.s.size())};
        if (variant.packet == 1) {
            traceSingles(scene, context, rays, piece, lambda.data());
        } else if (variant.packet == 8) {
            tracePackets<8, RTCRayHit8>(rays, piece, lambda.data(), [&](const int* valid, RTCRayHit8& packet) {
                rtcIntersect8(valid, scene, &context, &packet);
            });
        } else {
            tracePackets<16, RTCRayHit16>(rays, piece, lambda.data(), [&](const int* valid, RTCRayHit16& packet) {
                rtcIntersect16(valid, scene, &context, &packet);
            });
        }
    };
    const std::size_t tiles = (rays.s.size() + kGrain - 1) / kGrain;
    parallelFor(work, tiles, tile);
}

std::string embreeText() {
    return "Embree " + std::to_string(RTC_VERSION_MAJOR) + "." + std::to_string(RTC_VERSION_MINOR) + "." +
           std::to_string(RTC_VERSION_PATCH);
}

}  // namespace relief::peers
