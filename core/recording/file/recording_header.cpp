#include "core/recording/file/recording_header.h"

#include <sstream>

#include "core/base/checksum.h"
#include "core/recording/file/recording_values.h"
#include "core/recording/format/recording_format.h"

namespace fyd::recording {
namespace {

// Every text with its path; a list is one text, each of its words ended by a line feed.
template <class Header, class Visit>
void visitTexts(Header& header, Visit&& visit) {
  visit("/header/id", header.id);
  visit("/header/started_utc", header.started_utc);
  visit("/header/operator", header.operator_name);
  visit("/header/subject", header.subject);
  visit("/header/notes", header.notes);
  visit("/header/touchpad", header.touchpad);
  visit("/header/camera", header.camera);
  visit("/header/robot", header.robot);
  visit("/header/profile", header.profile);
  visit("/header/surface", header.surface);
  visit("/header/program", header.version);
}

constexpr std::uint64_t kLargestScene_bytes = 2ULL << 30;

/// Of files that do not name theirs.
constexpr int kUnnamedArithmetic = 1;

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    for (const char c : word) text += c == '\n' ? ' ' : c;
    text += '\n';
  }
  return text;
}

std::vector<std::string> parted(const std::string& text) {
  std::vector<std::string> words;
  std::size_t from = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; from = end + 1, end = text.find('\n', from))
    words.push_back(text.substr(from, end - from));
  return words;
}

constexpr const char* kScenePath = "/header/scene";        // only where one was felt
constexpr const char* kLatenessPath = "/header/lateness";  // not in older files
constexpr const char* kMissingPath = "/header/missing";    // only where something is missing
constexpr const char* kLackingPath = "/header/lacking";    // only in a copy of an older file

/// A line for each: table, first, count, why.
std::string linesOf(const std::vector<MissingRows>& missing) {
  std::string text;
  for (const MissingRows& rows : missing) {
    text += fmt::format("{} {} {} ", rows.table, rows.first, rows.count);
    for (const char c : rows.why) text += c == '\n' ? ' ' : c;
    text += '\n';
  }
  return text;
}

std::vector<MissingRows> missingOf(const std::string& text) {
  std::vector<MissingRows> missing;
  for (const std::string& line : parted(text)) {
    MissingRows rows;
    std::istringstream words(line);
    if (!(words >> rows.table >> rows.first >> rows.count))
      failHard(about(kMissingPath, verbatim(fmt::format("\"{}\"", line))));
    std::getline(words >> std::ws, rows.why);
    missing.push_back(rows);
  }
  return missing;
}

std::int64_t checksum(const RecordingHeader& header) {
  std::string all = fmt::format("{};{};", kFormatVersion, header.started.time_since_epoch().count());
  const auto add = [&](const char* path, const std::string& text) {
    all += fmt::format("{}:{}:{};", path, text.size(), text);
  };
  visitTexts(header, add);
  add("/header/tags", joined(header.tags));
  add("/header/step_state", header.step_state);
  if (header.arithmetic != kUnnamedArithmetic) all += fmt::format("arithmetic:{};", header.arithmetic);
  if (header.scene) {
    all += fmt::format("{}:{}:{};", kScenePath, header.scene->size(), crc32c(std::as_bytes(std::span(*header.scene))));
  }
  if (!header.lateness.empty()) add(kLatenessPath, header.lateness);
  if (!header.missing.empty()) add(kMissingPath, linesOf(header.missing));
  if (!header.lacking.empty()) add(kLackingPath, joined(header.lacking));
  return crc32c(std::as_bytes(std::span(all)));
}

std::string readTextIfAny(hid_t file, const char* path) {
  return H5Lexists(file, path, H5P_DEFAULT) > 0 ? readText(file, path) : std::string{};
}

std::shared_ptr<const std::string> readScene(hid_t file) {
  if (H5Lexists(file, kScenePath, H5P_DEFAULT) <= 0) return nullptr;
  return std::make_shared<const std::string>(readBytes(file, kScenePath, kLargestScene_bytes));
}

void checkVersion(hid_t file) {
  if (H5Aexists(file, "fyd_recording") <= 0) failHard("an HDF5 file, but not a recording of the console");
  const std::int64_t version = readNumber(file, "fyd_recording");
  if (version != kFormatVersion)
    failHard("a recording of format {}; this program reads format {}", version, kFormatVersion);
}

int readArithmetic(hid_t file) {
  if (H5Aexists(file, "arithmetic") <= 0) return kUnnamedArithmetic;
  const std::int64_t arithmetic = readNumber(file, "arithmetic");
  if (arithmetic < 1 || arithmetic > 1'000'000) failHard("arithmetic {}: expected 1 or more", arithmetic);
  return static_cast<int>(arithmetic);
}

}  // namespace

void writeHeader(hid_t file, const RecordingHeader& header) {
  writeNumber(file, "fyd_recording", kFormatVersion);
  writeNumber(file, "started_ns", header.started.time_since_epoch().count());
  visitTexts(header, [&](const char* path, const std::string& text) { writeText(file, path, text); });
  writeText(file, "/header/tags", joined(header.tags));
  writeBytes(file, "/header/step_state", header.step_state);
  writeNumber(file, "arithmetic", header.arithmetic);
  if (header.scene) writeBytes(file, kScenePath, *header.scene);
  if (!header.lateness.empty()) writeText(file, kLatenessPath, header.lateness);
  if (!header.missing.empty()) writeText(file, kMissingPath, linesOf(header.missing));
  if (!header.lacking.empty()) writeText(file, kLackingPath, joined(header.lacking));
  writeNumber(file, "header_crc32c", checksum(header));
}

RecordingHeader readHeader(hid_t file) {
  checkVersion(file);
  RecordingHeader header;
  header.started = Instant(Duration(readNumber(file, "started_ns")));
  visitTexts(header, [&](const char* path, std::string& text) { text = readText(file, path); });
  header.tags = parted(readText(file, "/header/tags"));
  header.step_state = readBytes(file, "/header/step_state");
  header.arithmetic = readArithmetic(file);
  header.scene = readScene(file);
  header.lateness = readTextIfAny(file, kLatenessPath);
  header.missing = missingOf(readTextIfAny(file, kMissingPath));
  header.lacking = parted(readTextIfAny(file, kLackingPath));
  if (readNumber(file, "header_crc32c") != checksum(header)) failHard("its header is damaged: the checksum differs");
  return header;
}

RecordingHeader salvageHeader(hid_t file) {
  checkVersion(file);
  RecordingHeader header;
  try {
    return readHeader(file);
  } catch (const RecordingFailure& failure) {
    header.missing = {{.table = kHeaderTable, .count = 1, .why = failure.message.text()}};
  }
  const auto attempt = [](auto&& read) {
    try {
      read();
    } catch (const RecordingFailure&) {
    }
  };
  attempt([&] { header.started = Instant(Duration(readNumber(file, "started_ns"))); });
  visitTexts(header, [&](const char* path, std::string& text) { attempt([&] { text = readText(file, path); }); });
  attempt([&] { header.tags = parted(readText(file, "/header/tags")); });
  attempt([&] { header.step_state = readBytes(file, "/header/step_state"); });
  attempt([&] { header.arithmetic = readArithmetic(file); });
  attempt([&] { header.scene = readScene(file); });
  attempt([&] {
    const auto before = missingOf(readTextIfAny(file, kMissingPath));  // what an earlier recovery found
    header.missing.insert(header.missing.end(), before.begin(), before.end());
  });
  attempt([&] { header.lateness = readTextIfAny(file, kLatenessPath); });
  attempt([&] { header.lacking = parted(readTextIfAny(file, kLackingPath)); });
  return header;
}

}  // namespace fyd::recording
