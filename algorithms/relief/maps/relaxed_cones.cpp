// Relaxed cones. Policarpo & Oliveira 2007 (GPU Gems 3, ch. 18), along sampled azimuths.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "base/scratch_pool.h"
#include "relief/maps/cone_builders.h"
#include "relief/maps/relaxed_cone_lanes.h"
#include "relief/memory.h"

namespace relief {

namespace {

double azimuth(int n, int directions) {
    return 2 * std::numbers::pi * n / directions;
}

// The slope kappa (height per texel) of the widest cone with its apex at h[0] of a profile h[0], h[1], ... such that a
// ray from above the apex (at the top of the slab) that enters the surface at sample j leaves it only outside of the
// cone.
double slopeOfProfile(const std::vector<double>& h) {
    double kappa = 0;
    const auto count = static_cast<int>(h.size());
    for (int j = 1; j < count; ++j) {
        // The ray leaves the surface no nearer than j and no higher than h[j].
        if (h[static_cast<std::size_t>(j)] - h.front() <= kappa * j) continue;
        // The ray from (0, 1) to (j, h[j]), where it is on the surface, and so in it; it leaves at the first sample
        // behind that is not above it. A ray that only touches a peak leaves it at the next sample.
        const double slope = (h[static_cast<std::size_t>(j)] - 1) / j;
        for (int k = j + 1; k < count; ++k) {
            const double ray = 1 + slope * k;
            if (ray < h[static_cast<std::size_t>(k)]) continue;
            const double rise = ray - h.front();
            if (rise > 0) kappa = std::max(kappa, rise / k);
            break;
        }
    }
    return kappa;
}

constexpr int kStripRows = 16;

// Rows of texels with the heights around them, as the field's addressing continues them.
class RelaxedStrip {
  public:
    RelaxedStrip(const HeightField& field, int directions, int reach) : field_(field), margin_(reach + kRelaxedMargin) {
        const bool clamps = field.address() != Address::Repeat;
        row_.width = field.width();
        row_.azimuths = directions;
        row_.reach = reach;
        row_.bilinear = field.surface() == Surface::Bilinear;
        // As in HeightField::at().
        row_.least = clamps ? -1.0 : -2.0 * margin_;
        row_.most = clamps ? field.width() + 1.0 : field.width() + 2.0 * margin_;
        row_.samples.resize(static_cast<std::size_t>(directions) * static_cast<std::size_t>(reach + 1));
        stride_ = static_cast<std::size_t>(field.width() + 2 * margin_);
        heights_.resize(stride_ * static_cast<std::size_t>(kStripRows + 2 * margin_));
        slopes_.resize(stride_);
        for (int x = 0; x < field.width() + 2 * margin_; ++x) {
            columns_.push_back(addressIndex(x - margin_, field.width(), field.address()));
        }
    }

    // Loads the heights around the rows from y0 on.
    void load(int y0) {
        y0_ = y0;
        float* to = heights_.data();
        float highest = 0;
        for (int y = y0 - margin_; y < y0 + kStripRows + margin_; ++y, to += stride_) {
            const auto row = field_.heights().row(addressIndex(y, field_.height(), field_.address()));
            for (std::size_t x = 0; x < stride_; ++x) {
                to[x] = row[static_cast<std::size_t>(columns_[x])];
                highest = std::max(highest, to[x]);
            }
        }
        row_.highest = static_cast<double>(highest);
    }

    // Writes the slopes of the row y of the picture.
    void build(int y, float* slopes) {
        ProfileSample* sample = row_.samples.data();
        for (int n = 0; n < row_.azimuths; ++n) {
            const double angle = azimuth(n, row_.azimuths);
            const double cosine = std::cos(angle), sine = std::sin(angle);
            for (int r = 0; r <= row_.reach; ++r, ++sample) {
                sample->across = r * cosine;
                double down = y + 0.5 + r * sine;
                if (row_.bilinear) down -= 0.5;
                if (field_.address() != Address::Repeat) down = std::clamp(down, -1.0, field_.height() + 1.0);
                const double whole = std::floor(down);
                sample->downShare = down - whole;
                sample->upper = heightsOf(static_cast<int>(whole));
                sample->lower = sample->upper + stride_;
            }
        }
        row_.apexes = heightsOf(y);
        relaxedSlopes(row_, slopes_.data());
        std::copy_n(slopes_.data(), field_.width(), slopes);
    }

  private:
    const float* heightsOf(int y) const {
        return heights_.data() + static_cast<std::size_t>(y - y0_ + margin_) * stride_ + margin_;
    }

    const HeightField& field_;
    int margin_;
    int y0_ = 0;
    std::size_t stride_;
    std::vector<int> columns_;
    std::vector<float> heights_, slopes_;
    RelaxedRow row_{};
};

}  // namespace

double relaxedSlope(const HeightField& field, int directions, int reach, int x, int y) {
    std::vector<double> profile;
    double kappa = 0;
    for (int n = 0; n < directions; ++n) {
        const double angle = azimuth(n, directions);
        profile.clear();
        for (int r = 0; r <= reach; ++r) {
            profile.push_back(field.at(x + 0.5 + r * std::cos(angle), y + 0.5 + r * std::sin(angle)));
        }
        kappa = std::max(kappa, slopeOfProfile(profile));
    }
    return kappa;
}

std::uint64_t relaxedStripBytes(const HeightField& field, int radius, std::size_t threads) {
    const int reach = std::min(radius, std::max(field.width(), field.height()));
    const auto around = static_cast<std::uint64_t>(2 * (reach + kRelaxedMargin));
    const auto strips = static_cast<std::uint64_t>((field.height() + kStripRows - 1) / kStripRows);
    return byteProduct({std::min<std::uint64_t>(strips, threads), static_cast<std::uint64_t>(field.width()) + around,
                        static_cast<std::uint64_t>(kStripRows) + around, sizeof(float)});
}

void relaxedCones(const HeightField& field, int directions, int radius, UnfilledVector<float>& slopes, Work& work) {
    const int reach = std::min(radius, std::max(field.width(), field.height()));
    work.progress().begin("map relaxed-cone", field.height());
    ScratchPool<RelaxedStrip> strips([&] { return std::make_unique<RelaxedStrip>(field, directions, reach); });
    parallelFor(work, (field.height() + kStripRows - 1) / kStripRows, [&](int n) {
        const auto strip = strips.borrow();
        strip->load(n * kStripRows);
        for (int y = n * kStripRows; y < std::min((n + 1) * kStripRows, field.height()) && !work.stopped(); ++y) {
            strip->build(y, slopes.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(field.width()));
            work.progress().advance();
        }
    });
}

}  // namespace relief
