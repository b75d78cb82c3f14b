#include "core/base/system_reason.h"

#include <array>
#include <cerrno>
#include <cstring>

namespace fyd {
namespace {

struct Known {
  int error;
  std::string_view words;  ///< strerror's, so that they can be looked up
};

constexpr std::array kKnown{Known{EPERM, sentence("Operation not permitted")},
                            Known{ENOENT, sentence("No such file or directory")},
                            Known{EIO, sentence("Input/output error")},
                            Known{ENXIO, sentence("No such device or address")},
                            Known{EBADF, sentence("Bad file descriptor")},
                            Known{EAGAIN, sentence("Resource temporarily unavailable")},
                            Known{ENOMEM, sentence("Cannot allocate memory")},
                            Known{EACCES, sentence("Permission denied")},
                            Known{EBUSY, sentence("Device or resource busy")},
                            Known{EEXIST, sentence("File exists")},
                            Known{EXDEV, sentence("Invalid cross-device link")},
                            Known{ENODEV, sentence("No such device")},
                            Known{ENOTDIR, sentence("Not a directory")},
                            Known{EISDIR, sentence("Is a directory")},
                            Known{EINVAL, sentence("Invalid argument")},
                            Known{ENFILE, sentence("Too many open files in system")},
                            Known{EMFILE, sentence("Too many open files")},
                            Known{ENOTTY, sentence("Inappropriate ioctl for device")},
                            Known{ETXTBSY, sentence("Text file busy")},
                            Known{EFBIG, sentence("File too large")},
                            Known{ENOSPC, sentence("No space left on device")},
                            Known{EROFS, sentence("Read-only file system")},
                            Known{EPIPE, sentence("Broken pipe")},
                            Known{ENAMETOOLONG, sentence("File name too long")},
                            Known{ENOTEMPTY, sentence("Directory not empty")},
                            Known{ELOOP, sentence("Too many levels of symbolic links")},
                            Known{EADDRINUSE, sentence("Address already in use")},
                            Known{EADDRNOTAVAIL, sentence("Cannot assign requested address")},
                            Known{ENETDOWN, sentence("Network is down")},
                            Known{ENETUNREACH, sentence("Network is unreachable")},
                            Known{ECONNRESET, sentence("Connection reset by peer")},
                            Known{ETIMEDOUT, sentence("Connection timed out")},
                            Known{ECONNREFUSED, sentence("Connection refused")},
                            Known{EHOSTUNREACH, sentence("No route to host")},
                            Known{ESTALE, sentence("Stale file handle")},
                            Known{EDQUOT, sentence("Disk quota exceeded")}};

}  // namespace

Message systemReason(int error) {
  for (const Known& each : kKnown) {
    if (each.error == error) return {MessageKind::input, each.words};
  }
  return verbatim(std::strerror(error));
}

Message systemReason(const std::error_code& error) {
  const bool of_system = error.category() == std::generic_category() || error.category() == std::system_category();
  return of_system ? systemReason(error.value()) : verbatim(error.message());
}

}  // namespace fyd
