#include "core/session/recording_health.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "core/session/recording_format.h"
#include "core/session/recording_header.h"

namespace fyd::session {
namespace {

constexpr std::size_t kMostLacksTold = 5;  // one line of words; `info --json` lists all

/// What a replay needs of a step, or compares with.
constexpr std::uint32_t kReplayed = kInputsOfStep | bitOf(Table::steps) | bitOf(Table::motors);

/// Tables whose lost rows leave nothing behind: those of the others are steps that are there.
constexpr std::uint32_t kLists =
    bitOf(Table::telemetry) | bitOf(Table::notes) | bitOf(Table::link) | bitOf(Table::pictures);

bool isOneOf(std::uint32_t tables, const std::string& path) { return (tables & bitOfPath(path)) != 0; }

Message lacksOf(const RecordingInfo& info) {
  std::vector<Message> lacks;
  if (info.gaps > 0) lacks.push_back(say("{} steps were lost", info.gaps));
  for (const MissingRows& missing : info.header.missing) lacks.push_back(wordsOf(missing));
  if (lacks.size() > kMostLacksTold) {
    lacks[kMostLacksTold] = say("and {} more", lacks.size() - kMostLacksTold);
    lacks.resize(kMostLacksTold + 1);
  }
  return listed(std::move(lacks));
}

}  // namespace

Health healthOf(const RecordingInfo& info) {
  switch (info.wholeness) {
    case Wholeness::crashed: return {"damaged", say("its recorder is gone; make it whole with: fyd session recover")};
    case Wholeness::damaged:
      return {"damaged", say("{}; make what can be proven whole with: fyd session recover", info.damage)};
    case Wholeness::whole:
    case Wholeness::growing: break;
  }
  if (const Message lacks = lacksOf(info); !lacks.empty()) return {"gaps", lacks};
  if (info.wholeness == Wholeness::whole) return {"good", {}};
  return {"growing", info.samples == info.committed_samples
                         ? Message{}
                         : say("{} steps are not committed yet", info.samples - info.committed_samples)};
}

Message wordsOf(const MissingRows& missing) {
  if (missing.table == kHeaderTable) return say("any text of the header may be wrong: {}", missing.why);
  if (isOneOf(kLists, missing.table))
    return say("{} rows of {} are gone before its row {} ({})", missing.count, missing.table, missing.first,
               missing.why);
  return say("{} is lost for {} steps from row {} on ({})", missing.table, missing.count, missing.first, missing.why);
}

Message whyNoExactReplay(const RecordingInfo& info) {
  if (info.wholeness == Wholeness::damaged && info.unproven_rows > 0) return info.damage;
  for (const MissingRows& missing : info.header.missing)
    if (missing.table == kHeaderTable || isOneOf(kReplayed, missing.table)) return wordsOf(missing);
  return {};
}

}  // namespace fyd::session
