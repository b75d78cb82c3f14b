// Power cuts while recording, and again while the recovery runs, on disks with sectors of 512 bytes and of 4 KiB.
// Nothing that was acknowledged is lost or wrong, the recovery makes the file whole, and HDF5 itself opens it.
//   attack_power_cuts COUNT SEED      at full length: attack_power_cuts 300 1 (cuts of each kind of disk)
#include "attack.h"
#include "core/recording/file/recording_disk.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/recovery/recording_repair.h"
#include "core/recording/recovery/recover.h"
#include "core/recording/recovery/verify.h"
#include "core/recording/writer/recording_writer.h"
#include "tests/integration/recording/remembering_disk.h"

namespace {

using namespace fyd;
using namespace fyd::recording;
using namespace recording::samples;
using Bytes = std::vector<std::byte>;

constexpr std::uint64_t kRows = 2600;

struct Acknowledged {
  std::size_t calls;
  std::uint64_t rows;
};

/// What a recorder asked of its disk, and when it said that so many steps are safe.
struct Session {
  std::shared_ptr<LoggingDisk> disk = std::make_shared<LoggingDisk>();
  std::vector<Acknowledged> acknowledged;

  explicit Session(const std::string& file) {
    auto writer = createRecording(file, header(), disk);
    if (!writer) std::abort();
    acknowledged.push_back({disk->calls.size(), 0});
    for (std::uint64_t row = 0; row < kRows; ++row) {
      if (!(*writer)->append(plainStep(row))) std::abort();
      if (row % 700 == 99 && !(*writer)->commit()) std::abort();
      acknowledged.push_back({disk->calls.size(), (*writer)->committedSteps()});
    }
    if (!(*writer)->close()) std::abort();
    acknowledged.push_back({disk->calls.size(), kRows});
  }
};

/// A moment of those from `first` on; every second time just before a sync, when most is at stake.
std::size_t momentOf(const std::vector<LoggingDisk::Call>& calls, std::size_t first, std::mt19937& random) {
  std::size_t end = first + random() % (calls.size() - first + 1);
  if (random() % 2 == 0)
    while (end < calls.size() && !calls[end].sync) ++end;
  return end;
}

void put(const std::string& file, const Bytes& bytes) {
  write(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void expectRows(attack::Report& report, const std::string& file, std::uint64_t at_least, Wholeness* wholeness) {
  const auto recording = Recording::open(file);
  if (!report.expect(recording.has_value(), recording ? "" : recording.error().text())) return;
  const std::uint64_t rows = (*recording)->info().committed_samples;
  report.expect(rows >= at_least, fmt::format("{} rows of {} acknowledged", rows, at_least));
  for (std::uint64_t row = 0; row < rows; ++row) {
    const auto step = (*recording)->step(row);
    if (!report.expect(step && sameRecord(*step, plainStep(row)), fmt::format("row {} is another", row))) return;
  }
  if (wholeness != nullptr) *wholeness = (*recording)->info().wholeness;
}

}  // namespace

int main(int count, char** words) {
  const auto cuts = attack::argument(count, words, 1, 3);
  std::mt19937 random(static_cast<unsigned>(attack::argument(count, words, 2, 1)));
  attack::Report report;
  const Folder folder;
  const Session session(folder.file("recorded.h5"));
  const auto& calls = session.disk->calls;
  const std::string file = folder.file();
  for (const std::size_t sector_bytes : {512U, 4096U}) {
    for (unsigned long i = 0; i < cuts; ++i) {
      const std::size_t end = momentOf(calls, session.acknowledged.front().calls, random);
      report.begin(fmt::format("cut {} at call {} of {}, sectors of {}", i, end, calls.size(), sector_bytes));
      std::uint64_t rows = 0;
      for (const Acknowledged& a : session.acknowledged)
        if (a.calls <= end) rows = std::max(rows, a.rows);
      const Bytes left = diskAfterCut(calls, end, sector_bytes, random);
      put(partialOf(file), left);
      expectRows(report, partialOf(file), rows, nullptr);
      // The recovery's own power goes too.
      const auto mending = std::make_shared<LoggingDisk>();
      report.expect(finishRecording(partialOf(file), mending).has_value(), "could not be finished");
      const std::size_t second = momentOf(mending->calls, 0, random);
      put(partialOf(file), diskAfterCut(mending->calls, second, sector_bytes, random, left));
      const auto outcome = recover(file);
      report.expect(outcome && outcome->result == RecoverResult::whole,
                    outcome ? outcome->first_damage.text() : outcome.error().text());
      Wholeness wholeness = Wholeness::crashed;
      expectRows(report, file, rows, &wholeness);
      report.expect(wholeness == Wholeness::whole, "not whole after its recovery");
      report.expect(othersOpen(file), fmt::format("HDF5 does not open it; the recovery was cut at call {}", second));
      std::filesystem::remove(file);
      std::filesystem::remove(partialOf(file));
    }
  }
  std::printf("%lu power cuts each of sectors of 512 and 4096 bytes, a second one in each recovery: %zu did not hold\n",
              cuts, report.broken());
  return report.exitCode();
}
