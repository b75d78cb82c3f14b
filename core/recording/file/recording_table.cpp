#include "core/recording/file/recording_table.h"

#include <algorithm>
#include <cstring>

#include "core/recording/file/recording_chunks.h"
#include "core/recording/file/recording_layout.h"
#include "core/recording/file/recording_row_type.h"

namespace fyd::recording {
namespace {

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

}  // namespace fyd::recording
