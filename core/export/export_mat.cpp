// Telemetry to a MATLAB 5 file: structs `telemetry` (one column each field), `units`, `header` and `events`.
//
// MATLAB 5 is read by MATLAB, Octave and SciPy alike; its variables end at 2 GiB, which is 1.5 hours of all fields.
// A struct must be written in one go, so the columns are kept in a mapped temporary file, not in memory.
#include <array>
#include <bit>
#include <filesystem>
#include <fstream>
#include <optional>

#include "core/export/export_columns.h"
#include "core/export/export_mat_value.h"
#include "core/export/export_selection.h"
#include "core/export/export_words.h"
#include "core/recording/file/export_file.h"
#include "core/recording/reader/review_notes.h"

namespace fyd::exports {
namespace {

/// Share of the export's time that the columns take, for the progress bar; the rest is libmatio's writing of the file.
constexpr double kColumnsShare = 0.7;
constexpr std::uint64_t kLargestVariable_bytes = (1ULL << 31) - (1ULL << 20);

using Fields = std::vector<std::pair<std::string, MatValue>>;

Result<void> fillColumns(const recording::Recording& recording, const ExportSelection& selection,
                         ColumnStore& columns) {
  std::size_t row = 0;
  std::vector<double> values;
  return forEachBlock(recording, selection, [&](std::span<const pipeline::TelemetrySample> block) -> Result<void> {
    values.resize(block.size());
    for (std::size_t c = 0; c <= selection.fields.size(); ++c) {
      for (std::size_t i = 0; i < block.size(); ++i) {
        values[i] = c == 0 ? secondsInto(recording.info(), block[i].now) : selection.fields[c - 1]->read(block[i]);
      }
      if (auto put = columns.put(c, row, values); !put) return put;
    }
    row += block.size();
    return {};
  });
}

MatValue headerStruct(const recording::RecordingInfo& info) {
  const recording::RecordingHeader& header = info.header;
  std::string tags;
  for (const std::string& tag : recording::tagsInForce(info)) tags += (tags.empty() ? "" : " ") + tag;
  Fields fields;
  const auto add = [&](const char* name, const std::string& text) {
    fields.emplace_back(name, matText(name, cleanText(text)));
  };
  add("id", header.id);
  add("started_utc", header.started_utc);
  add("operator_name", header.operator_name);
  add("subject", header.subject);
  add("notes", header.notes);
  add("tags", tags);
  add("touchpad", header.touchpad);
  add("camera", header.camera);
  add("robot", header.robot);
  add("version", header.version);
  add("profile", header.profile);
  return matStruct("header", std::move(fields));
}

MatValue eventsStruct(const std::vector<LogLine>& lines, const ExportOptions& options, std::uint64_t& count) {
  std::vector<double> times;
  std::vector<double> values;
  std::vector<std::string> kinds;
  std::vector<std::string> texts;
  for (const LogLine& line : lines) {
    if (!inRange(options, line.time_s)) continue;
    times.push_back(line.time_s);
    values.push_back(line.value);
    kinds.emplace_back(line.kind);
    texts.push_back(line.text);
  }
  count = times.size();
  Fields fields;
  fields.emplace_back("time_s", matColumn("time_s", times));
  fields.emplace_back("kind", matTexts("kind", kinds));
  fields.emplace_back("text", matTexts("text", texts));
  fields.emplace_back("value", matColumn("value", values));
  return matStruct("events", std::move(fields));
}

/// Where the element of a MATLAB 5 file that begins at `at` ends, if it and all elements in it do so by `end`.
std::optional<std::uint64_t> endOfElement(std::istream& file, std::uint64_t at, std::uint64_t end) {
  constexpr std::uint32_t kMatrix = 14;    // the type whose content is elements
  constexpr std::uint64_t kAlignment = 8;  // of every element's end
  std::array<char, 8> tag{};
  if (end - at < tag.size() || !file.seekg(static_cast<std::streamoff>(at)).read(tag.data(), tag.size())) {
    return std::nullopt;
  }
  const auto [type, bytes] = std::bit_cast<std::array<std::uint32_t, 2>>(tag);
  at += tag.size();
  if (type >> 16U != 0) return at;  // a short element: its content is in its tag
  const std::uint64_t stop = at + (bytes + kAlignment - 1) / kAlignment * kAlignment;
  if (stop > end) return std::nullopt;
  while (type == kMatrix && at < stop) {
    const auto next = endOfElement(file, at, stop);
    if (!next) return std::nullopt;
    at = *next;
  }
  return stop;
}

/// Whether the file is so many whole variables and nothing else. libmatio does not notice every failed write, and where
/// one failed the file may still be as large as the samples.
bool holdsVariables(const std::string& path, std::size_t count) {
  constexpr std::uint64_t kHeader_bytes = 128;
  std::error_code gone;
  const std::uint64_t size = std::filesystem::file_size(path, gone);
  std::ifstream file(path, std::ios::binary);
  std::optional<std::uint64_t> at = kHeader_bytes;
  if (gone || size < kHeader_bytes) return false;
  for (std::size_t i = 0; i < count && at; ++i) at = endOfElement(file, *at, size);
  return at == size;
}

Result<void> writeVariables(const std::string& path, const std::string& shown, const std::vector<MatValue>& variables) {
  struct CloseMat {
    void operator()(mat_t* file) const { Mat_Close(file); }
  };
  std::unique_ptr<mat_t, CloseMat> file(Mat_CreateVer(path.c_str(), "FYD Console recording", MAT_FT_MAT5));
  if (!file) return fail("{}: cannot be written", shown);
  for (const MatValue& variable : variables) {
    if (!variable) return fail("{}: no memory for its variables", shown);
    if (Mat_VarWrite(file.get(), variable.get(), MAT_COMPRESSION_NONE) != 0) {
      return fail("{}: writing {} failed; is the disk full?", shown, variable->name);
    }
  }
  const bool closed = Mat_Close(file.release()) == 0;  // writes what stdio still held
  if (!closed || !holdsVariables(path, variables.size())) {
    return fail("{}: not all of it could be written; is the disk full?", shown);
  }
  return {};
}

}  // namespace

Result<ExportResult> exportMat(const recording::Recording& recording, const std::string& path,
                               const ExportOptions& options) {
  auto selection = selectSomeRows(recording, options);
  if (!selection) return tl::unexpected(selection.error());
  const auto lines = logLines(recording, options.from_s);
  if (!lines) return tl::unexpected(lines.error());
  const std::uint64_t rows = selection->end - selection->first;
  const std::uint64_t payload = rows * (selection->fields.size() + 1) * sizeof(double);
  if (payload > kLargestVariable_bytes) {
    return fail(
        "{}: {} rows of {} fields are {:.1f} GiB, a MATLAB 5 file takes 2; choose fewer fields or a shorter time", path,
        rows, selection->fields.size(), static_cast<double>(payload) / (1ULL << 30));
  }
  auto file = recording::ExportFile::create(path, options.replace);
  if (!file) return tl::unexpected(file.error());
  selection->progress = recording::partOf(options.progress, 0.0, kColumnsShare);

  ColumnStore columns(selection->fields.size() + 1, static_cast<std::size_t>(rows));
  auto done = columns.open(std::filesystem::path(path).parent_path().string());
  if (done) done = fillColumns(recording, *selection, columns);
  if (done) done = columns.map();
  if (done) done = recording::tellProgress(options.progress, kColumnsShare);
  if (!done) return fail(about(path, done.error().message));

  Fields telemetry;
  Fields units;
  telemetry.emplace_back("time_s", matColumnInPlace("time_s", columns.column(0), static_cast<std::size_t>(rows)));
  units.emplace_back("time_s", matText("time_s", "s"));
  for (std::size_t c = 0; c < selection->fields.size(); ++c) {
    const std::string name(selection->fields[c]->name);
    telemetry.emplace_back(name, matColumnInPlace(name.c_str(), columns.column(c + 1), static_cast<std::size_t>(rows)));
    units.emplace_back(name, matText(name.c_str(), selection->fields[c]->unit));
  }
  ExportResult result{.files = {path}, .rows = rows};
  std::vector<MatValue> variables;
  variables.push_back(matStruct("telemetry", std::move(telemetry)));
  variables.push_back(matStruct("units", std::move(units)));
  variables.push_back(headerStruct(recording.info()));
  variables.push_back(eventsStruct(*lines, options, result.lines));

  done = writeVariables(file->temporary(), path, variables);
  if (done) done = recording::tellProgress(options.progress, 1.0);
  if (done) done = file->commit();
  if (!done) return tl::unexpected(done.error());
  return result;
}

}  // namespace fyd::exports
