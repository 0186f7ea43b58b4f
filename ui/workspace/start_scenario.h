// The scenario of the first start: the shipped stone wall, with a pixel whose ray is instructive.
#pragma once

#include <string>

#include "scenario/scenario.h"

namespace reliefui {

// Folder of the shipped pictures: next to the installed program, or in the source tree; empty if not found.
// programFolder: folder of the running program.
std::string datasetsFolder(const std::string& programFolder);
// Folder of the shipped lessons, which is next to that of the pictures; empty if not found.
std::string lessonsFolder(const std::string& datasets);
// The same for the figures of the papers.
std::string paperFiguresFolder(const std::string& datasets);

// Uses procedural bricks if the shipped pictures are missing.
relief::Scenario startScenario(const std::string& datasets);

// The pictures of a folder laid out like the shipped ones (height.*, color.*, normal_gl.*); the height is empty if
// there is none.
relief::Pictures picturesIn(const std::string& folder);

}  // namespace reliefui
