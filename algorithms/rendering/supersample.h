// The picture's truth: N x N view rays a pixel, each traced, coloured (bilinear, at the texture's own resolution) and
// lit by itself; their linear light is averaged with the weights of a pixel model.
//
// Samples lie at the centres of N x N equal parts of every pixel. A pass takes the same one in every pixel, as a frame
// of its own whose camera is shifted by less than a pixel; so memory does not depend on N, and one sample a pixel is
// the plain frame, bit for bit. Passes come in a low-discrepancy order: any first few of them are spread evenly, and
// the mean of them is a usable picture.
// Box: a pixel is the mean of its own samples; lcd: each channel that of its stripe. Gaussian, crt: samples up to
// kGaussianReach pixels from the pixel's centre, in neighbouring pixels and beyond the picture's edges too, weighted by
// exp(-d^2 / (2 sigma^2)) and divided by the sum. Equal bits for any number of threads: sums are taken pixel by pixel
// in the order of the passes. Cost: N x N frames.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "rendering/frame.h"

namespace relief {

// Five sigma: what lies beyond weighs 4e-6 of the centre.
inline constexpr int kGaussianRing = 2;  // neighbours on each side
inline constexpr double kGaussianReach = kGaussianRing + 0.5;

// All parts (column, row) of an N x N pixel in the order of the passes, by Roberts' R2 sequence.
std::vector<glm::ivec2> sampleOrder(int samples);

// Along one axis: weight in a channel of a sample at `place` in [0, 1) of the pixel's square, for the pixel
// n = -2 .. 2 to the right of (below) the sample's own.
enum class PixelAxis : std::uint8_t { Across, Down };
using SampleWeights = std::array<double, 2 * kGaussianRing + 1>;
SampleWeights sampleWeights(PixelModel model, PixelAxis axis, int channel, double place);

// Weighted sums of passes. A pass is a frame with `margin()` pixels more on every side.
class SampleSums {
  public:
    SampleSums(int width, int height, PixelModel model)
        : SampleSums(width, height, model,
                     model == PixelModel::Gaussian || model == PixelModel::Crt ? kGaussianRing : 0) {}
    // For several models side by side: passes with a margin that suits all of them.
    SampleSums(int width, int height, PixelModel model, int margin);

    int margin() const { return margin_; }
    // place: of the samples in their pixels, [0, 1]^2. rows: those whose sums are wanted; empty: all.
    void add(const ColorImage& pass, glm::dvec2 place, Work& work, RowRange rows = {});
    // Whether every channel has seen a sample.
    bool complete() const { return weight_.x > 0 && weight_.y > 0 && weight_.z > 0; }
    ColorImage mean(Work& work) const;  // complete

  private:
    PixelModel model_;
    int margin_;
    Image<glm::dvec3> sums_;
    glm::dvec3 weight_{0};  // the same for all pixels
};

// A sample of one pixel that met the relief: where colours are looked up, texels of the height map, and its part of the
// pixel in each channel. What samples that met nothing count is missing from their sum.
struct PixelSample {
    glm::dvec2 place{0};
    Color share{0};
};
// Those that count for pixel (x, y) of the request's frame, through `tracer`, which is of its method and heights. Cost:
// N x N rays, with gaussian and crt those of the neighbours, too. Throws Cancelled.
std::vector<PixelSample> pixelSamples(const FrameRequest& request, const Tracer& tracer, int x, int y, Work& work);

// The supersampled picture of the request (whose filter says N and model); every other setting as it stands. Adds
// counters CountSamples, CountSampleRays and, where the request wants counts, CountSampleSteps. rows: those
// that are wanted, of a picture of the whole size; empty: all.
ColorImage supersampled(const FrameRequest& request, const std::shared_ptr<MapCache>& maps, Work& work,
                        const FrameRenderer::Snapshot& snapshot, std::map<MessageId, double>& counters,
                        RowRange rows = {});

}  // namespace relief
