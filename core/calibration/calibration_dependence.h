// Which calibrations rest on others, and whether one they rest on is newer.
//
// A new curve of a distance sensor moves what it reads of the untouched cloth, and a new line of the load cell moves
// its zero: the no-touch offsets taken before are wrong by as much. A stiffness map holds for the encoders, the load
// cell, the distance sensors and the cloth's calibration it was measured with. The camera's scale is one of the whole
// picture: its region of interest does not move it.
//
// Offsets and zero are also changed by a tare, which writes no record. So the record of what they rest on notes the
// value that it left behind (before and after alike); a value that is another one now was taken since.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/calibration/calibration_record.h"

namespace fyd::calibration {

/// A calibration that is newer than the values that rest on it.
struct NewerBasis {
  std::string procedure;
  int sensor = 0;  ///< as in the record
  friend bool operator==(const NewerBasis&, const NewerBasis&) = default;
};

/// The parts that rest on others.
[[nodiscard]] std::span<const std::string_view> dependentParts();

/// @param procedure of the part that is asked about, as "no-touch"; @param records oldest first
/// @return by which newer calibrations its values are out of date; none: they are not, or were never taken
[[nodiscard]] std::vector<NewerBasis> newerBases(std::span<const CalibrationRecord> records, std::string_view procedure,
                                                 std::span<const Parameter> parameters);

[[nodiscard]] Message nameOf(const NewerBasis& basis);  ///< "distance sensor 2"
/// What is wrong with a part that has a newer basis, and what to do: "taken with another curve: take it again".
[[nodiscard]] Message remedyOf(std::string_view procedure);
/// "taken with another curve: take it again (distance sensor 2, load cell)"; empty without a newer basis.
[[nodiscard]] Message describeBases(std::string_view procedure, std::span<const NewerBasis> bases);

/// Whether a tare may change the value without taking the calibration that it rests on out of force.
[[nodiscard]] bool isTared(std::string_view procedure, std::string_view parameter_id);

/// Whether the cloth was calibrated and its calibration is in force: what stands on an indentation can say whether that
/// was ever proven.
[[nodiscard]] bool clothProven(std::span<const CalibrationRecord> records, std::span<const Parameter> parameters);

/// What an accepted calibration leaves behind as it is, for its record.
[[nodiscard]] std::vector<AppliedChange> leftBehind(std::string_view procedure, std::span<const Parameter> parameters);

}  // namespace fyd::calibration
