// How coarse the next frame of a picture that moves is drawn, by what the frames before it took.
//
// Levels are ways to draw, each cheaper than the one before. What a frame takes on them is expected to be in
// proportion to their nominal seconds, by one factor for all that follows the view, the method and the machine.
// - One frame that was slow for a reason of its own (a map was built, the machine was busy) changes nothing: it is the
//   median of the last three that counts, of fewer the fastest.
// - Where that is above the budget, the finest level is taken that is expected within it, at once.
// - Where a finer level is expected well within it, that one is taken as soon as three frames say so; where there is
//   much time to spare, the next finer one is tried whatever is expected. What was too slow nonetheless has its nominal
//   seconds corrected, and such trials are made ever more seldom.
// The budget is what is aimed at; up to kTolerated of it are borne, lest a view change its look to and fro.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace relief {

class FramePace {
  public:
    // Parts of the budget.
    static constexpr double kTolerated = 1.25, kWellWithin = 0.85;

    // budget: seconds a frame may take; not positive: none does, and the coarsest level is taken.
    explicit FramePace(double budget) : budget_(budget) {}

    // Seconds of a frame on each level where nothing has been measured, the finest first. Where they are the same as
    // before nothing is done; otherwise the finest level is taken that is expected within the budget.
    void setLevels(const std::vector<double>& nominal);
    int level() const { return level_; }
    // Seconds of a frame on a level.
    double expected(int level) const;

    // A frame on level() was made.
    void took(double seconds);
    // It was given up after so long.
    void gaveUp(double seconds);
    // A frame on the finest level was made while nothing moved; seconds without what is made only once.
    void rested(double seconds);

  private:
    double typical() const;
    void follow(double seconds);
    void coarser();
    void finer();
    void go(int level);
    int finestWithin(int first, double seconds) const;

    double budget_;
    std::vector<double> asked_, nominal_;  // as they were given; and corrected
    double scale_ = 1;                     // of what frames take to the nominal seconds
    int level_ = 0;
    std::array<double, 3> recent_{};  // seconds of the last frames on this level
    int frames_ = 0;                  // on it
    bool tried_ = false;              // it was come to from a coarser one
    int wait_ = 0;                    // frames on a level before a finer one is tried whatever is expected
};

}  // namespace relief
