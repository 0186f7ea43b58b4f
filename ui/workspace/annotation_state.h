// The annotations of all views, as a state in the scenario's object `ui`: adding or moving one is a step of undo, and
// renders nothing.
#pragma once

#include <vector>

#include "painting/annotation.h"
#include "workspace/state_json.h"

namespace reliefui {

inline constexpr std::size_t kMostAnnotations = 100;
// Characters of a text, and of the text of a number.
inline constexpr int kMostAnnotationText = 80;
inline constexpr int kMostNumberText = 3;
// Largest coordinate of a place.
inline constexpr double kFarthestAnnotation = 1 << 26;

struct AnnotationState {
    static constexpr const char* kName = "annotations";
    std::vector<Annotation> list;

    void read(relief::JsonReader reader);
    void check(const std::string& subject) const;
    relief::Json json() const;
    bool operator==(const AnnotationState&) const = default;
};

}  // namespace reliefui
