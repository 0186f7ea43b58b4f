#include "panes/point_state.h"

#include "workspace/pane_store.h"

namespace reliefui {

// All three members are required: a point given only in part is an error.
void PointState::read(relief::JsonReader reader) {
    QueryPoint& at = point.emplace();
    const auto number = [&](const char* key, double& value) {
        if (!reader.has(key)) reader.fail(key, relief::MessageId::WantANumber);
        reader.read(key, value);
    };
    number("s", at.s);
    number("t", at.t);
    number("z", at.z);
    reader.finish();
}

void PointState::check(const std::string& subject) const {
    constexpr double kFarthest = 1 << 26;  // in texels
    if (!point) return;
    checkWithin(subject, "s", point->s, -kFarthest, kFarthest);
    checkWithin(subject, "t", point->t, -kFarthest, kFarthest);
    checkWithin(subject, "z", point->z, 0, 1);
}

relief::Json PointState::json() const {
    return {{"s", point->s}, {"t", point->t}, {"z", point->z}};
}

}  // namespace reliefui
