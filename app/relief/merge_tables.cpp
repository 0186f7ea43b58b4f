#include "merge_tables.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "measuring/bench/bench_columns.h"
#include "measuring/verify/stress_record.h"
#include "output.h"
#include "stress_report.h"

namespace relief::app {

namespace {

template <class T>
std::optional<Json> numberOf(const std::string& text) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return Json(value);
}

// The type of a column's fields: integers, real numbers (or words among them, such as elevation "random"), words.
enum class Kind : std::uint8_t { Whole, Real, Word };

// Converts a field as benchField() wrote it: an empty field is a missing number.
Json valueOf(const CsvField& field, Kind kind) {
    if (kind == Kind::Word || field.quoted) return field.text;
    if (field.text.empty()) return nullptr;
    if (kind == Kind::Whole) {
        for (const auto& number : {numberOf<std::int64_t>(field.text), numberOf<std::uint64_t>(field.text)}) {
            if (number) return *number;
        }
    }
    const auto real = numberOf<double>(field.text);
    return real && std::isfinite(real->get<double>()) ? *real : Json(field.text);
}

[[noreturn]] void failLine(const std::string& path, std::size_t line) {
    throw InputError(path, Message(MessageId::PartLineWrong, {{"line", line}}));
}

// The rows of one cell.
struct Cell {
    std::size_t index = 0;
    std::vector<std::string_view> rows;
};

struct Table {
    std::string_view header;
    std::string from;                    // the first file with this header
    std::set<std::string> words, reals;  // columns with at least one word, or one non-integer
    std::vector<Cell> cells;

    Kind kindOf(const std::string& column) const {
        if (reals.contains(column)) return Kind::Real;
        return words.contains(column) ? Kind::Word : Kind::Whole;
    }
};

// Returns the part's cells and the number of rows of each; throws InputError if the part line does not list them.
std::vector<std::pair<std::size_t, std::size_t>> announcedCells(const TextPart& part) {
    const Json announced = part.part.more.value("rows", Json());
    if (!announced.is_array()) failLine(part.path, 1);
    std::vector<std::pair<std::size_t, std::size_t>> cells;
    for (const Json& cell : announced) {
        const bool pair = cell.is_array() && cell.size() == 2;
        if (!pair || !cell[0].is_number_unsigned() || !cell[1].is_number_unsigned()) failLine(part.path, 1);
        cells.emplace_back(cell[0].get<std::size_t>(), cell[1].get<std::size_t>());
        if (!part.part.has(cells.back().first)) failLine(part.path, 1);
    }
    return cells;
}

void readTable(const TextPart& part, Table& table) {
    std::string_view text = std::string_view(part.text).substr(part.body);
    const auto header = takeRecord(text);
    if (!header || header->empty()) failLine(part.path, 2);
    if (table.header.empty()) {
        table.header = *header;
        table.from = part.path;
    }
    if (*header != table.header) {
        throw InputError(part.path, Message(MessageId::PartOtherRun, {{"other", table.from},
                                                                      {"what", "line 2"},
                                                                      {"here", std::string(*header)},
                                                                      {"there", std::string(table.header)}}));
    }
    const std::size_t columns = csvFields(*header).size();
    std::vector<std::string_view> rows;
    while (const auto record = takeRecord(text)) {
        rows.push_back(*record);
        if (csvFields(*record).size() != columns) failLine(part.path, 2 + rows.size());
    }
    if (!text.empty()) failLine(part.path, 3 + rows.size());
    std::size_t used = 0;
    const auto announced = announcedCells(part);
    for (const auto& [index, count] : announced) {
        if (count > rows.size() || used > rows.size() - count) {
            throw InputError(part.path,
                             Message(MessageId::PartRowsWrong, {{"told", used + count}, {"found", rows.size()}}));
        }
        const auto first = rows.begin() + static_cast<std::ptrdiff_t>(used);
        table.cells.push_back({index, {first, first + static_cast<std::ptrdiff_t>(count)}});
        used += count;
    }
    if (used != rows.size()) {
        throw InputError(part.path, Message(MessageId::PartRowsWrong, {{"told", used}, {"found", rows.size()}}));
    }
    for (const auto& [key, columns] : {std::pair("words", &table.words), std::pair("reals", &table.reals)}) {
        for (const Json& name : part.part.more.value(key, Json::array())) {
            if (name.is_string()) columns->insert(name.get<std::string>());
        }
    }
}

std::string csvText(const Table& table) {
    std::string text = std::string(table.header) + "\n";
    for (const Cell& cell : table.cells) {
        for (const std::string_view row : cell.rows) text.append(row).append("\n");
    }
    return text;
}

std::string jsonText(const Table& table) {
    const std::vector<CsvField> names = csvFields(table.header);
    Json rows = Json::array();
    for (const Cell& cell : table.cells) {
        for (const std::string_view row : cell.rows) {
            const std::vector<CsvField> fields = csvFields(row);
            Json object = Json::object();
            for (std::size_t n = 0; n < names.size(); ++n) {
                object[names[n].text] = valueOf(fields[n], table.kindOf(names[n].text));
            }
            rows.push_back(std::move(object));
        }
    }
    return rows.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

void mergeTables(const std::vector<TextPart>& parts, const std::string& output, Session& session) {
    checkOutput(output, {"csv", "json"});
    Table table;
    for (const TextPart& part : parts) readTable(part, table);
    std::stable_sort(table.cells.begin(), table.cells.end(),
                     [](const Cell& a, const Cell& b) { return a.index < b.index; });
    for (std::size_t n = 0; n < table.cells.size(); ++n) {
        if (table.cells[n].index == n) continue;
        // Every cell must occur exactly once: otherwise a part repeats a cell, or the part that should hold the n-th
        // cell lacks it.
        const std::size_t wrong = std::min(n, table.cells[n].index);
        const auto owner =
            std::find_if(parts.begin(), parts.end(), [&](const TextPart& p) { return p.part.has(wrong); });
        failLine(owner->path, 1);
    }
    TextOutput file(output, session.stop());
    file.write(fileEnding(output) == "json" ? jsonText(table) : csvText(table));
    file.commit();
}

namespace {

// Reads the lines of one part's record in order.
class RecordReader {
  public:
    explicit RecordReader(const TextPart& part) : part_(part), left_(std::string_view(part.text).substr(part.body)) {}

    // Returns the next case, which must have this number, and its line including "\n".
    std::pair<StressCase, std::string_view> next(std::uint64_t number) {
        ++line_;
        const std::size_t end = left_.find('\n');
        if (end == std::string_view::npos) failLine(part_.path, line_);
        const std::string_view line = left_.substr(0, end + 1);
        auto one = parseStressCase(line);
        if (!one || one->number != number) failLine(part_.path, line_);
        left_.remove_prefix(end + 1);
        return {std::move(*one), line};
    }
    void expectEnd() const {
        if (!left_.empty()) failLine(part_.path, line_ + 1);
    }

  private:
    const TextPart& part_;
    std::string_view left_;
    std::size_t line_ = 1;
};

}  // namespace

int mergeRecords(const std::vector<TextPart>& parts, const std::optional<std::string>& output, Session& session) {
    if (output) checkOutput(*output, {"jsonl"});
    const TextPart& first = parts.front();
    const Json options = first.part.run.value("options", Json::object());
    const auto number = [&](const char* name) {
        const auto found = options.find(name);
        if (found == options.end() || !found->is_number_unsigned()) failLine(first.path, 1);
        return found->get<std::uint64_t>();
    };
    const std::uint64_t cases = number("cases");
    std::vector<RecordReader> readers;
    for (const TextPart& part : parts) readers.emplace_back(part);
    std::unique_ptr<TextOutput> record;
    if (output) {
        record = std::make_unique<TextOutput>(*output, session.stop());
        record->write(runLine(first.part.run) + "\n");
    }
    StressTally tally;
    for (std::uint64_t n = 0; n < cases; ++n) {
        const auto [one, line] = readers[n % readers.size()].next(n);
        tally.add(one);
        if (record) record->write(line);
    }
    for (const RecordReader& reader : readers) reader.expectEnd();
    if (record) record->commit();
    return reportStress(tally.report(), number("seed"), session);
}

}  // namespace relief::app
