#include "core/recording/recovery/recover.h"

#include <sys/stat.h>
#include <unistd.h>

#include "core/recording/file/recording_place.h"
#include "core/recording/reader/recording_source.h"
#include "core/recording/reader/recording_wholeness.h"
#include "core/recording/recovery/recording_copy.h"
#include "core/recording/recovery/recording_repair.h"
#include "core/recording/recovery/verify.h"

namespace fyd::recording {
namespace {

constexpr const char* kCopyEnding = ".recovered";
constexpr const char* kKeptEnding = ".damaged";

bool isThere(const std::string& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0;
}

/// The name the whole recording gets.
std::string targetOf(const std::string& found) {
  const std::string ending = kPartialEnding;
  return found.ends_with(ending) ? found.substr(0, found.size() - ending.size()) : found;
}

Result<std::string> freeName(const std::string& wanted) {
  if (!isThere(wanted) && !isThere(partialOf(wanted))) return wanted;
  for (int i = 2; i < 1000; ++i)
    if (const std::string name = fmt::format("{}-{}", wanted, i); !isThere(name) && !isThere(partialOf(name)))
      return name;
  return fail("{}: too many of this name; move them away", wanted);
}

Result<void> giveName(const std::string& found, const std::string& target) {
  if (found == target) return {};
  if (auto named = renameNew(found, target); !named) return named;
  return syncFolder(target);
}

/// Shares of the time. Copying takes twenty times as long as checking; but most often there is nothing to copy.
constexpr double kChecked = 0.25;
constexpr double kLooked = 0.35;

/// Deletes a file made here unless it was finished.
struct Unfinished {
  std::string file;
  Unfinished() = default;
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished() {
    if (!file.empty()) ::unlink(file.c_str());
  }
};

/// Removes the unfinished copy of an earlier recovery of the same recording that was killed.
void dropLeftCopy(const std::string& copy, const std::string& id) {
  const std::string left = partialOf(copy);
  const auto recorded = guarded(left, [&] { return isThere(left) && isBeingRecorded(left); });
  if (!recorded || *recorded) return;
  const auto recording = DamagedRecording::open(left);
  const bool ours = recording && !id.empty() && (*recording)->info().header.id == id;
  if (ours) ::unlink(left.c_str());
}

/// Copies twice: first without a file, for the header that says what is missing is written before the rows.
Result<CopyOutcome> copyTo(const std::string& copy, const std::string& found, const DamagedRecording& from,
                           Unfinished& unfinished, const Progress& progress) {
  auto looked = copyReadable(found, from, nullptr, partOf(progress, kChecked, kLooked));
  if (!looked) return looked;
  RecordingHeader header = from.info().header;
  header.missing = looked->missing;
  header.lacking = from.info().missing_columns;  // the copy has today's columns, with nothing in them
  if (looked->first_lost) header.step_state.clear();
  auto writer = RecordingWriter::create(copy, header);
  if (!writer) return tl::unexpected(writer.error());
  unfinished.file = partialOf(copy);
  (*writer)->countLost(from.info().gaps + looked->lost_steps);  // in each of its commits: another recovery needs one
  auto copied = copyReadable(found, from, writer->get(), partOf(progress, kLooked, 1.0));
  if (!copied) return copied;
  if (*copied != *looked) return fail("{}: reads differently each time; copy it to another disk first", found);
  if (auto told = tellProgress(progress, 1.0); !told) return tl::unexpected(told.error());
  if (auto closed = (*writer)->close(); !closed) return tl::unexpected(closed.error());
  unfinished.file = copy;
  return copied;
}

Result<RecoverOutcome> copyWhatIsLeft(const DamagedRecording& from, const std::string& found, const std::string& target,
                                      const Progress& progress) {
  if (const auto& unknown = from.info().unknown_columns; !unknown.empty()) {
    return fail("{}: a later program recorded {}, which a copy by this one would lose; recover it with that program",
                found, fmt::join(unknown, ", "));
  }
  Unfinished unfinished;
  dropLeftCopy(target + kCopyEnding, from.info().header.id);
  const auto copy = freeName(target + kCopyEnding);
  if (!copy) return tl::unexpected(copy.error());
  auto copied = copyTo(*copy, found, from, unfinished, progress);
  if (!copied) return tl::unexpected(copied.error());
  const auto kept = freeName(target + kKeptEnding);
  if (!kept) return tl::unexpected(kept.error());
  if (auto named = renameNew(found, *kept); !named) return tl::unexpected(named.error());
  unfinished.file.clear();  // from here on it is the only file under this name
  if (auto synced = syncFolder(*kept); !synced) return tl::unexpected(synced.error());
  if (auto named = giveName(*copy, target); !named) return tl::unexpected(named.error());
  const bool all = copied->lost_steps == 0 && copied->missing.empty();
  return RecoverOutcome{.result = all ? RecoverResult::whole : RecoverResult::part_lost,
                        .file = target,
                        .kept = *kept,
                        .steps = copied->steps,
                        .lost_steps = copied->lost_steps,
                        .missing = std::move(copied->missing),
                        .first_damage = {}};
}

/// What an earlier recovery found lost, where this is the copy it made. Steps that the recorder lost are no damage.
void tellOfACopy(const RecordingInfo& info, const std::string& target, RecoverOutcome& outcome) {
  outcome.steps = info.committed_samples;
  outcome.missing = info.header.missing;
  outcome.lost_steps = goneSteps(info.header);
  outcome.result = outcome.missing.empty() ? RecoverResult::whole : RecoverResult::part_lost;
  if (const std::string kept = target + kKeptEnding; !outcome.missing.empty() && isThere(kept)) outcome.kept = kept;
}

/// An earlier recovery was killed between its two renamings: the copy is whole, but not yet under its name.
Result<RecoverOutcome> nameLeftCopy(const std::string& target) {
  const std::string copy = target + kCopyEnding;
  if (!isThere(copy) || !isThere(target + kKeptEnding)) return fail("{}: there is no such file", target);
  RecoverOutcome outcome;
  outcome.file = target;
  {
    const auto recording = Recording::open(copy);
    if (!recording) return tl::unexpected(recording.error());
    const RecordingInfo& info = (*recording)->info();
    if (info.wholeness != Wholeness::whole) return fail("{}: there is no such file", target);
    tellOfACopy(info, target, outcome);
    outcome.kept = target + kKeptEnding;  // there it is, whatever the copy lacks
  }
  if (auto named = giveName(copy, target); !named) return tl::unexpected(named.error());
  return outcome;
}

RecoverOutcome nothing(const Error& why) {
  RecoverOutcome outcome;
  outcome.first_damage = why.message;
  return outcome;
}

}  // namespace

Result<RecoverOutcome> recover(const std::string& path, const Progress& progress) {
  const std::string found = existingName(path);
  const std::string target = targetOf(found);
  if (!isThere(found)) return nameLeftCopy(target);
  if (target != found && isThere(target)) return fail("{}: exists; move one of the two away first", target);
  const auto recorded = guarded(found, [&] { return isBeingRecorded(found); });
  if (!recorded) return tl::unexpected(recorded.error());
  if (*recorded) return fail("{}: is being recorded at this moment", found);
  RecoverOutcome outcome;
  {
    const auto recording = DamagedRecording::open(found);
    if (!recording) return nothing(recording.error());
    const RecordingInfo& info = (*recording)->info();
    tellOfACopy(info, target, outcome);
    bool ended = false;
    const auto checked = verify(found, [&](double done) {
      ended = !tellProgress(progress, kChecked * done);
      return !ended;
    });
    if (ended) return tl::unexpected(checked.error());  // ended before anything is known of the damage
    const bool sound = checked && checked->intact();
    if (sound && info.wholeness == Wholeness::whole) {
      if (auto named = giveName(found, target); !named) return tl::unexpected(named.error());
      outcome.file = target;
      return outcome;
    }
    if (!sound) {
      auto copied = copyWhatIsLeft(**recording, found, target, progress);
      if (copied) copied->first_damage = checked ? checked->first_damage : checked.error().message;
      return copied;
    }
  }
  if (auto told = tellProgress(progress, 1.0); !told) return tl::unexpected(told.error());
  if (auto finished = finishRecording(found); !finished) return tl::unexpected(finished.error());
  if (auto named = giveName(found, target); !named) return tl::unexpected(named.error());
  outcome.file = target;
  return outcome;
}

}  // namespace fyd::recording
