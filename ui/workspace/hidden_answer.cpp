#include "workspace/hidden_answer.h"

#include "workspace/discard.h"

namespace reliefui {

std::shared_ptr<Snapshot> withoutAnswer(const Snapshot& snapshot) {
    auto hidden = makeFreedInBackground<Snapshot>(snapshot);
    hidden->trace.steps.clear();
    hidden->trace.further.clear();
    hidden->trace.hit = relief::Hit::none(relief::Outcome::Unset);
    hidden->trace.judgement = {};
    hidden->trace.hidden = true;
    hidden->other.reset();
    hidden->footprint.reset();
    return hidden;
}

}  // namespace reliefui
