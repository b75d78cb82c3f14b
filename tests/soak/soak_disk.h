// The recorder of a soak on a disk that gets full, fails or stands still; each recording is opened and checked at its end.
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "core/recording/file/recording_disk.h"
#include "core/recording/writer/recorder.h"
#include "tests/soak/soak.h"

namespace fyd::soak {

/// Refuses or delays what is asked of it while something is wrong with it.
class TroubledDisk final : public recording::DiskCalls {
 public:
  [[nodiscard]] int write(int file, std::span<const std::byte> bytes, std::uint64_t at) override;
  [[nodiscard]] int sync(int file) override;
  [[nodiscard]] int resize(int file, std::uint64_t bytes) override;
  std::atomic<int> trouble{0};  ///< an errno
  std::atomic<bool> only_syncs{false};
  std::atomic<int> slow_ms{0};
};

class SoakDisk {
 public:
  SoakDisk(const pipeline::Parameters& parameters, std::string folder, Figures& figures);
  ~SoakDisk();

  void push(const pipeline::Inputs& inputs, const pipeline::Outputs& outputs);
  void offer(const cv::Mat& picture, const sensing::FingerDetection& finger, Instant taken, std::uint64_t number);
  /// Begins, notes, troubles or ends, by chance.
  void act(Chance& chance);
  /// Every fault that it may begin, with a count of 0.
  static void nameFaults(Figures& figures);
  /// Ends and checks what is being recorded.
  void finish();

 private:
  void begin();
  void end();
  void waitForRecorder();
  void checkWhole(const std::string& file, std::uint64_t samples);
  void checkLeft(const std::string& file);

  std::string folder_;
  Figures& figures_;
  std::shared_ptr<TroubledDisk> disk_ = std::make_shared<TroubledDisk>();
  recording::Recorder recorder_;
  std::string file_;  ///< being recorded; empty: none
  std::uint64_t pushed_ = 0;
  std::uint64_t begun_ = 0;  // pushed before the recording
  int files_ = 0;
};

}  // namespace fyd::soak
