#include "filtering/sampler.h"

#include <array>
#include <cmath>

#include "errors.h"

namespace relief {

namespace {

constexpr std::array<std::string_view, 2> kPixelModels{"box", "gaussian"};

// Whole part and rest, reduced first under repeat so that far-off points keep their digits.
struct Split {
    std::int64_t index;
    float rest;
};

Split split(double x, int size, Address address) {
    if (address == Address::Repeat) {
        if (x < 0 || x >= size) x = std::fmod(x, size);
    } else {
        x = std::clamp(x, -1.0, size + 1.0);
    }
    const double whole = std::floor(x);
    return {static_cast<std::int64_t>(whole), static_cast<float>(x - whole)};
}

}  // namespace

const std::vector<FilterDescription>& filterList() {
    static const std::vector<FilterDescription> list{
        {"nearest", "the texel that holds the point"},
        {"bilinear", "the four texels around the point, weighted by closeness"},
        {std::string(kSupersample), "many rays a pixel, traced and lit one by one: the picture's truth, slow"},
    };
    return list;
}

const FilterDescription& findFilter(std::string_view name) {
    std::string known;
    for (const FilterDescription& filter : filterList()) {
        if (filter.name == name) return filter;
        known += (known.empty() ? "" : ", ") + filter.name;
    }
    throw InputError("--filter", Message(MessageId::UnknownName,
                                         {{"what", "filter"}, {"name", std::string(name)}, {"known", known}}));
}

std::string_view pixelModelName(PixelModel model) {
    return kPixelModels[static_cast<std::size_t>(model)];
}

PixelModel parsePixelModel(std::string_view text) {
    for (std::size_t i = 0; i < kPixelModels.size(); ++i) {
        if (kPixelModels[i] == text) return static_cast<PixelModel>(i);
    }
    throw InputError("--pixel-model",
                     Message(MessageId::UnknownName,
                             {{"what", "pixel model"}, {"name", std::string(text)}, {"known", "box, gaussian"}}));
}

Color sampleNearest(const ColorImage& image, double s, double t, Address address) {
    const int x = addressIndex(split(s, image.width(), address).index, image.width(), address);
    const int y = addressIndex(split(t, image.height(), address).index, image.height(), address);
    return image(x, y);
}

Color sampleBilinear(const ColorImage& image, double s, double t, Address address) {
    const Split x = split(s - 0.5, image.width(), address);
    const Split y = split(t - 0.5, image.height(), address);
    const int x0 = addressIndex(x.index, image.width(), address);
    const int x1 = addressIndex(x.index + 1, image.width(), address);
    const int y0 = addressIndex(y.index, image.height(), address);
    const int y1 = addressIndex(y.index + 1, image.height(), address);
    const Color top = (1 - x.rest) * image(x0, y0) + x.rest * image(x1, y0);
    const Color bottom = (1 - x.rest) * image(x0, y1) + x.rest * image(x1, y1);
    return (1 - y.rest) * top + y.rest * bottom;
}

}  // namespace relief
