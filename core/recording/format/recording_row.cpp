#include "core/recording/format/recording_row.h"

namespace fyd::recording {
namespace {

template <class Number>
double numberAt(const std::byte* at) {
  Number number{};
  std::memcpy(&number, at, sizeof number);
  return static_cast<double>(number);
}

}  // namespace

double numberIn(const std::byte* row, const Column& column) {
  const std::byte* at = row + column.offset;
  switch (column.type) {
    case ColumnType::u8: return numberAt<std::uint8_t>(at);
    case ColumnType::u16: return numberAt<std::uint16_t>(at);
    case ColumnType::u32: return numberAt<std::uint32_t>(at);
    case ColumnType::u64: return numberAt<std::uint64_t>(at);
    case ColumnType::i16: return numberAt<std::int16_t>(at);
    case ColumnType::i32: return numberAt<std::int32_t>(at);
    case ColumnType::i64: return numberAt<std::int64_t>(at);
    case ColumnType::f64: return numberAt<double>(at);
  }
  return 0.0;
}

}  // namespace fyd::recording
