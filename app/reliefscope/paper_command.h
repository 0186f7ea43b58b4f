// reliefscope --paper-figures NAMES [-o FOLDER]: lists the figures of the papers, or writes them, without a window.
#pragma once

#include <string>

#include "arguments.h"

namespace relief::app {

// count, values: of main(). datasets: folder of the shipped pictures, next to which the figures are. Returns the exit
// status. Throws InputError, WorkError.
int paperFigures(int count, char** values, const Arguments& arguments, const std::string& datasets);

}  // namespace relief::app
