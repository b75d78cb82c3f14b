// Telemetry as a CSV file, one row per step, columns as in telemetryFields().
#pragma once

#include <string>
#include <vector>

#include "app/cli/parts/output_file.h"
#include "core/pipeline/telemetry.h"

namespace fyd::cli {

/// As an OutputFile.
class TelemetryCsv {
 public:
  /// @param inputs of the command, as for writeTextFile
  /// Throws Failure when the file cannot be made.
  TelemetryCsv(const std::string& path, const std::vector<std::string>& inputs, Appears appears = Appears::growing);
  void write(const pipeline::TelemetrySample& sample);
  /// What was written so far stands before anything that is printed from now on.
  void flush();
  /// Throws Failure when not everything reached the file.
  void close();
  /// The same, with what went wrong returned; empty: nothing.
  [[nodiscard]] Message closed();
  /// What went wrong so far; empty: nothing.
  [[nodiscard]] Message problem() const { return file_.problem(); }

 private:
  void writeNames();

  OutputFile file_;
  std::string line_;
  bool named_ = false;  ///< the first line is written
};

}  // namespace fyd::cli
