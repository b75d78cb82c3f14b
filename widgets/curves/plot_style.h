// The look of the axes of every plot, and margins that align plots placed below each other.
#pragma once

#include <QList>

class QCPAxis;

namespace fyd::widgets {

/// Of the curves over time and of the spectrum below them, px.
inline constexpr int kCurveLeft_px = 48;
inline constexpr int kCurveRight_px = 16;
inline constexpr int kTimeScale_px = 20;  ///< height of the scale's numbers
/// Of the live reading and of the fit, px.
inline constexpr int kReadingLeft_px = 64;

/// Numbers and a thin grid, nothing else, in the theme's colours; again after each change of the look.
void styleAxes(const QList<QCPAxis*>& axes);

}  // namespace fyd::widgets
