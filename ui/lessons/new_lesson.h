// Makes a lesson of what the window shows.
#pragma once

#include <QString>

#include "scenario/scenario.h"

namespace reliefui {

// Writes lesson.json, text.en.md and text.uk.md into a new folder: a page with this scenario, its step and pane, and
// texts to be replaced. Pictures in the folder datasets are named as shipped ones. Throws InputError if the folder
// exists, WorkError if it cannot be written.
void writeNewLesson(const QString& folder, const relief::Scenario& scenario, const QString& pane,
                    const QString& datasets);

}  // namespace reliefui
