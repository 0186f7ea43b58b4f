// What a filter did for one pixel: for the footprint pane, reports and tests.
#pragma once

#include <cstdint>
#include <vector>

#include "filtering/level_footprint.h"

namespace relief {

// One reading of a texel: of the level chosen, or of a finer one where steep relief is under it. A texel may be logged
// more than once, in parts of its weight; its whole weight is their sum.
struct FootprintTexel {
    int i = 0;  // texel of its level, addressed
    int j = 0;
    int level = 0;
    double u = 0;  // centre of what is read of it, texels of the footprint's level, unwrapped
    double v = 0;
    Color weight{0};  // before it is divided by the sum; the same in all channels but for lcd and crt
    bool tested = false;
    bool hidden = false;
    glm::dvec2 blocker{0};  // hidden: where the relief is in the way, texels of the height map, unwrapped
};

struct FootprintLog {
    LevelFootprint footprint;
    std::vector<FootprintTexel> texels;  // none where the colour was read bilinearly
    bool skipped = false;                // no texel needed a test: nothing near is high enough to hide any
    bool allHidden = false;              // nothing was visible: the colour is that at the hit
    Color color{0};

    // Of filters that read the texture at a point; place: texels of level 0.
    void takePoint(glm::dvec2 place, const Color& read) {
        footprint.kind = FootprintKind::Bilinear;
        footprint.centre = place;
        color = read;
    }
};

// What was read and what was not needed, of many pixels.
struct FootprintCounts {
    std::int64_t footprints = 0;  // of them filtered as ellipses
    std::int64_t bilinear = 0;    // footprints smaller than a texel
    std::int64_t texels = 0;      // read
    std::int64_t tested = 0;      // traced back; form=rays: rays whose footprints were read
    std::int64_t hidden = 0;      // of the tested
    std::int64_t skipped = 0;     // texels whose test was not needed
    std::int64_t flat = 0;        // footprints none of whose texels needed a test
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
