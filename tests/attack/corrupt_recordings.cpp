// Damage aimed at the commits, the journal and the tables of one row of recordings that were closed, left by a killed
// recorder, or by a power cut: nothing wrong is shown as right, nothing shortened is called intact, and the recovery
// keeps what can be proven and names the rest.
//   attack_corrupt_recordings COUNT SEED      at full length: attack_corrupt_recordings 300 1
#include "attack.h"
#include "core/base/checksum.h"
#include "core/recording/file/recording_disk.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/reader/recording_health.h"
#include "core/recording/recovery/recover.h"
#include "core/recording/recovery/verify.h"
#include "core/recording/writer/recording_writer.h"
#include "tests/integration/recording/remembering_disk.h"
#include "tests/reference_crc.h"

namespace {

using namespace fyd;
using namespace fyd::recording;
using namespace recording::samples;

constexpr std::uint64_t kRows = 4100;

/// A recording to damage.
struct Original {
  const char* name = "";
  std::string content;
  std::uint64_t rows = 0;  ///< promised
};

enum class Target : std::uint8_t { commits, journal, one_row };

constexpr std::array kOneRowTables{"/inputs/motor_reference", "/inputs/robot_state", "/inputs/ir", "/notes/index",
                                   "/link"};

void fill(RecordingWriter& writer, std::uint64_t rows) {
  for (std::uint64_t row = 0; row < rows; ++row) {
    if (row == 700 && (!writer.append(Note{.when = plainStep(row).inputs.now, .text = "here"}) ||
                       !writer.append(LinkRow{.when = plainStep(row).inputs.now})))
      std::abort();
    if (!writer.append(plainStep(row))) std::abort();
  }
}

Original closedOne(const std::string& file) {
  auto writer = RecordingWriter::create(file, header());
  fill(**writer, kRows);
  if (!(*writer)->close()) std::abort();
  return {"closed", contentOf(file), kRows};
}

Original killedOne(const std::string& file) {
  {
    auto writer = RecordingWriter::create(file, header());
    fill(**writer, kRows);
  }
  Original out{"killed", contentOf(partialOf(file)), kRows / kBlockSteps * kBlockSteps};
  return out;
}

/// Cut just after the journal of its last commit was synced; of what it holds any part has reached its place.
Original cutOne(const std::string& file, std::mt19937& random) {
  const auto disk = std::make_shared<LoggingDisk>();
  {
    auto writer = createRecording(file, header(), disk);
    fill(**writer, kRows);
  }
  std::size_t last_sync = disk->calls.size();
  while (!disk->calls[last_sync - 1].sync) --last_sync;
  std::vector<LoggingDisk::Call> calls;
  for (std::size_t i = 0; i < disk->calls.size(); ++i)
    if (i < last_sync || random() % 2 == 0) calls.push_back(disk->calls[i]);
  calls.push_back({.sync = true});
  calls.push_back({.sync = true});
  const auto bytes = diskAfterCut(calls, calls.size(), 512, random);
  return {"cut", {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, kRows / kBlockSteps * kBlockSteps};
}

/// How much is overwritten, and with what.
std::string damage(std::string& content, std::size_t first, std::size_t length, std::mt19937& random) {
  const std::size_t at = first + random() % length;
  switch (random() % 4) {
    case 0:
    case 1: content[at] = static_cast<char>(content[at] ^ (1 << random() % 8)); return fmt::format("a bit at {}", at);
    case 2:
      for (std::size_t i = at; i < std::min(at + 8, content.size()); ++i) content[i] = static_cast<char>(random());
      return fmt::format("8 bytes from {}", at);
    default:
      const std::size_t sector = at / 512 * 512;
      std::fill_n(content.begin() + static_cast<long>(sector), std::min<std::size_t>(512, content.size() - sector),
                  '\0');
      return fmt::format("the sector at {}", sector);
  }
}

struct Counts {
  std::size_t unreadable = 0;
  std::size_t whole = 0;
  std::size_t part_lost = 0;
  std::uint64_t lost_steps = 0;
};

/// Everything of it can be read and is what it was.
bool isComplete(attack::Report& report, const Recording& recording, std::uint64_t rows) {
  bool complete = recording.info().committed_samples == rows && recording.notes() && recording.linkRows() &&
                  recording.notes()->size() == 1 && recording.linkRows()->size() == 1;
  for (std::uint64_t row = 0; row < recording.info().committed_samples; ++row) {
    const auto step = recording.step(row);
    complete = complete && step;
    if (step && !report.expect(sameRecord(*step, plainStep(row)) && step->missing == 0,
                               fmt::format("row {} is shown as another", row)))
      break;
  }
  return complete;
}

/// Each commit row as HDF5 gives it has the checksum it says.
bool commitsAreSound(const std::string& file) {
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t set = H5Dopen2(id, "/commits", H5P_DEFAULT);
  const hid_t type = H5Dget_type(set);
  const hid_t space = H5Dget_space(set);
  std::vector<CommitRow> rows(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  bool sound = H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()) >= 0;
  for (const CommitRow& row : rows)
    sound =
        sound && row.own_crc == referenceCrc32c(std::as_bytes(std::span(&row, 1)).first(offsetof(CommitRow, own_crc)));
  H5Sclose(space);
  H5Tclose(type);
  H5Dclose(set);
  H5Fclose(id);
  return sound;
}

void expectRecovered(attack::Report& report, const std::string& file, const RecoverOutcome& outcome,
                     std::uint64_t rows) {
  report.expect(outcome.steps + outcome.lost_steps == rows,
                fmt::format("{} steps kept, {} lost, of {}", outcome.steps, outcome.lost_steps, rows));
  report.expect((outcome.result == RecoverResult::whole) == (outcome.lost_steps == 0 && outcome.missing.empty()),
                "its outcome is not what was lost");
  const auto checked = verify(file);
  report.expect(checked && checked->intact() && checked->wholeness == Wholeness::whole, "not intact afterwards");
  if (report.expect(othersOpen(file), "HDF5 does not open it afterwards"))
    report.expect(commitsAreSound(file), "a commit is still damaged afterwards");
  const auto recording = Recording::open(file);
  if (!report.expect(recording.has_value(), "cannot be opened afterwards")) return;
  const RecordingInfo& info = (*recording)->info();
  report.expect(info.header.missing == outcome.missing, "the file does not say what is missing");
  report.expect((healthOf(info).word == "good") == (outcome.result == RecoverResult::whole), "health is another");
  std::uint32_t missing = 0;
  for (std::uint64_t row = 0; row < info.committed_samples; ++row) {
    const auto step = (*recording)->step(row);
    if (!report.expect(step && attack::isPlainWhereThere(*step), fmt::format("kept row {} is another", row))) return;
    missing |= step->missing & kInputsOfStep;
  }
  report.expect(missing == 0 || !whyNoExactReplay(info).empty(), "a replay without its inputs would be called exact");
}

void attackOnce(attack::Report& report, const Original& original, Target target, const std::string& file,
                Counts& counts) {
  const std::string damaged = contentOf(file);
  const auto recording = Recording::open(file);
  const auto checked = verify(file);
  std::uint64_t rows = original.rows;
  if (!recording) {
    ++counts.unreadable;
    report.expect(!checked || !checked->intact(), "cannot be opened, and verify calls it intact");
  } else {
    const RecordingInfo& info = (*recording)->info();
    const bool complete = isComplete(report, **recording, original.rows);
    // A torn journal is what a power cut leaves of a commit that nobody was told of: the commit before is the newest.
    const bool older = target == Target::journal && info.wholeness != Wholeness::whole &&
                       info.committed_samples + kBlockSteps == original.rows;
    if (older) rows = info.samples;
    report.expect(checked.has_value(), "opens, and verify cannot");
    report.expect(complete || older || !checked->intact(), "is shortened, and verify calls it intact");
    report.expect(complete || older || info.wholeness != Wholeness::whole || checked->damaged > 0,
                  "is shortened, and called whole");
    report.expect(info.damage.empty() || (!checked->intact() && checked->wholeness == Wholeness::damaged),
                  "info and verify differ");
  }
  const auto outcome = recover(file);
  if (!report.expect(outcome.has_value(), outcome ? "" : outcome.error().text())) return;
  if (outcome->result == RecoverResult::nothing) {
    report.expect(!recording, "opens, and recover finds nothing in it");
    report.expect(contentOf(file) == damaged, "was changed although nothing can be read");
    return;
  }
  ++(outcome->result == RecoverResult::whole ? counts.whole : counts.part_lost);
  counts.lost_steps += outcome->lost_steps;
  report.expect(target != Target::one_row || outcome->lost_steps == 0, "a table of one row cost steps");
  expectRecovered(report, outcome->file, *outcome, rows);
}

}  // namespace

int main(int count, char** words) {
  const auto attacks = attack::argument(count, words, 1, 3);
  std::mt19937 random(static_cast<unsigned>(attack::argument(count, words, 2, 1)));
  attack::Report report;
  Counts counts;
  const Folder folder;
  const std::string closed = folder.file("closed.h5");
  const std::array originals{closedOne(closed), killedOne(folder.file("killed.h5")),
                             cutOne(folder.file("cut.h5"), random)};
  // The same calls in the same order: the rows stand at the same places in all three. An empty commit begins each.
  constexpr std::uint64_t kCommits = 2 + kRows / kBlockSteps;
  for (unsigned long i = 0; i < attacks; ++i) {
    const auto target = static_cast<Target>(i % 3);
    const Original& original = originals[random() % 2 == 0 ? 0 : random() % originals.size()];
    const Folder here;
    const std::string file = here.file();
    std::string content = original.content;
    std::string words_of_it;
    for (unsigned long more = 0; more <= random() % 2; ++more) {
      if (target == Target::commits) {
        const std::uint64_t commits = &original == originals.data() ? kCommits : kCommits - 1;
        const std::uint64_t number = random() % 2 == 0 ? commits - 1 - random() % 3 : random() % commits;
        words_of_it += fmt::format("commit {}: ", number) +
                       damage(content, commitAt(closed, number), sizeof(CommitRow), random) + ", ";
      } else if (target == Target::journal) {
        const std::size_t length = random() % 2 == 0 ? 64 : 40'000;
        words_of_it += "journal: " + damage(content, 0, length, random) + ", ";
      } else {
        const char* table = kOneRowTables[random() % kOneRowTables.size()];
        words_of_it += fmt::format("{}: ", table) + damage(content, chunkOf(closed, table, 0).first, 32, random) + ", ";
      }
    }
    write(file, content);
    report.begin(fmt::format("attack {}, {}: {}", i, original.name, words_of_it));
    attackOnce(report, original, target, file, counts);
  }
  std::printf("%lu corruptions: %zu unreadable, %zu recovered whole, %zu in part, %lu steps lost; %zu did not hold\n",
              attacks, counts.unreadable, counts.whole, counts.part_lost, counts.lost_steps, report.broken());
  return report.exitCode();
}
