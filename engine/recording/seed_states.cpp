// SPDX-License-Identifier: MIT
#include "engine/recording/seed_states.h"

#include <algorithm>

#include "engine/recording/columns.h"

namespace svoscope {

namespace {

constexpr std::uint64_t kMostSeeds = 1u << 22;  // more in one frame is damage

template <typename T>
bool same(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;  // bit by bit: NaN equals itself
}

template <typename T>
void write(ByteWriter& out, const T& v) {
  if constexpr (std::is_enum_v<T> || std::is_integral_v<T>)
    out.integer(static_cast<std::int64_t>(v));
  else if constexpr (std::is_same_v<T, Vec2f>)
    out.raw(v.x()), out.raw(v.y());
  else
    out.raw(v);
}

template <typename T>
void read(ByteReader& in, T& v) {
  if constexpr (std::is_enum_v<T>)
    v = valueOfCode<T>(in.integer());
  else if constexpr (std::is_integral_v<T>)
    v = static_cast<T>(in.integer());
  else if constexpr (std::is_same_v<T, Vec2f>)
    in.raw(v.x()), in.raw(v.y());
  else
    in.raw(v);
}

using Changed = std::uint32_t;  // a bit for each field that is in the blob
static_assert(seedStateFields() <= 32, "the mask of changed fields has no more bits");

}  // namespace

void SeedIndex::set(List seeds) {
  seeds_ = std::move(seeds);
  next_ = 0;
  at_.clear();
}

const SeedView* SeedIndex::find(std::int64_t id) const {
  constexpr std::size_t kLook = 32;
  if (!seeds_ || seeds_->empty()) return nullptr;
  const auto& seeds = *seeds_;
  for (std::size_t i = next_; i < std::min(next_ + kLook, seeds.size()); ++i) {
    if (seeds[i].id != id) continue;
    next_ = i + 1;
    return &seeds[i];
  }
  if (at_.empty()) {
    at_.reserve(seeds.size());
    for (std::size_t i = 0; i < seeds.size(); ++i) at_.emplace(seeds[i].id, i);
  }
  const auto it = at_.find(id);
  if (it == at_.end()) return nullptr;
  next_ = it->second + 1;
  return &seeds[it->second];
}

void encodeSeeds(const std::vector<SeedView>& seeds, const SeedIndex& before, ByteWriter& out) {
  const SeedView fresh;
  out.unsignedInteger(seeds.size());
  std::int64_t last_id = 0;
  for (const SeedView& seed : seeds) {
    const SeedView* old = before.find(seed.id);
    Changed changed = 0, bit = 1;
    visitSeedState(
        [&](const char*, const auto& now, const auto& then) {
          if (!same(now, then)) changed |= bit;
          bit <<= 1;
        },
        seed, old ? *old : fresh);
    out.integer(seed.id - last_id);
    out.unsignedInteger(changed);
    bit = 1;
    visitSeedState(
        [&](const char*, const auto& field) {
          if (changed & bit) write(out, field);
          bit <<= 1;
        },
        seed);
    last_id = seed.id;
  }
}

bool decodeSeeds(ByteReader& in, const SeedIndex& before, std::vector<SeedView>& seeds) {
  const std::uint64_t count = in.unsignedInteger();
  if (!in.good() || count > kMostSeeds) return false;
  seeds.clear();
  seeds.reserve(count);
  std::int64_t id = 0;
  for (std::uint64_t i = 0; i < count && in.good(); ++i) {
    id += in.integer();
    const SeedView* old = before.find(id);
    seeds.push_back(old ? *old : SeedView());
    SeedView& seed = seeds.back();
    seed.id = id;
    const auto changed = static_cast<Changed>(in.unsignedInteger());
    Changed bit = 1;
    visitSeedState(
        [&](const char*, auto& field) {
          if (changed & bit) read(in, field);
          bit <<= 1;
        },
        seed);
  }
  return in.good() && in.atEnd();
}

}  // namespace svoscope
