#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>

#include "measuring/text_table.h"
#include "tracer_peers.h"

namespace relief::peers {

namespace {

constexpr int kDigits = 3;

std::string viewText(Elevation view) {
    return view ? elevationText(view) : "random";
}

// Geometric mean and minimum of ratios.
struct Mean {
    double sum = 0;
    int count = 0;
    double least = 1e300;

    void add(double ratio) {
        sum += std::log(ratio);
        ++count;
        least = std::min(least, ratio);
    }
    double value() const { return std::exp(sum / count); }
};

template <class Key>
void printMeans(const std::string& title, const std::vector<PeerCell>& cells, const Key& key, std::ostream& out) {
    std::vector<std::string> methods;
    std::vector<std::string> groups;
    std::map<std::pair<std::string, std::string>, Mean> means;
    const auto remember = [](std::vector<std::string>& names, const std::string& name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    std::map<std::string, Mean> best;  // the best of our methods in each cell
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const PeerCell& cell = cells[c];
        remember(methods, cell.method);
        remember(groups, key(cell));
        means[{key(cell), cell.method}].add(cell.ratio);
    }
    for (std::size_t c = 0; c < cells.size(); c += methods.size()) {
        double most = 0;
        for (std::size_t m = 0; m < methods.size(); ++m) most = std::max(most, cells[c + m].ratio);
        best[key(cells[c])].add(most);
    }
    std::vector<TableRow> rows{{title}};
    for (const std::string& method : methods) {
        rows[0].push_back(method);
        rows[0].push_back("least");
    }
    if (methods.size() > 1) rows[0].insert(rows[0].end(), {"best of ours", "least"});
    for (const std::string& group : groups) {
        TableRow row{group};
        const auto add = [&](const Mean& mean) {
            row.push_back(readable(mean.value(), kDigits));
            row.push_back(readable(mean.least, kDigits));
        };
        for (const std::string& method : methods) add(means.at({group, method}));
        if (methods.size() > 1) add(best.at(group));
        rows.push_back(row);
    }
    out << "\nRatio to the fastest Embree, geometric mean, and the least of the cells\n" << textTable(rows);
}

// Prints how much slower a ray is on the largest map than on the smallest.
void printGrowth(const std::vector<PeerCell>& cells, std::ostream& out) {
    std::vector<TableRow> rows{{"map", "view", "method", "sizes", "growth", "Embree's", "bytes a ray"}};
    for (const PeerCell& small : cells) {
        const PeerCell* large = nullptr;
        bool least = true;
        for (const PeerCell& other : cells) {
            if (other.map != small.map || other.view != small.view || other.method != small.method) continue;
            least = least && other.size >= small.size;
            if (other.size > small.size && (large == nullptr || other.size > large->size)) large = &other;
        }
        if (!least || large == nullptr) continue;
        rows.push_back({small.map, viewText(small.view), small.method,
                        std::to_string(small.size) + " to " + std::to_string(large->size),
                        readable(small.rate / large->rate, kDigits),
                        readable(small.bestRate / large->bestRate, kDigits),
                        readable(small.bytes, kDigits) + " to " + readable(large->bytes, kDigits)});
    }
    if (rows.size() == 1) return;
    out << "\nTime of a ray on the largest map over that on the smallest; bytes of maps and heights that our scalar "
           "text "
           "reads a ray\n"
        << textTable(rows, 3);
}

}  // namespace

void printCells(const std::vector<PeerCell>& cells, std::ostream& out) {
    if (cells.empty()) return;
    std::vector<TableRow> rows{{"map", "size", "view", "rays", "Mrays/s", "+-%", "Embree", "+-%", "ratio", "+-%",
                                "differs %", "wrong", "method", "Embree's fastest"}};
    for (const PeerCell& cell : cells) {
        rows.push_back({cell.map, std::to_string(cell.size), viewText(cell.view), std::to_string(cell.rays),
                        readable(cell.rate / 1e6, kDigits), readable(100 * cell.spread, 2),
                        readable(cell.bestRate / 1e6, kDigits), readable(100 * cell.bestSpread, 2),
                        readable(cell.ratio, kDigits), readable(100 * cell.ratioSpread, 2),
                        readable(100 * cell.differs, kDigits), std::to_string(cell.wrong), cell.method, cell.best});
    }
    out << "\n"
        << textTable(rows, 1, 12)
        << "\nRates are medians, +-: (p75 - p25) / median; ratio: to the fastest variant of Embree in the same round, "
           "median.\ndiffers: rays on which Embree is more than 0.05 texel from the bilinear surface, or hits "
           "otherwise: its surface is triangles, not bilinear\npatches, so this is a difference of model, not a "
           "fault. wrong: rays on which our method is not bit for bit the scalar exact answer.\n";
    printMeans(
        "view", cells, [](const PeerCell& cell) { return viewText(cell.view); }, out);
    printMeans(
        "map", cells, [](const PeerCell& cell) { return cell.map + " " + std::to_string(cell.size); }, out);
    printMeans(
        "all", cells, [](const PeerCell&) { return std::string("all"); }, out);
    printGrowth(cells, out);
}

}  // namespace relief::peers
