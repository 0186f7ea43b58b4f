#include "scenario/json_reader.h"

#include <algorithm>

namespace relief {

namespace {

// Returns the position after the string that begins at `at`.
std::size_t pastString(const std::string& text, std::size_t at) {
    for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] == '\\') ++at;
    }
    return at;
}

// Returns the beginning of the n-th element of the first array at or after `at`.
std::size_t elementAt(const std::string& text, std::size_t at, std::size_t n) {
    const std::size_t begin = text.find('[', at);
    if (begin == std::string::npos) return at;
    int depth = 1;
    std::size_t i = begin + 1;
    for (; i < text.size() && depth > 0 && n > 0; ++i) {
        const char c = text[i];
        if (c == '"') i = pastString(text, i);
        if (c == '[' || c == '{') ++depth;
        if (c == ']' || c == '}') --depth;
        if (c == ',' && depth == 1) --n;
    }
    const std::size_t found = text.find_first_not_of(" \t\r\n", i);
    return found == std::string::npos ? begin : found;
}

// Where the key is named at or after `at`; npos: nowhere. A text of the same letters is no key.
std::size_t keyAt(const std::string& text, std::size_t at, const std::string& key) {
    const std::string quoted = '"' + key + '"';
    for (at = text.find(quoted, at); at != std::string::npos; at = text.find(quoted, at + 1)) {
        const std::size_t next = text.find_first_not_of(" \t\r\n", at + quoted.size());
        if (next != std::string::npos && text[next] == ':') break;
    }
    return at;
}

std::size_t lineAt(const std::string& text, std::size_t at) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(at, text.size()));
    return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

// The library copies and writes nested values by recursion.
void checkDepth(const std::string& text, const std::string& fileName) {
    constexpr int kDeepest = 100;
    int depth = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"') at = pastString(text, at);
        if (c == '[' || c == '{') ++depth;
        if (c == ']' || c == '}') --depth;
        if (depth > kDeepest) {
            throw InputError(fileName,
                             Message(MessageId::JsonTooDeep, {{"line", lineAt(text, at)}, {"most", kDeepest}}));
        }
    }
}

}  // namespace

std::string placeText(const JsonPlace& place) {
    if (const auto* const key = std::get_if<std::string>(&place)) return *key;
    return "[" + std::to_string(std::get<std::size_t>(place)) + "]";
}

std::size_t lineOf(const std::string& text, const JsonPath& path) {
    std::size_t at = 0;
    for (const JsonPlace& place : path) {
        if (const auto* const element = std::get_if<std::size_t>(&place)) {
            at = elementAt(text, at, *element);
            continue;
        }
        const std::size_t found = keyAt(text, at, std::get<std::string>(place));
        if (found == std::string::npos) break;
        at = found;
    }
    return lineAt(text, at);
}

Json parseJson(const std::string& text, const std::string& fileName) {
    checkDepth(text, fileName);
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw InputError(fileName, Message(MessageId::ScenarioNotJson, {{"line", lineAt(text, error.byte)}}));
    } catch (const Json::exception&) {
        // For a number beyond double ("1e999") the library does not report the position.
        throw InputError(fileName, Message(MessageId::ScenarioNotJson, {{"line", 1}}));
    }
}

}  // namespace relief
