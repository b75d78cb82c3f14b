// Plausibility of a KRC's measurements: values that no LWR can have are refused, whatever their cause (a faulty
// program, a layout of another version), before anything is used or mirrored as a command. Pure.
//
// Bounds, well outside the arm's ranges (KUKA's data of the LWR 4+: joints ±170° at most, reach 1.2 m, 7 kg, 176 Nm):
//   joints      measured, commanded, commanded plus offset: within ±2π rad
//   frames      rotation orthonormal within 0.01 and right-handed; place, and the commanded one's offset, within 3 m
//   apart       commanded and measured place differ by at most 0.3 m: 300 N at the thesis' 1000 N/m
//   step        the measured place moves at most 0.3 m from a measurement to the next: 3 m/s at the longest cycle
//   tool        force within 1000 N, torque within 500 Nm
//   KRL reals   1 to 3, taken as acceleration, within ±100 g
// Values that are not used (Jacobian, masses, temperatures, torques of the joints) are not checked.
#pragma once

#include "core/base/error.h"
#include "core/base/vec3.h"
#include "core/protocol/fri_codec.h"

namespace fyd::device {

/// @param measurement of finite numbers, as the codec gives them @return an error that names the quantity, its value
/// and the bound
[[nodiscard]] Result<void> checkMeasurement(const protocol::FriMeasurement& measurement);

/// @param ahead measurements from `before` to `now`, above 0
/// @return an error when the tool cannot have moved so far
[[nodiscard]] Result<void> checkStep(const protocol::FriMeasurement& before, const protocol::FriMeasurement& now,
                                     int ahead);

/// Place of a frame in the base, m.
[[nodiscard]] Vec3 placeIn(const protocol::FriFrame& frame);

}  // namespace fyd::device
