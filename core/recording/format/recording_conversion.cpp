#include "core/recording/format/recording_conversion.h"

namespace fyd::recording {

RowConversion::RowConversion(const TableLayout& stored, const TableLayout& today)
    : stored_bytes_(stored.row_bytes), fresh_(today.fresh), needed_(stored.row_bytes != today.row_bytes) {
  const auto in = [](const TableLayout& layout, const std::string& name) {
    return std::ranges::find(layout.columns, name, &Column::name);
  };
  for (const Column& column : today.columns) {
    const auto found = in(stored, column.name);
    if (found == stored.columns.end()) {
      lacking_.push_back(column.name);
      continue;
    }
    pieces_.push_back({found->offset, column.offset, std::min(found->bytes(), column.bytes())});
    needed_ = needed_ || found->offset != column.offset || found->count != column.count;
  }
  for (const Column& column : stored.columns)
    if (in(today, column.name) == today.columns.end()) unknown_.push_back(column.name);
  needed_ = needed_ || !lacking_.empty() || !unknown_.empty();
}

std::vector<std::byte> RowConversion::toToday(std::vector<std::byte> stored_rows) const {
  if (!needed_) return stored_rows;
  const std::size_t count = stored_rows.size() / stored_bytes_;
  std::vector<std::byte> rows;
  rows.reserve(count * fresh_.size());
  for (std::size_t i = 0; i < count; ++i) {
    rows.insert(rows.end(), fresh_.begin(), fresh_.end());
    std::byte* row = rows.data() + i * fresh_.size();
    for (const Piece& piece : pieces_)
      std::memcpy(row + piece.today, stored_rows.data() + i * stored_bytes_ + piece.stored, piece.bytes);
  }
  return rows;
}

void RowConversion::putBack(std::span<const std::byte> today_row, std::span<std::byte> stored_row) const {
  for (const Piece& piece : pieces_)
    std::memcpy(stored_row.data() + piece.stored, today_row.data() + piece.today, piece.bytes);
}

}  // namespace fyd::recording
