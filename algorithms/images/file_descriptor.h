// File descriptors that close themselves, and reading from a position.
#pragma once

#include <sys/stat.h>
#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace relief {

// A file descriptor that the destructor closes.
class Descriptor {
  public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }
    bool open() const { return number_ >= 0; }
    // Closes the descriptor if it is open; a full disk may be reported only here. Returns 0 or an errno.
    int close();

  private:
    int number_ = -1;
};

// Reads `count` bytes from position `at`. Returns the number of bytes read, fewer only at the end of the file; -1 with
// an errno if the file cannot be read or the position is negative.
::ssize_t readAt(int descriptor, std::int64_t at, void* to, std::size_t count);

// Throws InputError if the file is a folder, a pipe or a device.
void requireRegular(const std::string& path, const struct stat& status);

}  // namespace relief
