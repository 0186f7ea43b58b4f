#include "images/picture_input.h"

#include <algorithm>
#include <limits>

#include "images/picture_bands.h"
#include "images/picture_library.h"

namespace relief {

std::string lowerCase(std::string_view text) {
    std::string out(text);
    for (char& c : out)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return out;
}

double fullRange(NumberType type) {
    switch (type) {
        case NumberType::UInt8:
            return std::numeric_limits<std::uint8_t>::max();
        case NumberType::Int8:
            return std::numeric_limits<std::int8_t>::max();
        case NumberType::UInt16:
            return std::numeric_limits<std::uint16_t>::max();
        case NumberType::Int16:
            return std::numeric_limits<std::int16_t>::max();
        case NumberType::UInt32:
            return std::numeric_limits<std::uint32_t>::max();
        case NumberType::Int32:
            return std::numeric_limits<std::int32_t>::max();
        case NumberType::Float:
        case NumberType::Double:
            break;
    }
    return 0;
}

std::size_t numberBytes(NumberType type) {
    return withNumbers({nullptr, 1, type}, [](const auto* number) { return sizeof *number; });
}

PictureInput::PictureInput(const std::string& path, std::int64_t maxPixels, PictureAccess access)
    : file_(pictureLibrary().open(path, maxPixels, access)), info_(file_->info()) {}

PictureInput::~PictureInput() = default;

std::string PictureInput::description() const {
    return file_->attribute("ImageDescription");
}

std::string PictureInput::bandText() const {
    return info_.format == "tiff" ? description() : file_->attribute(std::string(kBandAttribute));
}

int PictureInput::channelIndex(std::string_view name) const {
    const std::string lowerName = lowerCase(name);
    const auto found = std::find_if(info_.channels.begin(), info_.channels.end(),
                                    [&](const std::string& channel) { return lowerCase(channel) == lowerName; });
    return found == info_.channels.end() ? -1 : static_cast<int>(found - info_.channels.begin());
}

int PictureInput::alphaChannel() const {
    const int declared = file_->alphaChannel();
    return declared >= 0 ? declared : channelIndex("A");
}

RawPlanes PictureInput::read(std::span<const int> channels, Work& work, std::size_t bytesAfter) {
    return file_->read(channels, work, bytesAfter);
}

NumberType PictureInput::type(int channel) const {
    return file_->type(channel);
}

void PictureInput::readRows(int channel, int first, int count, std::byte* samples) {
    file_->readRows(channel, first, count, samples);
}

ImageInfo readImageInfo(const std::string& path, std::int64_t maxPixels) {
    return PictureInput(path, maxPixels).info();
}

}  // namespace relief
