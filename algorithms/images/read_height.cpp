#include <charconv>
#include <cmath>
#include <optional>

#include "images/height_scaling.h"

namespace relief {

HeightRange parseHeightRange(const std::string& text) {
    if (text == "auto") return {};
    if (text == "full") return {.kind = HeightRange::Kind::Full};
    HeightRange range{.kind = HeightRange::Kind::Bounds};
    const char* end = text.data() + text.size();
    const auto low = std::from_chars(text.data(), end, range.low);
    if (low.ec == std::errc() && low.ptr != end && *low.ptr == ',') {
        const auto high = std::from_chars(low.ptr + 1, end, range.high);
        const bool finite = std::isfinite(range.low) && std::isfinite(range.high);
        if (high.ec == std::errc() && high.ptr == end && finite && range.low < range.high) return range;
    }
    throw InputError("--range", Message(MessageId::RangeSyntax, {{"text", text}}));
}

std::string heightRangeText(const HeightRange& range) {
    if (range.kind == HeightRange::Kind::Auto) return "auto";
    if (range.kind == HeightRange::Kind::Full) return "full";
    return numberText(range.low) + "," + numberText(range.high);
}

HeightImage readHeight(const std::string& path, const HeightReadOptions& options, Work& work) {
    std::optional<PictureInput> input(std::in_place, path, options.maxPixels);
    HeightImage image;
    image.info = input->info();
    const int channel = chosenChannel(*input, options.channel);
    image.channel = image.info.channels[static_cast<std::size_t>(channel)];
    const RawPlanes raw = input->read({&channel, 1}, work, sizeof(float));
    // Release the file's bytes before allocating the heights: for a large map each is a gigabyte.
    input.reset();
    const RawPlane& plane = raw.planes.front();

    const auto width = static_cast<std::size_t>(image.info.width);
    const std::size_t count = width * static_cast<std::size_t>(image.info.height);
    const Survey found = survey(plane, count, sampleBounds(options.range, plane.type), work);
    if (!found.finite()) throw notFinite(plane, found.firstBad, found.firstBad % width, found.firstBad / width, path);
    image.fileLow = found.low;
    image.fileHigh = found.high;
    const HeightScaling scaling = chosenScaling(options, plane.type, found, path, image.notes);
    image.heights = FloatImage(image.info.width, image.info.height);
    scale(plane, scaling, image.heights.pixels(), work);
    return image;
}

}  // namespace relief
