// Counts from step logs how many children of a texel a ray enters at each level of the recursion of [MIP18]. The paper
// states at most two; a straight line crosses one, two or three of four.
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
    static constexpr std::size_t kMost = 3;  // maximum number of children of a texel that a straight line crosses

    // Descents without a hit, in which all children on the ray's way were entered: number of descents that entered 1,
    // 2, 3.
    std::array<std::int64_t, kMost> finished{};
    // descents in which the ray ended by a hit or at a border, so that their counts are incomplete
    std::int64_t ended = 0;

    std::int64_t descents() const { return finished[0] + finished[1] + finished[2]; }
    double mean() const;                    // children per finished descent; 0: there are none
    double share(std::size_t count) const;  // share of finished descents that entered `count` children, 1 to 3
    void add(const ChildCounts& other);
};

// By the level of the texel into which the ray descended.
using ChildrenByLevel = std::map<int, ChildCounts>;

// Adds the children in the steps [begin, end) of one ray, from either implementation of the max pyramid tracer.
// Children are the steps one level lower whose texel lies in the one descended into.
void addChildren(const std::vector<Step>& steps, std::size_t begin, std::size_t end, ChildrenByLevel& counts);
// Returns the counts of all levels together.
ChildCounts sumOf(const ChildrenByLevel& counts);

// Returns "level,one,two,three,mean,ended" with a line per level from the top, then a line "all".
std::string childrenCsv(const ChildrenByLevel& counts);
// Returns the same as a text table with a histogram of bars.
std::string childrenText(const ChildrenByLevel& counts);

}  // namespace relief
