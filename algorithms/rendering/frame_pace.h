// Chooses how coarsely the next frame of a moving picture is drawn, from the times of the frames before it.
//
// Levels are ways to draw, each cheaper than the one before. The expected time of a frame is the level's nominal
// seconds times one scale for all levels, which follows the view, the method and the machine.
// - A single frame that was slow for a reason of its own (a map was built, the machine was busy) changes nothing: the
//   median of the last three frames counts, or the fastest if there are fewer.
// - If that time is above the budget, the finest level expected to keep within it is taken at once.
// - If a finer level is expected to be well within the budget, it is taken after three frames; if much time is left,
//   the next finer level is tried whatever its expected time. If it proves too slow, its nominal seconds are corrected
//   and further trials become rarer.
// The budget is the target; up to kTolerated times the budget is accepted, so that a view does not alternate between
// levels.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace relief {

class FramePace {
  public:
    // In parts of the budget.
    static constexpr double kTolerated = 1.25, kWellWithin = 0.85;

    // budget: seconds that a frame may take; if it is not positive, no level keeps within it and the coarsest is taken.
    explicit FramePace(double budget) : budget_(budget) {}

    // Sets the nominal seconds per frame of each level, finest first, used until times are measured. Values equal to
    // the last call's have no effect; others select the finest level that is expected to keep within the budget.
    void setLevels(const std::vector<double>& nominal);
    int level() const { return level_; }
    // Returns the expected seconds of a frame on a level.
    double expected(int level) const;

    // Records that a frame on level() was made in this many seconds.
    void took(double seconds);
    // Records that a frame on level() was cancelled after this many seconds.
    void gaveUp(double seconds);
    // Records a frame on the finest level that was made while nothing moved; seconds: without work done only once
    // (maps).
    void rested(double seconds);

  private:
    // Returns the median frame time on this level, or a cautious estimate from fewer than three frames.
    double typical() const;
    // Adapts the scale so that the expected time of the level equals `seconds`.
    void follow(double seconds);
    // Moves to a coarser level after frames that were too slow, and corrects scale or nominal seconds.
    void coarser();
    // Moves to a finer level if it is expected to keep within the budget, or on trial.
    void finer();
    void go(int level);
    // Returns the finest level, from `first` on, that is expected to take at most `seconds`; the coarsest if there is
    // none.
    int finestWithin(int first, double seconds) const;

    double budget_;
    std::vector<double> given_, nominal_;  // as passed to setLevels(); and with corrections
    double scale_ = 1;                     // measured seconds per nominal second
    int level_ = 0;
    std::array<double, 3> recent_{};  // seconds of the last frames on this level
    int frames_ = 0;                  // frames made on this level
    bool onTrial_ = false;            // the level was reached from a coarser one
    int wait_ = 0;                    // frames on a level before a finer one is tried whatever its expected time
};

}  // namespace relief
