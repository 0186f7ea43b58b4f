// How the numbers of a height file become heights in [0, 1]: for readers of whole pictures and of bands of rows.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "images/picture_input.h"

namespace relief {

// Statistics of samples, collected in one pass.
struct Survey {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    std::size_t firstBad = std::numeric_limits<std::size_t>::max();  // index of the first NaN or infinity
    std::size_t outside = 0;                                         // number of samples outside the given bounds

    bool finite() const { return firstBad == std::numeric_limits<std::size_t>::max(); }
};
Survey merged(const Survey& a, const Survey& b);

// Bounds beyond which samples are counted as outside: those of the range, or of the type.
struct SampleBounds {
    double low = 0, high = 1;
};
SampleBounds sampleBounds(const HeightRange& range, NumberType type);
// Surveys the first `count` samples in parallel.
Survey survey(const RawPlane& plane, std::size_t count, SampleBounds bounds, Work& work);
// The error for sample i of the plane, which is NaN or infinite. x, y: its texel.
InputError notFinite(const RawPlane& plane, std::size_t i, std::size_t x, std::size_t y, const std::string& path);

// h = (value - low) / (high - low), clamped to [0, 1]; 0 if flat. Computed in double, rounded to float once.
struct HeightScaling {
    double low = 0;
    double high = 1;
    bool flat = false;
    bool invert = false;

    float operator()(double number) const;
};
// Converts as many samples as `heights` has, in parallel.
void scale(const RawPlane& plane, const HeightScaling& scaling, std::span<float> heights, Work& work);

// Returns the scaling for the requested range, and adds to `notes` what the user should be told about it. Throws
// InputError if the range excludes the samples.
HeightScaling chosenScaling(const HeightReadOptions& options, NumberType type, const Survey& survey,
                            const std::string& path, std::vector<Message>& notes);

// Index of the channel of this name or number; of the usual one if empty. Throws InputError.
int chosenChannel(const PictureInput& input, const std::string& channel);

}  // namespace relief
