// Undo history: a sequence of scenario values.
#pragma once

#include <memory>
#include <vector>

#include <QString>

#include "scenario/scenario.h"

namespace reliefui {

// A value type: copies share their entries, so that an earlier history can be kept cheaply and restored as a whole.
class History {
  public:
    struct Entry {
        relief::Scenario scenario;
        QString what;      // name of the change that led here, for the undo menu
        QString mergeKey;  // consecutive changes with the same key form one entry; empty: never merged
    };

    bool empty() const { return entries_.empty(); }
    const Entry& current() const { return *entries_[index_]; }
    bool canUndo() const { return index_ > 0; }
    bool canRedo() const { return index_ + 1 < entries_.size(); }
    const Entry& undone() const { return *entries_[index_ - 1]; }
    const Entry& redone() const { return *entries_[index_ + 1]; }
    void undo() { --index_; }
    void redo() { ++index_; }

    void push(Entry entry) {
        const bool merges = !empty() && open_ && !entry.mergeKey.isEmpty() && current().mergeKey == entry.mergeKey;
        entries_.resize(empty() ? 0 : index_ + 1);
        if (merges) entries_.pop_back();
        entries_.push_back(std::make_shared<const Entry>(std::move(entry)));
        if (entries_.size() > kLongest) entries_.erase(entries_.begin());
        index_ = entries_.size() - 1;
        open_ = true;
    }
    // Replaces the scenario of the current entry by its final form, with the step clamped to the ray.
    void amend(const relief::Scenario& scenario) {
        if (empty()) return;
        Entry entry = current();
        entry.scenario = scenario;
        entries_[index_] = std::make_shared<const Entry>(std::move(entry));
    }
    // The next change starts a new entry even if its key is the same.
    void close() { open_ = false; }

  private:
    static constexpr std::size_t kLongest = 1000;

    std::vector<std::shared_ptr<const Entry>> entries_;
    std::size_t index_ = 0;
    bool open_ = false;
};

}  // namespace reliefui
