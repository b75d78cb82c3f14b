// Physical constants, each defined here only. Angles are degrees, lengths millimetres,
// forces newtons, stiffness N/mm unless a name says otherwise.
#pragma once

namespace fyd {

inline constexpr double kStandardGravity = 9.80665;  ///< m/s², CGPM 1901; newtons per kilogram-force

}  // namespace fyd
