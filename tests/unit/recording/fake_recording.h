// A recording in memory, for tests of code that reads recordings: rows from a function, the rest from lists.
#pragma once

#include <algorithm>
#include <functional>
#include <utility>

#include "core/recording/reader/recording.h"

namespace fyd::recording {

class FakeRecording : public Recording {
 public:
  using Row = std::function<pipeline::TelemetrySample(std::uint64_t row)>;

  FakeRecording(std::uint64_t rows, Row row) : row_(std::move(row)) {
    info_.samples = info_.committed_samples = rows;
    info_.header.id = "0123456789abcdef0123456789abcdef";
    info_.header.started_utc = "2026-03-14T09:26:53.500Z";
    info_.header.started = instantAt(100.0);
    info_.header.version = "test";
    if (rows > 0) info_.duration_s = secondsInto(info_, row_(rows - 1).now);
  }

  /// A row `time_s` into a recording; NaN for other fields.
  static pipeline::TelemetrySample sampleAt(double time_s, std::uint64_t step) {
    pipeline::TelemetrySample sample;
    sample.now = instantAt(100.0 + time_s);
    sample.step = step;
    return sample;
  }

  RecordingInfo info_;
  std::vector<RecordedPicture> pictures_;
  std::vector<EventRow> events_;
  std::vector<Note> notes_;
  std::vector<LinkRow> link_rows_;
  mutable std::size_t largest_read_ = 0;  ///< rows asked for at once
  mutable std::string failure_;           ///< when set, reading rows fails with it

  const RecordingInfo& info() const override { return info_; }
  Result<bool> refresh() override { return false; }

  Result<void> telemetry(std::uint64_t first, std::span<pipeline::TelemetrySample> out) const override {
    if (!failure_.empty()) return fail(verbatim(failure_));
    largest_read_ = std::max(largest_read_, out.size());
    for (auto& sample : out) sample = row_(first++);
    return {};
  }
  Result<void> field(std::size_t field, std::uint64_t first, std::span<double> out) const override {
    if (!failure_.empty()) return fail(verbatim(failure_));
    for (double& value : out) value = pipeline::telemetryFields()[field].read(row_(first++));
    return {};
  }
  Result<StepRecord> step(std::uint64_t row) const override { return fail("row {}: no inputs here", row); }
  Result<std::uint64_t> rowAt(double time_s) const override {
    std::uint64_t low = 0;
    std::uint64_t high = info_.committed_samples;
    while (low < high) {
      const std::uint64_t middle = (low + high) / 2;
      const bool before =
          row_(middle).now < info_.header.started + fromSeconds(time_s);  // to the nanosecond, as in a file
      (before ? low : high) = middle + (before ? 1 : 0);
    }
    return low;
  }
  Result<Overview> overview(std::size_t field, double from_s, double to_s, std::size_t buckets) const override {
    Overview overview;
    const std::uint64_t first = *rowAt(from_s);
    const std::uint64_t rows = *rowAt(to_s) - first;
    const std::uint64_t per_bucket =
        std::max<std::uint64_t>(1, (rows + buckets - 1) / std::max<std::size_t>(buckets, 1));
    for (std::uint64_t i = 0; i < rows; ++i) {
      const pipeline::TelemetrySample sample = row_(first + i);
      if (i % per_bucket == 0) {
        overview.time_s.push_back(secondsInto(info_, sample.now));
        overview.values.push_back({});
      }
      const double value = pipeline::telemetryFields()[field].read(sample);
      MinMax& bucket = overview.values.back();
      bucket.low = std::fmin(bucket.low, value);
      bucket.high = std::fmax(bucket.high, value);
    }
    return overview;
  }
  Result<RecordedPicture> pictureAt(double time_s) const override {
    for (auto picture = pictures_.rbegin(); picture != pictures_.rend(); ++picture) {
      if (picture->time_s <= time_s) return *picture;
    }
    return fail("no picture at {} s", time_s);
  }
  Result<RecordedPicture> picture(std::uint64_t index) const override {
    if (index >= pictures_.size()) return fail("picture {}: there are {}", index, pictures_.size());
    return pictures_[static_cast<std::size_t>(index)];
  }
  Result<std::vector<EventRow>> events() const override { return events_; }
  Result<std::vector<Note>> notes() const override { return notes_; }
  Result<std::vector<LinkRow>> linkRows() const override { return link_rows_; }

 private:
  Row row_;
};

}  // namespace fyd::recording
