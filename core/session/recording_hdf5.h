// The HDF5 C library as the recordings use it: handles that close themselves, failures as exceptions that stay inside
// this room (`guarded` turns them into Results), and one lock, because Debian's library knows nothing of threads.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/session/recording_conversion.h"

namespace fyd::session {

/// Every call into HDF5 of this process holds this lock, that of other users of the library (matio) too.
[[nodiscard]] std::unique_lock<std::recursive_mutex> hdf5Lock();

struct RecordingFailure : std::exception {
  explicit RecordingFailure(Message why) : message(std::move(why)) {}
  Message message;
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

/// How the file has a table. @throws RecordingFailure, as Hdf5Table::open
[[nodiscard]] TableLayout storedLayout(hid_t set, const TableLayout& today);

/// One growing table.
class Hdf5Table {
 public:
  Hdf5Table() = default;
  static Hdf5Table create(hid_t file, const TableLayout& layout);
  /// @throws RecordingFailure when it is missing, stored otherwise than this program does, or a column of a name this
  /// program knows is of another type. Columns may be more, fewer and elsewhere: `rows()` and what is read and appended
  /// are as the file has them; see conversion()
  static Hdf5Table open(hid_t file, const TableLayout& layout);
  [[nodiscard]] bool isOpen() const { return static_cast<bool>(set_); }
  [[nodiscard]] const RowConversion& conversion() const { return conversion_; }
  [[nodiscard]] std::size_t rowBytes() const { return layout_->row_bytes; }
  /// nullptr: the file has no column of this name.
  [[nodiscard]] const Column* column(std::string_view name) const;

  void append(std::span<const std::byte> rows);
  void read(std::uint64_t first, std::uint64_t count, std::span<std::byte> out) const;
  /// Takes in what another process has written.
  void refresh();
  [[nodiscard]] std::uint64_t rows() const { return rows_; }
  /// Bytes it takes in the file.
  [[nodiscard]] std::uint64_t storedBytes() const { return H5Dget_storage_size(set_.id()); }

 private:
  void readExtent();
  void appendChunks(std::span<const std::byte> rows);
  void appendRows(std::span<const std::byte> rows);

  const TableLayout* layout_ = nullptr;  // as the file has it
  std::unique_ptr<const TableLayout> own_;
  RowConversion conversion_;
  Handle set_;
  Handle type_;
  std::uint64_t rows_ = 0;
  bool made_here_ = false;             // and so written chunk by chunk
  std::vector<std::byte> unfinished_;  // the last chunk's rows, while it is not full
};

inline constexpr std::uint64_t kLongestText = 64U << 20U;
/// Single texts, and numbers of the root group; absent or of another kind: RecordingFailure.
void writeText(hid_t file, const char* path, const std::string& text);
[[nodiscard]] std::string readText(hid_t file, const char* path);
/// A list of bytes, no text.
void writeBytes(hid_t file, const char* path, const std::string& bytes);
[[nodiscard]] std::string readBytes(hid_t file, const char* path, std::uint64_t most = kLongestText);
void writeNumber(hid_t file, const char* attribute, std::int64_t value);
[[nodiscard]] std::int64_t readNumber(hid_t file, const char* attribute);

}  // namespace fyd::session
