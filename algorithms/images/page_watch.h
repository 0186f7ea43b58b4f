// Keeps the process alive when pages of a file that is mapped into memory can no longer be read: another program has
// shortened the file, or its disk or server has failed. Without it the system ends the process by SIGBUS.
#pragma once

#include <cstddef>

namespace relief {

// Watches an address range that a file is mapped to, during the object's lifetime. At the first access to a page that
// the file no longer provides, that page and those behind it become zeros, and lost() becomes true: whoever has read
// them must then discard the result.
// Thread-safe. The first object of the process installs a handler of SIGBUS, which passes faults at other addresses to
// the handler that was there before; a program that installs its own one later must do the same.
class PageWatch {
  public:
    // first: the beginning of a page. It must be watched for less long than it is mapped.
    PageWatch(void* first, std::size_t bytes);
    ~PageWatch();
    PageWatch(const PageWatch&) = delete;
    PageWatch& operator=(const PageWatch&) = delete;

    bool lost() const;

    struct Range;

  private:
    Range* range_;
};

}  // namespace relief
