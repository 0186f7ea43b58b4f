// Reads pictures through OpenImageIO in bands of rows, for pictures larger than memory. For openimageio_input.cpp.
#pragma once

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "images/file_descriptor.h"
#include "images/picture_bytes.h"

namespace relief {

// A TIFF file that is read from the disk, but without the metadata that hideTiffMetadata() hides.
class TiffOnDisk final : public OIIO::Filesystem::IOProxy {
  public:
    // Throws InputError if the file cannot be read, or is a volume.
    explicit TiffOnDisk(const std::string& path);

    const char* proxytype() const override { return "tiff on disk"; }
    std::size_t size() const override { return size_; }
    std::size_t read(void* bytes, std::size_t count) override;
    std::size_t pread(void* bytes, std::size_t count, std::int64_t offset) override;

  private:
    Descriptor file_;
    std::size_t size_ = 0;
    std::size_t directoryAt_ = 0;
    Bytes directory_;  // with the metadata hidden; replaces the file's bytes from directoryAt_ on
};

// Returns true if OpenImageIO decodes the format by rows or tiles; of others it decodes the whole picture first. head:
// the first bytes of the file.
bool isReadByRows(const std::string& format, std::span<const unsigned char> head);

// Rows of one channel of an open picture, also of one that is stored in tiles.
class RowReader {
  public:
    // Reads rows [first, first + count) in the given type. A row of tiles is kept, so that bands may be lower than
    // tiles. Returns false if OpenImageIO fails.
    bool read(OIIO::ImageInput& input, int channel, OIIO::TypeDesc type, int first, int count, std::byte* samples);

    // Bytes that a picture's row of tiles takes; 0 if it is stored in rows.
    static std::uint64_t keptBytes(const OIIO::ImageSpec& spec);

  private:
    int begin_ = 0, end_ = 0;  // rows kept
    int channel_ = -1;
    std::vector<std::byte> rows_;
};

}  // namespace relief
