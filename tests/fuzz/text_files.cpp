// A text that a person writes, as a file or as an option, of any content: refused with a reason that names it, or
// within the promises of its header, usable, and the same after it was written and read again. The first byte selects
// the reader.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "core/base/csv.h"
#include "core/base/profile_text.h"
#include "core/calibration/calibration_record.h"
#include "core/catalogue/catalogue_address.h"
#include "core/catalogue/catalogue_text.h"
#include "core/device/robot/axis_map.h"
#include "core/device/touchpad/modbus_link.h"
#include "core/protocol/endpoint.h"
#include "core/sim/gesture_card.h"
#include "core/sim/network/network_emulator.h"
#include "core/sim/server/touchpad_fault.h"
#include "core/station/profile/tuning_presets.h"
#include "core/texture/felt/felt_plant.h"
#include "core/texture/felt/plant_sweep.h"
#include "core/texture/recording.h"
#include "core/texture/surface_model.h"
#include "tests/fuzz/fuzz.h"

using namespace fyd;

namespace {

constexpr std::string_view kName = "t.txt";

template <class T>
bool accepted(const Result<T>& read, std::string_view error_begins = kName) {
  if (!read) {
    const std::string text = read.error().text();
    fuzz::require(text.starts_with(error_begins) && text.size() > error_begins.size());
  }
  return read.has_value();
}

bool within(double value, double least, double most) { return value >= least && value <= most; }

void finger(const sim::FingerPath& path) {
  fuzz::require(std::isfinite(path.duration_s()));
  for (const double share : {0.0, 0.3, 0.7, 0.99, 1.0, 1.6}) {
    const sim::FingerState at = path.at(share * path.duration_s());
    fuzz::require(within(at.x_mm, -sim::kUsableHalfWidth_mm - 1e-9, sim::kUsableHalfWidth_mm + 1e-9));
    fuzz::require(within(at.y_mm, -sim::kUsableHalfDepth_mm - 1e-9, sim::kUsableHalfDepth_mm + 1e-9));
    fuzz::require(within(at.indentation_mm, 0.0, sim::kDeepestPress_mm + 1e-9));
  }
}

void gesture(std::string_view text) {
  const auto card = sim::parseGesture(text, kName);
  if (!accepted(card)) return;
  fuzz::require(sim::isGestureName(card->name) && card->rows.size() >= 2 && card->rows.front().time_s == 0.0);
  fuzz::require(within(card->speed, sim::kSlowestGesture, sim::kFastestGesture));
  for (std::size_t i = 1; i < card->rows.size(); ++i) {
    fuzz::require(card->rows[i].time_s > card->rows[i - 1].time_s);
  }
  finger(card->path());
  const auto written = sim::formatGesture(*card);
  fuzz::require(written && sim::isGestureCard(*written));
  const auto again = sim::parseGesture(*written, kName);
  fuzz::require(again && again->rows.size() == card->rows.size() && sim::formatGesture(*again).value() == *written);
  if (const auto part = sim::trimmed(*card, 0.2 * card->duration_s(), 0.8 * card->duration_s())) {
    fuzz::require(sim::formatGesture(*part).has_value());
    finger(part->path());
  }
}

void fingerTable(std::string_view text) {
  if (const auto path = sim::FingerPath::fromCsvText(text, std::string(kName)); accepted(path)) finger(*path);
}

void delayTrace(std::string_view text) {
  const auto trace = sim::parseDelayTrace(text, std::string(kName));
  if (!accepted(trace)) return;
  fuzz::require(!trace->delay_ms.empty() && (trace->t_s.empty() || trace->t_s.size() == trace->delay_ms.size()));
  for (std::size_t i = 1; i < trace->t_s.size(); ++i) fuzz::require(trace->t_s[i] > trace->t_s[i - 1]);
  const sim::NetworkSettings settings{.trace = *trace};
  fuzz::require(sim::checkNetwork(settings).has_value());
  sim::NetworkEmulator network(settings);
  for (const double now_s : {1.0, 1.001, 2.0, 1e3, 1e6}) {
    for (const Instant out : network.pass(100, instantAt(now_s)).out) {
      fuzz::require(out >= instantAt(now_s) && out <= instantAt(now_s + 60.001));
    }
  }
}

void csv(std::string_view text) {
  for (const EmptyField empty : {EmptyField::refused, EmptyField::nan}) {
    const auto table = parseCsv(text, kName, {"x", "y"}, empty);
    if (!accepted(table)) continue;
    fuzz::require(table->rows() > 0 && table->values.size() == 2 && table->header.size() <= kMostCsvColumns);
    for (const auto& column : table->values) fuzz::require(column.size() == table->rows());
    fuzz::require(table->lines.front() > 1 && std::ranges::is_sorted(table->lines));
    fuzz::require(table->lines.back() <=
                  static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return c == '\n' || c == '\r'; })) +
                      1);
  }
}

void sweep(std::string_view text) {
  const auto rows = texture::parseSweep(text, kName);
  if (!accepted(rows)) return;
  std::size_t count = 0;
  for (const texture::SweepPart& part : texture::partsOf(*rows)) {
    fuzz::require(!part.empty());
    count += part.size();
    for (const texture::SweepRow& row : part) {
      fuzz::require(row.part == part.front().part && std::isfinite(row.t_s) && std::isfinite(row.stretch_deg));
      for (std::size_t motor = 0; motor < texture::kFeltMotors; ++motor) {
        fuzz::require(std::isfinite(row.duty_percent[motor]));
        fuzz::require(within(row.encoder_counts[motor], 0, texture::kSweepCountsPerTurn - 1));
      }
    }
  }
  fuzz::require(count == rows->size());
}

void plant(std::string_view text) {
  auto read = texture::parsePlant(text, kName);
  if (!accepted(read)) return;
  for (const Parameter& each : bindParameters(*read)) fuzz::require(insideRange(each));
  fuzz::require(within(read->resonanceAt_Hz(60.0), 10.0, 400.0) && read->rollerAccelerationPerG_deg_s2() > 0.0);
  const auto again = texture::parsePlant(texture::formatPlant(*read), kName);
  fuzz::require(again && *again == *read);
}

void accelerations(std::string_view text) {
  constexpr double kMostSteps = 1e4;
  for (const double rate_Hz : {0.0, 1000.0}) {
    const auto recording = texture::parseRecording(text, kName, rate_Hz);
    if (!accepted(recording)) continue;
    fuzz::require(!recording->samples.empty() && recording->samples.front().taken == Instant{});
    fuzz::require(std::isfinite(recording->start_s) && recording->rate_Hz > 0.0 && std::isfinite(recording->rate_Hz));
    fuzz::require(std::ranges::is_sorted(recording->samples, {}, &texture::AccelerationSample::taken));
    const double span_s = toSeconds(recording->samples.back().taken.time_since_epoch());
    for (const double uniform_Hz : {recording->rate_Hz, 1000.0}) {
      if (span_s * uniform_Hz > kMostSteps) continue;
      const auto uniform = texture::makeUniform(*recording, uniform_Hz);
      if (!accepted(uniform, "")) continue;
      for (const texture::UniformStream::Step& step : uniform->steps) fuzz::require(step.acceleration_g.finite());
    }
  }
}

void surface(std::string_view text) {
  const auto model = texture::parseSurface(text, kName);
  if (!accepted(model)) return;
  fuzz::require(within(model->reference_speed_mm_s, 1, 1000) && within(model->reference_force_N, 0.01, 20));
  fuzz::require(within(model->speed_exponent, 0, 3) && within(model->force_exponent, 0, 3));
  fuzz::require(!model->bands.empty() && model->bands.size() <= texture::kMaximumBands);
  for (const texture::SurfaceBand& band : model->bands) {
    fuzz::require((band.wavelength_mm > 0.0) != (band.frequency_Hz > 0.0));
    fuzz::require(std::isfinite(band.wavelength_mm) && std::isfinite(band.frequency_Hz));
    fuzz::require(within(band.quality, 0.1, 100) && within(band.rms_g, 0.0, 1e3));
  }
  const std::string written = texture::formatSurface(*model);
  const auto again = texture::parseSurface(written, kName);
  fuzz::require(again && again->name == model->name && again->description == model->description);
  fuzz::require(again->bands.size() == model->bands.size() && texture::formatSurface(*again) == written);
}

void records(std::string_view text) {
  const auto list = calibration::parseRecords(text, kName);
  if (!accepted(list)) return;
  sensing::SensingParameters sensing;
  const std::vector<Parameter> parameters = bindParameters(sensing);
  for (const calibration::CalibrationRecord& record : *list) {
    fuzz::require(record.sensor >= 0 && record.sensor <= 8);
    (void)calibration::inForce(record, parameters);
    const auto age = calibration::ageOf(record, "2026-11-21", {});
    if (accepted(age, "'")) fuzz::require(age->days >= 0);
  }
  const std::string written = calibration::formatRecords(*list);
  const auto again = calibration::parseRecords(written, kName);
  fuzz::require(again && again->size() == list->size() && calibration::formatRecords(*again) == written);
}

void preset(std::string_view text) {
  static const station::Profile base;
  auto profile = station::parsePreset(text, kName, base);
  if (!accepted(profile)) return;
  for (const Parameter& each : bindParameters(*profile)) fuzz::require(insideRange(each));
  const std::string written = station::formatPreset(*profile);
  const auto again = station::parsePreset(written, kName, base);
  fuzz::require(again && station::formatPreset(*again) == written);
}

void profile(std::string_view text) {
  for (const ProfileEntry& entry : profileEntries(text)) fuzz::require(entry.id.find('.') != std::string::npos);
  station::Profile profile;
  const std::vector<Parameter> parameters = bindParameters(profile);
  if (!accepted(parseProfile(text, kName, parameters))) return;
  for (const Parameter& each : parameters) fuzz::require(insideRange(each));
  const std::string written = formatProfile(parameters);
  station::Profile again;
  const std::vector<Parameter> reread = bindParameters(again);
  fuzz::require(parseProfile(written, kName, reread) && formatProfile(reread) == written);
  fuzz::require(profileEntries(written).size() == parameters.size());
}

void axes(std::string_view text) {
  const auto map = device::parseAxisMap(text);
  if (!accepted(map, "axes \"")) return;
  const Vec3 back = map->toTouchpad(map->toBase({1.0, 2.0, 3.0}));
  fuzz::require(back.x == 1.0 && back.y == 2.0 && back.z == 3.0);
}

void endpoint(std::string_view text) {
  const auto read = protocol::parseEndpoint(text);
  if (!accepted(read, "address \"")) return;
  const auto again = protocol::parseEndpoint(protocol::toString(*read));
  fuzz::require(again && *again == *read);
}

void modbus(std::string_view text) {
  const auto read = device::parseModbusAddress(std::string(text));
  if (!accepted(read, "")) return;
  fuzz::require(read->serial.size() <= device::kLongestSerial);
  const auto again = device::parseModbusAddress(device::toString(*read));
  fuzz::require(again && device::toString(*again) == device::toString(*read));
}

void fault(std::string_view text) {
  const auto read = sim::parseTimedFault(text);
  if (!accepted(read, "")) return;
  fuzz::require(static_cast<std::size_t>(read->fault) < sim::kTouchpadFaultNames.size());
  fuzz::require(std::isfinite(read->at_s) && read->at_s >= 0.0 && read->for_s >= 0.0);
}

void utc(std::string_view text) {
  const auto span = catalogue::parseUtc(text);
  if (accepted(span, "time '")) fuzz::require(span->begin_ms >= 0 && span->end_ms > span->begin_ms);
}

void catalogueAddress(std::string_view text) {
  using Kind = catalogue::CatalogueAddress::Kind;
  const auto read = catalogue::parseCatalogueAddress(text);
  if (!accepted(read, "catalogue") || read->kind == Kind::none) return;
  const bool server = read->kind == Kind::postgresql;
  fuzz::require(!read->name.empty() && !read->key.empty() && (server || read->target.starts_with('/')));
  const auto again = catalogue::parseCatalogueAddress((server ? "postgresql:" : "sqlite:") + read->target);
  fuzz::require(again && again->kind == read->kind && again->name == read->name);
}

constexpr std::array<void (*)(std::string_view), 17> kReaders = {
    gesture, fingerTable, delayTrace, csv,      sweep,  plant, accelerations, surface,         records,
    preset,  profile,     axes,       endpoint, modbus, fault, utc,           catalogueAddress};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1 || size > 4096) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  kReaders[data[0] % kReaders.size()](text);
  return 0;
}
