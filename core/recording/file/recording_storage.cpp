#include "core/recording/file/recording_storage.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/base/system_reason.h"
#include "core/recording/file/recording_driver.h"
#include "core/recording/file/recording_layout.h"
#include "core/recording/file/recording_place.h"

namespace fyd::recording {
namespace {

Message words(int error) { return systemReason(error); }

int opened(const std::string& path, int flags) {
  const int descriptor = ::open(path.c_str(), flags | O_RDWR | O_CLOEXEC, 0644);
  if (descriptor < 0) failHard(words(errno));
  if (lockAsRecorder(descriptor)) return descriptor;
  const int error = errno;
  if ((flags & O_CREAT) != 0) ::unlink(path.c_str());  // just made and empty, it would hold the name for nothing
  ::close(descriptor);
  failHard("its lock cannot be had, it may be recorded at this moment: {}", words(error));
}

void expectDone(int error) {
  if (error == EOVERFLOW) failHard("the disk: one commit changes more than the journal holds");
  if (error == JournaledFile::kShortened) failHard("another program has made the file shorter while it was written");
  if (error != 0) failHard("the disk: {}", words(error));
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

RecordingStorage::RecordingStorage(const std::string& partial, std::shared_ptr<DiskCalls> calls)
    : descriptor_(opened(partial, O_CREAT | O_EXCL)),
      disk_(
          std::make_shared<JournaledFile>(descriptor_.number(), JournaledFile::Mode::write, false, std::move(calls))) {
  const Handle access = accessThrough(disk_);
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "the file");
  check(H5Pset_userblock(creation.id(), kJournalBytes), "the file");
  take(H5Fcreate(partial.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()));
}

RecordingStorage::RecordingStorage(const LeftBehind& left_behind, std::shared_ptr<DiskCalls> calls)
    : descriptor_(opened(left_behind.path, 0)),
      disk_(std::make_shared<JournaledFile>(descriptor_.number(), JournaledFile::Mode::write, true, std::move(calls))) {
  checkStart(*disk_);
  expectDone(disk_->applyJournal());
  const Handle access = accessThrough(disk_, true);
  const hbool_t clear = true;  // the ended recorder's "open for writing" flag, as HDF5's tool h5clear does
  check(H5Pset(access.id(), "clear_status_flags", &clear), "the file");
  take(H5Fopen(left_behind.path.c_str(), H5F_ACC_RDWR, access.id()));
}

RecordingStorage::~RecordingStorage() {
  const auto lock = hdf5Lock();  // a member: its owner's destructor holds the lock no longer
  disk_->abandon();
  file_.reset();
}

void RecordingStorage::take(hid_t opened_file) {
  if (opened_file < 0) disk_->abandon();  // what HDF5 kept of it must not be written when the process ends
  file_ = Handle(opened_file, H5Fclose, "the file");
}

bool RecordingStorage::isStill(const std::string& path) const {
  struct stat ours {};
  struct stat named {};
  (void)::fstat(descriptor_.number(), &ours);
  if (::stat(path.c_str(), &named) != 0) return errno != ENOENT;  // a disk that does not answer is no program's doing
  return named.st_ino == ours.st_ino && !disk_->shortened();
}

void RecordingStorage::startSwmr() { check(H5Fstart_swmr_write(file_.id()), "shared reading"); }

void RecordingStorage::flush() { check(H5Fflush(file_.id(), H5F_SCOPE_LOCAL), "the file"); }

void RecordingStorage::persist() { expectDone(disk_->commit()); }

void RecordingStorage::close() {
  flush();
  file_.reset();
}

void RecordingStorage::dropJournal() { expectDone(disk_->dropJournal()); }

}  // namespace fyd::recording
