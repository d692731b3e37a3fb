// SPDX-License-Identifier: MIT
// A sequence whose images are kept in memory: several runs, rendered or decoded once.
#pragma once

#include <memory>
#include <vector>

#include "engine/dataset/sequence.h"

namespace svoscope {

/// Copies share the source and the images. One thread at a time, over all copies.
class KeptSequence : public Sequence {
 public:
  explicit KeptSequence(std::unique_ptr<Sequence> source)
      : source_(std::move(source)),
        images_(std::make_shared<std::vector<cv::Mat>>(source_->size())) {}

  const std::string& name() const override { return source_->name(); }
  int size() const override { return source_->size(); }
  const Camera& camera() const override { return source_->camera(); }
  double timestamp(int index) const override { return source_->timestamp(index); }
  const Trajectory& groundTruth() const override { return source_->groundTruth(); }
  Result<cv::Mat> readDepth(int index) override { return source_->readDepth(index); }

  Result<SequenceImage> read(int index) override {
    cv::Mat& kept = images_->at(index);
    if (!kept.empty()) return SequenceImage{index, timestamp(index), kept};
    auto image = source_->read(index);
    if (image.ok()) kept = image.value().gray;
    return image;
  }

 private:
  std::shared_ptr<Sequence> source_;
  std::shared_ptr<std::vector<cv::Mat>> images_;
};

}  // namespace svoscope
