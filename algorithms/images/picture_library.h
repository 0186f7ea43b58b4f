// The part of reading and writing pictures that needs OpenImageIO, behind one table of functions. Everything else in
// this folder compiles and links without it: a program that defines pictureLibrary() itself can load OpenImageIO, and
// the two hundred libraries that it depends on, when the first picture is opened.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "images/described_tiff.h"
#include "images/picture_input.h"

namespace relief {

// One picture file, opened and checked. PictureInput calls these functions and documents them.
class PictureFile {
  public:
    PictureFile() = default;
    virtual ~PictureFile() = default;
    PictureFile(const PictureFile&) = delete;
    PictureFile& operator=(const PictureFile&) = delete;

    virtual ImageInfo info() const = 0;
    // A text attribute; empty if the file has none of that name.
    virtual std::string attribute(const std::string& name) const = 0;
    // Index of the channel that the file declares as alpha, or -1.
    virtual int alphaChannel() const = 0;
    virtual RawPlanes read(std::span<const int> channels, Work& work, std::size_t bytesAfter) = 0;
    virtual NumberType type(int channel) const = 0;
    virtual void readRows(int channel, int first, int count, std::byte* samples) = 0;
};

// A picture to be written. numbers: samples row by row, the channels of a pixel interleaved, of `type`, but float where
// that is half.
struct PictureBlock {
    int width = 0;
    int height = 0;
    std::vector<std::string> channels;
    std::string type;                                             // as ImageInfo::type
    std::vector<std::pair<std::string, std::string>> attributes;  // by OpenImageIO's names
    const void* numbers = nullptr;
};

struct PictureLibrary {
    // Opens and checks a picture. path: UTF-8. Throws InputError, MemoryError.
    std::unique_ptr<PictureFile> (*open)(const std::string& path, std::int64_t maxPixels, PictureAccess access);
    // Writes a picture. format: OpenImageIO's name ("png", "openexr", ...). The file appears when it is complete.
    // Throws WorkError.
    void (*write)(const std::string& path, const std::string& format, const PictureBlock& block);
    // As writeMipTiff(), for a path that ends in .tif or .tiff.
    void (*writeTiffPages)(const std::string& path, const std::vector<DescribedPage>& pages);
};

// The implementations linked with OpenImageIO: openimageio_input.cpp and openimageio_output.cpp.
std::unique_ptr<PictureFile> openWithOpenImageIo(const std::string& path, std::int64_t maxPixels, PictureAccess access);
void writeWithOpenImageIo(const std::string& path, const std::string& format, const PictureBlock& block);
void writePagesWithOpenImageIo(const std::string& path, const std::vector<DescribedPage>& pages);
inline constexpr PictureLibrary kOpenImageIo{&openWithOpenImageIo, &writeWithOpenImageIo, &writePagesWithOpenImageIo};

// The table that the functions of relief/files.h use: kOpenImageIo, unless the program defines this function.
// Thread-safe.
const PictureLibrary& pictureLibrary();

}  // namespace relief
