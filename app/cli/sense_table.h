// A table of raw readings, one press in each row: what `fyd sense` and `fyd calibrate cloth` read.
//
//   adc1,adc2,adc3,x_mm,y_mm,area_mm2,bridge_mV_per_V
//
// adc: 12-bit codes or means of them, a column for each of the profile's distance sensors. x, y and area: centroid and
// area of the contact patch on the cloth, perspective removed. An empty field, or nan, means none.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/csv.h"
#include "core/sensing/indentation.h"

namespace fyd::cli {

struct SenseTable {
  std::vector<std::vector<double>> codes;  ///< per row, one per sensor; NaN: none
  std::vector<double> x_mm;
  std::vector<double> y_mm;
  std::vector<double> area_mm2;  ///< NaN: none
  std::vector<double> bridge_mV_per_V;
  std::vector<std::size_t> lines;  ///< the file's line of each row
  CsvTable csv;                    ///< as read, for messages

  [[nodiscard]] std::size_t rows() const { return lines.size(); }
  [[nodiscard]] sensing::PressReading press(std::size_t row) const {
    return {.codes = codes[row], .x_mm = x_mm[row], .y_mm = y_mm[row], .area_mm2 = area_mm2[row]};
  }
};

/// Throws Failure with file and line for what cannot be read, and for an area below 0 or without end.
[[nodiscard]] SenseTable readSenseTable(const std::string& path, const sensing::IndentationParameters& parameters);

}  // namespace fyd::cli
