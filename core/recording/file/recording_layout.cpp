#include "core/recording/file/recording_layout.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "core/recording/file/recording_chunks.h"
#include "core/recording/file/recording_driver.h"
#include "core/recording/file/recording_row_type.h"

namespace fyd::recording {
namespace {

/// Tables whose rows are read one by one, without a step that refers to them; none is compressed. They are small beside
/// the rest: even a truncated file is large enough to hold all of their rows.
constexpr std::array kListed{Table::events, Table::notes, Table::link, Table::pictures};

/// HDF5 takes the first of these in the file, at byte 0, 512, 1024, 2048…
constexpr std::array<std::uint8_t, 8> kHdf5Signature{0x89, 'H', 'D', 'F', '\r', '\n', 0x1A, '\n'};
constexpr std::uint64_t nextStart(std::uint64_t at) { return at == 0 ? 512 : 2 * at; }

/// HDF5's superblock of version 3, up to its end-of-file address. Others are refused: older versions allow groups with
/// a cyclic index, and an extension may hold an image of HDF5's metadata cache.
struct Superblock {
  std::array<std::uint8_t, 8> signature = kHdf5Signature;
  std::uint8_t version = 3;
  std::uint8_t bytes_of_address = 8;
  std::uint8_t bytes_of_length = 8;
  std::uint8_t opened_by = 0;  // marks of those who have it open
  std::array<std::uint8_t, 8> base = std::bit_cast<std::array<std::uint8_t, 8>>(kJournalBytes);
  std::array<std::uint8_t, 8> extension = std::bit_cast<std::array<std::uint8_t, 8>>(~std::uint64_t{0});  // none
  std::array<std::uint8_t, 8> end{};
  bool operator==(const Superblock&) const = default;
};
static_assert(sizeof(Superblock) == 36);

Superblock superblockAt(const JournaledFile& disk, std::uint64_t at) {
  Superblock block;
  if (disk.read(at, std::as_writable_bytes(std::span(&block, 1))) != 0) failHard("its first bytes cannot be read");
  return block;
}

/// HDF5's numbers of the messages in an object's header.
constexpr unsigned kExternalFiles = 0x07;
constexpr unsigned kOldGroup = 0x11;
bool has(const H5O_info_t& info, unsigned message) { return ((info.hdr.mesg.present >> message) & 1U) != 0; }

H5O_info_t infoOf(hid_t file, const std::string& path) {
  H5O_info_t info{};
  check(H5Oget_info_by_name2(file, path.c_str(), &info, H5O_INFO_BASIC | H5O_INFO_HDR, H5P_DEFAULT), path.c_str());
  return info;
}

void checkGroup(hid_t file, const std::string& path) {
  const H5O_info_t info = infoOf(file, path);
  if (info.type != H5O_TYPE_GROUP || has(info, kOldGroup)) failHard("{}: not a group as a recording has it", path);
}

/// Every step of the path stands in this file.
void checkPath(hid_t file, const std::string& path) {
  checkGroup(file, "/");
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
    const std::string part = path.substr(0, end);
    H5L_info_t link{};
    check(H5Lget_info(file, part.c_str(), &link, H5P_DEFAULT), part.c_str());
    if (link.type != H5L_TYPE_HARD) failHard("{}: a link to another place; a recording holds its own values", part);
    if (end == std::string::npos) return;
    checkGroup(file, part);
  }
}

Handle openHere(hid_t file, const char* path) {
  checkPath(file, path);
  const H5O_info_t info = infoOf(file, path);
  if (info.type != H5O_TYPE_DATASET) failHard("{}: not a dataset", path);
  if (has(info, kExternalFiles)) failHard("{}: its values lie in other files; a recording holds its own", path);
  return {H5Dopen2(file, path, H5P_DEFAULT), H5Dclose, path};
}

H5D_layout_t layoutClass(hid_t set, const char* path) {
  const Handle properties(H5Dget_create_plist(set), H5Pclose, path);
  const H5D_layout_t layout = H5Pget_layout(properties.id());
  if (layout == H5D_VIRTUAL) failHard("{}: its values lie in other datasets; a recording holds its own", path);
  return layout;
}

bool isListed(const TableLayout& layout) {
  return &layout == &commitLayout() ||
         std::ranges::any_of(kListed, [&](Table table) { return &layout == &layoutOf(table); });
}

}  // namespace

void checkStart(const JournaledFile& disk) {
  for (std::uint64_t at = 0; at < kJournalBytes; at = nextStart(at))
    if (superblockAt(disk, at).signature == kHdf5Signature)
      failHard("an HDF5 file, but not a recording of the console");
  Superblock found = superblockAt(disk, kJournalBytes);
  found.opened_by = 0;
  found.end = {};
  if (found.signature != kHdf5Signature) failHard("not a recording, or too damaged to open");
  if (found != Superblock{})
    failHard("an HDF5 file, but not a recording of the console, or its first bytes are damaged");
}

std::uint64_t closedLength(const JournaledFile& disk) {
  const Superblock found = superblockAt(disk, kJournalBytes);
  return found.opened_by == 0 ? std::bit_cast<std::uint64_t>(found.end) : 0;
}

OpenedTable openTable(hid_t file, const TableLayout& today) {
  Handle set = openHere(file, today.path);
  TableLayout layout = storedLayout(set.id(), today);
  if (layoutClass(set.id(), layout.path) != H5D_CHUNKED || !hasOurChunks(set.id(), layout))
    failHard("{}: not in chunks of {} rows{}, as this program stores it: another program packed it anew", layout.path,
             layout.chunk_rows, layout.compressed ? say(", shuffled and deflated") : Message{});
  const Handle space(H5Dget_space(set.id()), H5Sclose, layout.path);
  const hssize_t rows = H5Sget_simple_extent_npoints(space.id());
  const std::uint64_t bytes = diskBytes(file);
  if (isListed(today) && (rows < 0 || static_cast<std::uint64_t>(rows) > bytes / layout.row_bytes))
    failHard("{}: {} rows of {} bytes each, while the whole file takes {} bytes", layout.path, rows, layout.row_bytes,
             bytes);
  return {std::move(set), std::move(layout)};
}

Handle openValue(hid_t file, const char* path) {
  Handle set = openHere(file, path);
  const H5D_layout_t layout = layoutClass(set.id(), path);
  if (layout != H5D_CONTIGUOUS && layout != H5D_COMPACT) failHard("{}: not in one piece", path);
  return set;
}

std::uint64_t mostUnopened(hid_t file, Table table) {
  const TableLayout& layout = layoutOf(table);
  return isListed(layout) ? diskBytes(file) / layout.row_bytes : std::numeric_limits<std::uint64_t>::max();
}

std::uint64_t mostRows(Table table, std::uint64_t number) {
  constexpr std::uint64_t kAny = std::numeric_limits<std::uint64_t>::max();
  const bool of_steps = table == Table::telemetry || table == Table::steps || table == Table::motors;
  return of_steps && number < kAny / kBlockSteps ? kBlockSteps * (number + 1) : kAny;
}

bool countsArePlausible(const CommitRow& row) {
  const std::uint64_t steps = row.rows[indexOf(Table::telemetry)];
  return steps <= mostRows(Table::steps, row.number) && row.rows[indexOf(Table::steps)] == steps &&
         row.rows[indexOf(Table::motors)] == steps;
}

}  // namespace fyd::recording
