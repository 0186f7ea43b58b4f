#include "filtering/pixel_model.h"

#include <cmath>

#include "relief/errors.h"

namespace relief {

namespace {

double bell(double x, double sigma) {
    return std::abs(x) <= kPixelReach ? std::exp(-0.5 * (x / sigma) * (x / sigma)) : 0.0;
}

// Half-open, so that neighbouring stripes and pixels share no sample.
double inside(double x, double from, double to) {
    return x >= from && x < to ? 1.0 : 0.0;
}

}  // namespace

std::string_view pixelModelName(PixelModel model) {
    return kPixelModelNames[static_cast<std::size_t>(model)];
}

PixelModel parsePixelModel(std::string_view text) {
    std::string known;
    for (std::size_t i = 0; i < kPixelModelNames.size(); ++i) {
        if (kPixelModelNames[i] == text) return static_cast<PixelModel>(i);
        known.append(known.empty() ? "" : ", ").append(kPixelModelNames[i]);
    }
    throw InputError("--pixel-model", unknownName({"what", MessageId::WordPixelModel}, std::string(text), known));
}

double pixelFactorAcross(PixelModel model, int channel, double dx) {
    switch (model) {
        case PixelModel::Box:
            return inside(dx, -0.5, 0.5);
        case PixelModel::Gaussian:
            return bell(dx, kGaussianSigma);
        case PixelModel::Lcd:
            return inside(dx, channel / 3.0 - 0.5, (channel + 1) / 3.0 - 0.5);
        case PixelModel::Crt:
            break;
    }
    constexpr std::array<double, 3> kSpots{-0.25, 0.25, 0.0};
    return bell(dx - kSpots[static_cast<std::size_t>(channel)], kCrtSigma);
}

double pixelFactorDown(PixelModel model, int channel, double dy) {
    switch (model) {
        case PixelModel::Box:
        case PixelModel::Lcd:
            return inside(dy, -0.5, 0.5);
        case PixelModel::Gaussian:
            return bell(dy, kGaussianSigma);
        case PixelModel::Crt:
            break;
    }
    return bell(dy - (channel == 2 ? kCrtCircle : -0.5 * kCrtCircle), kCrtSigma);
}

}  // namespace relief
