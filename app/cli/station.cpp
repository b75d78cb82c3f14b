// fyd station …
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <thread>

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "app/cli/parts/command.h"
#include "app/cli/parts/profile_options.h"
#include "app/cli/parts/telemetry_csv.h"
#include "core/base/end_signals.h"
#include "core/catalogue/catalogue.h"
#include "core/catalogue/catalogue_address.h"
#include "core/catalogue/catalogue_delivery.h"
#include "core/recording/format/recording_format.h"
#include "core/station/profile/option_words.h"
#include "core/station/station.h"
#include "core/station/station_sources.h"
#include "core/texture/felt/felt_level.h"

namespace fyd::cli {
namespace {

namespace words = station::words;

constexpr Duration kOwnEnd = std::chrono::milliseconds(250);  // in which a session that is not held up ends by itself

struct StationOptions {
  station::StationOptions station;
  ProfileOptions profile;
  double duration_s = 0.0;
  std::string telemetry;
  std::string touchpad;
  recording::RecordingRequest record;
  std::string catalogue;
  bool headless = false;
  bool simulate = false;
  bool json = false;
};

/// Summary of a session, from its telemetry.
struct SessionFigures {
  pipeline::TelemetrySample last;
  std::uint64_t samples = 0;
  std::uint64_t in_contact = 0;
  double pwm_abs_max = 0.0;
  // while Active
  double least_energy_mJ = pipeline::kNone;
  double most_withheld_mJ = pipeline::kNone;
  // and touched
  std::uint64_t felt_samples = 0;
  double felt_squares = 0.0;
  double duty_squares = 0.0;
  double dead = 0.0;
  double clipped = 0.0;
  void add(const pipeline::TelemetrySample& sample) {
    last = sample;
    ++samples;
    in_contact += sample.contact ? 1 : 0;
    pwm_abs_max = std::max(pwm_abs_max, std::abs(sample.vibration_duty_percent));
    if (sample.state != pipeline::SafetyState::active) return;
    least_energy_mJ = std::fmin(least_energy_mJ, sample.finger_energy_mJ);
    most_withheld_mJ = std::fmax(most_withheld_mJ, sample.coupling_withheld_mJ);
    if (!sample.contact) return;
    ++felt_samples;
    felt_squares += sample.felt_acceleration_g * sample.felt_acceleration_g;
    duty_squares += sample.vibration_duty_percent * sample.vibration_duty_percent;
    dead += sample.vibration_dead_share;
    clipped += sample.vibration_clipped_share;
  }
};

/// Arms once, when everything is first ready, and never again: re-arming is left to the operator. One that was refused,
/// because something went missing in that very step, did not arm.
class ArmOnce {
 public:
  void see(const pipeline::TelemetrySample& sample, station::Station& station) {
    using enum pipeline::SafetyState;
    // Of these states the way back to Ready leads over nothing: a Ready that is seen later was never Active.
    done_ = done_ || sample.state == active || sample.state == held || sample.state == stopped || endSignal() != 0;
    if (done_ || sample.state != ready || sample.step < judged_by_) return;
    if (!station.command({.action = pipeline::OperatorAction::arm})) return;
    // The step that is being made may have taken its commands before, the one after it takes this one: never two at once,
    // of which the second would arm what ended in between.
    judged_by_ = station.status().loop.steps + kTakenWithin;
  }

 private:
  static constexpr std::uint64_t kTakenWithin = 2;
  bool done_ = false;
  std::uint64_t judged_by_ = 0;  ///< the step that shows what became of the last arm
};

nlohmann::ordered_json recordingOf(const recording::RecorderStatus& status) {
  return {{"path", status.path},
          {"whole", status.state == recording::RecorderState::idle},
          {"problem", status.problem},
          {"seconds", status.seconds},
          {"samples", status.samples},
          {"lost", status.lost},
          {"bytes", status.bytes},
          {"bytes_per_s", status.bytes_per_s},
          {"minutes_left", jsonNumber(status.minutes_left)},
          {"pictures", status.pictures},
          {"pictures_lost", status.pictures_lost},
          {"commit_p99_ms", jsonNumber(status.commit_p99_ms)},
          {"processor_percent", status.processor_percent},
          {"differences", status.differences}};
}

/// What the finger feels of the texture, while it touches and the session is Active.
nlohmann::ordered_json vibrationOf(const SessionFigures& figures, bool identified,
                                   const station::SimulationTruth& truth) {
  const double count = figures.felt_samples == 0 ? pipeline::kNone : static_cast<double>(figures.felt_samples);
  const double felt_g = std::sqrt(figures.felt_squares / count);
  return {{"plant", identified ? "identified" : "not identified"},
          {"felt_g_rms", jsonNumber(felt_g)},
          {"felt_level_dB", jsonNumber(texture::feltLevel_dB(felt_g))},
          {"felt_g_rms_simulated", jsonNumber(truth.felt_g_rms)},
          {"duty_rms_percent", jsonNumber(std::sqrt(figures.duty_squares / count))},
          {"dead_share", jsonNumber(figures.dead / count)},
          {"clipped_share", jsonNumber(figures.clipped / count)}};
}

void reportStation(const StationOptions& options, const SessionFigures& figures, const station::Station& station) {
  const station::StationStatus status = station.status();
  const station::SimulationTruth truth = station.simulationTruth();
  const double contact =
      figures.samples == 0 ? 0.0 : static_cast<double>(figures.in_contact) / static_cast<double>(figures.samples);
  nlohmann::ordered_json json;
  json["state"] = pipeline::toString(figures.last.state);
  json["reason"] = figures.last.fault == pipeline::Fault::none ? "" : pipeline::toString(figures.last.fault);
  json["steps"] = status.loop.steps;
  json["missed_cycles"] = status.loop.missed_cycles;
  json["real_time"] = status.loop.real_time;
  json["lateness"] = status.loop.waits ? recording::kLatenessWaits : recording::kLatenessFault;
  json["waited_s"] = status.loop.waited_s;
  json["step_ns_p50"] = status.loop.step_ns_p50;
  json["step_ns_p99"] = status.loop.step_ns_p99;
  json["stiffness_target_N_per_mm"] = jsonNumber(figures.last.target_N_per_mm);
  json["stiffness_measured_N_per_mm"] = jsonNumber(figures.last.stiffness_N_per_mm);
  json["coupling"] =
      teleop::kTouchpadCouplingNames[static_cast<std::size_t>(options.station.profile.step.step.coupling)];
  json["robot_stiffness_N_per_mm"] = jsonNumber(figures.last.robot_stiffness_N_per_mm);
  json["least_finger_energy_mJ"] = jsonNumber(figures.least_energy_mJ);
  json["coupling_withheld_mJ"] = jsonNumber(figures.most_withheld_mJ);
  json["contact_fraction"] = contact;
  json["finger_error_mm_rms"] = jsonNumber(truth.finger_error_mm_rms);
  json["indentation_error_mm_rms"] = jsonNumber(truth.indentation_error_mm_rms);
  json["vibration"] = vibrationOf(figures, options.station.profile.step.texture.plant.identified, truth);
  json["touch_messages_sent"] = status.link.touches_sent;
  json["state_messages_received"] = status.link.states_received;
  json["refused_datagrams"] = status.link.refused;
  json["link_protocol"] = status.link.protocol;
  json["link_round_trip_ms"] = jsonNumber(status.link.figures.round_trip_ms);
  json["link_jitter_ms"] = jsonNumber(status.link.figures.jitter_ms);
  json["link_loss_percent"] = jsonNumber(status.link.figures.loss_percent);
  json["link_lost"] = status.link.figures.lost;
  json["scenes"] = protocol::kSceneCopies[static_cast<std::size_t>(status.link.scenes)];
  if (status.link.led) {
    json["predictor"] = status.link.led->predictor;
    json["prediction_error_mm"] = jsonNumber(status.link.led->error_mm);
    json["prediction_horizon_ms"] = jsonNumber(status.link.led->horizon_ms);
  }
  json["pwm_abs_max"] = figures.pwm_abs_max;
  json["telemetry_lost"] = station.telemetryLost();
  if (options.station.record) json["recording"] = recordingOf(station.recorderStatus());
  for (const device::DeviceReport& part : status.parts) {
    json["parts"].push_back({{"name", toString(part.part)},
                             {"description", part.description},
                             {"ok", part.ok},
                             {"problem", part.problem},
                             {"rate_hz", part.rate_hz},
                             {"age_ms", jsonNumber(part.age_ms)},
                             {"errors", part.errors}});
  }
  if (options.json) {
    printJson(json);
    return;
  }
  for (const auto& [key, value] : json.items()) {
    if (key != "parts") std::cout << fmt::format("{:<32} {}\n", key, textOf(value));
  }
  for (const device::DeviceReport& part : status.parts) {
    std::cout << fmt::format("{:<32} {}\n", toString(part.part),
                             part.ok ? part.description : about(part.description, part.problem));
  }
}

/// Files that its telemetry must not be written over.
std::vector<std::string> inputsOf(const StationOptions& options) {
  const std::string& record = options.record.path;
  return {record.empty() ? "" : record + recording::kPartialEnding,
          record,
          options.profile.file,
          options.station.finger_csv,
          options.station.camera,
          options.station.key_file,
          options.station.scene,
          options.station.surface};
}

void runStation(const StationOptions& options) {
  watchForEnd();  // before anything is recorded
  // Log to standard error: standard output carries only the result.
  spdlog::set_default_logger(spdlog::stderr_color_mt("fyd"));
  if (options.headless) spdlog::warn("--headless is not needed: this program never opens a window");
  std::unique_ptr<TelemetryCsv> csv;  // before anything is recorded
  if (!options.telemetry.empty()) csv = std::make_unique<TelemetryCsv>(options.telemetry, inputsOf(options));
  auto station = valueOrFail(station::Station::open(options.station));

  ArmOnce arm;
  SessionFigures figures;
  std::vector<pipeline::TelemetrySample> batch(1000);
  station->start();
  const Instant start = Clock::now();
  auto scenes = protocol::SceneCopies::none;
  bool told_unwritten = false;
  const auto drain = [&] {
    if (const auto now = station->status().link.scenes; now != std::exchange(scenes, now)) {
      spdlog::log(isWrong(now) ? spdlog::level::warn : spdlog::level::info, "{}", protocol::toString(now));
    }
    while (const std::size_t taken = station->takeTelemetry(batch)) {
      for (std::size_t i = 0; i < taken; ++i) {
        arm.see(batch[i], *station);
        figures.add(batch[i]);
        if (csv) csv->write(batch[i]);
      }
    }
    if (csv && !csv->problem().empty() && !std::exchange(told_unwritten, true)) {
      spdlog::warn("{}", csv->problem().text());
    }
    for (const station::Notice& notice : station->takeNotices()) {
      spdlog::info("{:9.3f} s  {}", toSeconds(notice.when - start), notice.message.text());
    }
  };
  // This thread may be held up for as long as whoever reads the telemetry likes: the motors do not wait for it.
  std::jthread stopper([&station](const std::stop_token& over) {
    while (endSignal() == 0 && !over.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    for (const Instant came = Clock::now(); Clock::now() - came < kOwnEnd && !over.stop_requested();) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    if (!over.stop_requested()) station->requestStop();
  });
  while (endSignal() == 0 && (options.duration_s <= 0.0 || toSeconds(Clock::now() - start) < options.duration_s)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    drain();
  }
  drain();
  const SessionFigures at_end = figures;
  station->requestStop();  // closing a recording on a slow disk takes seconds
  stopper.request_stop();
  if (station->recorderStatus().state == recording::RecorderState::recording) (void)station->stopRecording();
  if (csv) csv->flush();
  reportStation(options, at_end, *station);
  station->shutDown();
  // Told beside a recording that failed: a full disk fails both.
  const Message unwritten = csv ? csv->closed() : Message{};
  if (options.station.record) {
    const recording::RecorderStatus recorded = station->recorderStatus();
    const bool failed = recorded.state == recording::RecorderState::failed;
    // The recording is closed by now, on a disk that got full as well; a failed catalogue entry is only a warning.
    if (std::error_code none; !failed || std::filesystem::exists(options.station.record->path, none)) {
      const auto entered = catalogue::catalogueRecording(options.catalogue, options.station.record->path);
      if (!entered) spdlog::warn("catalogue: {}", entered.error().text());
    }
    if (failed) {
      const Message lost = say("recording: {}", recorded.problem);
      throw Failure(unwritten.empty() ? lost : verbatim(fmt::format("{}; {}", lost, unwritten)));
    }
  }
  if (!unwritten.empty()) throw Failure(unwritten);
}

}  // namespace

void add_station(CLI::App& app) {
  auto options = std::make_shared<StationOptions>();
  CLI::App* command = app.add_subcommand("station", "Run a session: touchpad, camera, haptic loop and robot link");
  command->add_flag("--headless", options->headless)->group("");  // hidden: kept for old command lines
  command->add_flag("--simulate", options->simulate, "The same as --touchpad simulated");
  command->add_option("--touchpad", options->touchpad, words::kTouchpad);
  command->add_option("--motors", options->station.motors, words::kMotors);
  command->add_option("--duration", options->duration_s, "Seconds; 0 runs until interrupted")
      ->check(numberFrom(0.0, 1e7));
  command->add_option("--finger", options->station.finger_csv, words::kFinger);
  command->add_option("--camera", options->station.camera, words::kCamera);
  command->add_option("--robot", options->station.robot, words::kRobot);
  command->add_option("--key", options->station.key_file, words::kKey);
  command->add_option("--scene", options->station.scene, words::kScene);
  command->add_option("--surface", options->station.surface, words::kSurface);
  options->profile.addTo(*command);
  command->add_option("--record", options->record.path, words::kRecord);
  command->add_option("--operator", options->record.operator_name, words::kOperator);
  command->add_option("--subject", options->record.subject, words::kSubject);
  command->add_option("--notes", options->record.notes, words::kNotes);
  command->add_option("--tag", options->record.tags, words::kTag)->allow_extra_args(false);
  command->add_option("--catalogue", options->catalogue, words::kCatalogue)
      ->check(goodFor(catalogue::parseCatalogueAddress));
  command->add_option("--telemetry", options->telemetry, "Write every step's sample to this CSV file");
  command->add_flag("--json", options->json, "Result as JSON");
  command->callback([options] {
    if (options->simulate && !options->touchpad.empty() && options->touchpad != "simulated") {
      throw UsageError(say("station: {}", words::contradiction(options->touchpad)));
    }
    if (!options->simulate && options->touchpad.empty() && options->profile.file.empty()) {
      throw UsageError(say("station: no touchpad is named: add --simulate, --touchpad or a --profile that names one"));
    }
    options->station.touchpad = options->simulate ? "simulated" : options->touchpad;
    if (!options->record.path.empty()) {
      options->station.record = options->record;
    } else if (!options->record.operator_name.empty() || !options->record.subject.empty() ||
               !options->record.notes.empty() || !options->record.tags.empty()) {
      throw UsageError(say("station: {}", phrase(words::kRecordMissing)));
    }
    if (const auto good = station::checkWords(options->station); !good) {
      throw UsageError(about("station", good.error().message));
    }
    options->station.profile = options->profile.load(ProfileOptions::Together::not_yet);  // it names the touchpad
    options->station.profile = options->profile.loadFor(station::touchpadOf(options->station));
    options->profile.warnOfOutdatedParts(options->station.profile);
    runStation(*options);
  });
}

}  // namespace fyd::cli
