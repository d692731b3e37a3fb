// SPDX-License-Identifier: MIT
// Smooth camera motions in the world frame (z up, metres, seconds).
#pragma once

#include "engine/geometry/se3.h"

namespace svoscope::synthetic {

/// T_world_cam of a camera at `eye` that looks at `target`, rolled by `roll` radians about its
/// axis. The view must not be vertical.
SE3 lookAt(const Vec3& eye, const Vec3& target, double roll);

/// T_world_cam of a camera at `eye` that looks straight down, its x axis turned by `yaw` from the
/// world's, then tilted by small angles about its own x and y axis (radians).
SE3 lookDown(const Vec3& eye, double yaw, double tilt_x, double tilt_y);

/// The unsteadiness of a hand: a sum of sinusoids between 0.3 and 1.9 Hz, about -1..1 on each
/// axis; `phase` makes independent ones.
Vec3 handShake(double t, double phase);

SE3 roomMotion(double t);      ///< to and fro on an arc around the middle of the room
SE3 spinMotion(double t);      ///< turns on the spot
SE3 deskMotion(double t);      ///< along the axes, hardly turning
SE3 floorMotion(double t);     ///< figures of Lissajous above the floor
SE3 corridorMotion(double t);  ///< walks along +x at 1.1 m/s
SE3 streetMotion(double t);    ///< drives along +x at 8 m/s

}  // namespace svoscope::synthetic
