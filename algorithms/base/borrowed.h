// Per-thread scratch buffers that are reused from one use to the next. Nested uses get distinct buffers, because a
// thread that waits for parallel work may meanwhile run another task of the same kind.
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace relief {

template <class T>
class Borrowed {
  public:
    Borrowed() {
        if (!kept().empty()) {
            value_ = std::move(kept().back());
            kept().pop_back();
        } else {
            value_ = std::make_unique<T>();
        }
    }
    ~Borrowed() { kept().push_back(std::move(value_)); }
    Borrowed(const Borrowed&) = delete;
    Borrowed& operator=(const Borrowed&) = delete;

    // Contents are as the last use on this thread left them.
    T& operator*() { return *value_; }
    T* operator->() { return value_.get(); }

  private:
    static std::vector<std::unique_ptr<T>>& kept() {
        static thread_local std::vector<std::unique_ptr<T>> buffers;
        return buffers;
    }
    std::unique_ptr<T> value_;
};

}  // namespace relief
