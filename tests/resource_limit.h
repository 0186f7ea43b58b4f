// A limit of the operating system on this process, for tests.
#pragma once

#include <sys/resource.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace relief::test {

// Limits a resource (RLIMIT_...) of this process to at most `most` during the object's lifetime.
class ResourceLimit {
  public:
    ResourceLimit(decltype(RLIMIT_AS) resource, rlim_t most) : resource_(resource) {
        const int got = ::getrlimit(resource_, &before_);
        rlimit limit = before_;
        limit.rlim_cur = std::min(before_.rlim_max, most);
        if (got != 0 || ::setrlimit(resource_, &limit) != 0) throw std::system_error(errno, std::generic_category());
    }
    ~ResourceLimit() { ::setrlimit(resource_, &before_); }
    ResourceLimit(const ResourceLimit&) = delete;
    ResourceLimit& operator=(const ResourceLimit&) = delete;

  private:
    decltype(RLIMIT_AS) resource_;
    rlimit before_{};
};

}  // namespace relief::test
