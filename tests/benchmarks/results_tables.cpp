#include "results_tables.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <vector>

#include "measuring/text_table.h"
#include "relief/describe.h"
#include "relief/errors.h"
#include "relief/files.h"
#include "results_file.h"

namespace relief::claims {

namespace {

// Returns the operation counts per pixel that [PERSP] states.
std::string paperCounts(const std::string& variant) {
    static const std::map<std::string, std::string> counts{
        {"direct", "8 / 8 / 2"},
        {"row-constant", "4 / 4 / 2"},
        {"incremental", "0 / 4 / 2"},
        {"streams", "0 / 4 / 2"},
        {"derivatives-direct", "10 / 10 / 4 / 1"},  // mul / add / div / sub, of the four derivatives alone
        {"derivatives-iterative", "2 / 6 / 4 / 0"}};
    const auto found = counts.find(variant);
    return found == counts.end() ? "" : found->second;
}

// Returns sentences about the whole file, beyond the rows that the table shows.
std::string rowsSentences(const Table& table) {
    Range restarted, drifting, streams, narrow, iterative, cached;
    for (const Row& row : table.rows()) {
        if (table.text(row, "precision") != "float") continue;
        const std::string& variant = table.text(row, "variant");
        const auto rateOf = [&](const std::string& other) {
            Row key{{"width", table.text(row, "width")},
                    {"elevation", table.text(row, "elevation")},
                    {"precision", "float"},
                    {"variant", other}};
            return table.number(table.at(key), "rate");
        };
        const bool restarts = table.text(row, "anchor") != "0";
        if (variant == "incremental" && !restarts) drifting.add(table.number(row, "error_max"));
        if ((variant.starts_with("incremental") || variant == "streams") && restarts) {
            restarted.add(table.number(row, "error_max"));
        }
        if (variant == "streams" && restarts && table.text(row, "streams") == "16") {
            (table.text(row, "width") == "640" ? narrow : streams)
                .add(100 * table.number(row, "rate") / rateOf("fill"));
        }
        if (variant == "derivatives-iterative") iterative.add(table.number(row, "rate") / rateOf("derivatives-direct"));
        if (variant == "derivatives-cached") cached.add(table.number(row, "rate") / rateOf("derivatives-direct"));
    }
    std::string out = "\nOver all widths and angles of the sweep, float:";
    if (!drifting.empty()) {
        out += " without restarts forward differences drift by up to " + readable(drifting.high(), 2) +
               " texels, with them no variant errs by more than " + readable(restarted.high(), 2) + ";";
    }
    if (!streams.empty()) out += " sixteen streams write " + streams.text() + "% of the fill";
    if (!narrow.empty()) out += " (" + narrow.text() + "% at 640 pixels, where what is done once a row is felt)";
    if (!streams.empty()) out += ";";
    if (!iterative.empty()) {
        out += " the ellipse by iterated derivatives runs at " + readable(iterative.mean(), 3) +
               " times the direct form's rate (geometric mean), by cached coefficients at " +
               readable(cached.mean(), 3) + " times (" + cached.text() + ");";
    }
    out.back() = '.';
    return out + "\n";
}

std::string rowsTable(const Table& table) {
    const Row place{{"width", "16384"}, {"elevation", "25"}, {"precision", "float"}};
    Row filled = place;
    filled["variant"] = "fill";
    const double fill = table.number(table.at(filled), "rate");
    std::string out = head({"variant", "paper: mul / add / div", "here", "restarts every", "Mpixels/s", "+-%",
                            "of the fill", "error, texels"},
                           4);
    for (const Row& row : table.rows()) {
        if (!std::all_of(place.begin(), place.end(),
                         [&](const auto& p) { return table.text(row, p.first) == p.second; })) {
            continue;
        }
        const std::string& variant = table.text(row, "variant");
        // Spelled as --variants and --mapping take it.
        const bool never = variant.starts_with("incremental") && table.text(row, "anchor") == "0";
        std::string name = "`" + variant + (never ? ":anchor=0`" : "`");
        if (variant == "streams") name += ", " + table.text(row, "streams");
        if (variant == "subspan") name += ", " + table.text(row, "span") + " pixels";
        const std::string& anchor = table.text(row, "anchor");
        const bool restarts = variant.starts_with("incremental") || variant == "streams" || variant == "subspan";
        const std::string& error = table.text(row, "error_max");
        out += line({name, paperCounts(variant),
                     joined({three(table.number(row, "mul")), three(table.number(row, "add")),
                             three(table.number(row, "div"))}),
                     anchor != "0" ? anchor + " pixels"
                     : restarts    ? "never"
                                   : "",
                     three(table.number(row, "rate") / 1e6), readable(100 * table.number(row, "spread"), 2),
                     three(table.number(row, "rate") / fill),
                     error.empty() ? "" : readable(parseNumber(error, table.path()), 2)});
    }
    return out + rowsSentences(table) + origin(table);
}

// Returns a filter's name with the options that were given, as the benchmark takes it.
std::string filterName(const Table& table, const Row& row) {
    const std::string& name = table.text(row, "filter");
    if (!name.starts_with("elliptical") || name.starts_with("elliptical-visible")) return name;
    const std::string& weights = table.text(row, "weights");
    const std::string& source = table.text(row, "implementation");
    const std::string& levels = table.text(row, "levels");
    return name + (weights == "gaussian" ? "" : ":weights=" + weights) +
           (source == "map" || source == "table" ? ":source=" + source : "") +
           (source == "direct" && weights == "gaussian" ? ":implementation=scalar" : "") +
           (levels == "exhaustive" ? ":levels=exhaustive" : "");
}

// Returns the values of one filter at each elevation: "314 / 353 / 409".
std::string overElevations(const Table& table, const std::string& filter, Row key,
                           const std::function<std::string(const Row&)>& value) {
    std::vector<std::string> parts;
    for (const std::string& elevation : table.values("elevation")) {
        key["elevation"] = elevation;
        for (const Row& row : table.rows()) {
            const bool fits = filterName(table, row) == filter &&
                              std::all_of(key.begin(), key.end(),
                                          [&](const auto& w) { return table.text(row, w.first) == w.second; });
            if (!fits) continue;
            parts.push_back(value(row));
            break;
        }
    }
    return joined(parts);
}

std::vector<std::string> filterNames(const Table& table) {
    std::vector<std::string> names;
    for (const Row& row : table.rows()) {
        const std::string name = filterName(table, row);
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}

// Returns the range of the ratios of the column for `first` to that for `second`, over all cells that contain both.
Range ratiosOf(const Table& table, const std::string& column, const std::string& first, const std::string& second,
               const std::string& pixelModel) {
    Range ratios;
    for (const Row& one : table.rows()) {
        if (filterName(table, one) != first || table.text(one, "pixel_model") != pixelModel) continue;
        for (const Row& other : table.rows()) {
            if (filterName(table, other) != second || table.text(other, "pixel_model") != pixelModel ||
                table.text(other, "scene") != table.text(one, "scene") ||
                table.text(other, "elevation") != table.text(one, "elevation")) {
                continue;
            }
            ratios.add(table.number(one, column) / table.number(other, column));
        }
    }
    return ratios;
}

std::string checkerSentences(const Table& table) {
    std::string out;
    const auto say = [&](const std::string& column, const std::string& first, const std::string& second,
                         const std::string& words) {
        const Range ratios = ratiosOf(table, column, first, second, "gaussian");
        if (!ratios.empty()) out += words + " " + ratios.text() + " times; ";
    };
    say("rmse", "trilinear", "elliptical", "Against a Gaussian pixel the error of `trilinear` is that of `elliptical`");
    say("rmse", "elliptical", "elliptical:levels=exhaustive", "that of `elliptical` is that of level 0 alone");
    say("rate", "elliptical", "elliptical:implementation=scalar", "rates: SIMD over the reference implementation");
    say("rate", "elliptical:source=table", "elliptical:implementation=scalar",
        "a table over the formula, both scalar,");
    say("rate", "elliptical:source=map", "elliptical:implementation=scalar", "the papers' map over the formula");
    if (out.empty()) return out;
    out.resize(out.size() - 2);
    return "\n" + out + ".\n";
}

// Errors and costs of the forms that take the relief into account, as multiples of those of plain filtering.
std::string reliefSentences(const Table& table) {
    std::string out;
    for (const std::string& name : filterNames(table)) {
        if (!name.starts_with("elliptical-visible")) continue;
        const Range errors = ratiosOf(table, "rmse", name, "elliptical", "gaussian");
        const Range costs = ratiosOf(table, "rate", "elliptical", name, "gaussian");
        if (errors.empty()) continue;
        out += " `" + name + "` " + readable(errors.mean(), 2) + " (" + errors.text() + ") of the error at " +
               readable(costs.mean(), 2) + " (" + costs.text() + ") times the cost;";
    }
    if (out.empty()) return out;
    out.back() = '.';
    return "\nOver plain `elliptical`, geometric mean (range) of all cells:" + out + "\n";
}

std::string checkerTable(const Table& table) {
    std::string out = head({"filter", "Gaussian pixel", "box pixel", "texels", "Mpixels/s"}, 1);
    const auto error = [&](const Row& row) { return three(1000 * table.number(row, "rmse")); };
    for (const std::string& name : filterNames(table)) {
        const Row gaussian{{"pixel_model", "gaussian"}};
        out += line({"`" + name + "`", overElevations(table, name, gaussian, error),
                     overElevations(table, name, {{"pixel_model", "box"}}, error),
                     overElevations(table, name, gaussian,
                                    [&](const Row& row) { return three(table.number(row, "texels_read")); }),
                     overElevations(table, name, gaussian,
                                    [&](const Row& row) { return three(table.number(row, "rate") / 1e6); })});
    }
    return out + checkerSentences(table) + origin(table);
}

std::string reliefTable(const Table& table) {
    const std::vector<std::string> scenes = table.values("scene");
    std::vector<std::string> names{"filter"};
    for (const std::string& scene : scenes)
        names.push_back(std::filesystem::path(scene).parent_path().empty()
                            ? scene
                            : std::filesystem::path(scene).parent_path().filename().string());
    names.insert(names.end(), {"read: " + names[1], "hidden", "Mpixels/s"});
    std::string out = head(names, 1);
    for (const std::string& name : filterNames(table)) {
        std::vector<std::string> cells{"`" + name + "`"};
        const auto over = [&](const std::string& scene, const std::string& column, double factor) {
            return overElevations(table, name, {{"scene", scene}, {"pixel_model", "gaussian"}},
                                  [&](const Row& row) { return three(factor * table.number(row, column)); });
        };
        for (const std::string& scene : scenes) cells.push_back(over(scene, "rmse", 1000));
        cells.push_back(over(scenes[0], "texels_read", 1));
        cells.push_back(over(scenes[0], "hidden", 1));
        cells.push_back(over(scenes[0], "rate", 1e-6));
        out += line(cells);
    }
    return out + reliefSentences(table) + origin(table);
}

std::string tableOf(const std::string& name, const std::filesystem::path& folder) {
    static const std::map<std::string, std::string (*)(const Table&)> made{{"rows", rowsTable},
                                                                           {"filters_checker", checkerTable},
                                                                           {"filters_relief", reliefTable},
                                                                           {"filters_position", reliefTable},
                                                                           {"peers", peersTable},
                                                                           {"filter_peers", filterPeersTable},
                                                                           {"distance_peers", distancePeersTable},
                                                                           {"frames", framesTable}};
    const auto found = made.find(name);
    if (found == made.end()) {
        const std::filesystem::path file = folder / (name + ".md");
        return std::filesystem::exists(file) ? readTextFile(file.string()) : std::string();
    }
    const std::filesystem::path file = folder / (name + ".csv");
    return std::filesystem::exists(file) ? found->second(Table(file.string())) : std::string();
}

}  // namespace

std::string withTables(const std::string& document, const std::string& folder) {
    const std::string opening = "<!-- table ";
    std::string out;
    std::string kept;  // of the table being replaced
    std::string fresh;
    bool inside = false;
    for (const std::string& text : linesOf(document)) {
        if (text == "<!-- end -->" && inside) {
            out += (fresh.empty() ? kept : "\n" + fresh + "\n") + text + "\n";
            inside = false;
        } else if (inside) {
            kept += text + "\n";
        } else {
            out += text + "\n";
            if (!text.starts_with(opening) || !text.ends_with(" -->")) continue;
            inside = true;
            kept.clear();
            fresh = tableOf(text.substr(opening.size(), text.size() - opening.size() - 4), folder);
            while (fresh.starts_with('\n')) fresh.erase(0, 1);
            while (fresh.ends_with('\n')) fresh.pop_back();
            if (!fresh.empty()) fresh += "\n";
        }
    }
    if (inside) fail("the document", "a table without an end");
    return out;
}

}  // namespace relief::claims
