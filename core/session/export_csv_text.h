// Telemetry as text in CSV: numbers of the export and of `fyd station --telemetry` are written here.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/pipeline/telemetry.h"

namespace fyd::session {

/// The fewest digits that read back equal; "nan", "inf", "-inf" where there is no number.
void appendNumber(std::string& line, double value);

/// In quotes where CSV wants it (comma, quote, line end).
void appendText(std::string& line, std::string_view text);

/// "force_N [N]": the column's name and unit.
[[nodiscard]] std::string columnTitle(const pipeline::TelemetryField& field);

/// The sample's fields with commas between them, after what `line` holds.
void appendRow(std::string& line, const pipeline::TelemetrySample& sample,
               std::span<const pipeline::TelemetryField* const> fields);

}  // namespace fyd::session
