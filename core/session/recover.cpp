#include "core/session/recover.h"

#include <sys/stat.h>
#include <unistd.h>

#include "core/session/recording_place.h"
#include "core/session/recording_repair.h"
#include "core/session/recording_salvage.h"
#include "core/session/recording_source.h"
#include "core/session/recording_writer.h"
#include "core/session/verify.h"

namespace fyd::session {
namespace {

bool exists(const std::string& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0;
}

/// The name the whole recording gets.
std::string targetOf(const std::string& found) {
  const std::string ending = kPartialEnding;
  return found.ends_with(ending) ? found.substr(0, found.size() - ending.size()) : found;
}

Result<std::string> freeName(const std::string& wanted) {
  if (!exists(wanted) && !exists(partialOf(wanted))) return wanted;
  for (int i = 2; i < 1000; ++i)
    if (const std::string name = fmt::format("{}-{}", wanted, i); !exists(name) && !exists(partialOf(name)))
      return name;
  return fail("{}: too many of this name; move them away", wanted);
}

Result<void> giveName(const std::string& found, const std::string& target) {
  if (found == target) return {};
  if (auto named = renameNew(found, target); !named) return named;
  return syncFolder(target);
}

/// Shares of the time. Copying takes twenty times as long as checking; but most often there is nothing to copy.
constexpr double kChecked = 0.3;
constexpr double kStepsCopied = 0.75;

/// A file made here goes again unless it was finished.
struct Unfinished {
  std::string file;
  Unfinished() = default;
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished() {
    if (!file.empty()) ::unlink(file.c_str());
  }
};

/// What of the recording's other lists can be read goes along; they are too few to be counted one by one.
Result<void> copyLists(const Recording& from, RecordingWriter& to, const Progress& progress) {
  if (const auto notes = from.notes(); notes)
    for (const Note& note : *notes) (void)to.append(note);  // a refusing disk refuses the next step too
  if (const auto links = from.linkRows(); links)
    for (const LinkRow& link : *links) (void)to.append(link);
  const std::uint64_t pictures = from.info().frames;
  for (std::uint64_t i = 0; i < pictures; ++i) {
    if (auto told = tellProgress(progress, static_cast<double>(i) / static_cast<double>(pictures)); !told) return told;
    const auto picture = encodedPicture(from, i);
    if (!picture) continue;
    (void)to.append(*picture);
    if (i % 100 == 99) (void)to.commit();
  }
  return {};
}

Result<void> copySteps(const Recording& from, RecordingWriter& to, const Progress& progress, RecoverOutcome& outcome) {
  const std::uint64_t rows = from.info().committed_samples;
  for (std::uint64_t row = 0; row < rows; ++row) {
    const double done = static_cast<double>(row) / static_cast<double>(rows);
    if (auto told = row % kBlockSteps == 0 ? tellProgress(progress, done) : Result<void>(); !told) return told;
    const auto record = from.step(row);
    if (!record) {
      ++outcome.lost_steps;
      if (outcome.first_damage.empty()) outcome.first_damage = record.error().message;
      continue;
    }
    if (auto put = to.append(*record); !put) return put;
    ++outcome.steps;
  }
  return {};
}

Result<RecoverOutcome> copyWhatIsLeft(const Recording& from, const std::string& found, const std::string& target,
                                      const Progress& progress) {
  RecoverOutcome outcome;
  Unfinished unfinished;
  const auto copy = freeName(target + ".recovered");
  if (!copy) return tl::unexpected(copy.error());
  auto writer = RecordingWriter::create(*copy, from.info().header);
  if (!writer) return tl::unexpected(writer.error());
  unfinished.file = partialOf(*copy);
  auto done = copySteps(from, **writer, partOf(progress, kChecked, kStepsCopied), outcome);
  if (done) done = copyLists(from, **writer, partOf(progress, kStepsCopied, 1.0));
  if (done) done = tellProgress(progress, 1.0);
  if (done) done = (*writer)->close();
  if (!done) return tl::unexpected(done.error());
  unfinished.file = *copy;
  const auto kept = freeName(target + ".damaged");
  if (!kept) return tl::unexpected(kept.error());
  if (auto named = giveName(found, *kept); !named) return tl::unexpected(named.error());
  unfinished.file.clear();  // from here on it is all there is under this name
  if (auto named = giveName(*copy, target); !named) return tl::unexpected(named.error());
  outcome.result = RecoverResult::part_lost;
  outcome.file = target;
  outcome.kept = *kept;
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
  if (!exists(found)) return fail("{}: there is no such file", path);
  const std::string target = targetOf(found);
  if (target != found && exists(target)) return fail("{}: exists; move one of the two away first", target);
  const auto recorded = guarded(found, [&] { return isBeingRecorded(found); });
  if (!recorded) return tl::unexpected(recorded.error());
  if (*recorded) return fail("{}: is being recorded at this moment", found);
  RecoverOutcome outcome;
  {
    const auto recording = openDamaged(found);
    if (!recording) return nothing(recording.error());
    const RecordingInfo& info = (*recording)->info();
    outcome.steps = info.committed_samples;
    bool ended = false;
    const auto checked = verify(found, [&](double done) {
      ended = !tellProgress(progress, kChecked * done);
      return !ended;
    });
    if (ended) return tl::unexpected(checked.error());  // not damaged: nobody knows
    const bool sound = checked && checked->intact();
    if (sound && info.wholeness == Wholeness::whole) {
      if (auto named = giveName(found, target); !named) return tl::unexpected(named.error());
      outcome.result = RecoverResult::whole;
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
  outcome.result = RecoverResult::whole;
  outcome.file = target;
  return outcome;
}

}  // namespace fyd::session
