// Undo as a history of scenario values.
#pragma once

#include <memory>
#include <vector>

#include <QString>

#include "scenario/scenario.h"

namespace reliefui {

// A value: copies share the entries, so that an earlier history can be kept and come back whole.
class History {
  public:
    struct Entry {
        relief::Scenario scenario;
        QString what;      // what led here, for the menu
        QString mergeKey;  // changes with the same key in a row are one entry; empty: never
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
    // The scenario of the current entry as it turned out (its step clamped to the ray).
    void amend(const relief::Scenario& scenario) {
        if (empty()) return;
        Entry entry = current();
        entry.scenario = scenario;
        entries_[index_] = std::make_shared<const Entry>(std::move(entry));
    }
    // The next change starts an entry of its own, whatever its key.
    void close() { open_ = false; }

  private:
    static constexpr std::size_t kLongest = 1000;

    std::vector<std::shared_ptr<const Entry>> entries_;
    std::size_t index_ = 0;
    bool open_ = false;
};

}  // namespace reliefui
