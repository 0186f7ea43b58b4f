// Conservative cones. For each block of cells, collects the nodes of the max pyramid that may steepen one of them; for
// each of its cells, selects those that may steepen its own cone; and opens these down to the cell that does, to within
// the slack.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/parallel.h"
#include "base/scratch_pool.h"
#include "relief/maps/cone_builders.h"
#include "relief/maps/cone_scene.h"
#include "relief/maps/cone_strip.h"
#include "relief/maps/conservative_cone_lanes.h"

namespace relief {

namespace {

// Height; nodes below the cone by less than this are still opened. Far above the rounding of sums in double (2^-50).
constexpr double kRoomMargin = 1e-9;

constexpr int kBlock = kStripRows;  // side of a block, in cells
constexpr std::size_t kBlockCells = kBlock * kBlock;

// The cones of one block of cells. Reused for the blocks of a row, to keep the cells that determined the last block.
class BlockCones {
  public:
    explicit BlockCones(const ConeScene& scene) : scene_(scene), strip_(scene) {}

    // Begins a row of blocks. Nothing is kept from other rows, so the result does not depend on which thread processes
    // which row.
    void startRow(int y0) {
        strip_.load(y0);
        for (auto& seeds : seeds_) seeds.clear();
    }

    void build(int x0, int y0, UnfilledVector<float>& apex, UnfilledVector<float>& slopes);

  private:
    // Height above which a cell can matter, relative to every cell of the block, as a function of the gap.
    struct Fall {
        static constexpr int kSteps = 32;
        std::array<double, kSteps> above{};
        double flattest = 0;
        double apex = 0;  // at the middle of the block; a plane below the apexes
        double slopeX = 0;
        double slopeY = 0;
        double lowest = 0;
    };

    void start(int x0, int y0);
    void guess(int sector);
    void measureFall();
    void collect(int level, int i, int j, int shiftX, int shiftY, int sector);
    bool matters(const ConePlanes::Node& node, const ConeNodes::Place& at, std::int64_t gap2) const;
    void refine(std::size_t at, int sector);
    void open(std::size_t at, const ConeNodes::Place& node, int sector);
    void raise(std::size_t at, const ConeDecider& by, int sector);
    bool isNear(const ConeCells& cells) const;
    ConeCells cellsOf(const ConeNodes::Place& node) const {
        return {(node.i << node.level) + node.shiftX, std::min((node.i + 1) << node.level, scene_.width) + node.shiftX,
                (node.j << node.level) + node.shiftY,
                std::min((node.j + 1) << node.level, scene_.height) + node.shiftY};
    }
    ConeCells cellAt(std::size_t at) const {
        const int x = block_.x0 + static_cast<int>(at % kBlock);
        const int y = block_.y0 + static_cast<int>(at / kBlock);
        return {x, x + 1, y, y + 1};
    }
    // Calls body for the cells of the block that exist; blocks are cut at the edge of the picture.
    template <class Body>
    void overCells(const Body& body) const {
        for (int y = 0; y < block_.y1 - block_.y0; ++y) {
            for (int x = 0; x < block_.x1 - block_.x0; ++x) body(static_cast<std::size_t>(y * kBlock + x));
        }
    }
    template <class Body>
    void fromEveryPeriod(const Body& body) const {
        const int around = scene_.wraps ? 1 : 0;
        body(0, 0);  // the own period first: its results prune the others
        for (int py = -around; py <= around; ++py) {
            for (int px = -around; px <= around; ++px) {
                if (px != 0 || py != 0) body(px * scene_.width, py * scene_.height);
            }
        }
    }

    const ConeScene& scene_;
    ConeStrip strip_;
    ConeCells block_{};
    std::array<float, kBlockCells> apex_{};
    std::array<double, kBlockCells> slope_{};  // attained by a cell, or the lower bound
    std::array<ConeDecider, kBlockCells> decider_{};
    std::array<bool, kBlockCells> decided_{};
    std::array<std::vector<ConeDecider>, kMaxSectors> seeds_;
    Fall fall_;
    ConeNodes nodes_;
    std::vector<std::uint32_t> which_;
};

void BlockCones::start(int x0, int y0) {
    block_ = {x0, std::min(x0 + kBlock, scene_.width), y0, std::min(y0 + kBlock, scene_.height)};
    overCells([&](std::size_t n) {
        apex_[n] = strip_.apex(x0 + static_cast<int>(n % kBlock), static_cast<int>(n / kBlock));
    });
}

// Lower bounds of the slopes: of cells beyond the reach, of the near cells, and of the cells that determined the last
// block.
void BlockCones::guess(int sector) {
    overCells([&](std::size_t n) {
        const float near = strip_.slope(sector, block_.x0 + static_cast<int>(n % kBlock), static_cast<int>(n / kBlock));
        slope_[n] =
            std::max((scene_.highest - static_cast<double>(apex_[n])) / scene_.reach, static_cast<double>(near));
        decided_[n] = false;
    });
    for (const ConeDecider& seed : seeds_[static_cast<std::size_t>(sector)]) {
        overCells([&](std::size_t n) { raise(n, seed, sector); });
    }
}

// Whether the strip has examined all these cells for every cell of the block.
bool BlockCones::isNear(const ConeCells& cells) const {
    // Clamp: the unbounded outermost cells are visible in more directions than the strip examines.
    if (scene_.unbounded && scene_.sectors.count() > 1) return false;
    return cells.x0 >= block_.x1 - 1 - kNearCells && cells.x1 - 1 <= block_.x0 + kNearCells &&
           cells.y0 >= block_.y1 - 1 - kNearCells && cells.y1 - 1 <= block_.y0 + kNearCells;
}

void BlockCones::raise(std::size_t at, const ConeDecider& by, int sector) {
    const ConeCells cell = cellAt(at);
    const ConeCells other{by.x, by.x + 1, by.y, by.y + 1};
    const double rise = by.height - static_cast<double>(apex_[at]);
    if (rise <= 0) return;
    const auto gap2 = static_cast<double>(squaredGap(cell, other));
    // Gap 0: the 3 x 3 cells, which are not above the apex by definition.
    if (gap2 == 0 || gap2 >= scene_.squaredReach || !(rise * rise > slope_[at] * slope_[at] * gap2)) return;
    if (!scene_.meets(cell, other, sector)) return;
    slope_[at] = rise / std::sqrt(gap2);
    decider_[at] = by;
    decided_[at] = true;
}

void BlockCones::measureFall() {
    static const std::array<double, Fall::kSteps> gaps = [] {
        std::array<double, Fall::kSteps> all{};
        for (int k = 1; k < Fall::kSteps; ++k) all[static_cast<std::size_t>(k)] = std::exp2(0.5 * (k - 1));
        return all;
    }();
    constexpr double kMost = std::numeric_limits<double>::infinity();
    const double middleX = 0.5 * (block_.x1 - block_.x0 - 1);
    const double middleY = 0.5 * (block_.y1 - block_.y0 - 1);
    const auto offsetX = [&](std::size_t n) { return static_cast<double>(n % kBlock) - middleX; };
    const auto offsetY = [&](std::size_t n) { return static_cast<double>(n / kBlock) - middleY; };
    double sumX = 0;
    double sumY = 0;
    double squareX = 0;
    double squareY = 0;
    fall_ = {};
    fall_.above.fill(-kMost);
    fall_.flattest = fall_.lowest = fall_.apex = kMost;
    overCells([&](std::size_t n) {
        const auto apex = static_cast<double>(apex_[n]);
        const double slope = slope_[n] * scene_.slackFactor;
        sumX += offsetX(n) * apex;
        sumY += offsetY(n) * apex;
        squareX += offsetX(n) * offsetX(n);
        squareY += offsetY(n) * offsetY(n);
        fall_.flattest = std::min(fall_.flattest, slope);
        fall_.lowest = std::min(fall_.lowest, apex);
        for (std::size_t k = 0; k < gaps.size(); ++k) {
            fall_.above[k] = std::max(fall_.above[k], -apex - slope * gaps[k]);
        }
    });
    fall_.slopeX = squareX > 0 ? sumX / squareX : 0;
    fall_.slopeY = squareY > 0 ? sumY / squareY : 0;
    overCells([&](std::size_t n) {
        fall_.apex =
            std::min(fall_.apex, static_cast<double>(apex_[n]) - fall_.slopeX * offsetX(n) - fall_.slopeY * offsetY(n));
    });
}

// Whether a cell of the node may be above the cone of a cell of the block: by the maximum at the smallest gap, and by
// the planes and the tangent of the gap between the middles, which is a lower bound since the gap is convex.
bool BlockCones::matters(const ConePlanes::Node& node, const ConeNodes::Place& at, std::int64_t gap2) const {
    const int step = std::min(static_cast<int>(std::bit_width(static_cast<std::uint64_t>(gap2))), Fall::kSteps - 1);
    if (static_cast<double>(node.highest) + fall_.above[static_cast<std::size_t>(step)] <= 0) return false;
    const NodeSpan x = NodeSpan::of(at.level, at.i, scene_.width);
    const NodeSpan y = NodeSpan::of(at.level, at.j, scene_.height);
    const double offsetX = x.middle + at.shiftX - 0.5 * (block_.x0 + block_.x1 - 1);
    const double offsetY = y.middle + at.shiftY - 0.5 * (block_.y0 + block_.y1 - 1);
    const ConeTangent fall(offsetX, offsetY, fall_.flattest);
    const double halfX = 0.5 * (block_.x1 - block_.x0 - 1);
    const double halfY = 0.5 * (block_.y1 - block_.y0 - 1);
    const double room = fall.room(node, x, y) - fall_.apex + halfX * std::abs(fall_.slopeX - fall.x) +
                        halfY * std::abs(fall_.slopeY - fall.y);
    return room > -kRoomMargin;
}

void BlockCones::collect(int level, int i, int j, int shiftX, int shiftY, int sector) {
    const ConePlanes::Node& node = scene_.planes.at(level, i, j);
    if (static_cast<double>(node.highest) <= fall_.lowest) return;
    const ConeNodes::Place at{level, i, j, shiftX, shiftY};
    const ConeCells cells = cellsOf(at);
    const std::int64_t gap2 = squaredGap(block_, cells);
    if (isNear(cells) || static_cast<double>(gap2) >= scene_.squaredReach || !matters(node, at, gap2) ||
        !scene_.meets(block_, cells, sector))
        return;
    // Nodes smaller than this fraction of their distance do not give the cells of the block different bounds.
    constexpr std::int64_t kFine = 8;
    constexpr int kSmallest = 1;
    const std::int64_t size = kFine << level;
    if (level <= kSmallest || size * size <= gap2) {
        const NodeSpan x = NodeSpan::of(level, i, scene_.width);
        const NodeSpan y = NodeSpan::of(level, j, scene_.height);
        const auto narrow = [](double value) { return static_cast<float>(value); };
        nodes_.add(narrow(x.middle + shiftX - block_.x0), narrow(y.middle + shiftY - block_.y0), narrow(x.half),
                   narrow(y.half), node.highest, node.value, node.gradientX, node.gradientY, at);
        return;
    }
    for (int cj = 2 * j; cj < std::min(2 * j + 2, scene_.planes.height(level - 1)); ++cj) {
        for (int ci = 2 * i; ci < std::min(2 * i + 2, scene_.planes.width(level - 1)); ++ci) {
            collect(level - 1, ci, cj, shiftX, shiftY, sector);
        }
    }
}

// Opens a node that may steepen this cell's cone, down to its cells.
void BlockCones::open(std::size_t at, const ConeNodes::Place& node, int sector) {
    const ConeCells cell = cellAt(at);
    const auto apex = static_cast<double>(apex_[at]);
    const ConePlanes::Node& plane = scene_.planes.at(node.level, node.i, node.j);
    const double rise = static_cast<double>(plane.highest) - apex;
    if (rise <= 0) return;
    const ConeCells cells = cellsOf(node);
    const auto gap2 = static_cast<double>(squaredGap(cell, cells));
    const double slope = slope_[at] * scene_.slackFactor;
    if (gap2 >= scene_.squaredReach || rise * rise < slope * slope * gap2) return;
    if (node.level == 0) {
        raise(at, {cells.x0, cells.y0, static_cast<double>(plane.highest)}, sector);
        return;
    }
    const NodeSpan x = NodeSpan::of(node.level, node.i, scene_.width);
    const NodeSpan y = NodeSpan::of(node.level, node.j, scene_.height);
    const double offsetX = x.middle + node.shiftX - cell.x0;
    const double offsetY = y.middle + node.shiftY - cell.y0;
    const double room = ConeTangent(offsetX, offsetY, slope).room(plane, x, y) - apex;
    if (room <= -kRoomMargin || !scene_.meets(cell, cells, sector)) return;
    // Nearer children first.
    const int nearX = offsetX > 0 ? 0 : 1;
    const int nearY = offsetY > 0 ? 0 : 1;
    for (int n = 0; n < 4; ++n) {
        const int ci = 2 * node.i + (nearX ^ (n & 1));
        const int cj = 2 * node.j + (nearY ^ (n >> 1));
        if (ci < scene_.planes.width(node.level - 1) && cj < scene_.planes.height(node.level - 1)) {
            open(at, {node.level - 1, ci, cj, node.shiftX, node.shiftY}, sector);
        }
    }
}

void BlockCones::refine(std::size_t at, int sector) {
    // The cells that determined its neighbours are likely to determine this one.
    if (at % kBlock > 0 && decided_[at - 1]) raise(at, decider_[at - 1], sector);
    if (at >= kBlock && decided_[at - kBlock]) raise(at, decider_[at - kBlock], sector);
    const std::size_t found = nodesAbove(nodes_, static_cast<float>(at % kBlock), static_cast<float>(at / kBlock),
                                         apex_[at], static_cast<float>(slope_[at] * scene_.slackFactor), which_.data());
    for (std::size_t n = 0; n < found; ++n) open(at, nodes_.places[which_[n]], sector);
}

void BlockCones::build(int x0, int y0, UnfilledVector<float>& apex, UnfilledVector<float>& slopes) {
    start(x0, y0);
    const std::size_t cells = scene_.cells.size();
    const auto index = [&](std::size_t n) {
        const ConeCells cell = cellAt(n);
        return static_cast<std::size_t>(cell.y0) * static_cast<std::size_t>(scene_.width) +
               static_cast<std::size_t>(cell.x0);
    };
    overCells([&](std::size_t n) { apex[index(n)] = apex_[n]; });
    // Ten units of 2^-24: near slopes are rounded by three, the result by two, and comparisons in double by far less.
    constexpr float kSteeper = 1 + 6e-7F;
    for (int sector = 0; sector < scene_.sectors.count(); ++sector) {
        guess(sector);
        measureFall();
        nodes_.clear();
        fromEveryPeriod([&](int shiftX, int shiftY) { collect(scene_.planes.top(), 0, 0, shiftX, shiftY, sector); });
        nodes_.finish();
        which_.resize(nodes_.size() + 1);
        std::vector<ConeDecider>& seeds = seeds_[static_cast<std::size_t>(sector)];
        seeds.clear();
        overCells([&](std::size_t n) {
            refine(n, sector);
            slopes[static_cast<std::size_t>(sector) * cells + index(n)] =
                static_cast<float>(slope_[n] * scene_.slackFactor) * kSteeper;
            constexpr std::size_t kSeeds = 4;
            if (decided_[n] && seeds.size() < kSeeds &&
                std::find(seeds.begin(), seeds.end(), decider_[n]) == seeds.end()) {
                seeds.push_back(decider_[n]);
            }
        });
    }
}

}  // namespace

void conservativeCones(const HeightField& field, int sectors, double slack, UnfilledVector<float>& apex,
                       UnfilledVector<float>& slopes, Work& work) {
    MapCache own;
    const auto map = maxPyramidMap(field, own, work);
    const ConeScene scene(field, *map, sectors, slack, work);
    apex.resize(scene.cells.size());
    const int rows = (scene.height + kBlock - 1) / kBlock;
    work.progress().begin("map cone", rows);
    ScratchPool<BlockCones> blocks([&] { return std::make_unique<BlockCones>(scene); });
    parallelFor(work, rows, [&](int row) {
        const auto block = blocks.borrow();
        block->startRow(row * kBlock);
        for (int x = 0; x < scene.width && !work.stopped(); x += kBlock) block->build(x, row * kBlock, apex, slopes);
        work.progress().advance();
    });
}

}  // namespace relief
