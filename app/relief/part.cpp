#include "part.h"

#include <algorithm>
#include <cstdio>

#include "measuring/bench/machine.h"
#include "options_common.h"

namespace relief::app {

namespace {

constexpr std::size_t kShownLetters = 60;  // of a value in a message
constexpr std::size_t kShownParts = 20;    // of the missing parts listed in a message

std::string shown(const Json* value) {
    std::string text = value == nullptr ? "null" : asciiLine(*value);
    if (text.size() > kShownLetters) text = text.substr(0, kShownLetters) + "...";
    return text;
}

// Returns the first member that differs, descending into nested objects; members of `there` that `here` lacks come
// last.
std::optional<RunDifference> firstDifference(const Json* here, const Json* there, const std::string& name) {
    if (here == there || (here != nullptr && there != nullptr && *here == *there)) return std::nullopt;
    if (here == nullptr || there == nullptr || !here->is_object() || !there->is_object()) {
        return RunDifference{name, shown(here), shown(there)};
    }
    for (const Json* object : {here, there}) {
        for (const auto& [key, value] : object->items()) {
            if (auto found = firstDifference(member(*here, key.c_str()), member(*there, key.c_str()),
                                             name.empty() ? key : name + "." + key)) {
                return found;
            }
        }
    }
    // The members are equal and differ only in order.
    return std::nullopt;
}

void requireSameRun(const PartFile& file, const PartFile& first) {
    const auto difference = runDifference(file.part.run, first.part.run);
    if (difference && difference->what == "kind") {
        throw InputError(file.path, Message(MessageId::PartOtherKind, {{"other", first.path}}));
    }
    if (difference) {
        throw InputError(file.path, Message(MessageId::PartOtherRun, {{"other", first.path},
                                                                      {"what", difference->what},
                                                                      {"here", difference->here},
                                                                      {"there", difference->there}}));
    }
    if (file.part.of == first.part.of) return;
    const auto number = [](const Part& part) { return std::to_string(part.part) + "/" + std::to_string(part.of); };
    throw InputError(file.path, Message(MessageId::PartOtherRun, {{"other", first.path},
                                                                  {"what", "--part"},
                                                                  {"here", number(file.part)},
                                                                  {"there", number(first.part)}}));
}

}  // namespace

PartNumber parsePartNumber(const std::string& text) {
    const std::vector<std::string> halves = splitText(text, '/');
    try {
        if (halves.size() == 2) {
            const auto of = static_cast<int>(parseWhole(halves[1], "--part", 1, kMostParts));
            return {static_cast<int>(parseWhole(halves[0], "--part", 1, of)), of};
        }
    } catch (const InputError&) {
        // All faults of the run go into one message.
    }
    throw InputError("--part", Message(MessageId::PartSyntax, {{"text", text}, {"most", kMostParts}}));
}

RowRange partRows(const PartNumber& number, int height) {
    if (number.of > height) {
        throw InputError("--part", Message(MessageId::PartRows, {{"of", number.of}, {"height", height}}));
    }
    const auto border = [&](int part) { return static_cast<int>(std::int64_t{height} * part / number.of); };
    return {border(number.part - 1), border(number.part)};
}

std::string ContentHash::text() const {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash_));
    return text;
}

std::string hashText(std::span<const std::byte> bytes) {
    ContentHash hash;
    for (const std::byte byte : bytes) hash.add(static_cast<std::uint64_t>(byte));
    return hash.text();
}

Json runJson(const std::string& kind, Json options, std::span<const std::string> cells) {
    std::string names;
    // No name contains a line break.
    for (const std::string& cell : cells) names += cell + "\n";
    const Json run{{"kind", kind},
                   {"commit", commitText()},
                   {"options", std::move(options)},
                   {"cells", hashText(std::as_bytes(std::span(names)))}};
    return readBack(run);
}

std::string partLine(const Part& part) {
    Json line{{"relief part", part.part}, {"of", part.of}, {"run", part.run}};
    line.update(part.more);
    return asciiLine(line);
}

std::string runLine(const Json& run) {
    Json line;
    line["run"] = run;
    return asciiLine(line);
}

std::optional<Part> parsePartLine(std::string_view text) {
    Json line = Json::parse(text, nullptr, false);
    if (!line.is_object()) return std::nullopt;
    const auto number = [&](const char* name) {
        const std::int64_t value = numberIn(line, name, 0);
        return value >= 1 && value <= kMostParts ? static_cast<int>(value) : 0;
    };
    Part part;
    part.part = number("relief part");
    part.of = number("of");
    const Json* const run = member(line, "run");
    if (part.part < 1 || part.part > part.of || run == nullptr || !run->is_object()) return std::nullopt;
    for (const char* name : {"kind", "commit", "cells"}) {
        if (!run->value(name, Json()).is_string()) return std::nullopt;
    }
    if (!run->value("options", Json()).is_object()) return std::nullopt;
    part.run = *run;
    for (const char* name : {"relief part", "of", "run"}) line.erase(name);
    part.more = std::move(line);
    return part;
}

std::optional<RunDifference> runDifference(const Json& here, const Json& there) {
    const Json none = Json::object();
    const auto options = [&](const Json& run) {
        const Json* const found = member(run, "options");
        return found == nullptr ? &none : found;
    };
    for (const char* name : {"kind", "commit"}) {
        if (auto found = firstDifference(member(here, name), member(there, name), name)) return found;
    }
    const Json* const mine = options(here);
    const Json* const theirs = options(there);
    const Json* const seed = member(*mine, "seed");
    const Json* const otherSeed = member(*theirs, "seed");
    if (seed != nullptr || otherSeed != nullptr) {
        if (auto found = firstDifference(seed, otherSeed, "seed")) return found;
    }
    if (auto found = firstDifference(mine, theirs, "")) return found;
    return firstDifference(&here, &there, "");
}

void requireWholeRun(const std::vector<PartFile>& files) {
    const PartFile& first = files.front();
    std::vector<const PartFile*> found(static_cast<std::size_t>(first.part.of), nullptr);
    for (const PartFile& file : files) {
        requireSameRun(file, first);
        const PartFile*& place = found[static_cast<std::size_t>(file.part.part - 1)];
        if (place != nullptr) {
            throw InputError(file.path,
                             Message(MessageId::PartTwice,
                                     {{"part", file.part.part}, {"of", file.part.of}, {"other", place->path}}));
        }
        place = &file;
    }
    if (files.size() == found.size()) return;
    std::string missing;
    std::size_t count = 0;
    for (std::size_t n = 0; n < found.size(); ++n) {
        if (found[n] != nullptr || ++count > kShownParts) continue;
        missing += (missing.empty() ? "" : ", ") + std::to_string(n + 1);
    }
    if (count > kShownParts) missing += ", ...";
    throw InputError(first.path, Message(MessageId::PartsMissing, {{"of", first.part.of}, {"parts", missing}}));
}

}  // namespace relief::app
