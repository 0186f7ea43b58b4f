// Moving pictures of a pane: frames that differ in one value (scenario/sequence.h), as numbered files or as one page
// for browsers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenario/sequence.h"
#include "windows/html_page.h"
#include "workspace/snapshot_maker.h"

namespace reliefui {

struct MovingPicture {
    FigureKind kind;
    relief::Sequence sequence;
    SnapshotOrder order;  // the scenario, and what a frame of it shows
};

// Writes the frames as FOLDER/NAME_00000.png, ... where path is FOLDER/NAME.png (or .svg, .pdf), and creates the
// folder. All pictures (PNG) have the same size. A caption begins with what changes. progress: called after each frame
// with its number, from 1, and how many there are. A file appears only when it is complete; a run that was interrupted
// is repeated. Throws InputError if the figure is the same at all steps, or if frames of a longer sequence with this
// name are there; and what drawing throws.
using FrameProgress = std::function<void(std::size_t done, std::size_t all)>;
void writeFrames(const MovingPicture& moving, SnapshotMaker& maker, const FigurePage& page, const std::string& path,
                 const FrameProgress& progress, relief::Work& work);

// Returns the moving picture as one HTML file. Call on the thread of a QApplication.
std::string movingPage(const MovingPicture& moving, SnapshotMaker& maker, const LanguageSetter& installLanguage,
                       const FrameProgress& progress, relief::Work& work);

}  // namespace reliefui
