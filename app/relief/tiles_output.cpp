#include "tiles_output.h"

#include "images/tiled_writer.h"

namespace relief::app {

void writeTiles(HeightRows& rows, const std::string& output, const RestartOptions& restart, Session& session) {
    TiledWriter writer(rows, output, {.earlier = restart.chosen()});
    const auto note = [&](MessageId message, std::int64_t done) {
        session.note(writer.partPath(), Message(message, {{"done", done}, {"total", writer.bands()}}));
    };
    if (writer.earlierBands() > 0) note(MessageId::SweepResumed, writer.earlierBands());
    try {
        writer.write(session.work());
    } catch (const Cancelled&) {
        note(writer.keptBands() > 0 ? MessageId::SweepStopped : MessageId::SweepStoppedEmpty, writer.keptBands());
        throw;
    }
    session.eraseBar();
}

}  // namespace relief::app
