// The last seconds in memory: what a recording that starts now writes first, and what waits while the disk is slow.
// Steps lie packed in chunks of a second, each with the step's state before its first row; a recording starts at the
// start of a chunk, so that a replay can begin there.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/parameters.h"
#include "core/recording/packed_step.h"

namespace fyd::recording {

/// What a replay needs before the first row of a chunk.
struct StepSnapshot {
  std::string state;  ///< Pipeline::saveState; empty: not known, no replay is possible from here
  pipeline::Parameters parameters;
};

/// Used by one thread (the recorder's).
class StepHistory {
 public:
  static constexpr std::size_t kStepsPerChunk = 1000;

  /// Whether the coming step begins a chunk: `snapshot` of `begin` is then wanted.
  [[nodiscard]] bool chunkIsDue() const { return chunks_.empty() || chunks_.back().count >= kStepsPerChunk; }
  void beginChunk(StepSnapshot snapshot);
  /// @param packed one step, of the chunk begun last
  void add(std::span<const std::byte> packed, Instant now);

  /// Drops whole chunks that ended before `oldest`; not chunks a reader has yet to read, unless there are more than
  ///  `most_chunks`. @return steps that were dropped before the reader had read them
  [[nodiscard]] std::uint64_t trim(Instant oldest, std::size_t most_chunks);

  /// Where a recording that starts now begins: the oldest chunk's snapshot. Nothing while there is no step.
  struct Start {
    Instant when{};
    const StepSnapshot* snapshot = nullptr;
  };
  [[nodiscard]] std::optional<Start> start() const;

  /// The one reader: from the oldest step on.
  void readFromStart();
  void stopReading() { reading_ = false; }
  /// @return false when everything was read
  [[nodiscard]] bool read(StepRecord& out);
  /// Steps the reader has yet to read.
  [[nodiscard]] std::uint64_t unread() const;

 private:
  struct Chunk {
    StepSnapshot snapshot;
    Instant first{};
    Instant last{};
    std::size_t count = 0;
    std::vector<std::byte> steps;
  };

  std::deque<Chunk> chunks_;
  std::uint64_t dropped_chunks_ = 0;  // number of the front one
  bool reading_ = false;
  std::uint64_t reader_chunk_ = 0;
  std::size_t reader_offset_ = 0;
  std::size_t reader_step_ = 0;
};

}  // namespace fyd::recording
