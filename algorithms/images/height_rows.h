// Heights of a map delivered in bands of rows, from top to bottom, so that the map need not fit into memory.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "images/picture_input.h"
#include "relief/work.h"

namespace relief {

// Not thread-safe.
class HeightRows {
  public:
    HeightRows() = default;
    virtual ~HeightRows() = default;
    HeightRows(const HeightRows&) = delete;
    HeightRows& operator=(const HeightRows&) = delete;

    virtual int width() const = 0;
    virtual int height() const = 0;
    // UInt8 or UInt16: codes, shares of the full range. Float: heights in [0, 1].
    virtual NumberType type() const = 0;
    // Text that differs if any height may differ: an interrupted run goes on only with the same heights.
    virtual std::string identity() const = 0;
    // What prepare() and read() have learned about the heights so far, as JSON text, and the reverse, which replaces
    // prepare().
    virtual std::string learned() const = 0;
    virtual void restore(const std::string& learned) = 0;
    // To be called before the first read(), unless restore() is. Throws as read().
    virtual void prepare(Work& work) = 0;
    // Writes the width x count heights of rows [first, first + count) to `rows`. first ascends from call to call.
    // Throws InputError, MemoryError, Cancelled.
    virtual void read(int first, int count, std::byte* rows, Work& work) = 0;
    // What the user should be told about the conversion, once all rows are read.
    virtual std::vector<Message> notes() const = 0;
};

// The heights of a picture file, with the same bits as from readHeight(). 8- and 16-bit unsigned integers at full range
// are delivered as codes, everything else as floats. options.maxPixels does not count. Range auto or full of floats:
// prepare() reads all rows once. Throws InputError, MemoryError.
std::unique_ptr<HeightRows> pictureHeightRows(const std::string& path, const HeightReadOptions& options);

}  // namespace relief
