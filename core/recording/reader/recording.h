// Reads a recording: whole, still growing in another process, or left behind by a crash. Trusts committed rows only,
// each block checked against its CRC32C when it is first read. Memory does not grow with the recording's length.
//
// Times are seconds from the recording's start; rows are counted from 0.
// Stability: stable since 0.1
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/recording/reader/recording_info.h"
#include "core/recording/step_record.h"

namespace fyd::recording {

/// Used by one thread at a time.
class FYD_API Recording {
 public:
  /// @param path FILE or FILE.partial; FILE alone also finds FILE.partial beside it
  /// @return an error that names the file and what is wrong: no recording, another version, damaged header
  [[nodiscard]] static Result<std::unique_ptr<Recording>> open(const std::string& path);
  virtual ~Recording() = default;

  [[nodiscard]] virtual const RecordingInfo& info() const = 0;
  /// Takes in what was committed since. @return whether there was news
  [[nodiscard]] virtual Result<bool> refresh() = 0;

  /// Rows [first, first + out.size()) of telemetry.
  [[nodiscard]] virtual Result<void> telemetry(std::uint64_t first, std::span<pipeline::TelemetrySample> out) const = 0;
  /// One field (index into telemetryFields()) of those rows.
  [[nodiscard]] virtual Result<void> field(std::size_t field, std::uint64_t first, std::span<double> out) const = 0;
  /// Inputs and outputs of one row, as the step had them: for replay, which goes through rows in order. Its `missing`
  /// names what a recovered recording lost of them. Parameters are counted as bindParameters(pipeline::Parameters&) does
  /// in this library; 0xFFFF: one that it does not have.
  [[nodiscard]] virtual Result<StepRecord> step(std::uint64_t row) const = 0;
  /// The first row at or after `time_s`; committed_samples when there is none.
  [[nodiscard]] virtual Result<std::uint64_t> rowAt(double time_s) const = 0;

  /// At most `buckets` of the rows in [from_s, to_s]; no spike is lost. Long stretches come from the stored pyramid.
  [[nodiscard]] virtual Result<Overview> overview(std::size_t field, double from_s, double to_s,
                                                  std::size_t buckets) const = 0;

  /// The newest picture at `time_s`, and by its number in the recording.
  [[nodiscard]] virtual Result<RecordedPicture> pictureAt(double time_s) const = 0;
  [[nodiscard]] virtual Result<RecordedPicture> picture(std::uint64_t index) const = 0;

  /// Parameters are counted as in step().
  [[nodiscard]] virtual Result<std::vector<EventRow>> events() const = 0;
  [[nodiscard]] virtual Result<std::vector<Note>> notes() const = 0;
  [[nodiscard]] virtual Result<std::vector<LinkRow>> linkRows() const = 0;
};

/// Paths of the tables whose rows for this step are lost, such as "/inputs/ir".
[[nodiscard]] FYD_API std::vector<std::string> missingTables(const StepRecord& record);

}  // namespace fyd::recording
