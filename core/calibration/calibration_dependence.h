// Which calibrations rest on others, and whether one they rest on is newer.
//
// A new curve of a distance sensor changes its reading of the untouched cloth, and a new line of the load cell changes
// its zero: the no-touch offsets taken before are wrong by as much. A stiffness map holds for the encoders, the load
// cell, the distance sensors and the cloth's calibration it was measured with. The camera's scale is one of the whole
// picture: its region of interest does not move it.
//
// Offsets and zero are also changed by a tare, which writes no record. So the record of the calibration that they rest
// on also stores their value at that time (the same before and after); a value that differs from it was taken since.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/calibration/calibration_part.h"
#include "core/calibration/calibration_record.h"

namespace fyd::calibration {

/// A calibration that is newer than the values that rest on it.
struct NewerBasis {
  std::string procedure;
  int sensor = 0;  ///< as in the record
  friend bool operator==(const NewerBasis&, const NewerBasis&) = default;
};

/// @param procedure of the part that is asked about, as "no-touch"; @param records oldest first
/// @return by which newer calibrations its values are out of date; none: they are not, or were never taken
[[nodiscard]] std::vector<NewerBasis> newerBases(std::span<const CalibrationRecord> records, std::string_view procedure,
                                                 std::span<const Parameter> parameters);

/// "taken with another curve: take it again (Distance sensor 2, Load cell)"; empty without a newer basis.
[[nodiscard]] Message describeBases(std::string_view procedure, std::span<const NewerBasis> bases);

/// Whether the cloth was calibrated and its calibration is in force, which verifies the indentation that other
/// calibrations use.
[[nodiscard]] bool clothProven(std::span<const CalibrationRecord> records, std::span<const Parameter> parameters);

/// The dependent values that an accepted calibration leaves unchanged, for its record.
[[nodiscard]] std::vector<AppliedChange> leftBehind(std::string_view procedure, std::span<const Parameter> parameters);

}  // namespace fyd::calibration
