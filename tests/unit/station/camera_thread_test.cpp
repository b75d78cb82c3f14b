// The camera thread with a fake camera.
#include "core/station/camera_thread.h"

#include <gtest/gtest.h>

namespace fyd::station {
namespace {

using sensing::FingerReason;

/// Pictures of one grey, fifty a second.
class FlatCamera final : public device::Camera {
 public:
  explicit FlatCamera(int grey) : grey_(grey) {}
  [[nodiscard]] Message description() const override { return verbatim("flat"); }
  [[nodiscard]] Message kind() const override { return verbatim("test"); }
  [[nodiscard]] bool live() const override { return true; }
  [[nodiscard]] Result<device::CameraFrame> next() override {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return device::CameraFrame{
        .picture = cv::Mat(240, 320, CV_8UC1, cv::Scalar::all(grey_)), .taken = Clock::now(), .number = ++number_};
  }

 private:
  int grey_;
  std::uint64_t number_ = 0;
};

FingerReason reasonOf(int grey, bool flat_cloth) {
  CameraThread thread(
      verbatim("flat"),
      [grey]() -> Result<std::unique_ptr<device::Camera>> { return std::make_unique<FlatCamera>(grey); }, {},
      device::DeviceParameters{.camera_flat_cloth = flat_cloth});
  thread.start();
  const Instant end = Clock::now() + std::chrono::seconds(30);
  while (thread.finger.read().count < 3 && Clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_GE(thread.finger.read().count, 3U) << "no picture in 30 s";
  return thread.finger.read().value.reason;
}

TEST(CameraThread, APictureOfOneGreyIsAnUntouchedClothOnlyWhereTheProfileSaysSo) {
  EXPECT_EQ(reasonOf(200, false), FingerReason::flat_picture);
  EXPECT_EQ(reasonOf(255, false), FingerReason::saturated);
  EXPECT_EQ(reasonOf(200, true), FingerReason::no_finger);
  EXPECT_EQ(reasonOf(255, true), FingerReason::no_finger);
  EXPECT_EQ(reasonOf(0, true), FingerReason::black_picture) << "no cloth is black";
}

}  // namespace
}  // namespace fyd::station
