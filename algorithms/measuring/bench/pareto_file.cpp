// Reads the tables that `relief bench tracers` wrote.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include <nlohmann/json.hpp>

#include "measuring/bench/pareto.h"
#include "relief/files.h"

namespace relief {

namespace {

using Json = nlohmann::json;

// Reads one object of the array. Invalid values are reported with the row's number, from 1.
class RowReader {
  public:
    RowReader(const Json& object, std::size_t row, const std::string& fileName)
        : object_(object), row_(row), fileName_(fileName) {}

    std::string text(const char* column) const {
        const Json& value = at(column);
        if (!value.is_string()) fail(column);
        return value.get<std::string>();
    }
    // Reads a number of at least `low`; null gives NaN if that is allowed.
    double number(const char* column, double low, bool orNone = false) const {
        const Json& value = at(column);
        if (orNone && value.is_null()) return std::numeric_limits<double>::quiet_NaN();
        if (!value.is_number()) fail(column);
        const auto found = value.get<double>();
        if (!(found >= low) || !std::isfinite(found)) fail(column);
        return found;
    }
    double positive(const char* column) const {
        const double found = number(column, 0);
        if (!(found > 0)) fail(column);
        return found;
    }
    std::int64_t whole(const char* column) const {
        const Json& value = at(column);
        if (!value.is_number_integer() || value.get<double>() < 0 || value.get<double>() > 9e18) fail(column);
        return value.get<std::int64_t>();
    }
    // Converts a text by `parse`, and reports what it throws as an invalid value.
    template <class Parse>
    auto parsed(const char* column, const Parse& parse) const {
        const std::string word = text(column);
        try {
            return parse(word);
        } catch (const InputError&) {
            fail(column);
        }
    }
    bool has(const char* column) const { return object_.contains(column); }
    const Json& at(const char* column) const {
        const auto found = object_.find(column);
        if (found == object_.end()) fail(column);
        return *found;
    }
    [[noreturn]] void fail(const char* column) const {
        throw InputError(fileName_, Message(MessageId::BenchRowColumn, {{"row", row_}, {"column", column}}));
    }

  private:
    const Json& object_;
    std::size_t row_;
    const std::string& fileName_;
};

void readSize(const RowReader& from, BenchRow& row) {
    from.parsed("size", [&](const std::string& text) {
        const std::size_t x = text.find('x');
        if (x == std::string::npos) from.fail("size");
        constexpr double kMostTexels = 1e9;
        const auto side = [&](const std::string& part) {
            const double texels = parseNumber(part, "size");
            if (!(texels >= 1 && texels <= kMostTexels)) from.fail("size");
            return static_cast<int>(texels);
        };
        row.width = side(text.substr(0, x));
        row.heightTexels = side(text.substr(x + 1));
        return 0;
    });
}

Elevation elevationAt(const RowReader& from) {
    if (!from.at("elevation").is_string()) return from.number("elevation", 0);
    if (from.text("elevation") != elevationText(std::nullopt)) from.fail("elevation");
    return std::nullopt;
}

// Tables of the first version have no such column; their rates are of the method's default implementation.
Form formAt(const RowReader& from, const MethodChoice& method) {
    if (from.has("form")) {
        return from.parsed("form", [](const std::string& text) { return parseForm(text, "form"); });
    }
    try {
        return methodForm(method);
    } catch (const InputError&) {
        return Form::Scalar;  // a method of another library
    }
}

BenchRow readRow(const RowReader& from) {
    BenchRow row;
    row.height = from.text("height");
    readSize(from, row);
    row.surface = from.parsed("surface", [](const std::string& text) { return parseSurface(text); });
    row.address = from.parsed("address", [](const std::string& text) { return parseAddress(text); });
    row.reliefDepth = from.number("relief_depth", 0);
    const std::string options = from.text("options");
    row.method = from.parsed("method", [&](const std::string& name) {
        return splitMethodChoice(options.empty() ? name : name + ":" + options, "method");
    });
    row.form = formAt(from, row.method);
    row.elevation = elevationAt(from);
    if (!from.at("seed").is_number_integer()) from.fail("seed");
    row.seed = from.at("seed").get<std::uint64_t>();
    row.threads = static_cast<int>(std::min<std::int64_t>(from.whole("threads"), std::numeric_limits<int>::max()));
    row.rate = from.positive("rate");
    row.spread = from.number("spread", 0);
    row.errors.mean = from.number("error_mean", 0, true);
    row.errors.p95 = from.number("error_p95", 0, true);
    row.errors.p9999 = from.number("error_p9999", 0, true);
    row.errors.max = from.number("error_max", 0, true);
    row.errors.wrongOutcome = from.whole("wrong_outcome");
    row.errors.overshoots = from.whole("overshoots");
    row.stepsMean = from.number("steps_mean", 0, true);
    row.stepsP95 = from.whole("steps_p95");
    row.stepsMax = from.whole("steps_max");
    row.readsMean = from.number("reads_mean", 0, true);
    row.memoryBytes = from.whole("memory_bytes");
    row.buildSeconds = from.number("build_seconds", 0, true);
    row.compiler = from.text("compiler");
    row.cpu = from.text("cpu");
    row.commit = from.text("commit");
    return row;
}

// Returns the value of a CSV field as the JSON table has it: a text, a number, or null. The column determines which.
Json valueOf(const CsvField& field, const std::string& column) {
    static const BenchRow kStandard;
    const auto& columns = benchColumns();
    const auto known = std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.name == column; });
    // An elevation is a number or "random".
    const bool word = column == "elevation" ? field.text == elevationText(std::nullopt)
                                            : known != columns.end() && known->get(kStandard).index() == 0;
    if (word) return field.text;
    return field.text.empty() ? Json() : Json::parse(field.text, nullptr, false);
}

Json jsonOfCsv(std::string_view text, const std::string& fileName) {
    const std::vector<CsvField> names = csvFields(takeRecord(text).value_or(""));
    Json rows = Json::array();
    while (const auto record = takeRecord(text)) {
        const std::vector<CsvField> fields = csvFields(*record);
        if (fields.size() != names.size()) throw InputError(fileName, Message(MessageId::BenchNotTable));
        Json object = Json::object();
        for (std::size_t n = 0; n < names.size(); ++n) object[names[n].text] = valueOf(fields[n], names[n].text);
        rows.push_back(std::move(object));
    }
    // A table that was cut short.
    if (!text.empty()) throw InputError(fileName, Message(MessageId::BenchNotTable));
    return rows;
}

std::vector<BenchRow> rowsOf(const Json& json, const std::string& fileName) {
    if (!json.is_array()) throw InputError(fileName, Message(MessageId::BenchNotTable));
    if (json.empty()) throw InputError(fileName, Message(MessageId::BenchNoRows));
    std::vector<BenchRow> rows;
    for (const Json& object : json) {
        // Tables of the row and filter benchmarks have rows, too.
        if (!object.is_object() || (rows.empty() && !object.contains("error_mean"))) {
            throw InputError(fileName, Message(MessageId::BenchNotTable));
        }
        rows.push_back(readRow(RowReader(object, rows.size() + 1, fileName)));
    }
    return rows;
}

}  // namespace

std::vector<BenchRow> parseBenchCsv(const std::string& text, const std::string& fileName) {
    return rowsOf(jsonOfCsv(text, fileName), fileName);
}

std::vector<BenchRow> parseBenchJson(const std::string& text, const std::string& fileName) {
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        throw InputError(fileName,
                         Message(MessageId::ScenarioNotJson, {{"line", 1 + std::count(text.begin(), end, '\n')}}));
    } catch (const Json::exception&) {
        throw InputError(fileName, Message(MessageId::ScenarioNotJson, {{"line", 1}}));  // a number beyond double
    }
    return rowsOf(json, fileName);
}

std::vector<BenchRow> readBenchTable(const std::string& path) {
    const std::string text = readTextFile(path);
    return std::filesystem::path(path).extension() == ".csv" ? parseBenchCsv(text, path) : parseBenchJson(text, path);
}

}  // namespace relief
