// Working memory for the bodies of a parallel loop. Each body borrows one object exclusively; as many objects are
// created as bodies run at once, and they live as long as the pool. An object's contents are as its last user left
// them. Thread-safe.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace relief {

template <class T>
class ScratchPool {
  public:
    ScratchPool() : ScratchPool([] { return std::make_unique<T>(); }) {}
    // make: creates an object; called concurrently from any thread.
    explicit ScratchPool(std::function<std::unique_ptr<T>()> make) : make_(std::move(make)) {}

    class Borrowed {
      public:
        explicit Borrowed(ScratchPool& pool) : pool_(pool), value_(pool.take()) {}
        ~Borrowed() { pool_.giveBack(std::move(value_)); }
        Borrowed(const Borrowed&) = delete;
        Borrowed& operator=(const Borrowed&) = delete;

        T& operator*() const { return *value_; }
        T* operator->() const { return value_.get(); }

      private:
        ScratchPool& pool_;
        std::unique_ptr<T> value_;
    };

    // Borrows an object until the result goes out of scope.
    Borrowed borrow() { return Borrowed(*this); }

  private:
    std::unique_ptr<T> take() {
        {
            const std::lock_guard lock(mutex_);
            if (!free_.empty()) {
                std::unique_ptr<T> value = std::move(free_.back());
                free_.pop_back();
                return value;
            }
        }
        return make_();
    }
    void giveBack(std::unique_ptr<T> value) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(value));
    }

    std::function<std::unique_ptr<T>()> make_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<T>> free_;
};

}  // namespace relief
