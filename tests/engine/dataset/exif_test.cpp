// SPDX-License-Identifier: MIT
#include "engine/dataset/exif.h"

#include <gtest/gtest.h>

#include <string>

namespace svoscope {
namespace {

using namespace std::string_literals;

std::string jpegWith(const std::string& tiff) {
  const std::string segment = "Exif\0\0"s + tiff;
  const auto length = static_cast<char>(segment.size() + 2);
  return "\xFF\xD8\xFF\xE1"s + '\0' + length + segment + "\xFF\xDA rest"s;
}

// Header, offset 8, one entry: tag 0x0112, type 3 (short), count 1, value, no next directory.
const std::string kLittle = "II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0"s;
const std::string kBig = "MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x03\0\0\0\0\0\0"s;

TEST(Exif, OrientationInBothByteOrders) {
  EXPECT_EQ(exifOrientation(jpegWith(kLittle)), 6);
  EXPECT_EQ(exifOrientation(jpegWith(kBig)), 3);
  EXPECT_TRUE(swapsSides(6));
  EXPECT_FALSE(swapsSides(3));
}

TEST(Exif, WithoutATagPixelsAreAsStored) {
  EXPECT_EQ(exifOrientation(""), 1);
  EXPECT_EQ(exifOrientation("\x89PNG"), 1);
  EXPECT_EQ(exifOrientation("\xFF\xD8\xFF\xDA\x01"s), 1);
}

TEST(Exif, DamageIsNoOrientation) {
  const std::string whole = jpegWith(kLittle);
  for (std::size_t cut = 0; cut < whole.size(); ++cut) {
    const int orientation = exifOrientation(whole.substr(0, cut));
    EXPECT_TRUE(orientation == 1 || orientation == 6) << cut;
  }
  std::string far = whole;
  far[16] = '\x7F';  // the directory lies beyond the end
  EXPECT_EQ(exifOrientation(far), 1);
}

}  // namespace
}  // namespace svoscope
