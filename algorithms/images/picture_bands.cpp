#include "images/picture_bands.h"

#include <cstring>
#include <numeric>

#include "images/picture_input.h"
#include "relief/memory.h"

namespace relief {

namespace {

bool sameShape(const ImageInfo& a, const ImageInfo& b) {
    return a.format == b.format && a.width == b.width && a.channels == b.channels && a.type == b.type &&
           a.colorSpace == b.colorSpace;
}

std::size_t bytesOf(NumberType type) {
    return withNumbers({nullptr, 1, type}, [](const auto* number) { return sizeof *number; });
}

// The samples of one band, channels interleaved. Throws InputError if the channels differ in type.
struct BandNumbers {
    RawPlanes raw;
    std::size_t bytes = 0;

    BandNumbers(PictureInput& input, const std::string& path, Work& work) {
        const ImageInfo& info = input.info();
        std::vector<int> channels(info.channels.size());
        std::iota(channels.begin(), channels.end(), 0);
        raw = input.read(channels, work, 0);
        if (raw.storage.size() != 1) {
            throw InputError(path, Message(MessageId::PictureNumberType, {{"type", info.type + ", ..."}}));
        }
        bytes = static_cast<std::size_t>(info.width) * static_cast<std::size_t>(info.height) * channels.size() *
                bytesOf(raw.planes.front().type);
    }
};

}  // namespace

BandFile readBandFile(const std::string& path) {
    const PictureInput input(path, kMostBandPixels, PictureAccess::Rows);
    return {input.info(), input.bandText()};
}

void joinBands(const std::vector<std::string>& bands, const std::string& path, Work& work) {
    ImageInfo whole;
    std::int64_t height = 0;
    for (const std::string& band : bands) {
        const ImageInfo info = PictureInput(band, kMostBandPixels).info();
        if (height == 0) whole = info;
        if (!sameShape(info, whole)) throw InputError(band, Message(MessageId::BandMisfit, {{"other", bands.front()}}));
        height += info.height;
    }
    if (whole.width <= 0 || height > kMostBandPixels / whole.width) {
        throw InputError(path, Message(MessageId::PictureTooLarge,
                                       {{"width", whole.width}, {"height", height}, {"limit", kMostBandPixels}}));
    }
    whole.height = static_cast<int>(height);
    std::vector<std::byte> numbers;
    std::size_t done = 0;
    for (const std::string& band : bands) {
        PictureInput input(band, kMostBandPixels);
        const auto rows = static_cast<std::uint64_t>(input.info().height);
        // The file may have changed since the first loop.
        if (!sameShape(input.info(), whole)) throw InputError(band, Message(MessageId::FileTruncated));
        const BandNumbers part(input, band, work);
        if (numbers.empty()) {
            const std::uint64_t bytes = byteProduct({part.bytes / rows, static_cast<std::uint64_t>(height)});
            requireMemory(bytes, path);
            numbers.resize(bytes);
        }
        if (part.bytes > numbers.size() - done) throw InputError(band, Message(MessageId::FileTruncated));
        std::memcpy(numbers.data() + done, part.raw.storage.front().get(), part.bytes);
        done += part.bytes;
    }
    writeNumbers(path, whole, numbers.data());
}

}  // namespace relief
