// Tables of numbers from CSV text (quoting and line ends by libcsv, numbers by std::from_chars).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace fyd {

struct CsvTable {
  std::vector<std::string> columns;
  std::vector<std::string> header;          ///< all columns of the file, in its order
  std::vector<std::vector<double>> values;  ///< one vector per column, all of the same length
  std::vector<std::size_t> lines;           ///< the file's line of each row, for messages

  [[nodiscard]] std::size_t rows() const { return lines.size(); }
};

/// What an empty field is: text that is no number, or NaN.
enum class EmptyField : std::uint8_t { refused, nan };

/// Reads the named columns, in that order, whatever their order in the file; other columns are ignored.
/// "nan" (any case) reads as NaN; the caller decides whether that is allowed.
/// @return an error with file and line for a named column that is missing or stands there twice, more than
/// kMostCsvColumns, text in a number, a short row, or no rows
[[nodiscard]] Result<CsvTable> parseCsv(std::string_view text, std::string_view source_name,
                                        const std::vector<std::string>& wanted, EmptyField empty = EmptyField::refused);

/// More are refused: each name is kept in memory, and a damaged file may be nothing but commas.
inline constexpr std::size_t kMostCsvColumns = 1000;

/// A larger file is refused: a table of measurements is shorter, and a device or a pipe may never end.
inline constexpr std::size_t kLargestCsv_bytes = std::size_t{256} << 20;

/// Of a table whose rows have times, from the first to the last.
/// @return an error when that is longer than `most_s`, as it is where milliseconds were taken for seconds
[[nodiscard]] Result<void> checkLength(double length_s, double most_s);

/// parseCsv on a file's contents.
[[nodiscard]] Result<CsvTable> readCsv(const std::string& path, const std::vector<std::string>& wanted,
                                       EmptyField empty = EmptyField::refused);

}  // namespace fyd
