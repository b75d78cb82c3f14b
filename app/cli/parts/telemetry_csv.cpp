#include "app/cli/parts/telemetry_csv.h"

#include "app/cli/parts/command.h"
#include "app/cli/parts/output_file.h"
#include "core/export/export_csv_text.h"

namespace fyd::cli {

TelemetryCsv::TelemetryCsv(const std::string& path) : path_(path), file_(openForWriting(path)) {
  for (const pipeline::TelemetryField& field : pipeline::telemetryFields()) {
    line_ += line_.empty() ? "" : ",";
    line_ += field.name;
  }
  file_ << line_ << '\n';
}

void TelemetryCsv::write(const pipeline::TelemetrySample& sample) {
  line_.clear();
  for (const pipeline::TelemetryField& field : pipeline::telemetryFields()) {
    if (!line_.empty()) line_ += ',';
    exports::appendNumber(line_, field.read(sample));
  }
  line_ += '\n';
  file_ << line_;
}

void TelemetryCsv::close() {
  file_.close();
  if (!file_) throw Failure(say("{}: writing failed; is the disk full?", path_));
}

}  // namespace fyd::cli
