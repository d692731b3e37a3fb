// SPDX-License-Identifier: MIT
// One sequence read by several runs: what one of them has read lately, the others get without
// reading or rendering it again.
#pragma once

#include <memory>

#include "engine/dataset/sequence.h"

namespace svoscope {

class SharedReader;

/// Makes sequences that share their images. Runs that are moved together ask for the same frames
/// one after another, so that the last few suffice. Images are shared and must not be written to.
class SequenceSharer {
 public:
  explicit SequenceSharer(std::unique_ptr<Sequence> sequence);
  /// Usable from a thread of its own, longer than the sharer.
  std::unique_ptr<Sequence> make() const;

 private:
  std::shared_ptr<SharedReader> reader_;
};

}  // namespace svoscope
