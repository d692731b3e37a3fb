// SPDX-License-Identifier: MIT
// A list that changes now and then in the course of a run, as it stood at any frame.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

namespace svoscope {

/// `Value` has a member `id`. Not for several threads at once.
template <typename Value>
class ChangeLog {
 public:
  struct Change {
    int frame = 0;      ///< from this frame on
    bool gone = false;  ///< no longer in the list
    Value value;
  };
  using List = std::shared_ptr<const std::vector<Value>>;

  /// Frames must not fall.
  void add(Change change) { changes_.push_back(std::move(change)); }
  const std::vector<Change>& changes() const { return changes_; }

  /// The list by id. Shared by all frames between two changes, cheap if frames follow each other.
  List at(int frame) {
    const auto end = std::upper_bound(changes_.begin(), changes_.end(), frame,
                                      [](int f, const Change& c) { return f < c.frame; });
    const auto wanted = static_cast<std::size_t>(end - changes_.begin());
    if (list_ && wanted == applied_) return list_;
    if (wanted < applied_) {
      now_.clear();
      applied_ = 0;
    }
    for (; applied_ < wanted; ++applied_) {
      const Change& c = changes_[applied_];
      if (c.gone)
        now_.erase(c.value.id);
      else
        now_.insert_or_assign(c.value.id, &c.value);
    }
    auto list = std::make_shared<std::vector<Value>>();
    list->reserve(now_.size());
    for (const auto& [id, value] : now_) list->push_back(*value);
    return list_ = std::move(list);
  }

 private:
  std::vector<Change> changes_;
  std::map<decltype(Value::id), const Value*> now_;
  std::size_t applied_ = 0;
  List list_;
};

}  // namespace svoscope
