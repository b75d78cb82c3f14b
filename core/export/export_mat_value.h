// MATLAB variables as owned values, over libmatio's.
#pragma once

#include <matio.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fyd::exports {

struct FreeMatValue {
  void operator()(matvar_t* value) const { Mat_VarFree(value); }
};
using MatValue = std::unique_ptr<matvar_t, FreeMatValue>;

/// Text as a row of characters, in MATLAB's UTF-16. Empty when out of memory, as all below.
[[nodiscard]] MatValue matText(const char* name, std::string_view utf8);
/// A column of numbers, copied.
[[nodiscard]] MatValue matColumn(const char* name, const std::vector<double>& values);
/// A column of numbers that stay where they are, until the value is written.
[[nodiscard]] MatValue matColumnInPlace(const char* name, const double* values, std::size_t count);
/// A column of texts.
[[nodiscard]] MatValue matTexts(const char* name, const std::vector<std::string>& texts);
/// A scalar struct; takes its fields.
[[nodiscard]] MatValue matStruct(const char* name, std::vector<std::pair<std::string, MatValue>> fields);

}  // namespace fyd::exports
