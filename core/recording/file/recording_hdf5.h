// The HDF5 C library as the recordings use it: handles that close themselves, failures as exceptions that stay inside
// this module (`guarded` turns them into Results), and one lock, because not every build of the
// library is thread-safe, and several calls belong together.
#pragma once

#include <hdf5.h>

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace fyd::recording {

/// A recursive mutex that goes to whoever waits longest. A plain one is taken again by who has just let go of it, before
/// a waiting thread is awake: a long verification would keep the recorder away from the disk for seconds.
class FairMutex {
 public:
  void lock();
  void unlock();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t next_ = 0;
  std::uint64_t serving_ = 0;
  std::atomic<std::thread::id> owner_{};
  int depth_ = 0;  // the owner's
};

/// Every call into HDF5 of this process holds this lock, calls by other users of the library (matio) too.
[[nodiscard]] std::unique_lock<FairMutex> hdf5Lock();

struct RecordingFailure : std::exception {
  explicit RecordingFailure(Message why) : message(std::move(why)) {}
  Message message;
};

/// HDF5 itself cannot, as where a checksum of its own is wrong.
struct Hdf5Failure : RecordingFailure {
  using RecordingFailure::RecordingFailure;
};

template <class... Args>
[[noreturn]] void failHard(MessageFormat<Args...> format, Args&&... args) {
  throw RecordingFailure(say<Args...>(format, std::forward<Args>(args)...));
}
[[noreturn]] inline void failHard(Message message) { throw RecordingFailure(std::move(message)); }

/// Runs `work` under the lock; what it throws becomes an error that starts with `subject`.
template <class Work>
auto guarded(const std::string& subject, Work&& work) -> Result<decltype(work())> {
  const auto lock = hdf5Lock();
  try {
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      return {};
    } else {
      return work();
    }
  } catch (const RecordingFailure& failure) {
    return fail(about(subject, failure.message));
  } catch (const std::bad_alloc&) {
    return fail("{}: out of memory", subject);
  } catch (const std::length_error&) {
    return fail("{}: a size in it is beyond all reason", subject);
  }
}

/// Owns an HDF5 identifier.
class Handle {
 public:
  using Closer = herr_t (*)(hid_t);
  Handle() = default;
  /// @throws RecordingFailure when `id` is invalid, saying what failed and HDF5's own reason
  Handle(hid_t id, Closer closer, const char* what);
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}
  Handle& operator=(Handle&& other) noexcept;
  ~Handle() { reset(); }
  void reset();
  [[nodiscard]] hid_t id() const { return id_; }
  [[nodiscard]] explicit operator bool() const { return id_ >= 0; }

 private:
  hid_t id_ = -1;
  Closer closer_ = nullptr;
};

/// @throws RecordingFailure when `status` is negative
void check(herr_t status, const char* what);

/// The HDF5 type of a UTF-8 string of `bytes` bytes, padded with zeros.
[[nodiscard]] Handle textType(std::size_t bytes);

}  // namespace fyd::recording
