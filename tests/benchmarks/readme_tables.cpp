#include "readme_tables.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <vector>

#include "errors.h"
#include "images/files.h"
#include "measuring/text_table.h"
#include "relief/describe.h"

namespace relief::claims {

namespace {

constexpr int kDigits = 3;

[[noreturn]] void fail(const std::string& file, const std::string& why) {
    throw InputError(file, Message(MessageId::FileDamaged, {{"why", why}}));
}

std::vector<std::string> fieldsOf(const std::string& line) {
    std::vector<std::string> fields(1);
    bool inside = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool twice = line[i] == '"' && inside && i + 1 < line.size() && line[i + 1] == '"';
        if (twice) {
            fields.back() += line[i++];
        } else if (line[i] == '"') {
            inside = !inside;
        } else if (line[i] == ',' && !inside) {
            fields.emplace_back();
        } else {
            fields.back() += line[i];
        }
    }
    return fields;
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::size_t first = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', first)) {
        lines.push_back(text.substr(first, end - first));
        first = end + 1;
    }
    if (first < text.size()) lines.push_back(text.substr(first));
    return lines;
}

using Row = std::map<std::string, std::string>;

// A file of a benchmark.
class Table {
  public:
    explicit Table(const std::string& path) : path_(path) {
        const auto lines = linesOf(readTextFile(path));
        const auto names = fieldsOf(lines.at(0));
        for (std::size_t l = 1; l < lines.size(); ++l) {
            const auto fields = fieldsOf(lines[l]);
            if (fields.size() != names.size()) fail(path, "line " + std::to_string(l + 1));
            rows_.emplace_back();
            for (std::size_t c = 0; c < names.size(); ++c) rows_.back()[names[c]] = fields[c];
        }
    }

    const std::vector<Row>& rows() const { return rows_; }
    const std::string& path() const { return path_; }
    // The only row with these values.
    const Row& at(const Row& wanted) const {
        const Row* found = nullptr;
        for (const Row& row : rows_) {
            if (!std::all_of(wanted.begin(), wanted.end(),
                             [&](const auto& w) { return text(row, w.first) == w.second; })) {
                continue;
            }
            if (found != nullptr) fail(path_, "two rows " + told(wanted));
            found = &row;
        }
        if (found == nullptr) fail(path_, "no row " + told(wanted));
        return *found;
    }
    const std::string& text(const Row& row, const std::string& column) const {
        const auto found = row.find(column);
        if (found == row.end()) fail(path_, "no column " + column);
        return found->second;
    }
    double number(const Row& row, const std::string& column) const { return parseNumber(text(row, column), path_); }
    // Different values of a column, in the order of the rows.
    std::vector<std::string> values(const std::string& column) const {
        std::vector<std::string> all;
        for (const Row& row : rows_) {
            if (std::find(all.begin(), all.end(), text(row, column)) == all.end()) all.push_back(text(row, column));
        }
        return all;
    }

  private:
    static std::string told(const Row& wanted) {
        std::string out;
        for (const auto& [name, value] : wanted) out += (out.empty() ? "" : ", ") + name + " = " + value;
        return out;
    }

    std::string path_;
    std::vector<Row> rows_;
};

std::string line(const std::vector<std::string>& cells) {
    std::string out = "|";
    for (const std::string& cell : cells) out += cell.empty() ? " |" : " " + cell + " |";
    return out + "\n";
}

std::string head(const std::vector<std::string>& names, std::size_t left) {
    std::vector<std::string> rule;
    for (std::size_t c = 0; c < names.size(); ++c) rule.push_back(c < left ? "---" : "--:");
    return line(names) + line(rule);
}

std::string three(double value) {
    return readable(value, kDigits);
}

std::string joined(const std::vector<std::string>& parts) {
    std::string out;
    for (const std::string& part : parts) out += (out.empty() ? "" : " / ") + part;
    return out;
}

// Where it was measured, as the last line.
std::string origin(const Table& table) {
    const Row& row = table.rows().at(0);
    return "\n(" + table.text(row, "cpu") + ", " + table.text(row, "threads") + " thread(s), " +
           table.text(row, "compiler") + ", sources " + table.text(row, "commit") + ")\n";
}

// What [PERSP] counts for a pixel.
std::string paperCounts(const std::string& variant) {
    static const std::map<std::string, std::string> counts{
        {"direct", "8 / 8 / 2"}, {"row-constant", "4 / 4 / 2"}, {"incremental", "0 / 4 / 2"}, {"streams", "0 / 4 / 2"}};
    const auto found = counts.find(variant);
    return found == counts.end() ? "" : found->second;
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
        std::string name = "`" + variant + "`";
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
    return out + origin(table);
}

// A filter's name with the options that it was given, as the benchmark takes it.
std::string filterName(const Table& table, const Row& row) {
    const std::string& name = table.text(row, "filter");
    if (!name.starts_with("elliptical") || name.starts_with("elliptical-visible")) return name;
    const std::string& weights = table.text(row, "weights");
    const std::string& source = table.text(row, "implementation");
    const std::string& levels = table.text(row, "levels");
    return name + (weights == "gaussian" ? "" : ":weights=" + weights) +
           (source == "map" || source == "table" ? ":source=" + source : "") +
           (levels == "exhaustive" ? ":levels=exhaustive" : "");
}

// value of the rows of one filter at each elevation: "314 / 353 / 409".
std::string overElevations(const Table& table, const std::string& filter, Row wanted,
                           const std::function<std::string(const Row&)>& value) {
    std::vector<std::string> parts;
    for (const std::string& elevation : table.values("elevation")) {
        wanted["elevation"] = elevation;
        for (const Row& row : table.rows()) {
            const bool fits = filterName(table, row) == filter &&
                              std::all_of(wanted.begin(), wanted.end(),
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
    return out + origin(table);
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
    return out + origin(table);
}

// Our best method over Embree's best variant, a cell each view.
std::string peersTable(const Table& table) {
    std::string out = head({"map", "view", "method", "Mrays/s", "+-%", "Embree's fastest", "Mrays/s", "+-%", "ratio",
                            "Embree off, texels"},
                           3);
    double logarithms = 0;
    double least = 1e300;
    int cells = 0;
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
                logarithms += std::log(ratio);
                least = std::min(least, ratio);
                ++cells;
                const auto rate = [&](const Row& row) { return three(table.number(row, "rate") / 1e6); };
                const auto spread = [&](const Row& row) { return readable(100 * table.number(row, "spread"), 2); };
                out +=
                    line({map + " " + size, view, "`" + table.text(*ours, "method") + "`", rate(*ours), spread(*ours),
                          table.text(*theirs, "method") + " " + table.text(*theirs, "options"), rate(*theirs),
                          spread(*theirs), three(ratio), readable(table.number(*theirs, "error_p95"), 2)});
            }
        }
    }
    if (cells == 0) fail(table.path(), "no cell with both");
    return out + "\nGeometric mean of the " + std::to_string(cells) + " ratios " + three(std::exp(logarithms / cells)) +
           ", the least " + three(least) +
           ". Embree's surface is triangles, not bilinear patches: the last column, 95% of its hits are nearer to "
           "ours than that, is a difference of model.\n" +
           origin(table);
}

std::string tableOf(const std::string& name, const std::filesystem::path& folder) {
    static const std::map<std::string, std::string (*)(const Table&)> made{
        {"rows", rowsTable}, {"filters_checker", checkerTable}, {"filters_relief", reliefTable}, {"peers", peersTable}};
    const auto found = made.find(name);
    if (found == made.end()) {
        const std::filesystem::path file = folder / (name + ".md");
        return std::filesystem::exists(file) ? readTextFile(file.string()) : std::string();
    }
    const std::filesystem::path file = folder / (name + ".csv");
    return std::filesystem::exists(file) ? found->second(Table(file.string())) : std::string();
}

}  // namespace

std::string withTables(const std::string& readme, const std::string& folder) {
    const std::string opening = "<!-- table ";
    std::string out;
    std::string kept;  // of the table being replaced
    std::string fresh;
    bool inside = false;
    for (const std::string& text : linesOf(readme)) {
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
    if (inside) fail("README", "a table without an end");
    return out;
}

}  // namespace relief::claims
