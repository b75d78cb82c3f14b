#include "core/recording/reader/recording_source.h"

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

int descriptorOf(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // opening a pipe must not block
  if (descriptor < 0) failHard(systemReason(errno));
  struct stat status {};
  if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) return descriptor;
  ::close(descriptor);
  failHard("not a file");
}

int duplicate(int descriptor) {
  const int again = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  if (again < 0) failHard(systemReason(errno));
  return again;
}

}  // namespace

bool isBeingRecorded(const std::string& path) { return recorderRuns(Descriptor(descriptorOf(path)).number()); }

RecordingSource::RecordingSource(const std::string& path) : RecordingSource(descriptorOf(path), path) {}

RecordingSource::RecordingSource(int descriptor, std::string path) : descriptor_(descriptor), path_(std::move(path)) {
  growing_ = recorderRuns();
  // The journal of a running recorder is not read: the recorder applies it itself.
  disk_ = std::make_shared<JournaledFile>(descriptor_.number(), JournaledFile::Mode::read, !growing_);
  checkStart(*disk_);
  if (!growing_) disk_->expectLength(closedLength(*disk_));
  const Handle access = accessThrough(disk_);
  // HDF5 waits twice as long before each new attempt at a block whose checksum is wrong: a tenth of a second in all is
  // enough for a recorder that the machine interrupted while writing it, and without a recorder a retry changes
  // nothing.
  check(H5Pset_metadata_read_attempts(access.id(), growing_ ? 26 : 1), "access");
  // While a recorder runs, or after it was killed, the file is flagged as open for writing: HDF5 then opens it only so.
  hid_t id = H5Fopen(path_.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.id());
  if (id < 0) id = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, access.id());
  file_ = Handle(id, H5Fclose, "not a recording, or too damaged to open");
}

std::unique_ptr<RecordingSource> RecordingSource::again() const {
  return std::unique_ptr<RecordingSource>(new RecordingSource(duplicate(descriptor_.number()), path_));
}

bool RecordingSource::recorderRuns() const { return recording::recorderRuns(descriptor_.number()); }

std::uint64_t RecordingSource::bytes() const {
  struct stat status {};
  return ::fstat(descriptor_.number(), &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

}  // namespace fyd::recording
