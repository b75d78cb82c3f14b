// Telemetry as CSV text, for the export and for `fyd station --telemetry`.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/pipeline/telemetry.h"

namespace fyd::exports {

/// The fewest digits that read back equal; "nan", "inf", "-inf" where there is no number.
void appendNumber(std::string& line, double value);

/// In quotes where CSV demands it (comma, quote, line end).
void appendText(std::string& line, std::string_view text);

/// "force_N [N]": the column's name and unit.
[[nodiscard]] std::string columnTitle(const pipeline::TelemetryField& field);

/// The sample's fields with commas between them, after what `line` holds.
void appendRow(std::string& line, const pipeline::TelemetrySample& sample,
               std::span<const pipeline::TelemetryField* const> fields);

}  // namespace fyd::exports
