#include "core/recording/reader/review_notes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "core/base/system_reason.h"
#include "core/base/whole_file.h"
#include "core/recording/file/export_file.h"
#include "core/recording/file/recording_place.h"

namespace fyd::recording {
namespace {

constexpr const char* kIdKey = "recording_id";

constexpr std::array<std::pair<NoteKind, const char*>, 2> kKinds = {
    {{NoteKind::note, "note"}, {NoteKind::bookmark, "bookmark"}}};

Result<ReviewNote> noteOf(const nlohmann::json& entry) {
  ReviewNote note;
  const std::string kind = entry.at("kind");
  const auto known = std::ranges::find(kKinds, kind, [](const auto& each) { return std::string_view(each.second); });
  if (known == kKinds.end()) return fail("kind \"{}\"; expected note or bookmark", kind);
  note.kind = known->first;
  note.time_s = entry.at("time_s");
  if (!std::isfinite(note.time_s)) return fail("time_s is no number");
  note.text = entry.at("text");
  note.written_utc = entry.value("written_utc", "");
  return note;
}

}  // namespace

Result<ReviewNotes> readReviewNotes(const std::string& recording_path, const std::string& id) {
  const std::string path = reviewNotesPath(recording_path);
  std::error_code problem;
  if (!std::filesystem::exists(path, problem) && !problem) return ReviewNotes{};
  const auto text = readWholeFile(path);
  if (!text) return tl::unexpected(text.error());
  ReviewNotes review;
  std::vector<ReviewNote>& notes = review.notes;
  try {
    const nlohmann::json all = nlohmann::json::parse(*text);  // must outlive the loop over a part of it
    if (const std::string theirs = all.value(kIdKey, ""); !theirs.empty() && !id.empty() && theirs != id) {
      return fail("{}: these notes are of another recording, {}; expected {}", path, theirs, id);
    }
    for (const nlohmann::json& entry : all.at("notes")) {
      auto note = noteOf(entry);
      if (!note) return fail("{}: note {}: {}", path, notes.size() + 1, note.error().message);
      notes.push_back(std::move(*note));
    }
    if (all.contains("tags")) review.tags = all.at("tags").get<std::vector<std::string>>();
  } catch (const nlohmann::json::exception& error) {
    return fail("{}: note {}: {}", path, notes.size() + 1, verbatim(error.what()));
  }
  std::ranges::stable_sort(notes, {}, &ReviewNote::time_s);
  return review;
}

std::vector<std::string> tagsInForce(const RecordingHeader& header, const Result<ReviewNotes>& review) {
  return review && review->tags ? *review->tags : header.tags;
}

std::vector<std::string> tagsInForce(const RecordingInfo& info) {
  return info.path.empty() ? info.header.tags : tagsInForce(info.header, readReviewNotes(info.path, info.header.id));
}

Result<void> writeReviewNotes(const std::string& recording_path, const std::string& id, ReviewNotes review) {
  std::ranges::stable_sort(review.notes, {}, &ReviewNote::time_s);
  const std::string path = reviewNotesPath(recording_path);
  const std::string recording = std::filesystem::path(path).stem().stem().string();  // without .notes.json
  nlohmann::ordered_json out{
      {"recording", wholeOf(recording)}, {kIdKey, id}, {"notes", nlohmann::ordered_json::array()}};
  if (review.tags) out["tags"] = *review.tags;
  for (const ReviewNote& note : review.notes) {
    const auto kind = std::ranges::find(kKinds, note.kind, &std::pair<NoteKind, const char*>::first);
    if (kind == kKinds.end()) return fail("{}: only notes and bookmarks are written here", recording_path);
    out["notes"].push_back(
        {{"time_s", note.time_s}, {"kind", kind->second}, {"text", note.text}, {"written_utc", note.written_utc}});
  }
  auto file = ExportFile::create(path, true);
  if (!file) return tl::unexpected(file.error());
  // Invalid UTF-8 is replaced, not refused, so that no note is lost because of one byte.
  const std::string text = out.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  if (auto written = file->write(text); !written) return written;
  return file->commit();
}

}  // namespace fyd::recording
