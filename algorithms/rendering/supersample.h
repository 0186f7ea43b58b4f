// The reference picture: N x N view rays per pixel, each traced, coloured (bilinear, at the texture's full resolution)
// and lit separately; their linear light is averaged with the weights of a pixel model.
//
// Samples lie at the centres of N x N equal parts of every pixel. A pass takes the same part in every pixel, as a frame
// of its own whose camera is shifted by less than a pixel; memory therefore does not depend on N, and one sample per
// pixel gives the plain frame, bit for bit. Passes come in a low-discrepancy order, so that the first passes are
// uniformly distributed and their mean is a usable picture.
// Box: a pixel is the mean of its own samples; lcd: each channel is the mean over its stripe. Gaussian, crt: samples up
// to kGaussianReach pixels from the pixel's centre, including those in neighbouring pixels and beyond the picture's
// edges, are weighted by exp(-d^2 / (2 sigma^2)) and divided by the sum of weights. The bits are equal for any number
// of threads: sums are formed pixel by pixel in the order of the passes. Cost: N x N frames.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "rendering/frame.h"

namespace relief {

// Neighbours on each side. The reach is five sigma: samples beyond weigh 4e-6 of the centre.
inline constexpr int kGaussianRing = 2;  // neighbours on each side
inline constexpr double kGaussianReach = kGaussianRing + 0.5;

// Returns all parts (column, row) of an N x N pixel in the order of the passes, by Roberts' R2 sequence.
std::vector<glm::ivec2> sampleOrder(int samples);

// Returns the weights, along one axis and in one channel, of a sample at `place` in [0, 1) of its pixel's square, for
// the pixels n = -2 .. 2 to the right of (below) the sample's own.
enum class PixelAxis : std::uint8_t { Across, Down };
using SampleWeights = std::array<double, 2 * kGaussianRing + 1>;
SampleWeights sampleWeights(PixelModel model, PixelAxis axis, int channel, double place);

// Weighted sums of passes. A pass is a frame with `margin()` more pixels on every side.
class SampleSums {
  public:
    SampleSums(int width, int height, PixelModel model)
        : SampleSums(width, height, model,
                     model == PixelModel::Gaussian || model == PixelModel::Crt ? kGaussianRing : 0) {}
    // For several models that use the same passes, whose margin suits all of them.
    SampleSums(int width, int height, PixelModel model, int margin);

    int margin() const { return margin_; }
    // Adds a pass. place: position of its samples in their pixels, [0, 1]^2.
    void add(const ColorImage& pass, glm::dvec2 place, Work& work);
    // Returns true if every channel has received a sample.
    bool complete() const { return weight_.x > 0 && weight_.y > 0 && weight_.z > 0; }
    ColorImage mean(Work& work) const;  // requires complete()

  private:
    PixelModel model_;
    int margin_;
    Image<glm::dvec3> sums_;
    glm::dvec3 weight_{0};  // equal for all pixels
};

// A sample of one pixel that met the relief: the point where its colour is looked up, texels of the height map, and its
// share of the pixel in each channel. The shares of samples without a hit are missing from the sum.
struct PixelSample {
    glm::dvec2 place{0};
    Color share{0};
};
// Returns the samples that contribute to pixel (x, y) of the request's frame. tracer: of the request's method and
// heights. Cost: N x N rays, for gaussian and crt also those of the neighbouring pixels. Throws Cancelled.
std::vector<PixelSample> pixelSamples(const FrameRequest& request, const Tracer& tracer, int x, int y, Work& work);

// A pass as a frame of its own, and the shares of its samples in one pixel of the request's frame. (x, y): the sample's
// pixel, relative to that pixel; 0, 0 for models that do not reach beyond it. Over all passes the shares of a channel
// sum to 1. The frame of a pass begins `margin - request.margin` pixels farther to the left and above.
struct SampleShare {
    int x = 0;
    int y = 0;
    glm::dvec3 share{0};
};
struct SamplePass {
    FrameRequest request;
    std::vector<SampleShare> shares;
};
// Returns the passes in the order in which supersampled() makes them.
std::vector<SamplePass> samplePasses(const FrameRequest& request);

// Returns the supersampled picture of the request, whose filter gives N and the model; all other settings are used
// unchanged. Adds the counters CountSamples, CountSampleRays and, if the request counts, CountSampleSteps. rows: the
// rows to make, which alone are returned; empty: all. Throws what FrameRenderer::render throws.
ColorImage supersampled(const FrameRequest& request, const std::shared_ptr<MapCache>& maps, Work& work,
                        const FrameRenderer::Snapshot& snapshot, std::map<MessageId, double>& counters,
                        RowRange rows = {});

}  // namespace relief
