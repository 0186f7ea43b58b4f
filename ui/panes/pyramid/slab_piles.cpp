#include "panes/pyramid/slab_piles.h"

#include <algorithm>
#include <cmath>

#include "panes/turntable.h"

namespace reliefui {

namespace {

constexpr double kAside = 0.08;  // between piles, of a slab's width
constexpr double kApart = 0.06;  // between slabs of a pile, of their depth
constexpr double kRoom = 0.96;   // of the view
// Slabs narrower than so many lines of text are made without regard to their titles.
constexpr double kLeastLines = 2;

// The piles of one division at one scale.
class Division {
  public:
    Division(const std::vector<std::vector<SlabSize>>& pyramids, std::size_t high, bool titles)
        : pyramids_(pyramids), high_(high), titles_(titles) {}

    std::size_t pilesOf(const std::vector<SlabSize>& slabs) const { return (slabs.size() + high_ - 1) / high_; }
    // Pixels.
    double pitch(const std::vector<SlabSize>& slabs, std::size_t pile, double scale) const {
        double wide = 0;
        for (std::size_t k = pile * high_; k < std::min(slabs.size(), (pile + 1) * high_); ++k) {
            wide = std::max({wide, slabs[k].width * scale, titles_ ? slabs[k].titleWidth : 0});
        }
        return wide + kAside * slabs.front().width * scale;
    }
    double rise(double scale) const {
        double most = 0;
        for (const std::vector<SlabSize>& slabs : pyramids_) {
            for (const SlabSize& slab : slabs) {
                const double deep = (1 + kApart) * slab.depth * std::sin(Turntable::kElevation) * scale;
                most = std::max(most, deep + (titles_ ? slab.titleHeight : 0));
            }
        }
        return most;
    }
    bool fits(double scale, double width, double height) const {
        double wide = 0;
        for (const std::vector<SlabSize>& slabs : pyramids_) {
            for (std::size_t pile = 0; pile < pilesOf(slabs); ++pile) wide += pitch(slabs, pile, scale);
        }
        return wide <= width && static_cast<double>(high_) * rise(scale) <= height;
    }
    // The largest scale that fits; 0: none.
    double largest(double width, double height) const {
        double low = 0;
        double high = std::max(width, height) * 4;
        constexpr int kHalvings = 40;
        for (int n = 0; n < kHalvings; ++n) {
            const double middle = (low + high) / 2;
            (fits(middle, width, height) ? low : high) = middle;
        }
        return low;
    }
    SlabPiles places(double scale) const {
        SlabPiles piles;
        piles.scale = scale;
        piles.titled = titles_;
        const double up = rise(scale) / scale / std::cos(Turntable::kElevation);
        double x = 0;
        int before = 0;
        for (const std::vector<SlabSize>& slabs : pyramids_) {
            piles.places.emplace_back();
            for (std::size_t pile = 0; pile < pilesOf(slabs); ++pile) {
                for (std::size_t k = pile * high_; k < std::min(slabs.size(), (pile + 1) * high_); ++k) {
                    piles.places.back().push_back({before, x, static_cast<double>(k - pile * high_) * up});
                }
                x += pitch(slabs, pile, scale) / scale;
                ++before;
            }
        }
        return piles;
    }

  private:
    const std::vector<std::vector<SlabSize>>& pyramids_;
    std::size_t high_;  // slabs of a pile
    bool titles_;
};

}  // namespace

SlabPiles slabPiles(const std::vector<std::vector<SlabSize>>& pyramids, double width, double height) {
    std::size_t levels = 0;
    double line = 0;
    for (const std::vector<SlabSize>& slabs : pyramids) {
        levels = std::max(levels, slabs.size());
        for (const SlabSize& slab : slabs) line = std::max(line, slab.titleHeight);
    }
    if (levels == 0) return {};
    for (const bool titles : {true, false}) {
        std::size_t best = levels;
        double scale = 0;
        for (std::size_t high = levels; high >= 1; --high) {
            const double now = Division(pyramids, high, titles).largest(kRoom * width, kRoom * height);
            if (now <= scale * (1 + 1e-6)) continue;
            scale = now;
            best = high;
        }
        if (titles && scale < kLeastLines * line) continue;
        return Division(pyramids, best, titles).places(std::max(scale, 1.0));
    }
    return {};
}

}  // namespace reliefui
