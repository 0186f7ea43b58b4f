// How a stopped command says what it has kept.
#pragma once

#include <string>

#include "relief/errors.h"
#include "session.h"

namespace relief::app {

// Cancelled, after a line has said what was kept.
struct StopTold : Cancelled {};

// Prints "relief: SUBJECT: ...", also with --quiet, and throws StopTold.
[[noreturn]] inline void endStopped(Session& session, const std::string& subject, const Message& message) {
    session.eraseBar();
    sayLine(subject + ": " + sentence(message, session.language()));
    throw StopTold();
}

}  // namespace relief::app
