// Telemetry to CSV, and the log beside it: OUT.csv and OUT.events.csv.
//
// Lost rows are not filled in: step and time jump there.
#include "core/export/export_csv_text.h"
#include "core/export/export_selection.h"
#include "core/export/export_words.h"
#include "core/recording/file/export_file.h"

namespace fyd::exports {
namespace {

Result<void> writeRows(const recording::Recording& recording, const ExportSelection& selection,
                       recording::ExportFile& file) {
  std::string text = "time_s [s]";  // from the recording's start; t_s is the station's clock, as recorded
  for (const auto* field : selection.fields) text.append(1, ',').append(columnTitle(*field));
  text += '\n';
  if (auto written = file.write(text); !written) return written;
  return forEachBlock(recording, selection, [&](std::span<const pipeline::TelemetrySample> rows) {
    text.clear();
    for (const pipeline::TelemetrySample& row : rows) {
      appendNumber(text, secondsInto(recording.info(), row.now));
      text += ',';
      appendRow(text, row, selection.fields);
      text += '\n';
    }
    return file.write(text);
  });
}

std::string eventsText(const std::vector<LogLine>& lines, const ExportOptions& options, std::uint64_t& count) {
  std::string text = "time_s [s],kind,text,value\n";
  for (const LogLine& line : lines) {
    if (!inRange(options, line.time_s)) continue;
    appendNumber(text, line.time_s);
    text += ',';
    appendText(text, line.kind);
    text += ',';
    appendText(text, line.text);
    text += ',';
    appendNumber(text, line.value);
    text += '\n';
    ++count;
  }
  return text;
}

}  // namespace

Result<ExportResult> exportCsv(const recording::Recording& recording, const std::string& path,
                               const ExportOptions& options) {
  const auto selection = selectSomeRows(recording, options);
  if (!selection) return tl::unexpected(selection.error());
  const auto lines = logLines(recording, options.from_s);
  if (!lines) return tl::unexpected(lines.error());

  ExportResult result{.rows = selection->end - selection->first};
  result.files = exportFiles(path);
  auto rows_file = recording::ExportFile::create(path, options.replace);
  if (!rows_file) return tl::unexpected(rows_file.error());
  auto events_file = recording::ExportFile::create(result.files.back(), options.replace);
  if (!events_file) return tl::unexpected(events_file.error());

  auto done = writeRows(recording, *selection, *rows_file);
  if (done) done = events_file->write(eventsText(*lines, options, result.lines));
  if (done) done = events_file->commit();
  if (done) done = rows_file->commit();  // last: when this file exists, both do
  if (!done) return tl::unexpected(done.error());
  return result;
}

}  // namespace fyd::exports
