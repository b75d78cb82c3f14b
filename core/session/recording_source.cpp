#include "core/session/recording_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/base/system_reason.h"
#include "core/session/recording_driver.h"
#include "core/session/recording_layout.h"
#include "core/session/recording_place.h"

namespace fyd::session {
namespace {

int opened(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // a pipe must not hold us up
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

std::string existingName(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 && ::stat(partialOf(path).c_str(), &status) == 0) return partialOf(path);
  return path;
}

bool isBeingRecorded(const std::string& path) { return recorderLives(Descriptor(opened(path)).number()); }

RecordingSource::RecordingSource(const std::string& path) : RecordingSource(opened(path), path) {}

RecordingSource::RecordingSource(int descriptor, std::string path) : descriptor_(descriptor), path_(std::move(path)) {
  growing_ = recorderLives();
  // A living recorder's journal is its own affair: it applies it while we look.
  disk_ = std::make_shared<JournaledFile>(descriptor_.number(), JournaledFile::Mode::read, !growing_);
  checkStart(*disk_);
  const Handle access = accessThrough(disk_);
  // HDF5 waits twice as long before each new attempt at a block whose checksum is wrong: a tenth of a second in all is
  // enough for a recorder that the machine interrupted while writing it, and where nobody writes, nothing will change.
  check(H5Pset_metadata_read_attempts(access.id(), growing_ ? 26 : 1), "access");
  // A living recorder, and one that was killed, leave a mark in the file: HDF5 then opens it in this way only.
  hid_t id = H5Fopen(path_.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.id());
  if (id < 0) id = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, access.id());
  file_ = Handle(id, H5Fclose, "not a recording, or too damaged to open");
}

std::unique_ptr<RecordingSource> RecordingSource::again() const {
  return std::unique_ptr<RecordingSource>(new RecordingSource(duplicate(descriptor_.number()), path_));
}

bool RecordingSource::recorderLives() const { return session::recorderLives(descriptor_.number()); }

std::uint64_t RecordingSource::bytes() const {
  struct stat status {};
  return ::fstat(descriptor_.number(), &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

}  // namespace fyd::session
