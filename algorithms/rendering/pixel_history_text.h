// The history of a pixel as equations with their numbers, for the command line and the window. Symbols are marked up as
// in u_x, q^2.
#pragma once

#include <string>
#include <vector>

#include "rendering/pixel_history.h"

namespace relief {

// An equation: "s = s_0 + λ a", its right side with numbers, and its value. numbers may be empty.
struct HistoryEquation {
    std::string formula;
    std::string numbers;
    std::string result;
};
// One station of the pixel's way. notes: what the numbers do not say.
struct HistoryStation {
    Message title;
    std::vector<Message> notes;
    std::vector<HistoryEquation> equations;
};
// Returns the stations in order; the last one is the product, compared with the drawn pixel.
std::vector<HistoryStation> historyStations(const PixelHistory& history, const FrameRequest& request);

// Returns the stations as plain text.
std::string historyText(const PixelHistory& history, const FrameRequest& request, Language language);

}  // namespace relief
