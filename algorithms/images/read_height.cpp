#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "base/parallel.h"
#include "images/picture_input.h"

namespace relief {

namespace {

// Digits of numbers in messages: enough to distinguish any two floats.
constexpr int kSentenceDigits = 9;
constexpr std::size_t kGrain = std::size_t{1} << 15;

// Statistics of all samples, collected in one pass.
struct Survey {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    std::size_t firstBad = std::numeric_limits<std::size_t>::max();  // index of the first NaN or infinity
    std::size_t outside = 0;                                         // number of samples outside the given bounds
};

Survey merged(const Survey& a, const Survey& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high), std::min(a.firstBad, b.firstBad), a.outside + b.outside};
}

template <class T>
Survey surveyed(const T* numbers, std::size_t first, std::size_t last, std::size_t stride, double low, double high) {
    Survey survey;
    for (std::size_t i = first; i < last; ++i) {
        const auto value = static_cast<double>(numbers[i * stride]);
        if (!std::isfinite(value)) {
            survey.firstBad = std::min(survey.firstBad, i);
            continue;
        }
        survey.low = std::min(survey.low, value);
        survey.high = std::max(survey.high, value);
        survey.outside += static_cast<std::size_t>(value < low || value > high);
    }
    return survey;
}

Survey survey(const RawPlane& plane, std::size_t count, double low, double high, Work& work) {
    return withNumbers(plane, [&](const auto* numbers) {
        const auto of = [&](std::size_t first, std::size_t last) {
            return surveyed(numbers, first, last, plane.stride, low, high);
        };
        return parallelReduce(work, count, kGrain, of, merged);
    });
}

// h = (value - low) / (high - low), clamped to [0, 1]; 0 if flat. Computed in double, rounded to float once.
struct Scaling {
    double low = 0;
    double high = 1;
    bool flat = false;
    bool invert = false;

    float operator()(double number) const {
        double h = 0;
        if (!flat) {
            // high - low may overflow; multiplying by 1 or 0.5 is exact.
            const double unit = std::isfinite(high - low) ? 1 : 0.5;
            h = (number * unit - low * unit) / (high * unit - low * unit);
            h = std::clamp(h, 0.0, 1.0);
        }
        return static_cast<float>(invert ? 1 - h : h);
    }
};

void scale(const RawPlane& plane, const Scaling& scaling, FloatImage& heights, Work& work) {
    const std::span<float> out = heights.pixels();
    withNumbers(plane, [&](const auto* numbers) {
        parallelRanges(work, out.size(), kGrain, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) out[i] = scaling(static_cast<double>(numbers[i * plane.stride]));
        });
    });
}

std::string inSentence(double value) {
    return numberText(value, kSentenceDigits);
}

// Returns the scaling for the requested range, and adds to `notes` what the user should be told about it.
Scaling chosenScaling(const HeightRange& range, double full, const Survey& survey, const std::string& path,
                      std::vector<Message>& notes) {
    const std::string low = inSentence(survey.low);
    const std::string high = inSentence(survey.high);
    if (range.kind == HeightRange::Kind::Bounds) {
        if (survey.outside > 0)
            notes.emplace_back(MessageId::HeightsClamped, std::vector<MessageValue>{{"count", survey.outside},
                                                                                    {"low", inSentence(range.low)},
                                                                                    {"high", inSentence(range.high)}});
        return {range.low, range.high};
    }
    if (full > 0) {
        if (survey.outside > 0)
            notes.emplace_back(MessageId::HeightsNegative,
                               std::vector<MessageValue>{{"count", survey.outside}, {"low", low}});
        return {0, full};
    }
    if (survey.outside == 0) return {0, 1};
    if (range.kind == HeightRange::Kind::Full)
        throw InputError(path, Message(MessageId::HeightsOutside, {{"low", low}, {"high", high}}));
    if (survey.low == survey.high) {
        notes.emplace_back(MessageId::HeightsFlat, std::vector<MessageValue>{{"value", low}});
        return {.flat = true};
    }
    notes.emplace_back(MessageId::HeightsStretched, std::vector<MessageValue>{{"low", low}, {"high", high}});
    return {survey.low, survey.high};
}

std::string channelList(const std::vector<std::string>& channels) {
    std::string list;
    for (std::size_t c = 0; c < channels.size(); ++c)
        list += (c == 0 ? "" : ", ") + std::to_string(c) + " " + channels[c];
    return list;
}

int chosenChannel(const PictureInput& input, const std::string& channel) {
    const std::vector<std::string>& channels = input.info().channels;
    if (channel.empty()) return std::max(0, input.channelIndex("Y"));
    std::size_t number = 0;
    const char* end = channel.data() + channel.size();
    const auto parsed = std::from_chars(channel.data(), end, number);
    if (parsed.ec == std::errc() && parsed.ptr == end) {
        if (number < channels.size()) return static_cast<int>(number);
    } else if (const int index = input.channelIndex(channel); index >= 0) {
        return index;
    } else if (channel.size() == 5 && input.alphaChannel() >= 0) {
        // Accepts "alpha" in any case for the channel that files call "A".
        const std::string_view alpha = "alpha";
        if (std::equal(alpha.begin(), alpha.end(), channel.begin(),
                       [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); }))
            return input.alphaChannel();
    }
    throw InputError(input.info().path,
                     Message(MessageId::ChannelMissing, {{"name", channel}, {"known", channelList(channels)}}));
}

double numberAt(const RawPlane& plane, std::size_t i) {
    return withNumbers(plane, [&](const auto* numbers) { return static_cast<double>(numbers[i * plane.stride]); });
}

}  // namespace

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
    const double full = fullRange(plane.type);

    const auto width = static_cast<std::size_t>(image.info.width);
    const bool bounds = options.range.kind == HeightRange::Kind::Bounds;
    const double low = bounds ? options.range.low : 0;
    const double high = bounds ? options.range.high : full > 0 ? full : 1;
    const Survey found = survey(plane, width * static_cast<std::size_t>(image.info.height), low, high, work);
    if (found.firstBad != std::numeric_limits<std::size_t>::max())
        throw InputError(path, Message(MessageId::HeightNotFinite, {{"x", found.firstBad % width},
                                                                    {"y", found.firstBad / width},
                                                                    {"value", numberAt(plane, found.firstBad)}}));
    image.fileLow = found.low;
    image.fileHigh = found.high;
    Scaling scaling = chosenScaling(options.range, full, found, path, image.notes);
    scaling.invert = options.invert;
    image.heights = FloatImage(image.info.width, image.info.height);
    scale(plane, scaling, image.heights, work);
    return image;
}

}  // namespace relief
