// The counter-proof to every bound on what is believed: none of them fires on healthy devices. A session in virtual
// time, closed over the simulated touchpad with its own noise: readings through the registers' codec, the watches of
// the devices' threads and the pure step; pictures through the detector, one in ten also through a JPEG and back. The
// finger follows a recording after the other; the forces of recordings go through the load cell's line. Any complaint,
// any refused block or picture, any step outside Active ends it with exit code 1.
//
//   attack_healthy_day [HOURS] [FOLDER...]      full length: attack_healthy_day 24 and the folders of all recordings
//                                               (default: 0.24 h, tests/data)
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include <unistd.h>
#include <opencv2/imgcodecs.hpp>

#include "core/base/csv.h"
#include "core/base/units.h"
#include "core/device/camera/frozen_picture.h"
#include "core/device/camera/picture_decoder.h"
#include "core/device/touchpad/frozen_readings.h"
#include "core/device/touchpad/plausibility.h"
#include "core/pipeline/pipeline.h"
#include "core/protocol/registers/drive_state.h"
#include "core/protocol/registers/register_codec.h"
#include "core/sensing/finger_detector.h"
#include "core/sim/touchpad/simulated_camera.h"

namespace {

using namespace fyd;
namespace fs = std::filesystem;

[[noreturn]] void fired(const std::string& where, double hours, const std::string& what) {
  std::printf("%s, after %.4f h: %s\n", where.c_str(), hours, what.c_str());
  std::exit(1);
}

struct Recordings {
  std::vector<std::pair<std::string, sim::FingerPath>> fingers;
  std::vector<texture::AccelerationSample> accelerations;
  std::uint64_t forces = 0;
  double largest_force_N = 0.0;
};

/// Strokes on a plane have no height: pressed (8 mm, as FingerPath::fromCsv maps one height) while there is a finger.
Result<sim::FingerPath> strokes(const fs::path& path) {
  const auto table = readCsv(path.string(), {"t_s", "x_mm", "y_mm"});
  if (!table) return tl::unexpected(table.error());
  const fs::path with_height = fs::temp_directory_path() / fmt::format("fyd-strokes-{}.csv", ::getpid());
  {
    std::ofstream out(with_height);
    out << "t_s,x_mm,y_mm,z_mm\n";
    double last = -1.0;
    for (std::size_t row = 0; row < table->rows(); ++row) {
      if (!(table->values[0][row] > last)) continue;
      last = table->values[0][row];
      const bool there = std::isfinite(table->values[1][row]);
      out << fmt::format("{},{},{},{}\n", last, table->values[1][row], table->values[2][row], there ? "-5" : "nan");
    }
  }
  auto made = sim::FingerPath::fromCsv(with_height.string());
  fs::remove(with_height);
  return made;
}

/// A force on the cloth as the bridge gives it and the step takes it.
void checkForce(Recordings& out, const std::string& name, double force_N) {
  const sensing::LoadCell cell;
  const sensing::LoadCellParameters line;
  const double value = (std::abs(force_N) / kStandardGravity * 1e3 - line.offset_g) / line.slope_g_per_mV_per_V;
  if (!std::isfinite(cell.force_N(value))) fired(name, 0.0, fmt::format("{} N is beyond the load cell", force_N));
  ++out.forces;
  out.largest_force_N = std::max(out.largest_force_N, std::abs(force_N));
}

Recordings readAll(const std::vector<std::string>& folders) {
  Recordings out;
  std::set<fs::path> files;
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().extension() == ".csv") files.insert(entry.path());
    }
  }
  for (const fs::path& file : files) {
    const std::string name = file.parent_path().filename().string() + "/" + file.filename().string();
    if (auto hand = sim::FingerPath::fromCsv(file.string())) {
      out.fingers.emplace_back(name, std::move(*hand));
    } else if (auto drawn = strokes(file)) {
      out.fingers.emplace_back(name, std::move(*drawn));
    } else if (const auto forces = readCsv(file.string(), {"human_force_N", "environment_force_N"})) {
      for (const auto& column : forces->values) {
        for (const double force : column) checkForce(out, name, force);
      }
    } else if (const auto shaken = readCsv(file.string(), {"ax", "ay", "az"})) {
      for (std::size_t row = 0; row < shaken->rows(); ++row) {
        out.accelerations.push_back(
            {.acceleration_g = {shaken->values[0][row], shaken->values[1][row], shaken->values[2][row]}});
      }
    }
  }
  return out;
}

/// What the simulated device says, through its registers: by the page's own ranges nothing of it may be refused.
class Wire {
 public:
  device::TouchpadReadings carry(const device::TouchpadReadings& readings, Instant now, const std::string& where,
                                 double hours) {
    protocol::DeviceState state;
    state.status_word = statusBits(protocol::DriveState::operation_enabled) | protocol::status_bit::kRemote;
    state.bridge_mV_per_V = static_cast<float>(readings.bridge.value.value_mV_per_V);
    std::copy_n(readings.ir.value.begin(), state.ir.size(), state.ir.begin());
    state.motors = readings.motors.value;
    for (std::size_t i = 0; i < state.temperature_degC.size(); ++i) {  // as touchpad_electronics.cpp warms them
      const double settled = 23.0 + 75.0 * std::pow(readings.motors.value.current_mA[i] / 1e3, 2);
      warm_degC_[i] += (settled - warm_degC_[i]) * 0.001 / 40.0;
      state.temperature_degC[i] = warm_degC_[i];
    }
    protocol::DeviceState back;
    const auto problem = decode(encode(state), back);
    if (problem != protocol::StateProblem::none) fired(where, hours, describe(problem, back).text());
    if (readings.ir.count != ir_.count) {
      ir_.value = readings.ir.value;
      ir_.taken = readings.ir.taken;
      ir_.count = readings.ir.count;
    }
    if (readings.bridge.count != bridge_.count) {
      bridge_ = {{back.bridge_mV_per_V}, readings.bridge.taken, readings.bridge.count};
    }
    motors_.set(back.motors, now);
    return {.ir = ir_, .bridge = bridge_, .motors = motors_};
  }

 private:
  std::array<double, control::kMotorCount> warm_degC_ = {23.0, 23.0};
  Timed<sensing::IrCounts> ir_;
  Timed<sensing::BridgeReading> bridge_;
  Timed<control::MotorFeedback> motors_;
};

struct Counts {
  std::uint64_t steps = 0, ir = 0, bridge = 0, pictures = 0, jpegs = 0;
};

/// One session along one finger.
void session(const std::string& name, const sim::FingerPath& finger, const Recordings& recordings, double seconds,
             int seed, double begun_h, Counts& counts) {
  const Instant start = instantAt(1000.0);
  sim::SimParameters sim;
  sim.seed = seed;
  auto world = std::make_shared<sim::TouchpadWorld>(sim, finger, start);
  sim::SimulatedCamera camera(world);
  const pipeline::Parameters parameters;
  sensing::FingerDetector detector(parameters.sensing.finger);
  device::FrozenReadings frozen;
  device::Plausibility plausibility;
  device::FrozenPicture picture_watch(std::chrono::milliseconds(500));
  pipeline::Pipeline step{parameters};
  pipeline::Inputs inputs;
  inputs.robot.phase = pipeline::LinkPhase::running;
  control::MotorCommand command;
  Wire wire;
  Instant next_picture = start;
  const auto steps = static_cast<std::uint64_t>(seconds * 1e3);
  for (std::uint64_t i = 0; i < steps; ++i) {
    const Instant now = start + std::chrono::milliseconds(i + 1);
    const double hours = begun_h + static_cast<double>(i) / 3.6e6;
    world->advanceTo(now);
    const device::TouchpadReadings said = wire.carry(world->readings(), now, name, hours);
    const device::TouchpadReadings believed = plausibility.check(frozen.check(said), command, now);
    for (const std::string& complaint : {frozen.complaint().text(), plausibility.complaint().text()}) {
      if (!complaint.empty()) fired(name, hours, complaint);
    }
    counts.ir += believed.ir.count != inputs.ir.count ? 1 : 0;
    counts.bridge += believed.bridge.count != inputs.bridge.count ? 1 : 0;
    inputs.now = now;
    inputs.ir = believed.ir;
    inputs.bridge = believed.bridge;
    inputs.motors = believed.motors;
    if (now >= next_picture) {
      next_picture += fromSeconds(1.0 / sim.camera_rate_Hz);
      cv::Mat picture = camera.frameAt(now).picture;
      if (counts.pictures++ % 10 == 0) {
        std::vector<std::uint8_t> bytes;
        cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, 40 + static_cast<int>(counts.jpegs % 60)});
        auto decoded = device::decodeJpeg(bytes);
        if (!decoded) fired(name, hours, "a whole JPEG is refused: " + decoded.error().text());
        picture = std::move(*decoded);
        ++counts.jpegs;
      }
      if (!picture_watch.isNews(picture, now)) fired(name, hours, "a picture equal to the one before");
      inputs.finger.set(detector.detect(device::viewOf(picture)), now);
    }
    inputs.robot.state.set({.stiffness_N_per_mm = 0.51 + 0.2 * std::fabs(std::sin(1e-3 * static_cast<double>(i)))},
                           now);
    if (i % 10 == 0 && !recordings.accelerations.empty()) {
      auto sample = recordings.accelerations[i / 10 % recordings.accelerations.size()];
      sample.taken = now;
      (void)inputs.robot.accelerations.push(sample);
    }
    if (i == 500) (void)inputs.commands.push({.action = pipeline::OperatorAction::arm});
    const pipeline::Outputs& outputs = step.step(inputs);
    inputs.commands.clear();
    inputs.robot.accelerations.clear();
    command = outputs.motors;
    world->command(command);
    ++counts.steps;
    if (i > 500 && outputs.telemetry.state != pipeline::SafetyState::active) {
      fired(name, hours, fmt::format("{}: {}", toString(outputs.telemetry.state), toString(outputs.telemetry.fault)));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const double hours = argc > 1 ? std::atof(argv[1]) : 0.24;
  std::vector<std::string> folders(argv + std::min(argc, 2), argv + argc);
  if (folders.empty()) folders.emplace_back(FYD_TEST_DATA);
  Recordings recordings = readAll(folders);
  std::printf("%zu fingers, %llu forces up to %.2f N, %zu accelerations\n", recordings.fingers.size(),
              static_cast<unsigned long long>(recordings.forces), recordings.largest_force_N,
              recordings.accelerations.size());
  recordings.fingers.emplace_back("demonstration", sim::FingerPath::demonstration());
  recordings.fingers.emplace_back("untouched", sim::FingerPath::constant(0, 0, 0));
  recordings.fingers.emplace_back("held", sim::FingerPath::constant(3, -5, 6));
  Counts counts;
  double done_h = 0.0;
  // Every recording whole before any comes again.
  for (int round = 0; done_h < hours; ++round) {
    for (const auto& [name, finger] : recordings.fingers) {
      const double seconds =
          std::min(finger.duration_s() > 0.0 ? finger.duration_s() : 60.0, (hours - done_h) * 3600.0);
      if (seconds < 1.0) continue;
      session(name, finger, recordings, seconds, 1 + round, done_h, counts);
      done_h += seconds / 3600.0;
    }
    if (done_h * 3600.0 > hours * 3600.0 - 1.0) break;
  }
  std::printf(
      "%.4f h: %llu steps, %llu distance and %llu bridge readings, %llu pictures (%llu as JPEG): nothing fired\n",
      done_h, static_cast<unsigned long long>(counts.steps), static_cast<unsigned long long>(counts.ir),
      static_cast<unsigned long long>(counts.bridge), static_cast<unsigned long long>(counts.pictures),
      static_cast<unsigned long long>(counts.jpegs));
  return 0;
}
