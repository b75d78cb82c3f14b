#include "core/recording/reader/recording_tables.h"

#include "core/base/checksum.h"
#include "core/recording/file/recording_layout.h"
#include "core/recording/reader/recording_mend.h"

namespace fyd::recording {
namespace {

constexpr std::size_t kCacheBytes = 32U << 20U;
constexpr std::size_t kLargestBlockBytes = 512U << 20U;  // a larger block is not this program's: it is not read
constexpr std::uint64_t kCommitsPerRead = 256;
constexpr std::size_t kReadAtOnce_bytes = 1U << 20U;

// Tables with little in each commit are read many commits at a time.
std::uint64_t commitsPerBlock(Table table) {
  switch (table) {
    case Table::telemetry:
    case Table::steps:
    case Table::motors:
    case Table::picture_bytes: return 1;
    case Table::overview_25: return 8;
    default: return 64;
  }
}

bool ownCrcIsRight(const Hdf5Table& commits, std::span<const std::byte> row) {
  const Column* own = commits.column("own_crc");
  std::uint32_t crc = 0;
  if (own == nullptr || own->offset + sizeof crc > row.size()) return false;
  std::memcpy(&crc, row.data() + own->offset, sizeof crc);
  return crc == crc32c(row.first(own->offset));
}

std::uint64_t keyOf(std::size_t table, std::uint64_t first_commit) { return first_commit * (kTableCount + 1) + table; }

}  // namespace

RecordingTables::RecordingTables(hid_t file, bool growing, bool damaged) : growing_(growing) {
  commit_table_ = Hdf5Table::open(file, commitLayout());
  const Column* counts = commit_table_.column("rows");
  if (counts == nullptr) failHard("{}: does not count the tables' rows", commitLayout().path);
  // A table that the file's commits do not count is newer than the file.
  for (std::size_t i = 0; i < std::min(kTableCount, counts->count); ++i) {
    try {
      tables_[i] = Hdf5Table::open(file, layoutOf(static_cast<Table>(i)));
    } catch (const Hdf5Failure& failure) {
      if (!damaged || growing || static_cast<Table>(i) == Table::telemetry) throw;
      unopened_[i] = failure.message;
    }
  }
  if (growing_ && findLast()) return;
  if (commit_table_.rows() == 0 || growing_)
    failHard("no commit in it can be trusted: nothing was ever completely written");
  lookAtCommits(file);
}

void RecordingTables::lookAtCommits(hid_t file) {
  commit_count_ = commit_table_.rows();
  std::array<std::uint64_t, kTableCount> in_file{};
  for (std::size_t i = 0; i < kTableCount; ++i)
    in_file[i] = unopened_[i].empty() ? tables_[i].rows() : mostUnopened(file, static_cast<Table>(i));
  CommitMender mender([this](Table table) -> const Hdf5Table& { return tables_[indexOf(table)]; });
  last_.latest_ns = std::numeric_limits<std::int64_t>::min();
  const auto sound = [&](std::uint64_t number) -> std::optional<CommitRow> {
    auto row = soundCommit(number);
    for (std::size_t i = 0; row && i < kTableCount; ++i)
      if (row->rows[i] < last_.rows[i] || row->rows[i] > in_file[i]) row.reset();
    return row;
  };
  for (std::uint64_t number = 0; number < commit_count_;) {
    if (const auto row = sound(number)) {
      last_ = *row;
      ++number;
      continue;
    }
    std::uint64_t next = number + 1;
    std::optional<CommitRow> next_sound;
    while (next < commit_count_ && !(next_sound = sound(next))) ++next;
    const auto most = next_sound ? next_sound->rows : in_file;
    for (; number < next; ++number) {
      last_ = mender.mended(storedCommit(number), number, last_, most);
      damaged_.push_back(number);
      mended_.emplace(number, last_);
    }
  }
  if (damaged_.size() == commit_count_ && last_.rows == decltype(last_.rows){})
    failHard("no commit in it can be trusted: all {} are damaged", commit_count_);
}

bool RecordingTables::findLast() {
  for (std::uint64_t count = commit_table_.rows(); count > 0; --count) {
    CommitRow row;
    try {
      std::memcpy(&row, readCommits(count - 1, 1).data(), sizeof row);
    } catch (const RecordingFailure&) {
      count -= (count - 1) % commitLayout().chunk_rows;  // an incomplete chunk: the commit before may lie in another
      continue;
    }
    if (!intact(row, count - 1)) continue;
    bool complete = true;
    for (std::size_t i = 0; i < kTableCount; ++i) complete = complete && row.rows[i] <= tables_[i].rows();
    if (!complete) continue;
    last_ = row;
    commit_count_ = count;
    return true;
  }
  return false;
}

bool RecordingTables::refresh() {
  if (!growing_ || last_.closed != 0) return false;
  commit_table_.refresh();
  if (commit_table_.rows() == commit_count_) return false;
  for (Hdf5Table& table : tables_) table.refresh();
  const std::uint64_t before = commit_count_;
  if (!findLast()) failHard("the commits that were there have gone");
  return commit_count_ != before;
}

/// In this program's layout. A row converted to it gets a right own checksum when the one in the file was right.
std::vector<std::byte> RecordingTables::readCommits(std::uint64_t first, std::uint64_t count) const {
  std::vector<std::byte> stored(count * commit_table_.rowBytes());
  commit_table_.read(first, count, stored);
  if (!commit_table_.conversion().needed()) return stored;
  std::vector<std::byte> rows = commit_table_.conversion().toToday(stored);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto in_file = std::span(stored).subspan(i * commit_table_.rowBytes(), commit_table_.rowBytes());
    const auto here = std::span(rows).subspan(i * sizeof(CommitRow), sizeof(CommitRow));
    const std::uint32_t right = crc32c(here.first(offsetof(CommitRow, own_crc)));
    const std::uint32_t own_crc = ownCrcIsRight(commit_table_, in_file) ? right : ~right;
    std::memcpy(here.data() + offsetof(CommitRow, own_crc), &own_crc, sizeof own_crc);
  }
  return rows;
}

std::vector<std::string> RecordingTables::missingColumns() const {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < kTableCount; ++i) {
    const char* path = layoutOf(static_cast<Table>(i)).path;
    if (!has(static_cast<Table>(i))) out.emplace_back(path);
    for (const std::string& name : tables_[i].conversion().lacking()) out.push_back(fmt::format("{} {}", path, name));
  }
  return out;
}

std::vector<std::string> RecordingTables::unknownColumns() const {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < kTableCount; ++i)
    for (const std::string& name : tables_[i].conversion().unknown())
      out.push_back(fmt::format("{} {}", layoutOf(static_cast<Table>(i)).path, name));
  return out;
}

CommitRow RecordingTables::storedCommit(std::uint64_t number) const {
  const auto block = commitBlock(number);
  CommitRow row;
  std::memcpy(&row, block->bytes.data() + (number - block->first) * sizeof row, sizeof row);
  return row;
}

std::optional<CommitRow> RecordingTables::soundCommit(std::uint64_t number) const {
  if (const auto mended = mended_.find(number); mended != mended_.end()) return mended->second;
  const CommitRow row = storedCommit(number);
  if (!intact(row, number)) return std::nullopt;
  return row;
}

CommitRow RecordingTables::commit(std::uint64_t number) const {
  const auto row = soundCommit(number);
  if (!row) failHard("/commits: row {} is damaged", number);
  return *row;
}

std::shared_ptr<const RecordingBlock> RecordingTables::commitBlock(std::uint64_t number) const {
  if (number >= commit_count_) failHard("commit {} of {}", number, commit_count_);
  const std::uint64_t first = number / kCommitsPerRead * kCommitsPerRead;
  const Key key = keyOf(kTableCount, first);
  if (const auto found = cache_.find(key); found != cache_.end() && found->second->second->holds(number)) {
    newest_first_.splice(newest_first_.begin(), newest_first_, found->second);
    return found->second->second;
  }
  auto block = std::make_shared<RecordingBlock>();
  block->first = first;
  block->count = std::min(kCommitsPerRead, commit_count_ - first);
  try {
    block->bytes = readCommits(first, block->count);
  } catch (const RecordingFailure&) {
    if (growing_) throw;
    readEachCommit(*block);
  }
  remember(key, block);
  return block;
}

/// Rows that cannot be read are left as zeros, which is not a valid commit row.
void RecordingTables::readEachCommit(RecordingBlock& block) const {
  block.bytes.assign(block.count * sizeof(CommitRow), std::byte{0});
  for (std::uint64_t i = 0; i < block.count; ++i) {
    try {
      std::ranges::copy(readCommits(block.first + i, 1),
                        block.bytes.begin() + static_cast<std::ptrdiff_t>(i * sizeof(CommitRow)));
    } catch (const RecordingFailure&) {
      continue;
    }
  }
}

std::uint64_t RecordingTables::commitOf(Table table, std::uint64_t row) const {
  std::uint64_t low = 0;
  std::uint64_t high = commit_count_;
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    // A damaged commit is skipped for the next intact one; without one, the row's own commit is among the damaged.
    std::uint64_t probe = middle;
    std::optional<CommitRow> sound;
    while (probe < high && !(sound = soundCommit(probe))) ++probe;
    if (!sound || sound->rows[indexOf(table)] > row)
      high = middle;
    else
      low = probe + 1;
  }
  if (low == commit_count_) failHard("{}: row {} of {}", layoutOf(table).path, row, rows(table));
  return low;
}

std::shared_ptr<const RecordingBlock> RecordingTables::load(Table table, std::uint64_t first_commit,
                                                            std::uint64_t end_commit) const {
  const std::size_t i = indexOf(table);
  if (!unopened_[i].empty()) throw RecordingFailure{unopened_[i]};
  const std::size_t row_bytes = tables_[i].rowBytes();
  const std::size_t largest = std::max(row_bytes, layoutOf(table).row_bytes);
  auto block = std::make_shared<RecordingBlock>();
  block->first = first_commit == 0 ? 0 : commit(first_commit - 1).rows[i];
  const std::uint64_t end = commit(end_commit - 1).rows[i];
  if (end < block->first || (end - block->first) > kLargestBlockBytes / largest)
    failHard("{}: rows {} to {} in one block", layoutOf(table).path, block->first, end);
  block->count = end - block->first;
  // Piece by piece, so that a wrong row count allocates no memory.
  const std::uint64_t piece = std::max<std::uint64_t>(1, kReadAtOnce_bytes / row_bytes);
  for (std::uint64_t done = 0; done < block->count; done += piece) {
    const std::uint64_t rows = std::min(piece, block->count - done);
    block->bytes.resize((done + rows) * row_bytes);
    tables_[i].read(block->first + done, rows, std::span(block->bytes).subspan(done * row_bytes));
  }
  std::uint64_t from = block->first;
  for (std::uint64_t number = first_commit; number < end_commit; ++number) {
    const CommitRow row = commit(number);
    const std::uint64_t to = row.rows[i];
    if (to < from || to > end) failHard("/commits: row {} counts backwards", number);
    const auto bytes = std::span(block->bytes).subspan((from - block->first) * row_bytes, (to - from) * row_bytes);
    const std::uint32_t crc = bytes.empty() ? 0 : crc32c(bytes);
    if (crc != row.crc[i])
      failHard("{}: rows {} to {} are damaged: CRC32C {:08x}, committed as {:08x}", layoutOf(table).path, from, to, crc,
               row.crc[i]);
    from = to;
  }
  block->bytes = tables_[i].conversion().toToday(std::move(block->bytes));
  return block;
}

std::uint64_t RecordingTables::rowAfterDamage(Table table, std::uint64_t row) const {
  for (std::uint64_t number = commitOf(table, row); number < commit_count_; ++number)
    if (const auto sound = soundCommit(number); sound && sound->rows[indexOf(table)] > row)
      return sound->rows[indexOf(table)];
  return rows(table);
}

std::shared_ptr<const RecordingBlock> RecordingTables::block(Table table, std::uint64_t row) const {
  const std::size_t i = indexOf(table);
  if (recent_[i] && recent_[i]->holds(row)) return recent_[i];
  if (row >= rows(table)) failHard("{}: row {} of {}", layoutOf(table).path, row, rows(table));
  const std::uint64_t together = commitsPerBlock(table);
  const std::uint64_t first = commitOf(table, row) / together * together;
  const Key key = keyOf(i, first);
  if (const auto found = cache_.find(key); found != cache_.end() && found->second->second->holds(row)) {
    newest_first_.splice(newest_first_.begin(), newest_first_, found->second);
    return recent_[i] = found->second->second;
  }
  try {
    recent_[i] = load(table, first, std::min(first + together, commit_count_));
  } catch (const RecordingFailure&) {
    if (together == 1) throw;
    // One damaged commit must not make its neighbours unreadable.
    const std::uint64_t own = commitOf(table, row);
    return recent_[i] = load(table, own, own + 1);
  }
  remember(key, recent_[i]);
  return recent_[i];
}

const RecordingBlock& RecordingTables::blockAt(Table table, std::uint64_t row) const { return *block(table, row); }

void RecordingTables::remember(Key key, std::shared_ptr<const RecordingBlock> block) const {
  if (const auto old = cache_.find(key); old != cache_.end()) {  // it has grown since
    cached_bytes_ -= old->second->second->bytes.size();
    newest_first_.erase(old->second);
    cache_.erase(old);
  }
  cached_bytes_ += block->bytes.size();
  newest_first_.emplace_front(key, std::move(block));
  cache_[key] = newest_first_.begin();
  while (cached_bytes_ > kCacheBytes && newest_first_.size() > 1) {
    cached_bytes_ -= newest_first_.back().second->bytes.size();
    cache_.erase(newest_first_.back().first);
    newest_first_.pop_back();
  }
}

std::string RecordingTables::bytes(Table table, std::uint64_t first, std::uint64_t count) const {
  if (first > rows(table) || count > rows(table) - first)
    failHard("{}: bytes {}+{} of {}", layoutOf(table).path, first, count, rows(table));
  std::string out;
  while (out.size() < count) {
    const RecordingBlock& in = blockAt(table, first + out.size());
    const std::uint64_t from = first + out.size() - in.first;
    const std::uint64_t length = std::min(count - out.size(), in.count - from);
    out.append(reinterpret_cast<const char*>(in.bytes.data()) + from, length);
  }
  return out;
}

}  // namespace fyd::recording
