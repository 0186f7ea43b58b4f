// A picture file that is written row by row in any order, and the joining of such files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "images/picture_layout.h"
#include "relief/work.h"

namespace relief {

// The unfinished picture, FILE.rows: the rows at their final places. FILE.part next to it names the rows that are done.
// Where FILE is a symbolic link, both stand next to the link's target.
class PlacedFile {
  public:
    // path: of the picture. Touches no file yet. Throws WorkError if the picture could not replace `path` in the end.
    PlacedFile(std::string path, PictureLayout layout);
    // Removes FILE.rows if there is no FILE.part and the file was opened.
    ~PlacedFile();
    PlacedFile(const PlacedFile&) = delete;
    PlacedFile& operator=(const PlacedFile&) = delete;

    const PictureLayout& layout() const { return layout_; }
    // Opens FILE.rows, or creates it, and reserves the room that the picture takes on the disk, so that a disk that is
    // too small is refused at once. keep: what an earlier run has written stays. Throws WorkError.
    void open(bool keep);
    // Writes what PictureLayout::encoded() returned for rows from `first` on; returns their checksum. Thread-safe.
    // Throws WorkError.
    std::uint64_t write(int first, std::span<const std::byte> rows);
    // Returns true if these rows stand in the file with this checksum.
    bool holds(int first, int count, std::uint64_t checksum) const;
    // Completes the picture and renames it. Throws WorkError.
    void finish();

  private:
    [[noreturn]] void fail(int error) const;
    [[noreturn]] void failReserving(int error) const;

    std::string path_, target_, rows_;  // target_: the file that is replaced
    PictureLayout layout_;
    int descriptor_ = -1;
};

// A file of some rows of a picture, and what it holds.
struct PlacedPart {
    std::string path;
    PictureLayout layout;
};
// Joins such files, given from top to bottom, all but the last of whole groups of rows, to the file that one run would
// have written. Throws InputError (a file is damaged), WorkError, Cancelled. Memory: a few megabytes and the heads.
void joinPlaced(const std::vector<PlacedPart>& parts, const std::string& path, Work& work);

}  // namespace relief
