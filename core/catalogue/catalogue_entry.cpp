#include "core/catalogue/catalogue_entry.h"

#include <sys/stat.h>

#include <filesystem>

#include "core/base/system_reason.h"
#include "core/catalogue/catalogue_address.h"
#include "core/catalogue/catalogue_text.h"
#include "core/recording/reader/recording.h"
#include "core/recording/reader/recording_health.h"
#include "core/recording/reader/review_notes.h"

namespace fyd::catalogue {

std::string withNote(const std::string& notes, const recording::ReviewNote& note) {
  if (note.kind != recording::NoteKind::note) return notes;  // a bookmark says nothing
  const std::string line = cleanedText(note.text, false);
  return notes.empty() ? line : notes + '\n' + line;
}

Result<CatalogueEntry> readCatalogueEntry(const std::string& path) {
  const auto recording = recording::Recording::open(path);
  if (!recording) return tl::unexpected(recording.error());
  const recording::RecordingInfo& info = (*recording)->info();
  const recording::RecordingHeader& header = info.header;
  std::error_code error;
  std::filesystem::path absolute = std::filesystem::weakly_canonical(path, error);
  if (error) return fail(about(path, systemReason(error)));
  if (!std::filesystem::exists(absolute, error)) absolute += ".partial";  // which Recording::open finds too
  struct stat status {};
  if (stat(absolute.c_str(), &status) != 0) return fail("{}: gone while it was read", path);

  CatalogueEntry entry{.id = header.id,
                       .path = absolute,
                       .station = stationName(),
                       .started_utc = header.started_utc,
                       .duration_s = info.duration_s,
                       .operator_name = header.operator_name,
                       .subject = header.subject,
                       .notes = header.notes,
                       .touchpad = header.touchpad,
                       .robot = header.robot,
                       .samples = info.committed_samples,
                       .gaps = info.gaps,
                       .events = info.events,
                       .wholeness = info.wholeness,
                       .health = healthOf(info).word,
                       .bytes = static_cast<std::uint64_t>(status.st_size),
                       .file_modified_ns = status.st_mtim.tv_sec * 1'000'000'000LL + status.st_mtim.tv_nsec};
  const auto review = recording::readReviewNotes(path, header.id);
  if (review) {
    for (const recording::ReviewNote& note : review->notes) entry.notes = withNote(entry.notes, note);
  }
  entry.tags = recording::tagsInForce(header, review);
  entry = withFittingTexts(std::move(entry));
  if (auto ok = checkEntry(entry); !ok) return fail(about(path, ok.error().message));
  return entry;
}

}  // namespace fyd::catalogue
