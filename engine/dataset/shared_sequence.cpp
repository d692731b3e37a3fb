// SPDX-License-Identifier: MIT
#include "engine/dataset/shared_sequence.h"

#include <deque>
#include <mutex>

namespace svoscope {

/// Reads are serialised; answers of the newest frames are kept, errors as well.
class SharedReader {
 public:
  explicit SharedReader(std::unique_ptr<Sequence> sequence) : sequence_(std::move(sequence)) {}

  const Sequence& sequence() const { return *sequence_; }
  Result<SequenceImage> read(int index) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return cached(images_, index, [&] { return sequence_->read(index); });
  }
  Result<cv::Mat> readDepth(int index) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return cached(depths_, index, [&] { return sequence_->readDepth(index); });
  }

 private:
  static constexpr std::size_t kKept = 3;

  template <typename T>
  struct Kept {
    int index;
    Result<T> answer;
  };

  template <typename T, typename Read>
  static Result<T> cached(std::deque<Kept<T>>& kept, int index, const Read& read) {
    for (const Kept<T>& k : kept) {
      if (k.index == index) return k.answer;
    }
    kept.push_back({index, read()});
    if (kept.size() > kKept) kept.pop_front();
    return kept.back().answer;
  }

  std::mutex mutex_;
  std::unique_ptr<Sequence> sequence_;
  std::deque<Kept<SequenceImage>> images_;
  std::deque<Kept<cv::Mat>> depths_;
};

namespace {

class SharedSequence : public Sequence {
 public:
  explicit SharedSequence(std::shared_ptr<SharedReader> reader) : reader_(std::move(reader)) {}

  const std::string& name() const override { return reader_->sequence().name(); }
  int size() const override { return reader_->sequence().size(); }
  const Camera& camera() const override { return reader_->sequence().camera(); }
  double timestamp(int index) const override { return reader_->sequence().timestamp(index); }
  TimeSource timeSource() const override { return reader_->sequence().timeSource(); }
  std::vector<std::string> notes() const override { return reader_->sequence().notes(); }
  Result<SequenceImage> read(int index) override { return reader_->read(index); }
  const Trajectory& groundTruth() const override { return reader_->sequence().groundTruth(); }
  Result<cv::Mat> readDepth(int index) override { return reader_->readDepth(index); }

 private:
  std::shared_ptr<SharedReader> reader_;
};

}  // namespace

SequenceSharer::SequenceSharer(std::unique_ptr<Sequence> sequence)
    : reader_(std::make_shared<SharedReader>(std::move(sequence))) {}

std::unique_ptr<Sequence> SequenceSharer::make() const {
  return std::make_unique<SharedSequence>(reader_);
}

}  // namespace svoscope
