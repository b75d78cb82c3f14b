#include "core/recording/recovery/verify.h"

#include "core/recording/file/recording_header.h"
#include "core/recording/reader/recording_health.h"
#include "core/recording/reader/recording_source.h"
#include "core/recording/reader/recording_tables.h"
#include "core/recording/reader/recording_wholeness.h"

namespace fyd::recording {
namespace {

struct Opened {
  RecordingSource source;
  RecordingHeader header;  // read first: it throws when the file is no recording
  RecordingTables tables;
  explicit Opened(const std::string& path)
      : source(path), header(readHeader(source.file())), tables(source.file(), source.growing()) {}
};

/// Closes the file under the HDF5 lock, also when reading it failed.
struct CloseUnderLock {
  void operator()(const Opened* opened) const {
    const auto lock = hdf5Lock();
    delete opened;
  }
};

double bytesOf(const RecordingTables& tables) {
  double bytes = 0.0;
  for (std::size_t i = 0; i < kTableCount; ++i) {
    const auto table = static_cast<Table>(i);
    bytes += static_cast<double>(layoutOf(table).row_bytes) * static_cast<double>(tables.rows(table));
  }
  return bytes;
}

/// Checks the block with `row`. @return the first row after it
std::uint64_t checkBlock(const RecordingTables& tables, Table table, std::uint64_t row, Verification& into) {
  ++into.blocks;
  try {
    const auto block = tables.block(table, row);
    into.bytes += block->bytes.size();
    return block->first + block->count;
  } catch (const RecordingFailure& failure) {
    ++into.damaged;
    if (into.first_damage.empty()) into.first_damage = failure.message;
    return tables.rowAfterDamage(table, row);
  }
}

}  // namespace

Result<Verification> verify(const std::string& path, const Progress& progress) {
  const std::string found = existingName(path);
  auto opened = openedAsItIs(
      path, [](const std::string& name) { return std::unique_ptr<Opened, CloseUnderLock>(new Opened(name)); });
  if (!opened) return tl::unexpected(opened.error());
  const RecordingTables& tables = (*opened)->tables;
  Verification result;
  RecordingInfo judged{.header = (*opened)->header};
  judge((*opened)->source, tables, judged);
  result.wholeness = judged.wholeness;
  result.commits = tables.commits();
  result.damaged_commits = tables.damagedCommits().size();
  result.unproven_rows = judged.unproven_rows;
  result.missing_bytes = (*opened)->source.missingBytes();
  result.first_damage = judged.damage;
  const double all = bytesOf(tables);
  double before = 0.0;  // of the tables done
  for (std::size_t i = 0; i < kTableCount; ++i) {
    const auto table = static_cast<Table>(i);
    const auto row_bytes = static_cast<double>(layoutOf(table).row_bytes);
    // Block by block, so that a recorder of this process gets the HDF5 lock in between.
    for (std::uint64_t row = 0; row < tables.rows(table);) {
      if (auto told = tellProgress(progress, (before + row_bytes * static_cast<double>(row)) / all); !told)
        return tl::unexpected(told.error());
      const auto next = guarded(found, [&] { return checkBlock(tables, table, row, result); });
      if (!next) return tl::unexpected(next.error());
      row = *next;
    }
    before += row_bytes * static_cast<double>(tables.rows(table));
  }
  // When its recorder was killed meanwhile, a partial write may look like damage: it is complete in the journal.
  if (result.damaged > 0 && (*opened)->source.recorderEnded()) return verify(path, progress);
  if (!result.intact() && result.wholeness != Wholeness::growing) {
    judged.wholeness = result.wholeness = Wholeness::damaged;
    judged.damage = result.first_damage;
  }
  result.health = healthOf(judged);
  return result;
}

}  // namespace fyd::recording
