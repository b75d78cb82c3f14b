#include "core/session/recording_storage.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/session/recording_place.h"

namespace fyd::session {

RecordingStorage::RecordingStorage(const std::string& partial) {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access");
  check(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110), "access");
  check(H5Pset_file_locking(access.id(), false, true), "access");
  file_ = Handle(H5Fcreate(partial.c_str(), H5F_ACC_EXCL, H5P_DEFAULT, access.id()), H5Fclose, "the file");
  descriptor_ = ::open(partial.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor_ < 0) failHard("{}", std::generic_category().message(errno));
  if (!lockAsRecorder(descriptor_)) failHard("its lock cannot be had: {}", std::generic_category().message(errno));
}

RecordingStorage::~RecordingStorage() {
  file_.reset();
  if (descriptor_ >= 0) ::close(descriptor_);
}

void RecordingStorage::startSwmr() { check(H5Fstart_swmr_write(file_.id()), "shared reading"); }

void RecordingStorage::commit() {
  check(H5Fflush(file_.id(), H5F_SCOPE_LOCAL), "the file");
  if (::fdatasync(descriptor_) != 0) failHard("the disk: {}", std::generic_category().message(errno));
}

void RecordingStorage::close() {
  check(H5Fflush(file_.id(), H5F_SCOPE_LOCAL), "the file");
  file_.reset();
  if (::fdatasync(descriptor_) != 0) failHard("the disk: {}", std::generic_category().message(errno));
}

std::uint64_t RecordingStorage::bytes() const {
  struct stat status {};
  return ::fstat(descriptor_, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

}  // namespace fyd::session
