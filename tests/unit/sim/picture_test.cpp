// The simulated camera: geometry, lighting, noise and timing of its pictures.
#include "core/sim/touchpad/picture.h"

#include <thread>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/sim/touchpad/simulated_camera.h"

namespace fyd::sim {
namespace {

using namespace std::chrono_literals;

WorldSnapshot pressedAt(double x_mm, double y_mm, double force_N) {
  WorldSnapshot world;
  world.finger = {.x_mm = x_mm, .y_mm = y_mm, .indentation_mm = 2.0 * force_N, .lifted = force_N <= 0.0};
  world.force_N = force_N;
  return world;
}

cv::Mat draw(const SimParameters& parameters, const WorldSnapshot& world, std::uint64_t seed = 7) {
  std::mt19937_64 random(seed);
  cv::Mat picture;
  SimParameters ideal = parameters;
  ideal.cloth = ClothKind::ideal;
  PictureRenderer(ideal).render(world, random, picture);
  return picture;
}

struct ThesisFinger {
  int area_px = 0;
  double x_mm = 0.0;
  double y_mm = 0.0;
};

/// The printed detector, call by call [thesis §4.1.1], with one scale for each axis.
ThesisFinger thesisDetector(const cv::Mat& picture) {
  cv::Mat small;
  cv::resize(picture(cv::Rect(40, 45, 220, 150)), small, {160, 120});
  double darkest = 0.0;
  double brightest = 0.0;
  cv::minMaxLoc(small, &darkest, &brightest);
  const double sigma = (brightest - darkest) / 5.0;
  ThesisFinger finger;
  double weights = 0.0;
  double u = 0.0;
  double v = 0.0;
  for (int row = 0; row < 120; ++row) {
    for (int column = 0; column < 160; ++column) {
      const double grey = small.at<std::uint8_t>(row, column);
      if (grey >= 210.0) continue;
      ++finger.area_px;
      const double weight = std::exp(-(grey - darkest) * (grey - darkest) / (2.0 * sigma * sigma));
      weights += weight;
      u += weight * column;
      v += weight * row;
    }
  }
  if (finger.area_px == 0) return finger;
  finger.x_mm = (40.0 + (u / weights + 0.5) * 220.0 / 160.0 - 0.5 - 150.0) * 100.0 / 220.0;
  finger.y_mm = -(45.0 + (v / weights + 0.5) * 150.0 / 120.0 - 0.5 - 120.0) * 70.0 / 150.0;
  return finger;
}

TEST(Picture, GeometryIsThatOfTheRegionOfInterest) {
  EXPECT_EQ(pictureOf(0, 0).u_px, 150.0);
  EXPECT_EQ(pictureOf(0, 0).v_px, 120.0);
  EXPECT_DOUBLE_EQ(pictureOf(50, 35).u_px, 260.0);
  EXPECT_DOUBLE_EQ(pictureOf(50, 35).v_px, 45.0) << "back is up";
}

TEST(Picture, TheThesisDetectorFindsTheFingerEverywhereItFits) {
  double worst = 0.0;
  for (const double force : {0.1, 0.5, 2.0, 4.0}) {
    for (const double x : {-38.0, -12.3, 0.0, 25.7, 38.0}) {
      for (const double y : {-25.0, 0.0, 11.1, 25.0}) {
        const ThesisFinger found = thesisDetector(draw({}, pressedAt(x, y, force)));
        ASSERT_GT(found.area_px, 150) << force << " N at " << x << ", " << y;
        worst = std::max(worst, std::hypot(found.x_mm - x, found.y_mm - y));
      }
    }
  }
  RecordProperty("worst_error_mm", fmt::format("{:.3f}", worst));
  EXPECT_LT(worst, 0.3);
}

TEST(Picture, WithoutAFingerNoPixelOfTheRegionIsDark) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    EXPECT_EQ(thesisDetector(draw({}, pressedAt(0, 0, 0), seed)).area_px, 0);
  }
  SimParameters still;
  still.camera_noise = 0.0;
  const cv::Mat picture = draw(still, pressedAt(0, 0, 0));
  double darkest = 0.0;
  cv::minMaxLoc(picture(cv::Rect(40, 45, 220, 150)), &darkest);
  EXPECT_GE(darkest, 216.0);
  EXPECT_EQ(picture.at<std::uint8_t>(120, 160), 245);
  EXPECT_LT(picture.at<std::uint8_t>(0, 0), 200) << "the lens loses light at the corners";
}

TEST(Picture, TheSpotGrowsWithForce) {
  int last = 0;
  for (const double force : {0.05, 0.2, 0.8, 2.0, 5.0}) {
    const int area = thesisDetector(draw({}, pressedAt(0, 0, force))).area_px;
    EXPECT_GT(area, last) << force;
    last = area;
  }
  EXPECT_LT(last, 900);
}

TEST(Picture, LightNoiseAndGradientAreAsAsked) {
  SimParameters parameters;
  parameters.light = 0.0;
  parameters.camera_noise = 0.0;
  EXPECT_EQ(cv::countNonZero(draw(parameters, pressedAt(0, 0, 2.0))), 0) << "no light";
  parameters.light = 3.0;
  parameters.camera_vignette = 0.0;
  EXPECT_EQ(cv::countNonZero(draw(parameters, pressedAt(0, 0, 0.0)) != 255), 0) << "too much light";
  parameters.light = 0.5;
  parameters.camera_noise = 8.0;
  cv::Scalar mean;
  cv::Scalar sigma;
  cv::meanStdDev(draw(parameters, pressedAt(0, 0, 0.0)), mean, sigma);
  EXPECT_NEAR(mean[0], 122.5, 0.3);
  EXPECT_NEAR(sigma[0], 8.0, 0.3);
  parameters.camera_noise = 0.0;
  parameters.light_gradient = 0.4;
  const cv::Mat slanted = draw(parameters, pressedAt(0, 0, 0.0));
  EXPECT_NEAR(slanted.at<std::uint8_t>(0, 319) - slanted.at<std::uint8_t>(0, 0), 0.4 * 122.5, 1.0);
}

TEST(Picture, AnExtremeFingerIsDrawnInsideThePictureOnly) {
  SimParameters parameters;
  parameters.edge_softness_px = 20.0;
  for (const double x : {-1e6, -70.0, 70.0, 1e6}) {
    for (const double y : {-1e6, -60.0, 60.0, 1e6}) {
      EXPECT_EQ(draw(parameters, pressedAt(x, y, 50.0)).size(), cv::Size(320, 240));
    }
  }
}

TEST(Picture, IsTheSameForTheSameArgumentsAndOtherwiseNot) {
  const WorldSnapshot world = pressedAt(3, 4, 1);
  EXPECT_EQ(cv::countNonZero(draw({}, world, 1) != draw({}, world, 1)), 0);
  EXPECT_NE(cv::countNonZero(draw({}, world, 1) != draw({}, world, 2)), 0);
}

TEST(SimulatedCamera, ShowsTheWorldAtThePicturesOwnTime) {
  const Instant start = instantAt(5.0);
  SimParameters parameters;
  parameters.camera_delay_ms = 100.0;
  auto world = std::make_shared<TouchpadWorld>(parameters, FingerPath::demonstration(), start);
  SimulatedCamera camera(world);
  Instant now = start;
  while (now < start + 6400ms) world->advanceTo(now += 1ms);
  const device::CameraFrame frame = camera.frameAt(now);
  EXPECT_EQ(frame.number, 1U);
  EXPECT_EQ(frame.taken, now);
  const WorldSnapshot shown = world->truthAt(now - 100ms);
  EXPECT_NEAR(thesisDetector(frame.picture).x_mm, shown.finger.x_mm, 0.3);
  EXPECT_GT(std::abs(shown.finger.x_mm - world->truth().finger.x_mm), 2.0) << "the finger was moving";
}

TEST(SimulatedCamera, KeepsItsRateAndSkipsWhatABusyCallerMissed) {
  SimParameters parameters;
  parameters.camera_rate_Hz = 100.0;
  auto world = std::make_shared<TouchpadWorld>(parameters, FingerPath::constant(0, 0, 3), Clock::now());
  SimulatedCamera camera(world);
  Instant last{};
  for (int i = 0; i < 5; ++i) {
    const auto frame = camera.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->number, static_cast<std::uint64_t>(i) + 1);
    EXPECT_GT(frame->taken, last);
    last = frame->taken;
  }
  std::this_thread::sleep_for(60ms);
  const Instant before = Clock::now();
  ASSERT_TRUE(camera.next());
  ASSERT_TRUE(camera.next());
  EXPECT_GE(Clock::now() - before, 9ms) << "the missed ones are not made up for";
}

}  // namespace
}  // namespace fyd::sim
