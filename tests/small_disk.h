// A full disk, for tests.
#pragma once

#include <csignal>
#include <optional>

#include "resource_limit.h"

namespace relief::test {

// Limits the size of files written by this process to `bytes` during the object's lifetime, which simulates a full
// disk.
class SmallDisk {
  public:
    explicit SmallDisk(rlim_t bytes) : limit_(std::in_place, RLIMIT_FSIZE, bytes) {}
    ~SmallDisk() {
        limit_.reset();
        std::signal(SIGXFSZ, before_);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

  private:
    void (*before_)(int) = std::signal(SIGXFSZ, SIG_IGN);
    std::optional<ResourceLimit> limit_;
};

}  // namespace relief::test
