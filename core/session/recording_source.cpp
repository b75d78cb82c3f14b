#include "core/session/recording_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/session/recording_place.h"

namespace fyd::session {

std::string existingName(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 && ::stat(partialOf(path).c_str(), &status) == 0) return partialOf(path);
  return path;
}

RecordingSource::RecordingSource(const std::string& path) {
  descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) failHard("{}", std::generic_category().message(errno));
  try {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) failHard("not a file");
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access");
    check(H5Pset_file_locking(access.id(), false, true), "access");
    // A recorder that was killed leaves its mark in the file, and HDF5 then opens it in this way only.
    hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.id());
    if (id < 0) id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id());
    file_ = Handle(id, H5Fclose, "not a recording, or too damaged to open");
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

void RecordingSource::close() {
  file_.reset();
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

bool RecordingSource::recorderLives() const { return session::recorderLives(descriptor_); }

std::uint64_t RecordingSource::bytes() const {
  struct stat status {};
  return ::fstat(descriptor_, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

}  // namespace fyd::session
