#include "core/session/recording_telemetry_row.h"

#include <cstring>

namespace fyd::session {

using pipeline::TelemetrySample;

TelemetryRow rowOf(const TelemetrySample& s) {
  TelemetryRow row;
  row.now_ns = s.now.time_since_epoch().count();
  row.t_s = toSeconds(s.now.time_since_epoch());
  row.step = s.step;
#define X(member) row.member = s.member;
  FYD_TELEMETRY_DOUBLES(X)
#undef X
#define X(member) row.member = static_cast<std::uint8_t>(s.member);
  FYD_TELEMETRY_BYTES(X)
#undef X
  return row;
}

TelemetrySample sampleOf(const TelemetryRow& row) {
  TelemetrySample s;
  s.now = Instant(Duration(row.now_ns));
  s.step = row.step;
#define X(member) s.member = row.member;
  FYD_TELEMETRY_DOUBLES(X)
#undef X
#define X(member) s.member = static_cast<decltype(s.member)>(row.member);
  FYD_TELEMETRY_BYTES(X)
#undef X
  return s;
}

double fieldOf(const TelemetryRow& row, std::size_t field) {
  const Column& column = layoutOf(Table::telemetry).columns[field + 1];  // the first is now_ns, no field
  const auto* at = reinterpret_cast<const std::byte*>(&row) + column.offset;
  if (column.type == ColumnType::u8) return static_cast<double>(std::to_integer<std::uint8_t>(*at));
  if (column.type == ColumnType::u64) {
    std::uint64_t value = 0;
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
  }
  double value = 0.0;
  std::memcpy(&value, at, sizeof value);
  return value;
}

}  // namespace fyd::session
