// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

namespace svoscope {

/// Typed queue between two threads. After close() pops return what is left, then nothing.
template <typename T>
class BlockingQueue {
 public:
  void push(T value) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (closed_) return;
      values_.push_back(std::move(value));
    }
    changed_.notify_one();
  }

  /// Waits for a value; empty once closed and drained.
  std::optional<T> pop() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return closed_ || !values_.empty(); });
    return take();
  }

  /// Waits for a value, but not longer than this.
  template <typename Duration>
  std::optional<T> popWithin(Duration longest) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, longest, [this] { return closed_ || !values_.empty(); });
    return take();
  }

  /// Closed, and nothing is left.
  bool drained() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return closed_ && values_.empty();
  }

  /// Does not wait.
  std::optional<T> tryPop() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return take();
  }

  /// Waits until fewer than `limit` values are left, or the queue is closed.
  void waitBelow(std::size_t limit) {
    std::unique_lock<std::mutex> lock(mutex_);
    taken_.wait(lock, [&] { return closed_ || values_.size() < limit; });
  }

  /// Keeps the values for which keep(value) holds.
  template <typename Keep>
  void filter(const Keep& keep) {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::deque<T> kept;
    for (T& v : values_) {
      if (keep(v)) kept.push_back(std::move(v));
    }
    values_.swap(kept);
  }

  void close() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      closed_ = true;
    }
    changed_.notify_all();
    taken_.notify_all();
  }

  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    values_.clear();
    taken_.notify_all();
  }

  std::size_t size() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return values_.size();
  }

 private:
  std::optional<T> take() {
    if (values_.empty()) return std::nullopt;
    T value = std::move(values_.front());
    values_.pop_front();
    taken_.notify_all();
    return value;
  }

  mutable std::mutex mutex_;
  std::condition_variable changed_, taken_;
  std::deque<T> values_;
  bool closed_ = false;
};

}  // namespace svoscope
