#include "core/recording/writer/step_history.h"

#include <utility>

namespace fyd::recording {

void StepHistory::beginChunk(StepSnapshot snapshot) {
  Chunk chunk;
  chunk.snapshot = std::move(snapshot);
  if (!chunks_.empty()) chunk.steps.reserve(chunks_.back().steps.size() + kLargestPackedStep);
  chunks_.push_back(std::move(chunk));
}

void StepHistory::add(std::span<const std::byte> packed, Instant now) {
  Chunk& chunk = chunks_.back();
  if (chunk.count == 0) chunk.first = now;
  chunk.last = now;
  chunk.steps.insert(chunk.steps.end(), packed.begin(), packed.end());
  ++chunk.count;
}

std::uint64_t StepHistory::trim(Instant oldest, std::size_t most_chunks) {
  std::uint64_t lost = 0;
  while (chunks_.size() > 1) {
    const bool over = chunks_.size() > most_chunks;
    const bool unread = reading_ && reader_chunk_ <= dropped_chunks_;
    if (!over && (unread || chunks_.front().last >= oldest)) break;
    if (unread) lost += chunks_.front().count - (reader_chunk_ == dropped_chunks_ ? reader_step_ : 0);
    chunks_.pop_front();
    ++dropped_chunks_;
  }
  return lost;
}

std::optional<StepHistory::Start> StepHistory::start() const {
  if (chunks_.empty() || chunks_.front().count == 0) return std::nullopt;
  return Start{.when = chunks_.front().first, .snapshot = &chunks_.front().snapshot};
}

void StepHistory::readFromStart() {
  reading_ = true;
  reader_chunk_ = dropped_chunks_;
  reader_offset_ = 0;
  reader_step_ = 0;
}

bool StepHistory::read(StepRecord& out) {
  if (!reading_) return false;
  if (reader_chunk_ < dropped_chunks_) {  // dropped because the disk was too slow for too long: the file shows a gap
    reader_chunk_ = dropped_chunks_;
    reader_offset_ = 0;
    reader_step_ = 0;
  }
  while (reader_chunk_ - dropped_chunks_ < chunks_.size()) {
    const Chunk& chunk = chunks_[reader_chunk_ - dropped_chunks_];
    if (reader_step_ < chunk.count) {
      const std::span<const std::byte> rest = std::span(chunk.steps).subspan(reader_offset_);
      unpackStep(rest, out);
      reader_offset_ += packedSize(rest);
      ++reader_step_;
      return true;
    }
    if (reader_chunk_ - dropped_chunks_ + 1 == chunks_.size()) return false;
    ++reader_chunk_;
    reader_offset_ = 0;
    reader_step_ = 0;
  }
  return false;
}

std::uint64_t StepHistory::unread() const {
  if (!reading_) return 0;
  std::uint64_t out = 0;
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    const std::uint64_t number = dropped_chunks_ + i;
    if (number < reader_chunk_) continue;
    out += chunks_[i].count - (number == reader_chunk_ ? reader_step_ : 0);
  }
  return out;
}

}  // namespace fyd::recording
