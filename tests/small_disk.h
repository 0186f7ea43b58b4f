// A full disk, for tests.
#pragma once

#include <sys/resource.h>

#include <csignal>

namespace relief::test {

// Limits the size of files written by this process to `bytes` during the object's lifetime, which simulates a full
// disk.
class SmallDisk {
  public:
    explicit SmallDisk(rlim_t bytes) {
        before_ = std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &limit_);
        rlimit small = limit_;
        small.rlim_cur = bytes;
        ::setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallDisk() {
        ::setrlimit(RLIMIT_FSIZE, &limit_);
        std::signal(SIGXFSZ, before_);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

  private:
    rlimit limit_{};
    void (*before_)(int) = nullptr;
};

}  // namespace relief::test
