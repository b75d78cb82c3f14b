// A file whose commits are all or nothing, under HDF5, which by itself promises this for a killed process only: after
// a power cut the disk may hold any mixture of a block's old and new pages.
//
//   beyond the last commit's end    written at once: nothing committed points there yet
//   before it                       kept in memory until `commit`:
//                                   sync → journal with its CRC32C, at the file's start → sync → the places themselves
//
// The places themselves are synced by the next commit, before its journal replaces this one. So either the journal is
// whole, and applying it (again) gives the newest commit, or it is torn, and the file is the commit before. A journal
// that is sound may be all there is of a commit: it is applied before anything else is written, and it stays until
// then.
#pragma once

#include <sys/types.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace fyd::recording {

/// The system calls of a JournaledFile; each returns 0 or an errno. Tests override them to simulate disk errors.
class DiskCalls {
 public:
  virtual ~DiskCalls() = default;
  [[nodiscard]] virtual int write(int file, std::span<const std::byte> bytes, std::uint64_t at);
  [[nodiscard]] virtual int sync(int file);
  [[nodiscard]] virtual int resize(int file, std::uint64_t bytes);
};

/// Room for the journal before HDF5's own first byte: HDF5's "user block", which every reader of the format skips.
inline constexpr std::uint64_t kJournalBytes = 1U << 20U;

class JournaledFile {
 public:
  enum class Mode : std::uint8_t { read, write };
  /// @param file stays the caller's. @param with_journal read the journal that an ended recorder left
  JournaledFile(int file, Mode mode, bool with_journal, std::shared_ptr<DiskCalls> calls = {});

  /// Bytes beyond the end are zero. @return an errno
  [[nodiscard]] int read(std::uint64_t at, std::span<std::byte> out) const;
  /// Write errors are deferred to commit(): when HDF5 meets one in the middle of its work, its inconsistent state
  /// crashes the process at exit.
  void write(std::uint64_t at, std::span<const std::byte> bytes);
  /// Makes the file at least so long.
  void reach(std::uint64_t bytes);
  /// In the place of an errno, and none of them: another program has made the file shorter than it was written.
  static constexpr int kShortened = -1;
  /// @return the errno of the first write, resize or sync that failed, or kShortened; nothing is committed from then on
  [[nodiscard]] int commit();
  /// Writes the content of an ended recorder's journal to its places in the file; the journal itself stays until the
  /// next commit has synced them. @return an errno
  [[nodiscard]] int applyJournal();
  /// For a file that is finished: nothing is left to apply.
  [[nodiscard]] int dropJournal();
  /// From now on nothing is written to the disk: HDF5 can close its objects without changing the file.
  void abandon() { abandoned_ = true; }

  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// What is known of the file's length from elsewhere: it may have been cut short.
  void expectLength(std::uint64_t bytes) { expected_ = bytes; }
  [[nodiscard]] std::uint64_t missingBytes() const { return std::max(expected_, size_) - size_; }
  /// The file's length at this moment, in bytes; that of a growing recording increases.
  [[nodiscard]] std::uint64_t sizeNow() const;
  /// Bytes allocated on the disk. A sparse file counts at most its allocated blocks or 8 MiB, whichever is more.
  [[nodiscard]] std::uint64_t diskBytes() const;
  [[nodiscard]] bool shortened() const;  ///< by another program
  /// An intact journal was there when it was opened; other programs do not see its content.
  [[nodiscard]] bool foundJournal() const { return found_journal_; }

 private:
  struct Write {
    std::uint64_t at = 0;
    std::vector<std::byte> bytes;
  };
  [[nodiscard]] int writeAtOnce(std::uint64_t at, std::span<const std::byte> bytes);
  [[nodiscard]] int persist();
  [[nodiscard]] std::vector<std::byte> journal() const;
  void readJournal();

  int file_;
  Mode mode_;
  std::shared_ptr<DiskCalls> calls_;
  std::vector<Write> waiting_;  // in the order HDF5 wrote them: a reader in another process relies on it
  std::uint64_t size_ = 0;
  std::uint64_t expected_ = 0;
  std::uint64_t committed_end_ = 0;
  std::uint64_t written_end_ = 0;  // the file on the disk is at least so long
  std::uint64_t sequence_ = 0;
  bool found_journal_ = false;
  bool abandoned_ = false;
  int error_ = 0;  // the first
};

}  // namespace fyd::recording
