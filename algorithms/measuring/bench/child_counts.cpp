#include "measuring/bench/child_counts.h"

#include <algorithm>
#include <cmath>

#include "measuring/text_table.h"
#include "relief/messages.h"

namespace relief {

namespace {

// A descent whose texel the traversal has not left yet.
struct Open {
    int level;
    std::int64_t i, j;
    std::int64_t periodX, periodY;
    std::size_t children = 0;
};

bool isDescent(const Step& step) {
    const auto* const texel = step.as<subject::Texel>();
    return step.decision == Decision::Descend && texel != nullptr && texel->ray.has_value();
}

// Indices of level 0 may begin at -1 (clamp and border addressing), so its cells cannot be related to parents by
// halving; every cell visited counts as a child.
bool within(const Step& step, const Open& parent) {
    if (step.level != parent.level - 1) return false;
    if (step.periodX != parent.periodX || step.periodY != parent.periodY) return false;
    if (parent.level == 1) return true;
    return step.i >> 1 == parent.i && step.j >> 1 == parent.j;
}

bool entersTexel(const Step& step) {
    return step.decision == Decision::Skip || step.decision == Decision::Descend || step.decision == Decision::Test ||
           step.decision == Decision::Hit;
}

}  // namespace

double ChildCounts::mean() const {
    const auto count = static_cast<double>(descents());
    return count > 0 ? static_cast<double>(finished[0] + 2 * finished[1] + 3 * finished[2]) / count : 0;
}

double ChildCounts::share(std::size_t count) const {
    const auto all = static_cast<double>(descents());
    return all > 0 ? static_cast<double>(finished[count - 1]) / all : 0;
}

void ChildCounts::add(const ChildCounts& other) {
    for (std::size_t n = 0; n < kMost; ++n) finished[n] += other.finished[n];
    ended += other.ended;
}

void addChildren(const std::vector<Step>& steps, std::size_t begin, std::size_t end, ChildrenByLevel& counts) {
    std::vector<Open> open;
    const auto close = [&] {
        const Open& last = open.back();
        if (last.children >= 1) {
            ++counts[last.level].finished[std::min(last.children, ChildCounts::kMost) - 1];
        }
        open.pop_back();
    };
    for (std::size_t n = begin; n < end; ++n) {
        const Step& step = steps[n];
        if (step.decision == Decision::Ascend) {
            // The ray has left all texels at or below that level.
            while (!open.empty() && open.back().level <= step.level) close();
            continue;
        }
        if (!entersTexel(step) || step.as<subject::Texel>() == nullptr) continue;
        if (!open.empty() && within(step, open.back())) ++open.back().children;
        if (isDescent(step)) open.push_back({step.level, step.i, step.j, step.periodX, step.periodY, 0});
    }
    for (const Open& left : open) ++counts[left.level].ended;
}

ChildCounts sumOf(const ChildrenByLevel& counts) {
    ChildCounts all;
    for (const auto& [level, of] : counts) all.add(of);
    return all;
}

namespace {

template <class Put>
void forEachLine(const ChildrenByLevel& counts, const Put& put) {
    for (auto at = counts.rbegin(); at != counts.rend(); ++at) put(std::to_string(at->first), at->second);
    put("all", sumOf(counts));
}

}  // namespace

std::string childrenCsv(const ChildrenByLevel& counts) {
    std::string out = "level,one,two,three,mean,ended\n";
    forEachLine(counts, [&](const std::string& level, const ChildCounts& of) {
        out += level;
        for (const std::int64_t count : of.finished) out += "," + std::to_string(count);
        out += "," + numberText(of.mean()) + "," + std::to_string(of.ended) + "\n";
    });
    return out;
}

std::string childrenText(const ChildrenByLevel& counts) {
    constexpr double kBar = 24;  // characters for a share of 100%
    std::vector<TableRow> rows{{"level", "one", "two", "three", "mean", "ended"}};
    forEachLine(counts, [&](const std::string& level, const ChildCounts& of) {
        rows.push_back({level, std::to_string(of.finished[0]), std::to_string(of.finished[1]),
                        std::to_string(of.finished[2]), readable(of.mean(), 3), std::to_string(of.ended)});
    });
    const ChildCounts all = sumOf(counts);
    std::string out = textTable(rows) + "\n";
    constexpr std::array kNames{"one  ", "two  ", "three"};
    for (std::size_t n = 1; n <= ChildCounts::kMost; ++n) {
        const double share = all.share(n);
        const std::string bar(static_cast<std::size_t>(std::lround(kBar * share)), '#');
        out += std::string(kNames[n - 1]) + " " + readable(100 * share, 3) + "% " + bar + "\n";
    }
    return out +
           "\nNumber of children entered per texel that the search descended into without a hit; ended: descents in "
           "which the ray ended.\n[MIP18] states at most two.\n";
}

}  // namespace relief
