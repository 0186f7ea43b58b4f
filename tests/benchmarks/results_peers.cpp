// Tables of RESULTS.md with the comparisons with other programs.
#include "results_file.h"

namespace relief::claims {

// The ratio of our best method to Embree's best variant, one cell per view.
std::string peersTable(const Table& table) {
    std::string out = head({"map", "view", "method", "Mrays/s", "+-%", "Embree's fastest", "Mrays/s", "+-%", "ratio",
                            "Embree off, texels"},
                           3);
    Range ratios;
    std::map<std::string, Range> ofView;
    for (const std::string& map : table.values("height")) {
        for (const std::string& size : table.values("size")) {
            for (const std::string& view : table.values("elevation")) {
                const Row* ours = nullptr;
                const Row* theirs = nullptr;
                for (const Row& row : table.rows()) {
                    if (row.at("height") != map || row.at("size") != size || row.at("elevation") != view) continue;
                    const Row*& best = row.at("method").starts_with("embree") ? theirs : ours;
                    if (best == nullptr || table.number(row, "rate") > table.number(*best, "rate")) best = &row;
                }
                if (ours == nullptr || theirs == nullptr) continue;
                const double ratio = table.number(*ours, "rate") / table.number(*theirs, "rate");
                ratios.add(ratio);
                ofView[view].add(ratio);
                const auto rate = [&](const Row& row) { return three(table.number(row, "rate") / 1e6); };
                const auto spread = [&](const Row& row) { return readable(100 * table.number(row, "spread"), 2); };
                out +=
                    line({map + " " + size, view, "`" + table.text(*ours, "method") + "`", rate(*ours), spread(*ours),
                          table.text(*theirs, "method") + " " + table.text(*theirs, "options"), rate(*theirs),
                          spread(*theirs), three(ratio), readable(table.number(*theirs, "error_p95"), 2)});
            }
        }
    }
    if (ratios.empty()) fail(table.path(), "no cell with both");
    std::string views;
    for (const std::string& view : table.values("elevation")) {
        views += (views.empty() ? "" : ", ") + view + ": " + readable(ofView[view].mean(), 3);
    }
    return out + "\nGeometric mean of the " + std::to_string(ratios.count()) + " ratios " + three(ratios.mean()) +
           " (" + views + "), " + ratios.text() +
           ". Embree's surface is triangles, not bilinear patches: the last column, 95% of its hits are nearer to "
           "ours than that, is a difference of model.\n" +
           origin(table);
}

// The elliptical filter, SIMD and scalar, compared with OpenImageIO.
std::string filterPeersTable(const Table& table) {
    std::string out = head({"picture", "elevation", "form", "Mpixels/s", "+-%", "of OpenImageIO's best", "+-%",
                            "error x 1000", "of its least error"},
                           3);
    std::map<std::string, Range> ratios;
    Range errors;
    for (const std::string& picture : table.values("what")) {
        for (const std::string& view : table.values("view")) {
            double least = 1e300;
            std::vector<const Row*> ours;
            for (const Row& row : table.rows()) {
                if (table.text(row, "what") != picture || table.text(row, "view") != view) continue;
                if (table.text(row, "method").find('/') != std::string::npos) {
                    least = std::min(least, table.number(row, "error"));
                } else {
                    ours.push_back(&row);
                }
            }
            for (const Row* row : ours) {
                const double share = table.number(*row, "error") / least;
                const std::string& method = table.text(*row, "method");
                ratios[method].add(table.number(*row, "ratio"));
                errors.add(share);
                if (method.find("SSE") != std::string::npos || method.ends_with(" SCALAR")) continue;
                out += line({picture, view, method, three(table.number(*row, "rate") / 1e6),
                             readable(100 * table.number(*row, "spread"), 2), three(table.number(*row, "ratio")),
                             readable(100 * table.number(*row, "ratio_spread"), 2),
                             three(1000 * table.number(*row, "error")), three(share)});
            }
        }
    }
    out += "\nGeometric means of the ratios:";
    for (const auto& [method, range] : ratios) {
        out += " " + method + " " + three(range.mean()) + " (" + range.text() + "),";
    }
    out.back() = ';';
    return out + " error " + errors.text() + " of OpenImageIO's least.\n" + origin(table);
}

std::string distancePeersTable(const Table& table) {
    std::string out = head({"map", "voxels", "method", "maps a second", "+-%", "of the fastest peer", "+-%"}, 3);
    Range ratios;
    for (const Row& row : table.rows()) {
        const bool ours = table.text(row, "method").find('/') == std::string::npos;
        if (ours) ratios.add(table.number(row, "ratio"));
        out += line({table.text(row, "what"), table.text(row, "size"), table.text(row, "method"),
                     three(table.number(row, "rate")), readable(100 * table.number(row, "spread"), 2),
                     three(table.number(row, "ratio")), readable(100 * table.number(row, "ratio_spread"), 2)});
    }
    return out + "\nOurs over the faster of the two, geometric mean " + three(ratios.mean()) + " (" + ratios.text() +
           ").\n" + origin(table);
}

std::string framesTable(const Table& table) {
    std::vector<std::string> names{"picture"};
    const std::vector<std::string> methods = table.values("method");
    for (const std::string& method : methods) names.push_back("`" + method + "`");
    std::string out = head(names, 1);
    for (const std::string& picture : table.values("what")) {
        std::vector<std::string> cells{picture};
        for (const std::string& method : methods) {
            std::vector<std::string> rates;
            for (const std::string& view : table.values("view")) {
                rates.push_back(
                    three(table.number(table.at({{"what", picture}, {"method", method}, {"view", view}}), "rate")));
            }
            cells.push_back(joined(rates));
        }
        out += line(cells);
    }
    return out + origin(table);
}

}  // namespace relief::claims
