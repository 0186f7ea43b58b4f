#include "results_file.h"

#include <array>
#include <chrono>
#include <ctime>
#include <filesystem>

#include "measuring/bench/bench_columns.h"
#include "relief/files.h"

namespace relief::claims {

namespace {

constexpr int kDigits = 3;

// Returns the local date on which the file was last written: "2026-11-26".
std::string dayOf(const std::string& path) {
    const auto written = std::chrono::file_clock::to_sys(std::filesystem::last_write_time(path));
    const std::time_t time = std::chrono::system_clock::to_time_t(written);
    std::array<char, 16> day{};
    std::strftime(day.data(), day.size(), "%Y-%m-%d", std::localtime(&time));
    return day.data();
}

}  // namespace

void fail(const std::string& file, const std::string& why) {
    throw InputError(file, Message(MessageId::FileDamaged, {{"why", why}}));
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

Table::Table(const std::string& path) : path_(path) {
    const auto lines = linesOf(readTextFile(path));
    if (lines.empty()) fail(path, "empty");
    const auto names = csvFields(lines[0]);
    for (std::size_t l = 1; l < lines.size(); ++l) {
        const auto fields = csvFields(lines[l]);
        if (fields.size() != names.size()) fail(path, "line " + std::to_string(l + 1));
        rows_.emplace_back();
        for (std::size_t c = 0; c < names.size(); ++c) rows_.back()[names[c].text] = fields[c].text;
    }
    if (rows_.empty()) fail(path, "no rows");
}

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

std::string origin(const Table& table) {
    const Row& row = table.rows().at(0);
    return "\n(" + table.text(row, "cpu") + ", " + table.text(row, "threads") + " thread(s), " +
           table.text(row, "compiler") + ", sources " + table.text(row, "commit") + ", " + dayOf(table.path()) + ")\n";
}

}  // namespace relief::claims
