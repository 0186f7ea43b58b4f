// How many children of a texel a ray enters at each level of the recursion of [MIP18], counted from step logs. The
// paper: at most two. A line crosses one, two or three of four.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "relief/step_log.h"
#include "relief/tracers.h"

namespace relief {

struct ChildCounts {
    static constexpr std::size_t kMost = 3;  // children of one texel that a straight line can cross

    // Descents that confirmed nothing, so that all children on the ray's way were entered: how many entered 1, 2, 3.
    std::array<std::int64_t, kMost> finished{};
    std::int64_t ended = 0;  // descents in which the ray ended, by a hit or at a border: their counts say less

    std::int64_t descents() const { return finished[0] + finished[1] + finished[2]; }
    double mean() const;                    // children a finished descent; 0: there is none
    double share(std::size_t count) const;  // of the finished descents that entered `count` children, 1 to 3
    void add(const ChildCounts& other);
};

// By the level of the texel that was descended into.
using ChildrenByLevel = std::map<int, ChildCounts>;

// The steps of one ray, of either form of the max pyramid tracer: children are the steps one level below whose texel
// lies in the one descended into.
void addChildren(const std::vector<Step>& steps, std::size_t begin, std::size_t end, ChildrenByLevel& counts);
ChildCounts sumOf(const ChildrenByLevel& counts);

// "level,one,two,three,mean,ended", a line a level from the top, then one "all".
std::string childrenCsv(const ChildrenByLevel& counts);
// For people: the same with a histogram of bars.
std::string childrenText(const ChildrenByLevel& counts);

}  // namespace relief
