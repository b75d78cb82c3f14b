#include "core/export/export_selection.h"

#include <algorithm>
#include <limits>

namespace fyd::exports {
namespace {

using ChosenFields = std::vector<const pipeline::TelemetryField*>;

/// @return an error when the bounds are in the wrong order or NaN, and for an unknown field
Result<ChosenFields> selectFields(const ExportOptions& options) {
  if (!(options.from_s <= options.to_s)) {
    return fail("from {} s to {} s: the first must not be larger than the second", options.from_s, options.to_s);
  }
  const auto all = pipeline::telemetryFields();
  ChosenFields fields;
  if (options.fields.empty()) {
    for (const auto& field : all) fields.push_back(&field);
    return fields;
  }
  for (const std::string& name : options.fields) {
    const auto found = std::ranges::find(all, name, &pipeline::TelemetryField::name);
    if (found == all.end()) {
      std::string known;
      for (const auto& field : all) known += (known.empty() ? "" : ", ") + std::string(field.name);
      return fail("field \"{}\": there is none of this name; there are {}", name, known);
    }
    if (std::ranges::find(fields, &*found) != fields.end()) return fail("field \"{}\": asked for twice", name);
    fields.push_back(&*found);
  }
  return fields;
}

}  // namespace

Result<void> checkSelection(const ExportOptions& options) {
  if (const auto fields = selectFields(options); !fields) return tl::unexpected(fields.error());
  return {};
}

Result<ExportSelection> selectRows(const recording::Recording& recording, const ExportOptions& options) {
  auto fields = selectFields(options);
  if (!fields) return tl::unexpected(fields.error());
  ExportSelection selection{.fields = std::move(*fields), .progress = options.progress};
  const auto first = recording.rowAt(options.from_s);
  if (!first) return tl::unexpected(first.error());
  // The row at to_s itself belongs to the export; times of rows are whole nanoseconds.
  constexpr double kNanosecond_s = 1e-9;
  const auto end = recording.rowAt(options.to_s + kNanosecond_s);
  if (!end) return tl::unexpected(end.error());
  selection.end = options.to_s == std::numeric_limits<double>::infinity() ? recording.info().committed_samples : *end;
  selection.first = std::min(*first, selection.end);
  const recording::RecordingInfo& info = recording.info();
  if (info.unproven_rows > 0 && selection.end == info.committed_samples) {
    return fail(
        "{}: an export would end before the recording does; `fyd session recover` makes what can be proven "
        "whole first, or export up to an earlier second than {:.3f}",
        info.damage, info.duration_s);
  }
  return selection;
}

Result<ExportSelection> selectSomeRows(const recording::Recording& recording, const ExportOptions& options) {
  auto selection = selectRows(recording, options);
  if (selection && selection->first == selection->end) {
    return fail("no samples from {} s to {} s: the recording has {}, to {:.3f} s", options.from_s, options.to_s,
                recording.info().committed_samples, recording.info().duration_s);
  }
  return selection;
}

Result<void> forEachBlock(const recording::Recording& recording, const ExportSelection& selection,
                          const RowsConsumer& consume) {
  std::vector<pipeline::TelemetrySample> block;
  for (std::uint64_t row = selection.first; row < selection.end; row += block.size()) {
    const double done =
        static_cast<double>(row - selection.first) / static_cast<double>(selection.end - selection.first);
    if (auto told = recording::tellProgress(selection.progress, done); !told) return told;
    block.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kExportBlockRows, selection.end - row)));
    if (auto read = recording.telemetry(row, block); !read) return read;
    if (auto consumed = consume(block); !consumed) return consumed;
  }
  return {};
}

Result<std::uint64_t> pictureIndexAt(const recording::Recording& recording, double time_s) {
  std::uint64_t low = 0;
  std::uint64_t high = recording.info().frames;
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    const auto picture = recording.picture(middle);
    if (!picture) return tl::unexpected(picture.error());
    if (picture->time_s < time_s) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

}  // namespace fyd::exports
