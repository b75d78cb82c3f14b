#include "core/export/export_mcap_schemas.h"

#include <nlohmann/json.hpp>

#include "core/recording/recording_types.h"

namespace fyd::exports {
namespace {

using Json = nlohmann::ordered_json;

Json object(Json properties) { return {{"type", "object"}, {"properties", std::move(properties)}}; }

Json integer() { return {{"type", "integer"}, {"minimum", 0}}; }

Json text() { return {{"type", "string"}}; }

/// Seconds and nanoseconds since 1970, in the viewers' format.
Json stamp() {
  Json time = object({{"sec", integer()}, {"nsec", integer()}});
  time["title"] = "time";
  return time;
}

Json described(Json json, std::string_view unit, std::string_view help) {
  json["description"] = fmt::format("{}; unit {}", help, unit);
  return json;
}

}  // namespace

std::string telemetrySchema(std::span<const pipeline::TelemetryField* const> fields) {
  // No field is required: one without a number is left out.
  Json properties = Json::object();
  for (const pipeline::TelemetryField* field : fields) {
    properties[std::string(field->name)] = described({{"type", "number"}}, field->unit, field->help);
  }
  Json schema = object(std::move(properties));
  schema["title"] = "fyd.Telemetry";
  return schema.dump();
}

std::string linkSchema() {
  Json properties = Json::object();
  forEachField<recording::LinkRow>([&](auto, const auto& field) {
    using V = FieldValue<decltype(field), recording::LinkRow>;
    if constexpr (!std::is_same_v<V, Instant>)  // the instant is the message's own time
      properties[std::string(field.name)] =
          described(std::is_integral_v<V> ? integer() : Json{{"type", "number"}}, field.unit, field.help);
  });
  Json schema = object(std::move(properties));
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

}  // namespace fyd::exports
