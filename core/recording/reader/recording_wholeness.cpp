#include "core/recording/reader/recording_wholeness.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace fyd::recording {
namespace {

/// Rows in the file after those of the last commit; no commit covers them.
std::vector<std::string> unprovenRows(const RecordingTables& tables, std::uint64_t& sum) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < kTableCount; ++i) {
    const auto table = static_cast<Table>(i);
    const std::uint64_t present = tables.present(table);
    const std::uint64_t proven = tables.rows(table);
    if (present <= proven) continue;
    sum += present - proven;
    words.push_back(fmt::format("{} {}", present - proven, layoutOf(table).path));
  }
  return words;
}

Message damageOf(const RecordingSource& source, const RecordingTables& tables, std::uint64_t& unproven_rows) {
  std::vector<Message> out;
  if (const std::uint64_t missing = source.missingBytes(); missing > 0)
    out.push_back(say("cut short: its last {} of {} bytes are missing", missing, source.bytes() + missing));
  if (const auto& damaged = tables.damagedCommits(); !damaged.empty())
    out.push_back(say("/commits: {} of {} rows are damaged, the first: row {}", damaged.size(), tables.commits(),
                      damaged.front()));
  if (const auto rows = unprovenRows(tables, unproven_rows); !rows.empty())
    out.push_back(say("rows at its end that no sound commit proves: {}", fmt::join(rows, ", ")));
  return listed(std::move(out));
}

}  // namespace

std::uint64_t goneSteps(const RecordingHeader& header) {
  std::uint64_t sum = 0;
  for (const MissingRows& rows : header.missing)
    if (rows.table == layoutOf(Table::telemetry).path) sum = sum + rows.count < sum ? ~0ULL : sum + rows.count;
  return sum;
}

void judge(const RecordingSource& source, const RecordingTables& tables, RecordingInfo& info) {
  const CommitRow& last = tables.last();
  info.committed_samples = tables.rows(Table::telemetry);
  info.samples = tables.present(Table::telemetry);
  info.frames = tables.rows(Table::pictures);
  info.events = tables.rows(Table::events);
  // Steps lost by the ring, or by a recovery, also count as a jump once a step follows.
  info.gaps = std::max({last.jumped, last.lost, goneSteps(info.header)});
  info.unproven_rows = 0;
  info.damage = {};
  if (source.growing()) {
    info.wholeness = last.closed != 0        ? Wholeness::whole
                     : source.recorderRuns() ? Wholeness::growing
                                             : Wholeness::crashed;
    return;
  }
  info.damage = damageOf(source, tables, info.unproven_rows);
  info.wholeness = !info.damage.empty()                          ? Wholeness::damaged
                   : last.closed == 0 || source.journalPending() ? Wholeness::crashed
                                                                 : Wholeness::whole;
}

}  // namespace fyd::recording
