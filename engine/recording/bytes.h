// SPDX-License-Identifier: MIT
// Packed values of a blob: little-endian as in memory, integers with 7 bits a byte, zigzag.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

namespace svoscope {

class ByteWriter {
 public:
  template <typename T>
  void raw(const T& value) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof(T));
    std::memcpy(bytes_.data() + at, &value, sizeof(T));
  }
  void unsignedInteger(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) bytes_.push_back(static_cast<unsigned char>(value | 0x80));
    bytes_.push_back(static_cast<unsigned char>(value));
  }
  void integer(std::int64_t value) {
    unsignedInteger((static_cast<std::uint64_t>(value) << 1) ^
                    static_cast<std::uint64_t>(value >> 63));
  }
  void clear() { bytes_.clear(); }
  const unsigned char* data() const { return bytes_.data(); }
  std::size_t size() const { return bytes_.size(); }

 private:
  std::vector<unsigned char> bytes_;
};

/// Reads what a ByteWriter wrote. Beyond the end everything is 0 and good() is false.
class ByteReader {
 public:
  ByteReader(const unsigned char* data, std::size_t size) : at_(data), end_(data + size) {}

  template <typename T>
  void raw(T& value) {
    if (static_cast<std::size_t>(end_ - at_) < sizeof(T)) return fail();
    std::memcpy(&value, at_, sizeof(T));
    at_ += sizeof(T);
  }
  std::uint64_t unsignedInteger() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      if (at_ == end_) break;
      const unsigned char byte = *at_++;
      value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
      if (!(byte & 0x80)) return value;
    }
    fail();
    return 0;
  }
  std::int64_t integer() {
    const std::uint64_t value = unsignedInteger();
    return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
  }
  bool good() const { return good_; }
  bool atEnd() const { return at_ == end_; }

 private:
  void fail() {
    good_ = false;
    at_ = end_;
  }
  const unsigned char* at_;
  const unsigned char* end_;
  bool good_ = true;
};

}  // namespace svoscope
