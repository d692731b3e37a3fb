// SPDX-License-Identifier: MIT
#include "engine/dataset/shared_sequence.h"

#include <gtest/gtest.h>

namespace svoscope {
namespace {

/// Counts how often it is read.
class CountingSequence : public Sequence {
 public:
  explicit CountingSequence(int& reads) : reads_(reads) {}
  const std::string& name() const override { return name_; }
  int size() const override { return 10; }
  const Camera& camera() const override { return camera_; }
  double timestamp(int index) const override { return 0.1 * index; }
  Result<SequenceImage> read(int index) override {
    ++reads_;
    if (index == 4) return inputError("broken", "4.png", "");
    return SequenceImage{index, timestamp(index), cv::Mat(2, 2, CV_8UC1, cv::Scalar(index))};
  }
  const Trajectory& groundTruth() const override { return truth_; }
  Result<cv::Mat> readDepth(int) override { return cv::Mat(); }

 private:
  int& reads_;
  std::string name_ = "counting";
  Camera camera_;
  Trajectory truth_;
};

TEST(SharedSequence, FramesReadTogetherAreReadOnce) {
  int reads = 0;
  const SequenceSharer sharer(std::make_unique<CountingSequence>(reads));
  const auto a = sharer.make(), b = sharer.make(), c = sharer.make();
  for (int i = 0; i < 10; ++i) {
    for (Sequence* s : {a.get(), b.get(), c.get()}) {
      const auto image = s->read(i);
      ASSERT_EQ(image.ok(), i != 4) << "an error is shared like an image";
      if (i != 4) {
        EXPECT_EQ(image.value().gray.at<unsigned char>(1, 1), i);
      }
    }
  }
  EXPECT_EQ(reads, 10);
  EXPECT_TRUE(a->read(0).ok()) << "what is no longer kept is read again, as after a reset";
  EXPECT_EQ(reads, 11);
}

TEST(SharedSequence, OutlivesTheSharer) {
  int reads = 0;
  std::unique_ptr<Sequence> one;
  {
    const SequenceSharer sharer(std::make_unique<CountingSequence>(reads));
    one = sharer.make();
  }
  EXPECT_EQ(one->name(), "counting");
  EXPECT_TRUE(one->read(3).ok());
}

}  // namespace
}  // namespace svoscope
