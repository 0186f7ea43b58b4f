#include "images/height_scaling.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/parallel.h"

namespace relief {

namespace {

// Digits of numbers in messages: enough to distinguish any two floats.
constexpr int kSentenceDigits = 9;
constexpr std::size_t kGrain = std::size_t{1} << 15;

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

std::string inSentence(double value) {
    return numberText(value, kSentenceDigits);
}

std::string channelList(const std::vector<std::string>& channels) {
    std::string list;
    for (std::size_t c = 0; c < channels.size(); ++c)
        list += (c == 0 ? "" : ", ") + std::to_string(c) + " " + channels[c];
    return list;
}

double numberAt(const RawPlane& plane, std::size_t i) {
    return withNumbers(plane, [&](const auto* numbers) { return static_cast<double>(numbers[i * plane.stride]); });
}

}  // namespace

Survey merged(const Survey& a, const Survey& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high), std::min(a.firstBad, b.firstBad), a.outside + b.outside};
}

SampleBounds sampleBounds(const HeightRange& range, NumberType type) {
    if (range.kind == HeightRange::Kind::Bounds) return {range.low, range.high};
    const double full = fullRange(type);
    return {0, full > 0 ? full : 1};
}

Survey survey(const RawPlane& plane, std::size_t count, SampleBounds bounds, Work& work) {
    return withNumbers(plane, [&](const auto* numbers) {
        const auto of = [&](std::size_t first, std::size_t last) {
            return surveyed(numbers, first, last, plane.stride, bounds.low, bounds.high);
        };
        return parallelReduce(work, count, kGrain, of, merged);
    });
}

InputError notFinite(const RawPlane& plane, std::size_t i, std::size_t x, std::size_t y, const std::string& path) {
    return {path, Message(MessageId::HeightNotFinite, {{"x", x}, {"y", y}, {"value", numberAt(plane, i)}})};
}

float HeightScaling::operator()(double number) const {
    double h = 0;
    if (!flat) {
        // high - low may overflow; multiplying by 1 or 0.5 is exact.
        const double unit = std::isfinite(high - low) ? 1 : 0.5;
        h = (number * unit - low * unit) / (high * unit - low * unit);
        h = std::clamp(h, 0.0, 1.0);
    }
    return static_cast<float>(invert ? 1 - h : h);
}

void scale(const RawPlane& plane, const HeightScaling& given, std::span<float> out, Work& work) {
    const HeightScaling scaling = given;
    withNumbers(plane, [&](const auto* numbers) {
        parallelRanges(work, out.size(), kGrain, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) out[i] = scaling(static_cast<double>(numbers[i * plane.stride]));
        });
    });
}

HeightScaling chosenScaling(const HeightReadOptions& options, NumberType type, const Survey& survey,
                            const std::string& path, std::vector<Message>& notes) {
    const std::string low = inSentence(survey.low);
    const std::string high = inSentence(survey.high);
    const HeightRange& range = options.range;
    const double full = fullRange(type);
    const auto scaling = [&](double from, double to, bool flat = false) {
        return HeightScaling{from, to, flat, options.invert};
    };
    if (range.kind == HeightRange::Kind::Bounds) {
        if (survey.outside > 0)
            notes.emplace_back(MessageId::HeightsClamped, std::vector<MessageValue>{{"count", survey.outside},
                                                                                    {"low", inSentence(range.low)},
                                                                                    {"high", inSentence(range.high)}});
        return scaling(range.low, range.high);
    }
    if (full > 0) {
        if (survey.outside > 0)
            notes.emplace_back(MessageId::HeightsNegative,
                               std::vector<MessageValue>{{"count", survey.outside}, {"low", low}});
        return scaling(0, full);
    }
    if (survey.outside == 0) return scaling(0, 1);
    if (range.kind == HeightRange::Kind::Full)
        throw InputError(path, Message(MessageId::HeightsOutside, {{"low", low}, {"high", high}}));
    if (survey.low == survey.high) {
        notes.emplace_back(MessageId::HeightsFlat, std::vector<MessageValue>{{"value", low}});
        return scaling(0, 1, true);
    }
    notes.emplace_back(MessageId::HeightsStretched, std::vector<MessageValue>{{"low", low}, {"high", high}});
    return scaling(survey.low, survey.high);
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

}  // namespace relief
