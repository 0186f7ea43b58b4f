#include "tiles_output.h"

#include "images/tiled_writer.h"
#include "stopped.h"

namespace relief::app {

void writeTiles(HeightRows& rows, const std::string& output, const RestartOptions& restart, Session& session) {
    TiledWriter writer(rows, output, {.earlier = restart.chosen()});
    if (writer.earlierBands() > 0)
        session.note(writer.partPath(),
                     Message(MessageId::SweepResumed, {{"done", writer.earlierBands()}, {"total", writer.bands()}}));
    try {
        writer.write(session.work());
    } catch (const Cancelled&) {
        endStopped(session, writer.partPath(),
                   Message(writer.keptBands() > 0 ? MessageId::SweepStopped : MessageId::SweepStoppedEmpty,
                           {{"done", writer.keptBands()}, {"total", writer.bands()}}));
    }
    session.eraseBar();
}

}  // namespace relief::app
