// One picture file, opened and checked, with samples in the file's own type. Used by the readers of this folder; other
// code uses relief/files.h. Throws as specified there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "relief/files.h"
#include "relief/work.h"

namespace relief {

enum class NumberType : std::uint8_t { UInt8, Int8, UInt16, Int16, UInt32, Int32, Float, Double };

// Converts A to Z to lower case, independently of the locale.
std::string lowerCase(std::string_view text);

// The largest value of an integer type; 0 for floats.
double fullRange(NumberType type);

// Bytes of a number of the type.
std::size_t numberBytes(NumberType type);

// One channel of a block of interleaved samples; pixel i has the sample with index i * stride.
struct RawPlane {
    const std::byte* first = nullptr;
    std::size_t stride = 1;
    NumberType type = NumberType::UInt8;
};

// Calls fn(const T* first) with T the type of the plane's samples.
template <class Function>
decltype(auto) withNumbers(const RawPlane& plane, Function&& fn) {
    const void* first = plane.first;
    switch (plane.type) {
        case NumberType::UInt8:
            return fn(static_cast<const std::uint8_t*>(first));
        case NumberType::Int8:
            return fn(static_cast<const std::int8_t*>(first));
        case NumberType::UInt16:
            return fn(static_cast<const std::uint16_t*>(first));
        case NumberType::Int16:
            return fn(static_cast<const std::int16_t*>(first));
        case NumberType::UInt32:
            return fn(static_cast<const std::uint32_t*>(first));
        case NumberType::Int32:
            return fn(static_cast<const std::int32_t*>(first));
        case NumberType::Float:
            return fn(static_cast<const float*>(first));
        case NumberType::Double:
            break;
    }
    return fn(static_cast<const double*>(first));
}

struct RawPlanes {
    std::vector<std::unique_ptr<std::byte[]>> storage;
    std::vector<RawPlane> planes;  // in the order requested
};

// How the samples of an opened picture are read: all at once, or in bands of rows from top to bottom, for pictures
// larger than memory.
enum class PictureAccess : std::uint8_t { Whole, Rows };

class PictureFile;

class PictureInput {
  public:
    // Checks the file, its format and its size. Allocates nothing proportional to the size of the picture.
    PictureInput(const std::string& path, std::int64_t maxPixels, PictureAccess access = PictureAccess::Whole);
    ~PictureInput();
    PictureInput(const PictureInput&) = delete;
    PictureInput& operator=(const PictureInput&) = delete;

    const ImageInfo& info() const { return info_; }
    // The file's ImageDescription; may be empty.
    std::string description() const;
    // The text that a band was written with (writeColor()); empty if there is none.
    std::string bandText() const;
    // Index of the channel of that name, ignoring case; -1 if there is none.
    int channelIndex(std::string_view name) const;
    // Index of the alpha channel, or -1.
    int alphaChannel() const;

    // Reads these channels, into one block if they are of one type; half floats become float. Throws Cancelled, and
    // MemoryError if the samples and `bytesAfter` bytes per pixel, which the caller needs at the same time, do not fit.
    RawPlanes read(std::span<const int> channels, Work& work, std::size_t bytesAfter);

    // Type of a channel's samples; half floats become float.
    NumberType type(int channel) const;
    // Reads rows [first, first + count) of a channel of a picture opened for PictureAccess::Rows. samples: place for
    // width x count samples of type(channel). Formats that can be decoded only as a whole, and rows of tiles, take more
    // memory, which is checked. Fastest from top to bottom: compressed pictures begin anew for a row that has passed.
    void readRows(int channel, int first, int count, std::byte* samples);

  private:
    std::unique_ptr<PictureFile> file_;
    ImageInfo info_;
};

}  // namespace relief
