#include "app/cli/parts/telemetry_csv.h"

#include <utility>

#include "app/cli/parts/command.h"
#include "core/export/export_csv_text.h"

namespace fyd::cli {

TelemetryCsv::TelemetryCsv(const std::string& path, const std::vector<std::string>& inputs, Appears appears)
    : file_(path, inputs, appears) {}

void TelemetryCsv::writeNames() {
  if (std::exchange(named_, true)) return;
  line_.clear();
  for (const pipeline::TelemetryField& field : pipeline::telemetryFields()) {
    line_ += line_.empty() ? "" : ",";
    line_ += field.name;
  }
  line_ += '\n';
  file_.write(line_);
}

void TelemetryCsv::flush() {
  writeNames();
  file_.flush();
}

void TelemetryCsv::close() {
  writeNames();
  file_.close();
}

Message TelemetryCsv::closed() {
  try {
    close();
  } catch (const Failure& failure) {
    return failure.message;
  }
  return {};
}

void TelemetryCsv::write(const pipeline::TelemetrySample& sample) {
  writeNames();
  line_.clear();
  for (const pipeline::TelemetryField& field : pipeline::telemetryFields()) {
    if (!line_.empty()) line_ += ',';
    exports::appendNumber(line_, field.read(sample));
  }
  line_ += '\n';
  file_.write(line_);
}

}  // namespace fyd::cli
