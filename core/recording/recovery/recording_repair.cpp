#include "core/recording/recovery/recording_repair.h"

#include "core/base/checksum.h"
#include "core/recording/file/recording_storage.h"
#include "core/recording/file/recording_table.h"
#include "core/recording/reader/recording_tables.h"

namespace fyd::recording {
namespace {

/// The commit that follows `last` and closes the recording, in the file's own layout: another program may have
/// recorded more tables than this one knows.
std::vector<std::byte> closing(const Hdf5Table& commits, CommitRow last) {
  std::vector<std::byte> row(commits.rowBytes());
  commits.read(last.number, 1, row);
  const Column* crc = commits.column("crc");
  const Column* own_crc = commits.column("own_crc");
  if (crc == nullptr || own_crc == nullptr) failHard("{}: has no checksums", commitLayout().path);
  std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(crc->offset), crc->bytes(), std::byte{0});  // no new rows
  ++last.number;
  last.crc = {};
  last.closed = 1;
  commits.conversion().putBack(std::as_bytes(std::span(&last, 1)), row);
  const std::uint32_t sum = crc32c(std::span(row).first(own_crc->offset));
  std::memcpy(row.data() + own_crc->offset, &sum, sizeof sum);
  return row;
}

}  // namespace

Result<void> finishRecording(const std::string& path, std::shared_ptr<DiskCalls> calls) {
  return guarded(path, [&] {
    RecordingStorage storage(LeftBehind{path}, std::move(calls));
    if (CommitRow row = RecordingTables(storage.file(), false).last(); row.closed == 0) {
      Hdf5Table commits = Hdf5Table::open(storage.file(), commitLayout());
      commits.append(closing(commits, row));
    }
    storage.finish();
  });
}

}  // namespace fyd::recording
