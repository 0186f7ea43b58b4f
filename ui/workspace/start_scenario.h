// What is seen first: the shipped stone wall, with a pixel chosen whose ray is worth a look.
#pragma once

#include <string>

#include "scenario/scenario.h"

namespace reliefui {

// The folder of the shipped pictures: beside the program, where it is installed, or in the source; empty if none.
// programFolder: where the running program lies.
std::string datasetsFolder(const std::string& programFolder);

// Without the shipped pictures: procedural bricks.
relief::Scenario startScenario(const std::string& datasets);

// The pictures of a folder of the shipped kind (height.*, color.*, normal_gl.*); height empty if there is none.
relief::Pictures picturesIn(const std::string& folder);

}  // namespace reliefui
