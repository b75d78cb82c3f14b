#include "tests/soak/soak_disk.h"

#include <array>
#include <cerrno>
#include <filesystem>
#include <thread>

#include "core/base/profile_text.h"
#include "core/pipeline/parameters.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/reader/recording.h"
#include "core/recording/recovery/recover.h"
#include "core/recording/recovery/verify.h"

namespace fyd::soak {
namespace {

constexpr std::uint64_t kWaitEvery = 2000;  // steps: the recorder's ring holds more
constexpr std::chrono::seconds kPatience{120};

/// What goes wrong with it; without an error it is slow.
struct Trouble {
  const char* name;
  int error;
  bool only_syncs;
};
constexpr std::array<Trouble, 4> kTroubles = {{{"disk full", ENOSPC, false},
                                               {"disk write error", EIO, false},
                                               {"disk sync error", EIO, true},
                                               {"disk slow", 0, false}}};

recording::RecorderOptions options() {
  recording::RecorderOptions out;
  out.pre_trigger_s = 4.0;  // so many steps wait for a slow disk, three times over
  out.smallest_free_MB = 10.0;
  return out;
}

}  // namespace

int TroubledDisk::write(int file, std::span<const std::byte> bytes, std::uint64_t at) {
  if (const int error = trouble; error != 0 && !only_syncs) return error;
  return DiskCalls::write(file, bytes, at);
}

int TroubledDisk::sync(int file) {
  if (const int ms = slow_ms; ms > 0) std::this_thread::sleep_for(std::chrono::milliseconds(ms));
  if (const int error = trouble; error != 0) return error;
  return DiskCalls::sync(file);
}

int TroubledDisk::resize(int file, std::uint64_t bytes) {
  if (const int error = trouble; error != 0 && !only_syncs) return error;
  return DiskCalls::resize(file, bytes);
}

SoakDisk::SoakDisk(const pipeline::Parameters& parameters, std::string folder, Figures& figures)
    : folder_(std::move(folder)),
      figures_(figures),
      recorder_(options(), parameters, {}, {.touchpad = "soak", .camera = "soak", .robot = "soak"},
                {.profile =
                     [](const pipeline::Parameters& step) {
                       pipeline::Parameters copy = step;
                       return formatProfile(bindParameters(copy));
                     },
                 .link = {}}) {
  recorder_.writeThrough(disk_);
  recorder_.start();
}

SoakDisk::~SoakDisk() { recorder_.shutDown(); }

void SoakDisk::push(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs) {
  recorder_.push({.inputs = inputs, .outputs = outputs});
  if (++pushed_ % kWaitEvery == 0) waitForRecorder();
}

void SoakDisk::waitForRecorder() {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  // Steps wait for a slow disk in memory for a while, in the disk's time; here they come many times as fast.
  const auto behind = [&] {
    const recording::RecorderStatus status = recorder_.status();
    return status.taken < pushed_ ||
           (status.state == recording::RecorderState::recording && status.samples + kWaitEvery < pushed_ - begun_);
  };
  while (behind()) {
    if (std::chrono::steady_clock::now() > end) broken("the recorder does not take its steps");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const recording::RecorderStatus status = recorder_.status();
  if (status.lost != 0) broken(fmt::format("the recorder lost {} steps", status.lost));
  if (status.differences != 0) {
    broken(fmt::format("{} steps came out otherwise from their recorded inputs", status.differences));
  }
}

void SoakDisk::offer(const cv::Mat& picture, const sensing::FingerDetection& finger, Instant taken,
                     std::uint64_t number) {
  if (picture.empty()) return;
  recorder_.offerPicture(picture, cv::Rect(0, 0, std::min(40, picture.cols), std::min(30, picture.rows)), finger, taken,
                         number);
}

void SoakDisk::act(Chance& chance) {
  if (file_.empty()) return begin();
  const auto what = static_cast<std::size_t>(chance.below(7));
  if (what > kTroubles.size()) return end();
  if (what == kTroubles.size()) return void(recorder_.note(recording::NoteKind::note, "soak"));
  const Trouble& trouble = kTroubles[what];
  ++figures_.faults[trouble.name];
  if (trouble.error == 0) {
    disk_->slow_ms = 30;
  } else {
    disk_->only_syncs = trouble.only_syncs;
    disk_->trouble = trouble.error;
  }
}

void SoakDisk::nameFaults(Figures& figures) {
  for (const Trouble& trouble : kTroubles) figures.faults[trouble.name];
}

void SoakDisk::begin() {
  disk_->trouble = 0;
  disk_->slow_ms = 0;
  file_ = fmt::format("{}/{}.h5", folder_, ++files_);
  begun_ = pushed_;
  if (auto begun = recorder_.begin({.path = file_}); !begun) broken(begun.error().text());
}

void SoakDisk::end() {
  waitForRecorder();
  const bool troubled = disk_->trouble != 0;
  const auto closed = recorder_.end();
  const recording::RecorderStatus status = recorder_.status();
  disk_->trouble = 0;
  disk_->slow_ms = 0;
  if (closed) {
    checkWhole(file_, status.samples);
  } else {
    if (!troubled) broken(fmt::format("a healthy disk's recording did not close: {}", closed.error().text()));
    checkLeft(file_);
  }
  std::filesystem::remove(file_);
  file_.clear();
}

void SoakDisk::finish() {
  if (!file_.empty()) end();
}

void SoakDisk::checkWhole(const std::string& file, std::uint64_t samples) {
  const auto found = recording::Recording::open(file);
  if (!found) broken(fmt::format("a closed recording does not open: {}", found.error().text()));
  const recording::RecordingInfo& info = (*found)->info();
  if (info.wholeness != recording::Wholeness::whole || info.committed_samples != samples || info.gaps != 0) {
    broken(fmt::format("{}: wholeness {}, {} steps of {}, {} gaps", file, static_cast<int>(info.wholeness),
                       info.committed_samples, samples, info.gaps));
  }
  const auto checked = recording::verify(file);
  if (!checked || !checked->intact()) {
    broken(fmt::format("{}: {}", file, checked ? checked->first_damage.text() : checked.error().text()));
  }
  ++figures_.recordings;
  figures_.recorded_steps += samples;
}

void SoakDisk::checkLeft(const std::string& file) {
  const auto left = recording::Recording::open(recording::partialOf(file));
  if (!left) broken(fmt::format("what a failed disk left does not open: {}", left.error().text()));
  const std::uint64_t committed = (*left)->info().committed_samples;
  if ((*left)->info().wholeness == recording::Wholeness::damaged) {
    broken(fmt::format("what a failed disk left is damaged: {}", (*left)->info().damage.text()));
  }
  const auto outcome = recording::recover(file);
  if (!outcome) broken(fmt::format("{}: not recovered: {}", file, outcome.error().text()));
  if (outcome->result != recording::RecoverResult::whole || outcome->steps < committed) {
    broken(
        fmt::format("{}: recovered {} steps of {}: {}", file, outcome->steps, committed, outcome->first_damage.text()));
  }
  const auto checked = recording::verify(file);
  if (!checked || !checked->intact()) broken(fmt::format("{}: recovered, and not intact", file));
  ++figures_.failed_recordings;
  figures_.recorded_steps += outcome->steps;
}

}  // namespace fyd::soak
