#include "core/session/recording_hdf5.h"

#include <algorithm>
#include <cstring>

#include "core/session/recording_chunks.h"
#include "core/session/recording_layout.h"

namespace fyd::session {
namespace {

std::string reason() {
  std::string text;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned, const H5E_error2_t* error, void* into) {
        auto& words = *static_cast<std::string*>(into);
        if (words.empty() && error->desc != nullptr) words = error->desc;
        return herr_t{0};
      },
      &text);
  H5Eclear2(H5E_DEFAULT);
  return text;
}

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

/// The type and number of a column's values; nothing: of a kind this program has none of.
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

Handle textType(std::size_t bytes) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "a text's type");
  check(H5Tset_size(type.id(), bytes), "a text's length");
  check(H5Tset_cset(type.id(), H5T_CSET_UTF8), "a text's alphabet");
  check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "a text's padding");
  return type;
}

void writeUnits(hid_t set, const TableLayout& layout) {
  std::size_t longest = 1;
  for (const Column& column : layout.columns) longest = std::max(longest, column.unit.size());
  std::string units;
  for (const Column& column : layout.columns) {
    units += column.unit;
    units.append(longest - column.unit.size(), '\0');
  }
  const Handle type = textType(longest);
  const hsize_t count = layout.columns.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, "the units' space");
  const Handle attribute(H5Acreate2(set, "units", type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, "units");
  check(H5Awrite(attribute.id(), type.id(), units.data()), "units");
}

}  // namespace

std::unique_lock<std::recursive_mutex> hdf5Lock() {
  static std::recursive_mutex mutex;
  std::unique_lock lock(mutex);
  thread_local const bool kQuiet = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;  // its reasons go into our errors
  (void)kQuiet;
  return lock;
}

Handle::Handle(hid_t id, Closer closer, const char* what) : id_(id), closer_(closer) {
  if (id < 0) failHard(about(what, verbatim(reason())));
}

Handle& Handle::operator=(Handle&& other) noexcept {
  reset();
  id_ = std::exchange(other.id_, -1);
  closer_ = other.closer_;
  return *this;
}

void Handle::reset() {
  if (id_ >= 0) closer_(id_);
  id_ = -1;
}

void check(herr_t status, const char* what) {
  if (status < 0) failHard(about(what, verbatim(reason())));
}

Hdf5Table Hdf5Table::create(hid_t file, const TableLayout& layout) {
  Hdf5Table table;
  table.layout_ = &layout;
  table.type_ = rowType(layout);
  const Handle set_properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, layout.path);
  const hsize_t chunk = layout.chunk_rows;
  check(H5Pset_chunk(set_properties.id(), 1, &chunk), layout.path);
  check(H5Pset_obj_track_times(set_properties.id(), false), layout.path);
  if (layout.compressed) {
    check(H5Pset_shuffle(set_properties.id()), layout.path);
    check(H5Pset_deflate(set_properties.id(), 1), layout.path);
  }
  const Handle link_properties(H5Pcreate(H5P_LINK_CREATE), H5Pclose, layout.path);
  check(H5Pset_create_intermediate_group(link_properties.id(), 1), layout.path);
  const hsize_t none = 0;
  const hsize_t unlimited = H5S_UNLIMITED;
  const Handle space(H5Screate_simple(1, &none, &unlimited), H5Sclose, layout.path);
  table.set_ = Handle(H5Dcreate2(file, layout.path, table.type_.id(), space.id(), link_properties.id(),
                                 set_properties.id(), H5P_DEFAULT),
                      H5Dclose, layout.path);
  if (!layout.columns.empty()) writeUnits(table.set_.id(), layout);
  table.made_here_ = true;
  return table;
}

Hdf5Table Hdf5Table::open(hid_t file, const TableLayout& layout) {
  Hdf5Table table;
  OpenedTable opened = openTable(file, layout);
  table.set_ = std::move(opened.set);
  table.own_ = std::make_unique<TableLayout>(std::move(opened.stored));
  table.layout_ = table.own_.get();
  table.conversion_ = RowConversion(*table.layout_, layout);
  table.type_ = Handle(H5Dget_type(table.set_.id()), H5Tclose, layout.path);
  table.readExtent();
  return table;
}

TableLayout storedLayout(hid_t set, const TableLayout& today) {
  constexpr std::size_t kMostBytesMore = 1'024;  // of a row: a chunk of a later program's stays small too
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

const Column* Hdf5Table::column(std::string_view name) const {
  const auto found = std::ranges::find(layout_->columns, name, &Column::name);
  return found == layout_->columns.end() ? nullptr : &*found;
}

void Hdf5Table::readExtent() {
  const Handle space(H5Dget_space(set_.id()), H5Sclose, layout_->path);
  hsize_t size = 0;
  if (H5Sget_simple_extent_ndims(space.id()) != 1) failHard("{}: not a list of rows", layout_->path);
  check(H5Sget_simple_extent_dims(space.id(), &size, nullptr), layout_->path);
  rows_ = size;
}

void Hdf5Table::refresh() {
  if (!isOpen()) return;
  check(H5Drefresh(set_.id()), layout_->path);
  readExtent();
}

void Hdf5Table::append(std::span<const std::byte> rows) {
  if (rows.empty()) return;
  const hsize_t size = rows_ + rows.size() / layout_->row_bytes;
  check(H5Dset_extent(set_.id(), &size), layout_->path);
  if (made_here_)
    appendChunks(rows);
  else
    appendRows(rows);
  rows_ = size;
}

void Hdf5Table::appendChunks(std::span<const std::byte> rows) {
  const std::size_t whole = layout_->chunk_rows * layout_->row_bytes;
  std::uint64_t chunk = rows_ / layout_->chunk_rows;
  while (!rows.empty()) {
    const auto taken = rows.first(std::min(rows.size(), whole - unfinished_.size()));
    rows = rows.subspan(taken.size());
    unfinished_.insert(unfinished_.end(), taken.begin(), taken.end());
    writeChunk(set_.id(), *layout_, chunk * layout_->chunk_rows, unfinished_);
    if (unfinished_.size() < whole) break;
    unfinished_.clear();
    ++chunk;
  }
}

void Hdf5Table::appendRows(std::span<const std::byte> rows) {
  const hsize_t first = rows_;
  const hsize_t count = rows.size() / layout_->row_bytes;
  const Handle space(H5Dget_space(set_.id()), H5Sclose, layout_->path);
  check(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &first, nullptr, &count, nullptr), layout_->path);
  const Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose, layout_->path);
  check(H5Dwrite(set_.id(), type_.id(), memory.id(), space.id(), H5P_DEFAULT, rows.data()), layout_->path);
}

void Hdf5Table::read(std::uint64_t first, std::uint64_t count, std::span<std::byte> out) const {
  if (!isOpen() && count == 0) return;
  if (first > rows_ || count > rows_ - first) failHard("{}: rows {}+{} of {}", layout_->path, first, count, rows_);
  if (out.size() != count * layout_->row_bytes) failHard("{}: room for other rows than asked", layout_->path);
  const std::size_t row_bytes = layout_->row_bytes;
  const std::size_t whole = layout_->chunk_rows * row_bytes;
  while (!out.empty()) {
    const std::uint64_t start = first / layout_->chunk_rows * layout_->chunk_rows;
    const std::size_t skipped = (first - start) * row_bytes;
    const auto wanted = out.first(std::min(out.size(), whole - skipped));
    if (wanted.size() == whole) {
      readChunk(set_.id(), *layout_, start, wanted);
    } else {
      static std::vector<std::byte> chunk;  // scratch, under the HDF5 lock
      chunk.resize(whole);
      readChunk(set_.id(), *layout_, start, chunk);
      std::memcpy(wanted.data(), chunk.data() + skipped, wanted.size());
    }
    first = start + layout_->chunk_rows;
    out = out.subspan(wanted.size());
  }
}

void writeText(hid_t file, const char* path, const std::string& text) {
  const Handle properties(H5Pcreate(H5P_LINK_CREATE), H5Pclose, path);
  check(H5Pset_create_intermediate_group(properties.id(), 1), path);
  // A length of 0 is no type of HDF5's: the empty text is an empty space.
  const Handle type = textType(std::max<std::size_t>(1, text.size()));
  const Handle space(H5Screate(text.empty() ? H5S_NULL : H5S_SCALAR), H5Sclose, path);
  const Handle set(H5Dcreate2(file, path, type.id(), space.id(), properties.id(), H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
                   path);
  if (!text.empty()) check(H5Dwrite(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), path);
}

std::string readText(hid_t file, const char* path) {
  const Handle set = openValue(file, path);
  const Handle type(H5Dget_type(set.id()), H5Tclose, path);
  const Handle space(H5Dget_space(set.id()), H5Sclose, path);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) > 0) failHard("{}: not a text", path);
  if (H5Sget_simple_extent_type(space.id()) == H5S_NULL) return {};
  if (H5Sget_simple_extent_npoints(space.id()) != 1) failHard("{}: not one text", path);
  const std::size_t size = H5Tget_size(type.id());
  if (size > kLongestText) failHard("{}: a text of {} bytes", path, size);
  std::string text(size, '\0');
  check(H5Dread(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), path);
  return text;
}

void writeBytes(hid_t file, const char* path, const std::string& bytes) {
  const hsize_t count = bytes.size();
  const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, path);
  const Handle set(H5Dcreate2(file, path, H5T_STD_U8LE, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
                   path);
  check(H5Dwrite(set.id(), H5T_STD_U8LE, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), path);
}

std::string readBytes(hid_t file, const char* path, std::uint64_t most) {
  const Handle set = openValue(file, path);
  const Handle space(H5Dget_space(set.id()), H5Sclose, path);
  const Handle type(H5Dget_type(set.id()), H5Tclose, path);
  if (H5Tequal(type.id(), H5T_STD_U8LE) <= 0) failHard("{}: not bytes", path);
  const hssize_t size = H5Sget_simple_extent_npoints(space.id());
  if (size < 0 || static_cast<std::uint64_t>(size) > most) failHard("{}: {} bytes", path, size);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  check(H5Dread(set.id(), H5T_STD_U8LE, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), path);
  return bytes;
}

void writeNumber(hid_t file, const char* attribute, std::int64_t value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, attribute);
  const Handle id(H5Acreate2(file, attribute, H5T_STD_I64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                  attribute);
  check(H5Awrite(id.id(), H5T_STD_I64LE, &value), attribute);
}

std::int64_t readNumber(hid_t file, const char* attribute) {
  const Handle id(H5Aopen(file, attribute, H5P_DEFAULT), H5Aclose, attribute);
  const Handle space(H5Aget_space(id.id()), H5Sclose, attribute);
  if (H5Sget_simple_extent_npoints(space.id()) != 1) failHard("{}: not one number", attribute);
  std::int64_t value = 0;
  check(H5Aread(id.id(), H5T_STD_I64LE, &value), attribute);
  return value;
}

}  // namespace fyd::session
