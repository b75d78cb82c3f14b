// Telemetry as a CSV file, one row per step, columns as in telemetryFields().
#pragma once

#include <fstream>
#include <string>

#include "core/pipeline/telemetry.h"

namespace fyd::cli {

class TelemetryCsv {
 public:
  /// Throws Failure when the file cannot be made.
  explicit TelemetryCsv(const std::string& path);
  void write(const pipeline::TelemetrySample& sample);
  /// Throws Failure when not everything reached the file.
  void close();

 private:
  std::string path_;
  std::ofstream file_;
  std::string line_;
};

}  // namespace fyd::cli
