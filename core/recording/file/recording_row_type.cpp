#include "core/recording/file/recording_row_type.h"

#include <algorithm>
#include <optional>

namespace fyd::recording {
namespace {

hid_t scalarType(ColumnType type) {
  switch (type) {
    case ColumnType::u8: return H5T_STD_U8LE;
    case ColumnType::u16: return H5T_STD_U16LE;
    case ColumnType::u32: return H5T_STD_U32LE;
    case ColumnType::u64: return H5T_STD_U64LE;
    case ColumnType::i16: return H5T_STD_I16LE;
    case ColumnType::i32: return H5T_STD_I32LE;
    case ColumnType::i64: return H5T_STD_I64LE;
    case ColumnType::f64: return H5T_IEEE_F64LE;
  }
  return H5T_IEEE_F64LE;
}

std::optional<std::pair<ColumnType, std::size_t>> kindOf(hid_t member) {
  Handle element;
  hsize_t count = 1;
  if (H5Tget_class(member) == H5T_ARRAY) {
    if (H5Tget_array_ndims(member) != 1 || H5Tget_array_dims2(member, &count) < 0) return std::nullopt;
    element = Handle(H5Tget_super(member), H5Tclose, "a column's type");
  }
  for (std::size_t type = 0; type < kBytesOfType.size(); ++type)
    if (H5Tequal(element ? element.id() : member, scalarType(static_cast<ColumnType>(type))) > 0)
      return std::pair(static_cast<ColumnType>(type), static_cast<std::size_t>(count));
  return std::nullopt;
}

std::vector<Column> columnsIn(hid_t type, const TableLayout& today) {
  std::vector<Column> columns;
  const std::size_t row_bytes = H5Tget_size(type);
  const int members = H5Tget_nmembers(type);
  for (unsigned i = 0; i < static_cast<unsigned>(std::max(0, members)); ++i) {
    const std::unique_ptr<char, herr_t (*)(void*)> name(H5Tget_member_name(type, i), H5free_memory);
    const Handle member(H5Tget_member_type(type, i), H5Tclose, "a column's type");
    if (!name) failHard("{}: a column without a name", today.path);
    Column column{.name = name.get(), .unit = {}, .offset = H5Tget_member_offset(type, i), .help = {}};
    const auto kind = kindOf(member.id());
    if (kind) std::tie(column.type, column.count) = *kind;
    const auto known = std::ranges::find(today.columns, column.name, &Column::name);
    const std::size_t room = row_bytes - std::min(row_bytes, column.offset);
    if (known != today.columns.end() &&
        (!kind || kind->first != known->type || column.count == 0 || column.count > room || column.bytes() > room))
      failHard("{}: column {} is not of this format's type", today.path, column.name);
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace

Handle rowType(const TableLayout& layout) {
  if (layout.columns.empty()) return {H5Tcopy(H5T_STD_U8LE), H5Tclose, "a row's type"};
  Handle type(H5Tcreate(H5T_COMPOUND, layout.row_bytes), H5Tclose, "a row's type");
  for (const Column& column : layout.columns) {
    const hsize_t count = column.count;
    const Handle member(
        count == 1 ? H5Tcopy(scalarType(column.type)) : H5Tarray_create2(scalarType(column.type), 1, &count), H5Tclose,
        "a column's type");
    check(H5Tinsert(type.id(), column.name.c_str(), column.offset, member.id()), "a column");
  }
  return type;
}

TableLayout storedLayout(hid_t set, const TableLayout& today) {
  constexpr std::size_t kMostBytesMore = 1'024;  // of a row: bounds the chunks of a later program's recording
  const Handle type(H5Dget_type(set), H5Tclose, today.path);
  if (H5Tequal(type.id(), rowType(today).id()) > 0) return today;
  if (today.columns.empty() || H5Tget_class(type.id()) != H5T_COMPOUND)
    failHard("{}: its columns are not those of this format", today.path);
  TableLayout stored = today;
  stored.row_bytes = H5Tget_size(type.id());
  if (stored.row_bytes == 0 || stored.row_bytes > today.row_bytes + kMostBytesMore)
    failHard("{}: rows of {} bytes; this program's have {}", today.path, stored.row_bytes, today.row_bytes);
  if (stored.small) stored.chunk_rows = chunkRowsOf(stored.row_bytes);
  stored.columns = columnsIn(type.id(), today);
  return stored;
}

}  // namespace fyd::recording
