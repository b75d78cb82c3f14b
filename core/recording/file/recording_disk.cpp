#include "core/recording/file/recording_disk.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "core/base/checksum.h"

namespace fyd::recording {
namespace {

struct JournalHead {
  std::array<char, 16> magic{'F', 'Y', 'D', ' ', 'j', 'o', 'u', 'r', 'n', 'a', 'l', ' ', '1', '\r', '\n', '\0'};
  std::uint64_t sequence = 0;
  std::uint64_t bytes = 0;  // that follow
  std::uint32_t crc = 0;    // of them and of the two numbers above
  std::uint32_t reserved = 0;
};

struct PieceHead {
  std::uint64_t at = 0;
  std::uint64_t bytes = 0;
};

// XORed with the journal's bytes, so that a copy of HDF5's signature in it is not taken for the start of a file.
constexpr std::byte kJournalMask{0xA5};

std::uint32_t journalCrc(const JournalHead& head, std::span<const std::byte> body) {
  std::vector<std::byte> all(2 * sizeof(std::uint64_t));
  std::memcpy(all.data(), &head.sequence, sizeof head.sequence);
  std::memcpy(all.data() + sizeof head.sequence, &head.bytes, sizeof head.bytes);
  all.insert(all.end(), body.begin(), body.end());
  return crc32c(all);
}

int readFully(int file, std::span<std::byte> out, std::uint64_t at) {
  while (!out.empty()) {
    const ssize_t got = ::pread(file, out.data(), out.size(), static_cast<off_t>(at));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return errno;
    if (got == 0) break;
    at += static_cast<std::uint64_t>(got);
    out = out.subspan(static_cast<std::size_t>(got));
  }
  std::fill(out.begin(), out.end(), std::byte{0});
  return 0;
}

}  // namespace

int DiskCalls::write(int file, std::span<const std::byte> bytes, std::uint64_t at) {
  while (!bytes.empty()) {
    const ssize_t put = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) return errno;
    if (put == 0) return ENOSPC;
    at += static_cast<std::uint64_t>(put);
    bytes = bytes.subspan(static_cast<std::size_t>(put));
  }
  return 0;
}

int DiskCalls::sync(int file) { return ::fdatasync(file) == 0 ? 0 : errno; }

int DiskCalls::resize(int file, std::uint64_t bytes) {
  return ::ftruncate(file, static_cast<off_t>(bytes)) == 0 ? 0 : errno;
}

JournaledFile::JournaledFile(int file, Mode mode, bool with_journal, std::shared_ptr<DiskCalls> calls)
    : file_(file), mode_(mode), calls_(calls ? std::move(calls) : std::make_shared<DiskCalls>()) {
  struct stat status {};
  if (::fstat(file_, &status) == 0) size_ = static_cast<std::uint64_t>(status.st_size);
  committed_end_ = written_end_ = size_;
  if (with_journal) readJournal();
}

void JournaledFile::readJournal() {
  JournalHead head;
  if (readFully(file_, std::as_writable_bytes(std::span(&head, 1)), 0) != 0) return;
  if (head.magic != JournalHead{}.magic || head.bytes > kJournalBytes - sizeof head) return;
  std::vector<std::byte> body(head.bytes);
  if (readFully(file_, body, sizeof head) != 0 || journalCrc(head, body) != head.crc) return;
  for (std::byte& b : body) b ^= kJournalMask;
  sequence_ = head.sequence;
  std::span<const std::byte> rest = body;
  while (rest.size() >= sizeof(PieceHead)) {
    PieceHead piece;
    std::memcpy(&piece, rest.data(), sizeof piece);
    rest = rest.subspan(sizeof piece);
    if (piece.bytes > rest.size()) break;
    if (piece.at > size_) break;  // what a recorder keeps in its journal lies within the file
    const auto bytes = rest.first(piece.bytes);
    waiting_.push_back({piece.at, {bytes.begin(), bytes.end()}});
    size_ = std::max(size_, piece.at + piece.bytes);
    rest = rest.subspan(piece.bytes);
  }
  found_journal_ = true;
}

bool JournaledFile::shortened() const {
  struct stat status {};
  return ::fstat(file_, &status) == 0 && static_cast<std::uint64_t>(status.st_size) < written_end_;
}

std::uint64_t JournaledFile::sizeNow() const {
  struct stat status {};
  return ::fstat(file_, &status) == 0 ? std::max(size_, static_cast<std::uint64_t>(status.st_size)) : size_;
}

std::uint64_t JournaledFile::diskBytes() const {
  constexpr std::uint64_t kBlockBytes = 512;      // of st_blocks
  constexpr std::uint64_t kAlways = 8ULL << 20U;  // some file systems count new blocks seconds later
  struct stat status {};
  if (::fstat(file_, &status) != 0) return 0;
  const std::uint64_t taken = std::max(static_cast<std::uint64_t>(status.st_blocks) * kBlockBytes, kAlways);
  return std::min(static_cast<std::uint64_t>(status.st_size), taken);
}

int JournaledFile::read(std::uint64_t at, std::span<std::byte> out) const {
  if (const int error = readFully(file_, out, at); error != 0) return error;
  for (const Write& write : waiting_) {
    const std::uint64_t from = std::max(at, write.at);
    const std::uint64_t to = std::min(at + out.size(), write.at + write.bytes.size());
    if (from < to) std::memcpy(out.data() + (from - at), write.bytes.data() + (from - write.at), to - from);
  }
  return 0;
}

void JournaledFile::write(std::uint64_t at, std::span<const std::byte> bytes) {
  if (mode_ == Mode::read) {
    error_ = EROFS;
    return;
  }
  size_ = std::max(size_, at + bytes.size());
  const bool in_memory = abandoned_ || error_ != 0;
  const std::uint64_t kept = in_memory ? bytes.size() : at < committed_end_ ? committed_end_ - at : 0;
  const auto before = bytes.first(std::min<std::uint64_t>(kept, bytes.size()));
  if (!before.empty()) waiting_.push_back({at, {before.begin(), before.end()}});
  const auto after = bytes.subspan(before.size());
  if (after.empty()) return;
  error_ = writeAtOnce(at + before.size(), after);
  if (error_ != 0) waiting_.push_back({at + before.size(), {after.begin(), after.end()}});
}

int JournaledFile::writeAtOnce(std::uint64_t at, std::span<const std::byte> bytes) {
  if (shortened()) return kShortened;  // looked at before this makes it long again, with a hole
  const int error = calls_->write(file_, bytes, at);
  if (error == 0) written_end_ = std::max(written_end_, at + bytes.size());
  return error;
}

void JournaledFile::reach(std::uint64_t bytes) {
  if (mode_ == Mode::read || bytes <= size_) return;
  size_ = bytes;
  if (!abandoned_ && error_ == 0) error_ = shortened() ? kShortened : calls_->resize(file_, bytes);
}

std::vector<std::byte> JournaledFile::journal() const {
  std::vector<std::byte> body;
  for (const Write& write : waiting_) {
    const PieceHead piece{write.at, write.bytes.size()};
    const auto head = std::as_bytes(std::span(&piece, 1));
    body.insert(body.end(), head.begin(), head.end());
    body.insert(body.end(), write.bytes.begin(), write.bytes.end());
  }
  for (std::byte& b : body) b ^= kJournalMask;
  JournalHead head;
  head.sequence = sequence_;
  head.bytes = body.size();
  head.crc = journalCrc(head, body);
  const auto front = std::as_bytes(std::span(&head, 1));
  body.insert(body.begin(), front.begin(), front.end());
  return body;
}

int JournaledFile::commit() {
  if (error_ == 0) error_ = persist();
  return error_;
}

int JournaledFile::persist() {
  if (abandoned_ || mode_ == Mode::read) return 0;
  if (shortened()) return kShortened;
  if (const int error = calls_->sync(file_); error != 0) return error;
  if (waiting_.empty()) {
    committed_end_ = size_;
    return 0;
  }
  ++sequence_;
  const auto bytes = journal();
  if (bytes.size() > kJournalBytes) return EOVERFLOW;
  if (const int error = calls_->write(file_, bytes, 0); error != 0) return error;
  if (const int error = calls_->sync(file_); error != 0) return error;
  for (const Write& write : waiting_)
    if (const int error = calls_->write(file_, write.bytes, write.at); error != 0) return error;
  waiting_.clear();
  committed_end_ = size_;
  return 0;
}

int JournaledFile::applyJournal() {
  for (const Write& write : waiting_)
    if (const int error = calls_->write(file_, write.bytes, write.at); error != 0) return error_ = error;
  waiting_.clear();
  committed_end_ = size_;
  return 0;
}

int JournaledFile::dropJournal() {
  if (const int error = commit(); error != 0) return error;
  if (const int error = calls_->sync(file_); error != 0) return error;
  const std::array<std::byte, sizeof(JournalHead)> nothing{};
  if (const int error = calls_->write(file_, nothing, 0); error != 0) return error;
  return calls_->sync(file_);
}

}  // namespace fyd::recording
