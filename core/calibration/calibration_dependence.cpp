#include "core/calibration/calibration_dependence.h"

#include <algorithm>
#include <set>

#include "core/calibration/calibration_part.h"

namespace fyd::calibration {
namespace {

using Records = std::span<const CalibrationRecord>;

/// Place of the newest one; the number of records when there is none. @param sensor 0 or more; any: -1
std::size_t newest(Records records, std::string_view procedure, int sensor) {
  for (std::size_t i = records.size(); i-- > 0;) {
    if (records[i].procedure == procedure && (sensor < 0 || records[i].sensor == sensor)) return i;
  }
  return records.size();
}

bool isNewer(Records records, const Dependence& rests, std::size_t basis, std::span<const Parameter> parameters) {
  const CalibrationRecord& record = records[basis];
  if (!inForce(record, parameters)) return false;
  const std::size_t part = newest(records, rests.part, -1);
  const bool taken = part < records.size();
  if (taken && part > basis) return false;
  const auto note = std::ranges::find(record.changes, rests.tared, &AppliedChange::id);
  if (rests.tared.empty() || note == record.changes.end()) return taken && inForce(records[part], parameters);
  const Parameter* value = findParameter(parameters, rests.tared);
  return value != nullptr && sameValue(formatParameter(*value), note->after, record.sensor);
}

}  // namespace

std::vector<NewerBasis> newerBases(Records records, std::string_view procedure, std::span<const Parameter> parameters) {
  std::vector<NewerBasis> out;
  for (const Dependence& rests : dependences()) {
    if (rests.part != procedure) continue;
    std::set<int> sensors;
    for (const CalibrationRecord& each : records) {
      if (each.procedure == rests.basis) sensors.insert(each.sensor);
    }
    for (const int sensor : sensors) {
      const std::size_t basis = newest(records, rests.basis, sensor);
      if (isNewer(records, rests, basis, parameters)) out.push_back({std::string(rests.basis), sensor});
    }
  }
  return out;
}

Message describeBases(std::string_view procedure, std::span<const NewerBasis> bases) {
  if (bases.empty()) return {};
  std::vector<Message> names;
  for (const NewerBasis& each : bases) names.push_back(partName(each.procedure, each.sensor));
  return explained(remedyOf(procedure), listed(std::move(names)));
}

std::vector<AppliedChange> leftBehind(std::string_view procedure, std::span<const Parameter> parameters) {
  std::vector<AppliedChange> out;
  for (const Dependence& rests : dependences()) {
    if (rests.basis != procedure || rests.tared.empty()) continue;
    const Parameter* parameter = findParameter(parameters, rests.tared);
    if (parameter == nullptr) continue;
    const std::string value = formatParameter(*parameter);
    out.push_back({.id = std::string(rests.tared), .before = value, .after = value});
  }
  return out;
}

bool clothProven(std::span<const CalibrationRecord> records, std::span<const Parameter> parameters) {
  return std::ranges::any_of(records, [&](const CalibrationRecord& record) {
    return record.procedure == "cloth" && inForce(record, parameters);
  });
}

}  // namespace fyd::calibration
