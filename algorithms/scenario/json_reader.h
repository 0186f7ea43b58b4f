// Reads the members of one object of a JSON file by name and type, records which members nobody has read, and reports
// errors with their line.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "relief/errors.h"

namespace relief {

using Json = nlohmann::ordered_json;

// The keys of objects and the numbers of elements of arrays that lead to a value in a file.
using JsonPlace = std::variant<std::string, std::size_t>;
using JsonPath = std::vector<JsonPlace>;
// Returns the key, or "[3]" for an element.
std::string placeText(const JsonPlace& place);

// Returns the line (from 1) on which the text contains the value at this path, which is the line reported for an error
// in it.
std::size_t lineOf(const std::string& text, const JsonPath& path);
// Throws InputError with the line if the text is not JSON, or is nested more than 100 levels deep.
Json parseJson(const std::string& text, const std::string& fileName);

struct JsonSource {
    const std::string& text;
    const std::string& fileName;
};

class JsonReader {
  public:
    // path: keys that lead to the object in the file. Throws InputError if `object` is not a JSON object. Keeps
    // references.
    JsonReader(const JsonSource& source, const Json& object, JsonPath path)
        : source_(source), object_(object), path_(std::move(path)) {
        if (!object.is_object()) fail({}, MessageId::WantAObject);
    }

    bool has(const char* key) {
        known_.insert(key);
        return object_.contains(key);
    }
    void read(const char* key, double& value) {
        if (!has(key)) return;
        if (!object_[key].is_number()) fail(key, MessageId::WantANumber);
        value = object_[key].get<double>();
    }
    template <class T>
    requires std::integral<T>
    void readWhole(const char* key, T& value) {
        if (!has(key)) return;
        value = wholeAt<T>(key, object_[key]);
    }
    void read(const char* key, bool& value) {
        if (!has(key)) return;
        if (!object_[key].is_boolean()) fail(key, MessageId::WantABool);
        value = object_[key].get<bool>();
    }
    void read(const char* key, std::string& value) {
        if (!has(key)) return;
        if (!object_[key].is_string()) fail(key, MessageId::WantAText);
        value = object_[key].get<std::string>();
    }
    // Reads an array of exactly N numbers.
    template <std::size_t N>
    bool read(const char* key, std::array<double, N>& values) {
        if (!has(key)) return false;
        const Json& array = object_[key];
        if (!array.is_array() || array.size() != N) fail(key, Message(MessageId::WantNumbersOf, {{"count", N}}));
        for (std::size_t i = 0; i < N; ++i) {
            if (!array[i].is_number()) fail(key, Message(MessageId::WantNumbersOf, {{"count", N}}));
            values[i] = array[i].get<double>();
        }
        return true;
    }
    bool readPair(const char* key, int& first, int& second) {
        if (!has(key)) return false;
        const Json& array = object_[key];
        if (!array.is_array() || array.size() != 2) fail(key, MessageId::WantTwoWholes);
        first = wholeAt<int>(key, array[0]);
        second = wholeAt<int>(key, array[1]);
        return true;
    }
    // Reads a name and calls body(name); an InputError from body gets the line.
    template <class Body>
    void named(const char* key, const Body& body) {
        std::string text;
        if (!has(key)) return;
        read(key, text);
        guarded({key}, [&] { body(text); });
    }
    JsonReader child(const char* key) {
        known_.insert(key);
        JsonPath path = path_;
        path.emplace_back(key);
        return {source_, object_[key], path};
    }
    // Reads an array of texts; an InputError from body gets the line.
    template <class Body>
    void readTexts(const char* key, const Body& body) {
        if (!has(key)) return;
        if (!object_[key].is_array()) fail(key, MessageId::WantTexts);
        for (const Json& text : object_[key]) {
            if (!text.is_string()) fail(key, MessageId::WantTexts);
            guarded({key}, [&] { body(text.get<std::string>()); });
        }
    }
    // Calls body with a reader for each object of an array.
    template <class Body>
    void readObjects(const char* key, const Body& body) {
        if (!has(key)) return;
        if (!object_[key].is_array()) fail(key, MessageId::WantObjects);
        for (std::size_t n = 0; n < object_[key].size(); ++n) {
            JsonPath path = path_;
            path.emplace_back(key);
            path.emplace_back(n);
            body(JsonReader(source_, object_[key][n], std::move(path)));
        }
    }
    void readNumbers(const char* key, std::vector<double>& values) {
        if (!has(key)) return;
        if (!object_[key].is_array()) fail(key, MessageId::WantNumbers);
        for (const Json& value : object_[key]) {
            if (!value.is_number()) fail(key, MessageId::WantNumbers);
            values.push_back(value.get<double>());
        }
    }
    const Json& object() const { return object_; }
    // Marks all members as known, for objects whose keys are chosen by the user.
    void acceptAll() {
        for (const auto& [key, value] : object_.items()) known_.insert(key);
    }
    void finish() const {
        for (const auto& [key, value] : object_.items()) {
            if (known_.contains(key)) continue;
            JsonPath path = path_;
            path.push_back(key);
            throw InputError(source_.fileName, Message(MessageId::ScenarioUnknownKey,
                                                       {{"line", lineOf(source_.text, path)}, {"key", key}}));
        }
    }
    // Calls body and adds the file and the line of these keys to an InputError that it throws. An option's name as the
    // error's subject is dropped, because the error is in the file and not in an option.
    template <class Body>
    void guarded(const std::vector<std::string>& keys, const Body& body) const {
        try {
            body();
        } catch (const InputError& error) {
            JsonPath path = path_;
            path.insert(path.end(), keys.begin(), keys.end());
            const std::string& subject = error.subject();
            const bool option = subject.empty() || subject.starts_with("--");
            const Message why = option
                                    ? error.message()
                                    : Message(MessageId::SubjectSays, {{"subject", subject}, {"why", error.message()}});
            throw InputError(source_.fileName,
                             Message(MessageId::ScenarioLine, {{"line", lineOf(source_.text, path)}, {"why", why}}));
        }
    }
    [[noreturn]] void fail(const std::string& key, MessageId expected) const { fail(key, Message(expected)); }
    [[noreturn]] void fail(const std::string& key, const Message& expected) const {
        JsonPath path = path_;
        if (!key.empty()) path.push_back(key);
        const std::size_t line = lineOf(source_.text, path);
        if (path.empty()) throw InputError(source_.fileName, Message(MessageId::ScenarioNoObject, {{"line", line}}));
        throw InputError(source_.fileName,
                         Message(MessageId::ScenarioWrongType,
                                 {{"line", line}, {"key", placeText(path.back())}, {"wanted", expected}}));
    }

  private:
    template <class T>
    T wholeAt(const char* key, const Json& value) const {
        if (!value.is_number_integer()) fail(key, MessageId::WantAWhole);
        if (value.is_number_unsigned()) {
            const auto number = value.get<std::uint64_t>();
            if (number > static_cast<std::uint64_t>(std::numeric_limits<T>::max())) fail(key, MessageId::WantASmaller);
            return static_cast<T>(number);
        }
        const auto number = value.get<std::int64_t>();
        if (std::is_unsigned_v<T> || number < static_cast<std::int64_t>(std::numeric_limits<T>::min())) {
            fail(key, MessageId::WantALarger);
        }
        return static_cast<T>(number);
    }

    JsonSource source_;
    const Json& object_;
    JsonPath path_;
    std::set<std::string> known_;
};

}  // namespace relief
