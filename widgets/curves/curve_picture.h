// Exports the shown curves in memory, as PNG, SVG or PDF and as a CSV table.
#pragma once

#include <QByteArray>
#include <QString>

#include "core/base/error.h"
#include "widgets/curves/curve_stack.h"

namespace fyd::widgets {

enum class PictureKind { png, svg, pdf };
/// "png", also the file's extension.
[[nodiscard]] QString wordOf(PictureKind kind);

/// Every strip that is shown, with its name and unit above it, and `title` and the marks on top; in the look of the
/// window. PNG has twice the window's pixels; PDF is one landscape page of A4. For the window's thread.
/// @return an error when Qt cannot make the format
[[nodiscard]] Result<QByteArray> pictureOf(const CurveStack& stack, PictureKind kind, const QString& title);

/// Every sample of the curves that are shown, over the stretch of time that is shown: one column a curve, named with
/// its unit as exports name them ("force_N [N]"), "time [s]" first; "nan" where there is no value. For any thread.
struct CurveTable {
  std::vector<std::string> names;  ///< one for each of `rows.values`
  CurveRows rows;
};
/// @param source as drawn in the stack; its channels up to kCurveChannels are looked at
[[nodiscard]] CurveTable tableOf(const CurveStack& stack, const CurveSource& source);
[[nodiscard]] QByteArray csvOf(const CurveTable& table);

}  // namespace fyd::widgets
