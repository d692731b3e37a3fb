// SPDX-License-Identifier: MIT
// The one tag of EXIF that changes which pixel is where.
#pragma once

#include <string_view>

namespace svoscope {

/// Orientation (1 to 8) of a JPEG file's bytes; 1, as stored, if it says nothing.
int exifOrientation(std::string_view jpeg);

/// Orientations 5 to 8 swap width and height.
inline bool swapsSides(int orientation) { return orientation >= 5 && orientation <= 8; }

}  // namespace svoscope
