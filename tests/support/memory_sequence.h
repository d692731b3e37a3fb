// SPDX-License-Identifier: MIT
// Sequences for tests: images made by a function, or another sequence with some frames changed.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "engine/dataset/sequence.h"

namespace svoscope::test {

/// Passes frames of another sequence on, each through `change`; frames in `unreadable` are errors.
class ChangedSequence : public Sequence {
 public:
  using Change = std::function<void(int index, cv::Mat& gray)>;

  ChangedSequence(std::unique_ptr<Sequence> base, Change change, std::set<int> unreadable = {})
      : base_(std::move(base)), change_(std::move(change)), unreadable_(std::move(unreadable)) {}

  const std::string& name() const override { return base_->name(); }
  int size() const override { return base_->size(); }
  const Camera& camera() const override { return base_->camera(); }
  double timestamp(int index) const override { return base_->timestamp(index); }
  Result<SequenceImage> read(int index) override {
    if (unreadable_.count(index))
      return inputError("cannot be decoded", "frame.png", "check the file");
    auto image = base_->read(index);
    if (image.ok() && change_) change_(index, image.value().gray);
    return image;
  }
  const Trajectory& groundTruth() const override { return base_->groundTruth(); }
  Result<cv::Mat> readDepth(int index) override { return base_->readDepth(index); }

 private:
  std::unique_ptr<Sequence> base_;
  Change change_;
  std::set<int> unreadable_;
};

/// A built-in sequence; throws if the text is wrong.
inline std::unique_ptr<Sequence> openBuiltIn(const std::string& spec) {
  return std::move(openSequence(spec).value());
}

}  // namespace svoscope::test
