// Maps as engines read them: ordinary pictures, with the conventions that a shader must know. The conventions stand in
// a sidecar, FILE.json beside the first picture FILE, and in the picture's own metadata. Maps of other programs are
// read by conventions that the caller states. FORMATS.md describes the files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "relief/image.h"
#include "relief/maps/distance_map.h"
#include "relief/maps/engine_codes.h"
#include "relief/work.h"

namespace relief {

inline constexpr int kEngineMapVersion = 1;

// A volume of distances as the layers of an atlas (map_atlas.h). x = distance / scale, both in texture widths, in the
// slab's metric; 0 also for voxels in which a shader must look for the surface itself.
struct EngineVolume {
    DistanceKind kind = DistanceKind::Euclidean;
    DistanceParameters parameters;
    double slabTexels = 0;  // as in DistanceMap
    double maxRun = 0;
    double cap = 0;
    double scale = 1;
    int nx = 0;
    int ny = 0;
    int columns = 0;
};

struct EngineConventions {
    std::string kind = "cone";         // as `relief map` calls it
    std::vector<EngineRole> channels;  // R, G, B, A; empty: not known
    int bits = 8;                      // of a channel: 8, 16; 32: floats
    Surface surface = Surface::Bilinear;
    Address wrap = Address::Repeat;
    double reliefDepth = 0.1;  // thickness of the slab, texture widths
    double zeroLevel = 1;      // the height that lies in the polygon's plane
    int fieldWidth = 0;        // of the height map, texels
    int fieldHeight = 0;
    EngineRounding rounding = EngineRounding::Outward;
    ConeCoding cone;
    bool relaxed = false;  // a ray may cross the surface once within a cone
    bool greenUp = true;   // normals: y against the rows (OpenGL), or with them (Direct3D)
    std::optional<EngineVolume> volume;

    bool hasHeights() const { return packs(channels, EngineRole::Height) || packs(channels, EngineRole::Depth); }
};

// One picture: the numbers x of its channels.
struct EngineLevel {
    std::vector<FloatImage> channels;
};

struct EngineMap {
    EngineConventions conventions;
    std::vector<EngineLevel> levels;  // MIP levels, or levels of a pyramid; at least one

    // Returns the channel with this role; null if there is none.
    const FloatImage* channel(EngineRole role, int level = 0) const;
    // Returns the heights of a level, from its channel of heights or depths; std::nullopt if it has none.
    std::optional<FloatImage> heights(int level = 0) const;
};

// Throws InputError naming `path` unless the picture has this size.
void requireSize(const std::string& path, const FloatImage& picture, int width, int height);

// The conventions of other programs, by name; `summary` names the program or paper. bits is not part of them.
struct NamedConvention {
    std::string name;
    std::string summary;
    EngineConventions conventions;
};
const std::vector<NamedConvention>& namedConventions();
// Throws InputError naming `option`.
const NamedConvention& namedConvention(const std::string& name, const std::string& option);

// The path of a map's sidecar, and that of a level's picture: FILE.png of several levels is FILE.0.png, FILE.1.png, ...
std::string engineSidecar(const std::string& path);
std::string engineLevelPath(const std::string& path, int level, int levels);
// Returns true if the file has a sidecar, or its own metadata state that it is such a map.
bool isEngineMap(const std::string& path);

// Writes the pictures and, last, the sidecar. path: .png (8 or 16 bits), .exr (floats), .tif (any). Each file appears
// only when it is complete. Throws WorkError, InputError.
void writeEngineMap(const std::string& path, const EngineMap& map);

// Returns the conventions that the sidecar or the picture states; std::nullopt if neither does. Throws InputError.
std::optional<EngineConventions> readEngineConventions(const std::string& path);
// Reads the pictures by these conventions; bits are those of the file. Throws InputError, MemoryError, Cancelled.
EngineMap readEngineMap(const std::string& path, EngineConventions conventions, Work& work);

}  // namespace relief
