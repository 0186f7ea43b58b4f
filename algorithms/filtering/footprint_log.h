// What a filter did for one pixel; used by the footprint pane, reports and tests.
#pragma once

#include <cstdint>
#include <vector>

#include "filtering/level_footprint.h"

namespace relief {

// One sample of a texel: of the chosen level, or of a finer one where steep relief is under it. A texel may be logged
// several times with parts of its weight; its weight is their sum.
struct FootprintTexel {
    int i = 0;  // texel of its level, after addressing
    int j = 0;
    int level = 0;
    double u = 0;  // centre of the sampled part, texels of the footprint's level, unwrapped
    double v = 0;
    Color weight{0};  // before normalisation; equal in all channels except for lcd and crt
    bool tested = false;
    bool hidden = false;
    glm::dvec2 blocker{0};  // if hidden: where the relief blocks the view, texels of the height map, unwrapped
};

struct FootprintLog {
    LevelFootprint footprint;
    std::vector<FootprintTexel> texels;  // empty if the colour was sampled bilinearly
    bool skipped = false;                // no texel needed a test: nothing near is high enough to hide any
    bool allHidden = false;              // no texel was visible: the colour is that at the hit
    Color color{0};

    // Logs a filter that samples the texture at one point. place: texels of level 0.
    void takePoint(glm::dvec2 place, const Color& read) {
        footprint.kind = FootprintKind::Bilinear;
        footprint.centre = place;
        color = read;
    }
};

// Number of texels and tests, summed over pixels.
struct FootprintCounts {
    std::int64_t footprints = 0;  // filtered as ellipses
    std::int64_t bilinear = 0;    // footprints smaller than a texel
    std::int64_t texels = 0;      // sampled
    std::int64_t tested = 0;      // traced back; form=rays: rays whose footprints were sampled
    std::int64_t hidden = 0;      // of those tested
    std::int64_t skipped = 0;     // texels that needed no test
    std::int64_t flat = 0;        // footprints without a texel that needed a test
    std::int64_t allHidden = 0;   // footprints without a visible texel

    void add(const FootprintCounts& other) {
        footprints += other.footprints;
        bilinear += other.bilinear;
        texels += other.texels;
        tested += other.tested;
        hidden += other.hidden;
        skipped += other.skipped;
        flat += other.flat;
        allHidden += other.allHidden;
    }
};

}  // namespace relief
