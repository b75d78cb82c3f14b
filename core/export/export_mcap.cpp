// Everything of a recording to MCAP, for robotics viewers: JSON messages in the order of time on the channels
//   /telemetry  fyd.Telemetry              every step; a field that had no number is left out
//   /camera     foxglove.CompressedImage   the whole picture as JPEG, or the exact region as PNG
//   /log        foxglove.Log               events and notes
//   /link       fyd.Link                   the robot's link, once a second
// Times are nanoseconds since 1970: the recording's UTC start plus the station's clock.
#include <sodium.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iomanip>
#include <limits>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "core/base/codecs/codecs.h"
#include "core/export/export_csv_text.h"
#include "core/export/export_mcap_schemas.h"
#include "core/export/export_selection.h"
#include "core/export/export_words.h"
#include "core/export/mcap_writer.h"
#include "core/recording/file/export_file.h"

namespace fyd::exports {
namespace {

using Json = nlohmann::ordered_json;

std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// 0 when the text is no ISO 8601 time that nanoseconds since 1970 can tell, until 2262: times then count from the
/// recording's start.
std::chrono::nanoseconds sinceEpoch(const std::string& utc) {
  std::tm parts{};
  std::istringstream text(utc);
  text >> std::get_time(&parts, "%Y-%m-%dT%H:%M:%S");
  if (!text) return {};
  double fraction_s = 0.0;
  if (text.peek() == '.') text >> fraction_s;
  constexpr std::time_t kEnd_s = std::numeric_limits<std::int64_t>::max() / 1'000'000'000;
  const std::time_t since_s = ::timegm(&parts);
  if (since_s < 0 || since_s >= kEnd_s || !(fraction_s < 1.0)) return {};
  return std::chrono::seconds(since_s) + fromSeconds(fraction_s);
}

/// Merges the other streams of a recording into the telemetry, in the order of time.
class McapExport {
 public:
  McapExport(const recording::Recording& recording, const ExportOptions& options, McapWriter& writer)
      : recording_(recording), options_(options), writer_(writer) {
    epoch_ = sinceEpoch(recording.info().header.started_utc);
  }

  Result<void> open(const ExportSelection& selection) {
    const recording::RecordingHeader& header = recording_.info().header;
    fields_ = selection.fields;
    auto done = writer_.start("FYD Console " FYD_VERSION);
    if (done) {
      done = writer_.metadata("recording", {{"id", cleanText(header.id)},
                                            {"started_utc", cleanText(header.started_utc)},
                                            {"operator", cleanText(header.operator_name)},
                                            {"subject", cleanText(header.subject)},
                                            {"notes", cleanText(header.notes)},
                                            {"version", cleanText(header.version)}});
    }
    if (done && !header.profile.empty()) {
      done = writer_.attachment("profile.toml", "application/toml", header.profile, nanoseconds(header.started));
    }
    if (!done) return done;
    const auto channel = [&](std::string_view topic, std::string_view schema, const std::string& text) {
      return writer_.addChannel(writer_.addSchema(schema, "jsonschema", text), topic, "json", {});
    };
    telemetry_ = channel("/telemetry", "fyd.Telemetry", telemetrySchema(fields_));
    camera_ = channel("/camera", "foxglove.CompressedImage", pictureSchema());
    log_ = channel("/log", "foxglove.Log", logSchema());
    link_ = channel("/link", "fyd.Link", linkSchema());

    auto lines = logLines(recording_, options_.from_s);
    if (!lines) return tl::unexpected(lines.error());
    lines_ = std::move(*lines);
    auto rows = recording_.linkRows();
    if (!rows) return tl::unexpected(rows.error());
    link_rows_ = std::move(*rows);
    const auto picture = pictureIndexAt(recording_, options_.from_s);
    if (!picture) return tl::unexpected(picture.error());
    next_picture_ = *picture;
    return readPicture();
  }

  Result<void> rows(std::span<const pipeline::TelemetrySample> rows) {
    for (const pipeline::TelemetrySample& row : rows) {
      if (auto done = othersUntil(secondsInto(recording_.info(), row.now)); !done) return done;
      text_.assign(1, '{');
      for (const pipeline::TelemetryField* field : fields_) {
        const double value = field->read(row);
        if (!std::isfinite(value)) continue;  // JSON has no NaN, and null is no number to a viewer
        if (text_.size() > 1) text_ += ',';
        text_ += '"';
        text_ += field->name;
        text_ += "\":";
        appendNumber(text_, value);
      }
      text_ += '}';
      if (auto done = writer_.message(telemetry_, nanoseconds(row.now), text_); !done) return done;
    }
    return {};
  }

  /// Pictures, log and link up to and including `time_s`, oldest first.
  Result<void> othersUntil(double time_s) {
    const double none = std::numeric_limits<double>::infinity();
    while (true) {
      const double picture_s = picture_ ? picture_->time_s : none;
      const double log_s = next_line_ < lines_.size() ? lines_[next_line_].time_s : none;
      const double link_s =
          next_link_ < link_rows_.size() ? secondsInto(recording_.info(), link_rows_[next_link_].when) : none;
      const double next_s = std::min({picture_s, log_s, link_s});
      if (next_s == none || next_s > time_s) return {};
      Result<void> done;
      if (next_s == log_s) {
        done = logMessage(lines_[next_line_++]);
      } else if (next_s == link_s) {
        done = linkMessage(link_rows_[next_link_++]);
      } else {
        done = pictureMessage();
      }
      if (!done) return done;
    }
  }

  [[nodiscard]] std::uint64_t pictures() const { return pictures_; }
  [[nodiscard]] std::uint64_t lines() const { return lines_written_; }

 private:
  [[nodiscard]] std::uint64_t nanoseconds(Instant when) const {
    const Duration started = recording_.info().header.started.time_since_epoch();
    return bounded(recording::WideTime{epoch_.count()} + when.time_since_epoch().count() - started.count());
  }
  [[nodiscard]] std::uint64_t nanosecondsInto(double time_s) const {
    return bounded(recording::WideTime{epoch_.count()} + fromSeconds(time_s).count());
  }
  static std::uint64_t bounded(recording::WideTime time_ns) {
    return static_cast<std::uint64_t>(
        std::clamp<recording::WideTime>(time_ns, 0, std::numeric_limits<std::int64_t>::max()));
  }
  static Json stamp(std::uint64_t time_ns) {
    return {{"sec", time_ns / 1'000'000'000}, {"nsec", time_ns % 1'000'000'000}};
  }

  Result<void> readPicture() {
    picture_.reset();
    if (next_picture_ >= recording_.info().frames) return {};
    auto picture = recording_.picture(next_picture_++);
    if (!picture) return tl::unexpected(picture.error());
    picture_ = std::move(*picture);
    return {};
  }

  Result<void> pictureMessage() {
    const cv::Mat& pixels = options_.region ? picture_->region : picture_->whole;
    if (!pixels.empty() && inRange(options_, picture_->time_s)) {
      std::vector<std::uint8_t> coded;
      const bool ok = options_.region ? codecs::encodePicture(".png", pixels, coded)
                                      : codecs::encodePicture(".jpg", pixels, coded, {cv::IMWRITE_JPEG_QUALITY, 95});
      if (!ok) return fail("picture {} cannot be coded", picture_->number);
      std::string data(sodium_base64_encoded_len(coded.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
      sodium_bin2base64(data.data(), data.size(), coded.data(), coded.size(), sodium_base64_VARIANT_ORIGINAL);
      data.pop_back();  // its closing zero
      const std::uint64_t time_ns = nanosecondsInto(picture_->time_s);
      const Json json = {{"timestamp", stamp(time_ns)},
                         {"frame_id", "camera"},
                         {"data", data},
                         {"format", options_.region ? "png" : "jpeg"}};
      if (auto done = writer_.message(camera_, time_ns, dump(json)); !done) return done;
      ++pictures_;
    }
    return readPicture();
  }

  Result<void> logMessage(const LogLine& line) {
    if (!inRange(options_, line.time_s)) return {};
    constexpr int kInfo = 2;
    constexpr int kWarning = 3;
    const std::uint64_t time_ns = nanosecondsInto(line.time_s);
    const Json json = {{"timestamp", stamp(time_ns)},
                       {"level", line.weight == LogWeight::serious ? kWarning : kInfo},
                       {"message", fmt::format("{}: {}", line.kind, line.text)},
                       {"name", "session"},
                       {"file", ""},
                       {"line", 0}};
    ++lines_written_;
    return writer_.message(log_, time_ns, dump(json));
  }

  Result<void> linkMessage(const recording::LinkRow& row) {
    if (!inRange(options_, secondsInto(recording_.info(), row.when))) return {};
    Json json = Json::object();
    forEachField<recording::LinkRow>([&](auto, const auto& field) {
      using V = FieldValue<decltype(field), recording::LinkRow>;
      if constexpr (std::is_integral_v<V>) {
        json[std::string(field.name)] = field.of(row);
      } else if constexpr (std::is_floating_point_v<V>) {
        if (std::isfinite(field.of(row))) json[std::string(field.name)] = field.of(row);
      }
    });
    return writer_.message(link_, nanoseconds(row.when), dump(json));
  }

  const recording::Recording& recording_;
  const ExportOptions& options_;
  McapWriter& writer_;
  std::chrono::nanoseconds epoch_{};
  std::vector<const pipeline::TelemetryField*> fields_;
  std::uint16_t telemetry_ = 0, camera_ = 0, log_ = 0, link_ = 0;
  std::optional<recording::RecordedPicture> picture_;  ///< the next to write
  std::uint64_t next_picture_ = 0;
  std::vector<LogLine> lines_;
  std::size_t next_line_ = 0;
  std::vector<recording::LinkRow> link_rows_;
  std::size_t next_link_ = 0;
  std::string text_;
  std::uint64_t pictures_ = 0;
  std::uint64_t lines_written_ = 0;
};

}  // namespace

Result<ExportResult> exportMcap(const recording::Recording& recording, const std::string& path,
                                const ExportOptions& options) {
  const auto selection = selectSomeRows(recording, options);
  if (!selection) return tl::unexpected(selection.error());
  auto file = recording::ExportFile::create(path, options.replace);
  if (!file) return tl::unexpected(file.error());
  McapWriter writer([&](std::string_view bytes) { return file->write(bytes); });
  McapExport out(recording, options, writer);
  auto done = out.open(*selection);
  if (done) {
    done = forEachBlock(recording, *selection,
                        [&](std::span<const pipeline::TelemetrySample> rows) { return out.rows(rows); });
  }
  if (done) done = out.othersUntil(options.to_s);
  if (done) done = writer.finish();
  if (done) done = file->commit();
  if (!done) return tl::unexpected(done.error());
  return ExportResult{.files = {path},
                      .rows = selection->end - selection->first,
                      .pictures = out.pictures(),
                      .lines = out.lines(),
                      .messages = writer.messages()};
}

}  // namespace fyd::exports
