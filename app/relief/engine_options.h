// Options that state how an engine stores and reads a map: for `relief map`, which writes such maps, and `relief
// certify`, which reads them.
#pragma once

#include <string>

#include "measuring/verify/engine_march.h"
#include "options_common.h"
#include "relief/maps/engine_map.h"

namespace relief::app {

class EngineOptions {
  public:
    void addForWriting(CLI::App& parser);
    void addForReading(CLI::App& parser);

    // Returns the name of one of these options that was given; empty if none was.
    std::string given() const;
    // Returns true if the channels are stated, so that a map without sidecar can be read.
    bool statesChannels() const { return convention_ || pack_; }
    // Sets the conventions that the options state, over those that the file states or that are the default.
    void apply(EngineConventions& conventions) const;
    // Cones of a map that is read.
    ConeFetch fetch() const;
    // Number of MIP levels of a map that is written, for a map of that size; 1 if the option is not given.
    int mips(int width, int height) const;
    bool mipsGiven() const { return mips_.has_value(); }
    bool scaleGiven() const { return scale_.has_value(); }

  private:
    void addCommon(CLI::App& parser);

    OptionText convention_, pack_, unit_, scale_, length_, white_, bits_, rounding_, mips_, zeroLevel_, green_, fetch_;
    bool relaxed_ = false;
};

}  // namespace relief::app
