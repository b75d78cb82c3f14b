#include "core/recording/reader/recording_health.h"

#include <fmt/ranges.h>

#include <algorithm>

#include "core/recording/file/recording_header.h"
#include "core/recording/format/recording_format.h"

namespace fyd::recording {
namespace {

constexpr std::size_t kMostNamed = 5;  // columns in the one-line message; `info --json` lists all

/// What a replay needs of a step, or compares with.
constexpr std::uint32_t kReplayed = kInputsOfStep | bitOf(Table::steps) | bitOf(Table::motors);

/// Tables whose MissingRows are rows that are gone; in the other tables they are steps that are there.
constexpr std::uint32_t kLists =
    bitOf(Table::telemetry) | bitOf(Table::notes) | bitOf(Table::link) | bitOf(Table::pictures);

bool isOneOf(std::uint32_t tables, const std::string& path) { return (tables & bitOfPath(path)) != 0; }

/// What is missing of the recording, in words; empty: nothing.
Message missingOf(const RecordingInfo& info) {
  std::vector<Message> parts;
  if (info.gaps > 0) parts.push_back(say("{} steps were lost", info.gaps));
  for (const MissingRows& rows : info.header.missing) parts.push_back(wordsOf(rows));
  if (parts.size() > kMostNamed) {
    parts[kMostNamed] = say("and {} more", parts.size() - kMostNamed);
    parts.resize(kMostNamed + 1);
  }
  return listed(std::move(parts));
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
  if (const Message missing = missingOf(info); !missing.empty()) return {"gaps", missing};
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

}  // namespace fyd::recording
