#include "core/recording/reader/recording_span.h"

namespace fyd::recording {
namespace {

constexpr std::size_t kTimeField = 0;  // telemetryFields()[0] is t_s

struct Extremes {
  MinMax value;
  double start_s = pipeline::kNone;  // smallest time
  void take(double low, double high, double time_s) {
    value.low = std::fmin(value.low, low);
    value.high = std::fmax(value.high, high);
    start_s = std::fmin(start_s, time_s);
  }
};

class SpanReader {
 public:
  SpanReader(const RecordingTables& tables, std::size_t field) : tables_(tables), field_(field) {}

  /// Rows [first, end) from `level` where its rows lie wholly inside, from finer ones at both edges; −1: single rows.
  void take(int level, std::uint64_t first, std::uint64_t end, Extremes& into) const {
    if (first >= end) return;
    if (level < 0) return takeRows(first, end, into);
    const Table table = kOverviewTables[static_cast<std::size_t>(level)];
    const std::uint64_t rows = kOverviewRows[static_cast<std::size_t>(level)];
    const std::uint64_t from = (first + rows - 1) / rows;
    const std::uint64_t to = std::min(end / rows, tables_.rows(table));
    if (from >= to) return take(level - 1, first, end, into);
    take(level - 1, first, from * rows, into);
    takeStored(table, from, to, into);
    take(level - 1, to * rows, end, into);
  }

 private:
  void takeRows(std::uint64_t first, std::uint64_t end, Extremes& into) const {
    const TableLayout& layout = layoutOf(Table::telemetry);
    while (first < end) {
      const auto block = tables_.block(Table::telemetry, first);
      for (; first < end && block->holds(first); ++first) {
        const std::byte* row = block->bytes.data() + (first - block->first) * layout.row_bytes;
        const double value = numberIn(row, telemetryColumn(field_));
        into.take(value, value, numberIn(row, telemetryColumn(kTimeField)));
      }
    }
  }

  void takeStored(Table table, std::uint64_t first, std::uint64_t end, Extremes& into) const {
    const std::size_t row_bytes = layoutOf(table).row_bytes;
    while (first < end) {
      const auto block = tables_.block(table, first);
      for (; first < end && block->holds(first); ++first) {
        const std::byte* row = block->bytes.data() + (first - block->first) * row_bytes;
        into.take(number(row, 2 * field_), number(row, 2 * field_ + 1), number(row, 2 * kTimeField));
      }
    }
  }

  static double number(const std::byte* row, std::size_t column) {
    double value = 0.0;
    std::memcpy(&value, row + column * sizeof value, sizeof value);
    return value;
  }

  const RecordingTables& tables_;
  std::size_t field_;
};

}  // namespace

std::uint64_t firstRowAt(const RecordingTables& tables, std::int64_t instant_ns) {
  const std::uint64_t rows = tables.rows(Table::telemetry);
  // A commit's latest_ns never falls, even when the clock did: the first commit that reaches the instant has the row.
  std::uint64_t low = 0;
  std::uint64_t high = tables.commits();
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    const CommitRow commit = tables.commit(middle);
    if (commit.rows[indexOf(Table::telemetry)] > 0 && commit.latest_ns >= instant_ns)
      high = middle;
    else
      low = middle + 1;
  }
  if (low == tables.commits()) return rows;
  std::uint64_t row = low == 0 ? 0 : tables.commit(low - 1).rows[indexOf(Table::telemetry)];
  while (row < rows && nanoseconds(tables.value<pipeline::TelemetrySample>(Table::telemetry, row).now) < instant_ns)
    ++row;
  return row;
}

Overview overviewOf(const RecordingTables& tables, Instant started, std::size_t field, std::uint64_t first,
                    std::uint64_t end, std::size_t buckets) {
  Overview overview;
  if (buckets == 0 || first >= end) return overview;
  buckets = std::min<std::uint64_t>(buckets, end - first);  // more would be empty, and their sum with the rows overflow
  std::size_t levels = 0;                                   // as many as are coarse enough; of these the last is read
  while (levels < kOverviewRows.size() && kOverviewRows[levels] <= (end - first) / buckets) ++levels;
  const int level = static_cast<int>(levels) - 1;
  // Buckets begin at multiples of the level's rows, so that only the two outermost touch finer levels.
  const std::uint64_t unit = level < 0 ? 1 : kOverviewRows[static_cast<std::size_t>(level)];
  const std::uint64_t origin = first / unit * unit;
  const std::uint64_t units = (end - origin + unit - 1) / unit;
  const std::uint64_t rows = (units + buckets - 1) / buckets * unit;
  const SpanReader reader(tables, field);
  const double started_s = toSeconds(started.time_since_epoch());
  for (std::uint64_t from = origin; from < end; from += rows) {
    Extremes extremes;
    reader.take(level, std::max(from, first), std::min(from + rows, end), extremes);
    overview.time_s.push_back(extremes.start_s - started_s);
    overview.values.push_back(extremes.value);
  }
  return overview;
}

}  // namespace fyd::recording
