// Reading and writing pictures through OpenImageIO. Paths are UTF-8.
// Readable formats, recognised by the file's content: PNG, JPEG, TIFF, OpenEXR, Radiance HDR, BMP, GIF, WebP, JPEG
// 2000, PNM and PFM, PSD, FITS; by the file name: TGA, RLA and HEIF. Of a file with several pictures the first is read.
// Colour profiles and EXIF data are ignored.
// Every fault is an InputError with a one-line message: missing file, directory, empty, truncated, not an image, zero
// size, more pixels than the limit (detected before allocation), missing channel, a height that is NaN or infinite
// (with the first such pixel). An output that cannot be written is a WorkError. Outputs are written to a temporary file
// in the same folder and renamed.
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

// The properties of a picture file that can be read without its pixels.
struct ImageInfo {
    std::string path;
    std::string format;  // "png", "jpeg", "openexr", ...
    int width = 0;
    int height = 0;
    std::vector<std::string> channels;  // "R", "G", "B", "A", "Y", ...
    std::string type;                   // "uint8", "uint16", "half", "float", ...
    std::string colorSpace;             // as stated by the file; may be empty
};

// Reads the properties of a picture file. maxPixels: limit on width x height. Throws InputError.
ImageInfo readImageInfo(const std::string& path, std::int64_t maxPixels = kDefaultMaxPixels);

// How the numbers of a height file are converted to heights in [0, 1]. Auto: integers by their full range; floats in
// [0, 1] are kept, others are stretched to [0, 1], with a note. Full: integers by their full range; floats are kept,
// and values outside [0, 1] are an error. Bounds: [low, high] is mapped to [0, 1], other values are clamped.
struct HeightRange {
    enum class Kind : std::uint8_t { Auto, Full, Bounds };
    Kind kind = Kind::Auto;
    double low = 0;
    double high = 1;
    bool operator==(const HeightRange&) const = default;
};

// Parses "auto", "full" or "LO,HI". Throws InputError naming "--range".
HeightRange parseHeightRange(const std::string& text);
// Returns the text that parseHeightRange() parses.
std::string heightRangeText(const HeightRange& range);

struct HeightReadOptions {
    // Number from 0, or name (R, G, B, A, Y, ...); empty: Y if there is one, otherwise the first.
    std::string channel{};
    bool invert = false;  // 1 - h, after scaling
    HeightRange range{};
    std::int64_t maxPixels = kDefaultMaxPixels;
    bool operator==(const HeightReadOptions&) const = default;
};

// Heights in [0, 1] as read from a file, not colour-converted and not premultiplied by alpha, with information on the
// conversion.
struct HeightImage {
    FloatImage heights;
    ImageInfo info;
    std::string channel;  // name of the channel that was read
    double fileLow = 0;   // smallest and largest number in the file, in its own units (for 8-bit integers 0 to 255)
    double fileHigh = 0;
    std::vector<Message> notes;  // "floats outside [0, 1] were stretched from ...", to be shown to the user once
};

// Reads a channel of a picture as heights. Throws InputError, MemoryError, Cancelled.
HeightImage readHeight(const std::string& path, const HeightReadOptions& options, Work& work);

// Reads a colour picture as linear light: integer formats are converted from sRGB, float formats (EXR, HDR) are taken
// as linear, and grey is copied to three channels. Alpha is ignored (colours are not premultiplied). Throws InputError,
// MemoryError, Cancelled.
ColorImage readColor(const std::string& path, Work& work, std::int64_t maxPixels = kDefaultMaxPixels);
// Reads unit normals (OpenGL convention: x right, y up, z outwards) as n = 2 c - 1, normalised; a zero vector becomes
// (0, 0, 1). Values are not colour-converted. Throws InputError, MemoryError, Cancelled.
Image<glm::vec3> readNormals(const std::string& path, Work& work, std::int64_t maxPixels = kDefaultMaxPixels);

// The sRGB transfer function in both directions (IEC 61966-2-1); values are not clamped.
float linearFromSrgb(float encoded);
float srgbFromLinear(float linear);

// Writes a picture of linear colours; the extension determines the format. 8-bit formats and PNG: sRGB with 8 bits,
// clamped, NaN as 0; EXR and HDR: linear floats. bandText, of a band of rows of a larger picture: printable ASCII,
// stored in the file (PNG, TIFF or EXR), by which bands are joined (picture_bands.h). Throws InputError for unknown
// formats, WorkError.
void writeColor(const std::string& path, const ColorImage& image, const std::string& bandText = {});
// Writes heights. PNG and TIFF: 16 bits by the full range; EXR, and TIFF with asFloat: 32-bit floats, unchanged. Throws
// InputError for unknown formats, WorkError.
void writeHeight(const std::string& path, const FloatImage& heights, bool asFloat = false);

// One named float plane of a multi-channel picture ("depth.Z", "color.R", ...).
struct NamedPlane {
    std::string name;
    FloatImage plane;
};
// Writes 32-bit float OpenEXR with the planes in the given order, at least one and all of one size. bandText: as for
// writeColor(). Throws InputError if the extension is not .exr, WorkError.
void writePlanes(const std::string& path, const std::vector<NamedPlane>& planes, const std::string& bandText = {});

// An output file that is written under a temporary name in the same folder and renamed when complete, so that readers
// see either the old file or the whole new one. Without commit() the temporary file is removed. "-" is not handled
// here.
class AtomicFile {
  public:
    // Keeps the extension, from which OpenImageIO derives the format.
    explicit AtomicFile(std::string path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    const std::string& temporaryPath() const { return temporary_; }
    // Flushes the file to disk and renames it. Throws WorkError.
    void commit();

  private:
    std::string path_;    // as given, for messages
    std::string target_;  // with symbolic links resolved
    std::string temporary_;
    bool committed_ = false;
};

// Writes a text file by AtomicFile. Throws WorkError (full disk, no permission, ...).
void writeTextFile(const std::string& path, const std::string& text);
// Returns the whole file as bytes. Throws InputError (missing, directory, unreadable).
std::string readTextFile(const std::string& path);

}  // namespace relief
