#include "core/session/export_mcap_schemas.h"

#include <nlohmann/json.hpp>

namespace fyd::session {
namespace {

using Json = nlohmann::ordered_json;

Json object(Json properties) { return {{"type", "object"}, {"properties", std::move(properties)}}; }

Json integer() { return {{"type", "integer"}, {"minimum", 0}}; }

Json text() { return {{"type", "string"}}; }

/// Seconds and nanoseconds since 1970, the way those viewers have it.
Json stamp() {
  Json time = object({{"sec", integer()}, {"nsec", integer()}});
  time["title"] = "time";
  return time;
}

}  // namespace

std::string telemetrySchema(std::span<const pipeline::TelemetryField* const> fields) {
  // No field is required: one without a number is left out.
  Json properties = Json::object();
  for (const pipeline::TelemetryField* field : fields) {
    properties[std::string(field->name)] = {{"type", "number"}, {"description", "unit " + std::string(field->unit)}};
  }
  Json schema = object(std::move(properties));
  schema["title"] = "fyd.Telemetry";
  return schema.dump();
}

std::string linkSchema() {
  const auto number = [](const char* unit) {
    return Json{{"type", "number"}, {"description", std::string("unit ") + unit}};
  };
  Json schema = object({{"states_received", integer()},
                        {"touches_sent", integer()},
                        {"refused", integer()},
                        {"round_trip_ms", number("ms")},
                        {"jitter_ms", number("ms")},
                        {"loss_percent", number("%")}});
  schema["title"] = "fyd.Link";
  return schema.dump();
}

std::string pictureSchema() {
  Json data = text();
  data["contentEncoding"] = "base64";
  Json schema = object({{"timestamp", stamp()}, {"frame_id", text()}, {"data", data}, {"format", text()}});
  schema["title"] = "foxglove.CompressedImage";
  return schema.dump();
}

std::string logSchema() {
  Json schema = object({{"timestamp", stamp()},
                        {"level", integer()},
                        {"message", text()},
                        {"name", text()},
                        {"file", text()},
                        {"line", integer()}});
  schema["title"] = "foxglove.Log";
  return schema.dump();
}

}  // namespace fyd::session
