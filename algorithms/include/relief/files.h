// Reading and writing pictures through OpenImageIO. Paths are UTF-8.
// Read: PNG, JPEG, TIFF, OpenEXR, Radiance HDR, BMP, GIF, WebP, JPEG 2000, PNM and PFM, PSD, FITS, by what is in the
// file; TGA, RLA and HEIF by the name. The first picture of a file with several. Colour profiles and EXIF are ignored.
// Every fault is an InputError with one line: missing, directory, empty, truncated, not an image, zero size, more
// pixels than the cap (before anything is allocated), a channel that is not there, a height that is NaN or infinite
// (with the first such pixel), an output that cannot be written (WorkError). Outputs are written beside and renamed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "relief/image.h"
#include "relief/messages.h"
#include "relief/work.h"

namespace relief {

inline constexpr std::int64_t kDefaultMaxPixels = std::int64_t{1} << 28;

// What a picture file says about itself, without its pixels.
struct ImageInfo {
    std::string path;
    std::string format;  // "png", "jpeg", "openexr", ...
    int width = 0;
    int height = 0;
    std::vector<std::string> channels;  // "R", "G", "B", "A", "Y", ...
    std::string type;                   // "uint8", "uint16", "half", "float", ...
    std::string colorSpace;             // as the file says, may be empty
};

ImageInfo readImageInfo(const std::string& path, std::int64_t maxPixels = kDefaultMaxPixels);

// How numbers of a height file become heights in [0, 1].
// Auto: integers by their full range; floats in [0, 1] as they are, others stretched to [0, 1], with a message.
// Full: integers by their full range; floats as they are: outside [0, 1] is an error. Bounds: [low, high] to [0, 1],
// clamped.
struct HeightRange {
    enum class Kind : std::uint8_t { Auto, Full, Bounds };
    Kind kind = Kind::Auto;
    double low = 0;
    double high = 1;
    bool operator==(const HeightRange&) const = default;
};

// "auto", "full" or "LO,HI"; throws InputError naming "--range".
HeightRange parseHeightRange(const std::string& text);
std::string heightRangeText(const HeightRange& range);

struct HeightReadOptions {
    std::string channel;  // number from 0, or name (R, G, B, A, Y, ...); empty: Y if grey, else the first
    bool invert = false;  // 1 - h after scaling
    HeightRange range;
    std::int64_t maxPixels = kDefaultMaxPixels;
    bool operator==(const HeightReadOptions&) const = default;
};

// Heights as read: values in [0, 1], never colour-converted, alpha not premultiplied, and what was done to them.
struct HeightImage {
    FloatImage heights;
    ImageInfo info;
    std::string channel;  // the name of the channel taken
    double fileLow = 0;   // smallest and largest number as read, in units of the file (integers: 0 to 255, ...)
    double fileHigh = 0;
    std::vector<Message> notes;  // "floats outside [0, 1] were stretched from ...": shown to the user once
};

HeightImage readHeight(const std::string& path, const HeightReadOptions& options, Work& work);

// sRGB pictures made linear; float pictures (EXR, HDR) taken as linear; grey spread over three channels; alpha ignored
// (colours not premultiplied).
ColorImage readColor(const std::string& path, Work& work, std::int64_t maxPixels = kDefaultMaxPixels);
// Normals as they stand (OpenGL convention: x right, y up, z out), n = 2 c - 1, normalised; a zero vector becomes
// (0, 0, 1). Never colour-converted.
Image<glm::vec3> readNormals(const std::string& path, Work& work, std::int64_t maxPixels = kDefaultMaxPixels);

// sRGB transfer curve, both ways (IEC 61966-2-1), values unclamped.
float linearFromSrgb(float encoded);
float srgbFromLinear(float linear);

// Rows [begin, end) of a picture that become a file of their own, and the text by which such files find together again
// (picture_bands.h): printable ASCII, empty where it is not needed. The file is a PNG, TIFF or EXR.
struct PictureBand {
    int begin = 0, end = 0;
    std::string text;
};

// The name decides the format. 8-bit formats and PNG: sRGB 8 bit, clamped, NaN as 0; EXR and HDR: linear. band: only
// these rows; null: all.
void writeColor(const std::string& path, const ColorImage& image, const PictureBand* band = nullptr);
// Heights: PNG and TIFF 16 bit by full range; EXR and .tif with asFloat: 32-bit float as they are.
void writeHeight(const std::string& path, const FloatImage& heights, bool asFloat = false);

// One named plane of a multi-channel picture ("depth.Z", "color.R", ...), float.
struct NamedPlane {
    std::string name;
    FloatImage plane;
};
// 32-bit float OpenEXR, planes in the given order; all of one size. band: only these rows; null: all.
void writePlanes(const std::string& path, const std::vector<NamedPlane>& planes, const PictureBand* band = nullptr);

// An output that is written beside and renamed when complete: a reader sees the old file or the whole new one, never
// a part. Without commit() the partial file is removed. "-" is not handled here.
class AtomicFile {
  public:
    // Keeps the extension (OpenImageIO chooses the format by it).
    explicit AtomicFile(std::string path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    const std::string& temporaryPath() const { return temporary_; }
    // Flushes to disk and renames; throws WorkError.
    void commit();

  private:
    std::string path_;    // as given: errors name it
    std::string target_;  // behind links
    std::string temporary_;
    bool committed_ = false;
};

// Writes text atomically; throws WorkError (full disk, no permission, ...).
void writeTextFile(const std::string& path, const std::string& text);
// Whole file as bytes; throws InputError (missing, directory, unreadable).
std::string readTextFile(const std::string& path);

}  // namespace relief
