// Which rows, fields and pictures of a recording an export takes.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/export/export_recording.h"

namespace fyd::exports {

/// Rows read at once: the largest number that an export holds in memory.
inline constexpr std::size_t kExportBlockRows = 1000;

struct ExportSelection {
  std::uint64_t first = 0;
  std::uint64_t end = 0;  ///< one past the last row
  std::vector<const pipeline::TelemetryField*> fields;
  recording::Progress progress;
};

/// @return an error that names the option: bounds in the wrong order or NaN, an unknown field (with the names there
/// are)
[[nodiscard]] Result<ExportSelection> selectRows(const recording::Recording& recording, const ExportOptions& options);
/// selectRows, and an error when there is no row.
[[nodiscard]] Result<ExportSelection> selectSomeRows(const recording::Recording& recording,
                                                     const ExportOptions& options);

using RowsConsumer = std::function<Result<void>(std::span<const pipeline::TelemetrySample>)>;
/// Hands all rows of the selection to `consume`, at most kExportBlockRows at a time, in order; `progress` may end it.
[[nodiscard]] Result<void> forEachBlock(const recording::Recording& recording, const ExportSelection& selection,
                                        const RowsConsumer& consume);

/// The first picture at or after `time_s`; the number of pictures when there is none.
[[nodiscard]] Result<std::uint64_t> pictureIndexAt(const recording::Recording& recording, double time_s);

/// Whether a line of the log at `time_s` belongs to the export.
[[nodiscard]] inline bool inRange(const ExportOptions& options, double time_s) {
  return time_s >= options.from_s && time_s <= options.to_s;
}

}  // namespace fyd::exports
