// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <list>
#include <unordered_map>
#include <utility>

namespace svoscope {

/// Values by frame within a budget of bytes; those not asked for longest are dropped.
template <typename Value>
class LruCache {
 public:
  explicit LruCache(std::size_t budget) : budget_(budget) {}

  /// Null if it is not held.
  const Value* find(int frame) {
    const auto it = by_frame_.find(frame);
    if (it == by_frame_.end()) return nullptr;
    entries_.splice(entries_.begin(), entries_, it->second);
    return &entries_.front().value;
  }

  void add(int frame, Value value, std::size_t bytes) {
    entries_.push_front({frame, bytes, std::move(value)});
    by_frame_[frame] = entries_.begin();
    bytes_ += bytes;
    while (bytes_ > budget_ && entries_.size() > 1) {
      bytes_ -= entries_.back().bytes;
      by_frame_.erase(entries_.back().frame);
      entries_.pop_back();
    }
  }

  std::size_t bytes() const { return bytes_; }

 private:
  struct Entry {
    int frame;
    std::size_t bytes;
    Value value;
  };
  std::size_t budget_, bytes_ = 0;
  std::list<Entry> entries_;  ///< last used first
  std::unordered_map<int, typename std::list<Entry>::iterator> by_frame_;
};

}  // namespace svoscope
