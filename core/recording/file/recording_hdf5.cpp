#include "core/recording/file/recording_hdf5.h"

namespace fyd::recording {
namespace {

std::string reason() {
  std::string text;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned, const H5E_error2_t* error, void* into) {
        auto& words = *static_cast<std::string*>(into);
        if (words.empty() && error->desc != nullptr) words = error->desc;
        return herr_t{0};
      },
      &text);
  H5Eclear2(H5E_DEFAULT);
  return text;
}

}  // namespace

void FairMutex::lock() {
  const std::thread::id self = std::this_thread::get_id();
  if (owner_ == self) {
    ++depth_;
    return;
  }
  std::unique_lock lock(mutex_);
  const std::uint64_t turn = next_++;
  changed_.wait(lock, [&] { return turn == serving_; });
  owner_ = self;
  depth_ = 1;
}

void FairMutex::unlock() {
  if (--depth_ > 0) return;
  owner_ = std::thread::id();
  {
    const std::lock_guard lock(mutex_);
    ++serving_;
  }
  changed_.notify_all();
}

std::unique_lock<FairMutex> hdf5Lock() {
  static FairMutex mutex;
  std::unique_lock lock(mutex);
  thread_local const bool kQuiet = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;  // its reasons go into our errors
  (void)kQuiet;
  return lock;
}

Handle::Handle(hid_t id, Closer closer, const char* what) : id_(id), closer_(closer) {
  if (id < 0) throw Hdf5Failure(about(what, verbatim(reason())));
}

Handle& Handle::operator=(Handle&& other) noexcept {
  reset();
  id_ = std::exchange(other.id_, -1);
  closer_ = other.closer_;
  return *this;
}

void Handle::reset() {
  if (id_ >= 0) closer_(id_);
  id_ = -1;
}

void check(herr_t status, const char* what) {
  if (status < 0) throw Hdf5Failure(about(what, verbatim(reason())));
}

Handle textType(std::size_t bytes) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "a text's type");
  check(H5Tset_size(type.id(), bytes), "a text's length");
  check(H5Tset_cset(type.id(), H5T_CSET_UTF8), "a text's alphabet");
  check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "a text's padding");
  return type;
}

}  // namespace fyd::recording
