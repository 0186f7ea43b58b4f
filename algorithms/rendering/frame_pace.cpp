#include "rendering/frame_pace.h"

#include <algorithm>
#include <cassert>

namespace relief {

namespace {

// If frames take no more than this part of the budget, the next finer level is tried whatever its expected time.
constexpr double kMuchWithin = 0.5;
// A frame at rest shows that the finest level is too slow only if it took this many budgets; it may have been delayed
// by other work.
constexpr double kFarAbove = 4;
// Frames before such a trial; after a failed trial the wait is multiplied by kLonger, up to kLongestWait frames.
constexpr int kFirstWait = 6, kLonger = 4, kLongestWait = 1536;
// A finer level is no longer on trial after this many waits.
constexpr int kProven = 4;
// If a level on trial proves too slow within this many frames, its own nominal seconds are corrected; later, the common
// scale (the view has changed).
constexpr int kTrial = 5;
constexpr double kForget = 1.0 / 512;  // part of a correction that is forgotten per frame

}  // namespace

void FramePace::setLevels(const std::vector<double>& nominal) {
    assert(!nominal.empty());
    if (nominal == given_) return;
    given_ = nominal_ = nominal;
    wait_ = kFirstWait;
    go(finestWithin(0, budget_));
    onTrial_ = false;
}

double FramePace::expected(int level) const {
    return scale_ * nominal_[static_cast<std::size_t>(level)];
}

int FramePace::finestWithin(int first, double seconds) const {
    const int last = static_cast<int>(nominal_.size()) - 1;
    int level = std::min(first, last);
    while (level < last && expected(level) > seconds) ++level;
    return level;
}

void FramePace::go(int level) {
    onTrial_ = level < level_;
    level_ = level;
    frames_ = 0;
}

// A single frame counts only if it was faster than expected.
double FramePace::typical() const {
    const auto [a, b, c] = recent_;
    if (frames_ == 1) return std::min(a, expected(level_));
    if (frames_ == 2) return std::min(a, b);
    return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

void FramePace::follow(double seconds) {
    const double now = expected(level_);
    if (seconds > 0 && now > 0) scale_ *= seconds / now;
}

void FramePace::took(double seconds) {
    recent_[static_cast<std::size_t>(frames_ % 3)] = seconds;
    ++frames_;
    if (frames_ < 2) return;
    if (typical() > kTolerated * budget_) return coarser();
    if (frames_ < 3) return;
    follow(typical());
    if (onTrial_ && frames_ > kProven * wait_) {
        onTrial_ = false;
        wait_ = kFirstWait;
    }
    if (level_ > 0) finer();
}

void FramePace::coarser() {
    const double seconds = typical();
    if (onTrial_ && frames_ <= kTrial) {
        nominal_[static_cast<std::size_t>(level_)] = seconds / scale_;
    } else {
        follow(seconds);
    }
    if (onTrial_) wait_ = std::min(kLonger * wait_, kLongestWait);
    const int last = static_cast<int>(nominal_.size()) - 1;
    if (level_ < last) go(finestWithin(level_ + 1, budget_));
}

void FramePace::finer() {
    const int level = finestWithin(0, kWellWithin * budget_);
    if (level < level_) {
        go(level);
    } else if (frames_ >= wait_ && typical() <= kMuchWithin * budget_) {
        go(level_ - 1);
    } else {
        // Corrections decay, because they may stem from a time when the machine was busy.
        for (std::size_t n = 0; n < nominal_.size(); ++n) nominal_[n] += kForget * (given_[n] - nominal_[n]);
    }
}

void FramePace::gaveUp(double seconds) {
    if (seconds <= std::max(expected(level_), budget_)) return;
    recent_.fill(seconds);
    frames_ = std::max(frames_, 3);
    coarser();
}

void FramePace::rested(double seconds) {
    if (!(seconds > 0)) return;
    const bool slow = level_ == 0 && seconds > kFarAbove * budget_;
    const bool fast = level_ > 0 && seconds <= kWellWithin * budget_;
    // The measured cost of the finest level corrects its nominal seconds relative to the level that is drawn.
    if (level_ > 0 && frames_ >= 3) nominal_[0] = seconds / scale_;
    if (!slow && !fast) return;
    scale_ *= seconds / expected(0);
    go(finestWithin(0, budget_));
    onTrial_ = false;
}

}  // namespace relief
