// SPDX-License-Identifier: MIT
#include "engine/dataset/exif.h"

#include <cstdint>
#include <optional>

namespace svoscope {

namespace {

/// Unsigned number of `size` bytes at a position; empty beyond the end.
std::optional<std::uint32_t> number(std::string_view bytes, std::size_t at, int size, bool little) {
  if (at + static_cast<std::size_t>(size) > bytes.size()) return std::nullopt;
  std::uint32_t value = 0;
  for (int i = 0; i < size; ++i) {
    const int from = little ? size - 1 - i : i;
    value = value << 8 | static_cast<std::uint8_t>(bytes[at + static_cast<std::size_t>(from)]);
  }
  return value;
}

/// Entry 0x0112 of the first directory of a TIFF header.
int orientationOfTiff(std::string_view tiff) {
  if (tiff.size() < 8) return 1;
  const bool little = tiff.substr(0, 2) == "II";
  if (!little && tiff.substr(0, 2) != "MM") return 1;
  const auto directory = number(tiff, 4, 4, little);
  const auto entries = directory ? number(tiff, *directory, 2, little) : std::nullopt;
  for (std::uint32_t i = 0; entries && i < *entries; ++i) {
    const std::size_t at = std::size_t{*directory} + 2 + std::size_t{12} * i;
    const auto tag = number(tiff, at, 2, little), value = number(tiff, at + 8, 2, little);
    if (!tag || !value) return 1;
    if (*tag == 0x0112) return *value >= 1 && *value <= 8 ? static_cast<int>(*value) : 1;
  }
  return 1;
}

}  // namespace

int exifOrientation(std::string_view jpeg) {
  if (jpeg.substr(0, 2) != "\xFF\xD8") return 1;
  std::size_t at = 2;
  while (const auto marker = number(jpeg, at, 2, false)) {
    if (*marker < 0xFFC0 || *marker == 0xFFDA) return 1;  // the image itself begins
    const auto length = number(jpeg, at + 2, 2, false);
    if (!length || *length < 2) return 1;
    const std::string_view segment = jpeg.substr(at + 4, *length - 2);
    if (*marker == 0xFFE1 && segment.substr(0, 4) == "Exif" && segment.size() > 6)
      return orientationOfTiff(segment.substr(6));
    at += 2 + *length;
  }
  return 1;
}

}  // namespace svoscope
