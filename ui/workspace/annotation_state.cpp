#include "workspace/annotation_state.h"

#include <algorithm>
#include <span>

#include "relief/describe.h"
#include "scenario/text_lines.h"
#include "workspace/pane_store.h"

namespace reliefui {

namespace {

using relief::JsonReader;
using relief::Message;
using relief::MessageId;

void requireKnown(const char* what, const std::string& name, std::span<const std::string_view> known) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    throw relief::InputError(
        {}, relief::unknownName({"what", std::string(what)}, name, relief::commaList({known.begin(), known.end()})));
}

int lengthOf(const std::string& text) {
    return static_cast<int>(relief::characterCount(text));
}

// Throws InputError without a subject.
void checkAnnotation(const Annotation& note) {
    requireKnown("view", note.view, kAnnotatedViews);
    requireKnown("color", note.color, kAnnotationColors);
    const auto within = [](const char* what, Point p) {
        for (const double place : {p.x, p.y}) checkWithin({}, what, place, -kFarthestAnnotation, kFarthestAnnotation);
    };
    within("at", note.at);
    if (note.hasEnd()) within("to", note.to);
    const int most = note.kind == AnnotationKind::Number ? kMostNumberText : kMostAnnotationText;
    checkWithin({}, "characters of \"text\"", lengthOf(note.text), note.hasEnd() ? 0 : 1, most);
    checkWithin({}, "characters of \"text\", \"uk\"", lengthOf(note.ukrainian), 0, most);
}

void checkCount(std::size_t count) {
    if (count <= kMostAnnotations) return;
    throw relief::InputError(
        {}, Message(MessageId::TooMany, {{"what", "annotations"}, {"count", count}, {"limit", kMostAnnotations}}));
}

Point pointIn(JsonReader& reader, const char* key) {
    std::array<double, 2> place{};
    if (!reader.read(key, place)) reader.fail(key, Message(MessageId::WantNumbersOf, {{"count", 2}}));
    return {place[0], place[1]};
}

void readText(JsonReader& reader, Annotation& note) {
    if (!reader.has("text")) return;
    if (!reader.object().at("text").is_object()) return reader.read("text", note.text);
    JsonReader both = reader.child("text");
    both.read("en", note.text);
    both.read("uk", note.ukrainian);
    both.finish();
}

Annotation readAnnotation(JsonReader reader) {
    Annotation note;
    if (!reader.has("kind")) reader.fail("kind", MessageId::WantAText);
    reader.named("kind", [&](const std::string& name) {
        requireKnown("kind", name, kAnnotationKinds);
        const auto at = std::find(kAnnotationKinds.begin(), kAnnotationKinds.end(), name);
        note.kind = static_cast<AnnotationKind>(at - kAnnotationKinds.begin());
    });
    if (!reader.has("view")) reader.fail("view", MessageId::WantAText);
    reader.read("view", note.view);
    note.at = pointIn(reader, "at");
    if (note.hasEnd()) note.to = pointIn(reader, "to");
    readText(reader, note);
    reader.read("color", note.color);
    reader.finish();
    reader.guarded({}, [&] { checkAnnotation(note); });
    return note;
}

relief::Json jsonOf(const Annotation& note) {
    relief::Json json{{"kind", kAnnotationKinds[static_cast<std::size_t>(note.kind)]},
                      {"view", note.view},
                      {"at", {note.at.x, note.at.y}}};
    if (note.hasEnd()) json["to"] = {note.to.x, note.to.y};
    if (!note.ukrainian.empty()) {
        json["text"] = {{"en", note.text}, {"uk", note.ukrainian}};
    } else if (!note.text.empty()) {
        json["text"] = note.text;
    }
    if (note.color != Annotation{}.color) json["color"] = note.color;
    return json;
}

}  // namespace

void AnnotationState::read(JsonReader reader) {
    reader.readObjects("list", [&](JsonReader item) { list.push_back(readAnnotation(std::move(item))); });
    reader.finish();
    reader.guarded({"list"}, [&] { checkCount(list.size()); });
}

void AnnotationState::check(const std::string& subject) const {
    try {
        checkCount(list.size());
        for (const Annotation& note : list) checkAnnotation(note);
    } catch (const relief::InputError& error) {
        throw relief::InputError(subject, error.message());
    }
}

relief::Json AnnotationState::json() const {
    relief::Json notes = relief::Json::array();
    for (const Annotation& note : list) notes.push_back(jsonOf(note));
    return {{"list", std::move(notes)}};
}

}  // namespace reliefui
