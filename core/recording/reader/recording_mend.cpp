#include "core/recording/reader/recording_mend.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "core/base/checksum.h"
#include "core/recording/file/recording_layout.h"

namespace fyd::recording {
namespace {

using RowCounts = std::array<std::uint64_t, kTableCount>;

bool within(const RowCounts& least, const RowCounts& rows, const RowCounts& most) {
  for (std::size_t i = 0; i < kTableCount; ++i)
    if (rows[i] < least[i] || rows[i] > most[i]) return false;
  return true;
}

std::optional<CommitRow> withOneBitTurnedBack(CommitRow row, std::uint64_t number) {
  const auto bytes = std::as_writable_bytes(std::span(&row, 1));
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    const auto mask = std::byte{1} << (bit % 8);
    bytes[bit / 8] ^= mask;
    if (intact(row, number)) return row;
    bytes[bit / 8] ^= mask;
  }
  return std::nullopt;
}

std::int64_t latestOf(std::span<const std::byte> telemetry, std::int64_t before_ns) {
  constexpr std::size_t kBytes = kShape<pipeline::TelemetrySample>.bytes;
  for (std::size_t at = 0; at + kBytes <= telemetry.size(); at += kBytes) {
    pipeline::TelemetrySample sample;
    (void)fromRow(telemetry.data() + at, sample);  // it has no list
    before_ns = std::max(before_ns, nanoseconds(sample.now));
  }
  return before_ns;
}

}  // namespace

bool intact(const CommitRow& row, std::uint64_t number) {
  return row.number == number && countsArePlausible(row) &&
         row.own_crc == crc32c(std::as_bytes(std::span(&row, 1)).first(offsetof(CommitRow, own_crc)));
}

bool CommitMender::proven(Table table, std::uint64_t first, std::uint64_t end, std::uint32_t crc,
                          std::vector<std::byte>& rows) {
  rows.clear();
  if (end == first) return crc == 0;
  const Hdf5Table& in = tables_(table);
  if (!in.isOpen()) return false;
  const std::size_t row_bytes = in.rowBytes();
  if (end - first > bytes_left_ / row_bytes) return false;
  rows.resize((end - first) * row_bytes);
  bytes_left_ -= rows.size();
  try {
    in.read(first, end - first, rows);
  } catch (const RecordingFailure&) {
    return false;
  }
  return crc32c(rows) == crc;
}

CommitRow CommitMender::mended(const CommitRow& found, std::uint64_t number, const CommitRow& before,
                               const RowCounts& most) {
  if (rows_left_ > 0) {
    --rows_left_;
    if (const auto whole = withOneBitTurnedBack(found, number); whole && within(before.rows, whole->rows, most))
      return *whole;
  }
  CommitRow row = before;
  row.number = number;
  row.closed = 0;
  row.crc = {};
  std::vector<std::byte> rows;
  for (std::size_t i = 0; i < kTableCount; ++i) {
    const auto table = static_cast<Table>(i);
    if (found.rows[i] < before.rows[i] || found.rows[i] > std::min(most[i], mostRows(table, number))) continue;
    const bool known = proven(table, before.rows[i], found.rows[i], found.crc[i], rows);
    if (known && table == Table::telemetry)
      row.latest_ns = latestOf(tables_(table).conversion().toToday(rows), before.latest_ns);
    row.rows[i] = found.rows[i];
    row.crc[i] = found.rows[i] == before.rows[i] ? 0 : found.crc[i];
  }
  row.own_crc = crc32c(std::as_bytes(std::span(&row, 1)).first(offsetof(CommitRow, own_crc)));
  return row;
}

}  // namespace fyd::recording
