#include "core/session/recording_repair.h"

#include "core/session/recording_crc.h"
#include "core/session/recording_storage.h"
#include "core/session/recording_tables.h"

namespace fyd::session {

Result<void> finishRecording(const std::string& path, std::shared_ptr<DiskCalls> calls) {
  return guarded(path, [&] {
    RecordingStorage storage(LeftBehind{path}, std::move(calls));
    if (CommitRow row = RecordingTables(storage.file(), false).last(); row.closed == 0) {
      Hdf5Table commits = Hdf5Table::open(storage.file(), commitLayout());
      ++row.number;
      row.crc = {};  // no new rows
      row.closed = 1;
      row.own_crc = crc32c(std::as_bytes(std::span(&row, 1)).first(offsetof(CommitRow, own_crc)));
      commits.append(std::as_bytes(std::span(&row, 1)));
    }
    storage.finish();
  });
}

}  // namespace fyd::session
