#include "core/session/verify.h"

#include "core/session/recording_header.h"
#include "core/session/recording_source.h"
#include "core/session/recording_tables.h"

namespace fyd::session {
namespace {

struct Opened {
  RecordingSource source;
  RecordingTables tables;
  explicit Opened(const std::string& path) : source(path), tables(headed(source.file())) {}
  static hid_t headed(hid_t file) {
    (void)readHeader(file);  // throws when it is damaged
    return file;
  }
};

/// Checks the block with `row`. @return the first row after it
std::uint64_t checkBlock(const RecordingTables& tables, Table table, std::uint64_t row, Verification& into) {
  ++into.blocks;
  try {
    const auto block = tables.block(table, row);
    into.bytes += block->bytes.size();
    return block->first + block->count;
  } catch (const RecordingFailure& failure) {
    ++into.damaged;
    if (into.first_damage.empty()) into.first_damage = failure.what();
    return tables.rowAfterDamage(table, row);
  }
}

}  // namespace

Result<Verification> verify(const std::string& path) {
  const std::string found = existingName(path);
  auto opened = guarded(found, [&] { return std::make_unique<Opened>(found); });
  if (!opened) return tl::unexpected(opened.error());
  const RecordingTables& tables = (*opened)->tables;
  Verification result;
  result.commits = tables.commits();
  result.wholeness = tables.last().closed != 0           ? Wholeness::whole
                     : (*opened)->source.recorderLives() ? Wholeness::growing
                                                         : Wholeness::crashed;
  for (std::size_t i = 0; i < kTableCount; ++i) {
    const auto table = static_cast<Table>(i);
    // Block by block, so that a recorder of this process gets its turn at HDF5.
    for (std::uint64_t row = 0; row < tables.rows(table);) {
      const auto next = guarded(found, [&] { return checkBlock(tables, table, row, result); });
      if (!next) return tl::unexpected(next.error());
      row = *next;
    }
  }
  const auto lock = hdf5Lock();
  opened->reset();
  return result;
}

}  // namespace fyd::session
