// Small contacts: what the detector and the estimator make of a sphere's contacts as the simulated camera shows them,
// and what is none. The pictures are the simulator's or the labelled ones: neither shares a formula with the detector.
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "app/bench/parts/labelled_pictures.h"
#include "core/device/camera/camera.h"
#include "core/sensing/finger_detector.h"
#include "core/sensing/indentation.h"
#include "core/sim/touchpad/picture.h"
#include "tests/sweep.h"

namespace fyd::sensing {
namespace {

constexpr double kDepth_mm = 6.0;

/// Where an estimator in contact mode sees this press after a second, held: the sensors read what the estimator's own
/// cloth says of it, so that its depth is right and only the picture is tried.
Contact placeOf(const FingerDetection& seen, const Contact& truth, std::mt19937_64& random) {
  IndentationParameters p;
  p.mode = IndentationMode::contact;
  ContactCloth cloth(p);
  cloth.press(truth, kDepth_mm);
  const IrDistance curve;
  std::uniform_real_distribution<double> rest(0.0, 1.0);  // codes are whole: so that their mean is right
  IndentationEstimator estimator(p);
  Timed<IrCounts> ir;
  Timed<FingerDetection> finger;
  IndentationEstimate read;
  for (int i = 0; i < 60; ++i) {
    const Instant now = instantAt(10.0 + i / 60.0);
    IrCounts codes;
    for (std::size_t k = 0; k < 3; ++k) {
      const double code = curve.voltsAt(100.0 - cloth.share(k) * kDepth_mm) * kAdcCodes / kAdcReference_V;
      (void)codes.push(static_cast<std::uint16_t>(std::floor(code + rest(random))));
    }
    ir.set(codes, now);
    finger.set(seen, now);
    read = estimator.step(now, ir, finger);
  }
  EXPECT_NEAR(read.indentation_mm, kDepth_mm, 0.5) << truth.x_mm << ", " << truth.y_mm;
  return estimator.contactOf(seen);
}

TEST(SmallContacts, FromThePictureToPlaceAndAreaOnTheClothSixMillimetresDeep) {
  for (const double noise : {2.0, 6.0}) {
    sim::SimParameters simulated;
    simulated.cloth = sim::ClothKind::membrane;
    simulated.cloth_height_mm = 100.0;
    simulated.camera_noise = noise;
    const sim::PictureRenderer renderer(simulated);
    std::mt19937_64 random(3);
    FingerDetector detector;
    cv::Mat picture;
    for (const double area_mm2 : {12.0, 20.0, 35.0, 60.0, 100.0}) {
      double place = 0.0, area = 0.0, bias = 0.0;
      int count = 0;
      for (const double x : stepsTo(-40.0, 40.0, 10.3)) {
        for (const double y : stepsTo(-24.0, 24.0, 7.7)) {
          sim::WorldSnapshot world;
          world.finger = {.x_mm = x, .y_mm = y, .indentation_mm = kDepth_mm, .lifted = false};
          world.force_N = 3.0;
          world.contact_x_mm = x;
          world.contact_y_mm = y;
          world.contact_area_mm2 = area_mm2;
          renderer.render(world, random, picture);
          const FingerDetection seen = detector.detect(device::viewOf(picture));
          ASSERT_TRUE(seen.contact) << area_mm2 << " mm² at " << x << ", " << y << ": " << toString(seen.reason);
          const Contact found = placeOf(seen, {x, y, area_mm2}, random);
          place += std::pow(found.x_mm - x, 2) + std::pow(found.y_mm - y, 2);
          area += std::pow(found.area_mm2 / area_mm2 - 1.0, 2);
          bias += found.area_mm2 / area_mm2 - 1.0;
          ++count;
        }
      }
      std::printf("%3.0f mm², noise %.0f: place %.3f mm RMS, area %.1f %% RMS, %+.1f %% mean\n", area_mm2, noise,
                  std::sqrt(place / count), 100 * std::sqrt(area / count), 100 * bias / count);
      EXPECT_LE(std::sqrt(place / count), 0.05) << area_mm2;  // the project promises 0.3
      EXPECT_LE(std::sqrt(area / count), 0.03) << area_mm2;  // 2 % of 12 mm²: the simulated edge is symmetric in radius
    }
  }
}

TEST(SmallContacts, BlurDoesNotMakeThemLarger) {
  // 12 to 70 mm², blurred by up to 2 px: without what BlobMeter puts right the mean of the smallest is 17 % too large.
  double error[2] = {0, 0};
  int count[2] = {0, 0};
  for (const double radius_px : {4.2, 5.5, 10.0}) {
    bench::LabelledPictures frames(
        5, {.least_radius_px = 0.98 * radius_px, .most_radius_px = 1.02 * radius_px, .least_visible_px = 40.0});
    FingerDetector detector;
    double squares = 0.0, place = 0.0;
    int whole = 0;
    error[0] = error[1] = 0.0;
    count[0] = count[1] = 0;
    for (int i = 0; i < 1500; ++i) {
      frames.next();
      const bench::FrameLabel& truth = frames.label();
      const FingerDetection found = detector.detect(frames.picture());
      if (truth.cut) continue;
      ASSERT_TRUE(found.contact) << i;
      const double off = found.area_px / truth.area_px - 1.0;
      const int blurred = truth.blur_px > 1.5 ? 1 : 0;
      error[blurred] += off;
      ++count[blurred];
      squares += off * off;
      place += std::pow((found.x_px - truth.x_px) * 0.4545, 2) + std::pow((found.y_px - truth.y_px) * 0.4667, 2);
      ++whole;
    }
    ASSERT_GT(count[1], 100);
    EXPECT_LE(std::abs(error[0] / count[0]), 0.01) << radius_px;
    EXPECT_LE(std::abs(error[1] / count[1]), 0.03) << radius_px;
    EXPECT_LE(std::sqrt(squares / whole), 0.09) << radius_px;
    EXPECT_LE(std::sqrt(place / whole), 0.06) << radius_px;
  }
}

/// The untouched cloth, lit and noisy as said.
cv::Mat untouched(const sim::PictureRenderer& renderer, std::mt19937_64& random) {
  cv::Mat out;
  sim::WorldSnapshot world;
  world.finger.lifted = true;
  renderer.render(world, random, out);
  return out;
}

TEST(SmallContacts, NeitherNoiseNorDustIsATouch) {
  std::mt19937_64 random(7);
  for (const double light : {0.4, 1.0}) {
    for (const double gradient : {0.0, 0.4}) {
      sim::SimParameters simulated;
      simulated.camera_noise = 8.0;
      simulated.light = light;
      simulated.light_gradient = gradient;
      const sim::PictureRenderer renderer(simulated);
      FingerDetector detector;
      for (int i = 0; i < 500; ++i) {
        const cv::Mat picture = untouched(renderer, random);
        ASSERT_FALSE(detector.detect(device::viewOf(picture)).contact) << light << ' ' << gradient << ' ' << i;
      }
    }
  }
  // A speck of 1.5 mm, dark as a finger, is none; a contact of 3 mm is.
  const sim::PictureRenderer renderer{sim::SimParameters{}};
  std::uniform_real_distribution<double> place(0.0, 1.0);
  for (const double diameter_mm : {1.5, 3.0}) {
    int touches = 0;
    for (int i = 0; i < 100; ++i) {
      constexpr int kFine = 8;  // the speck is drawn this much larger
      const cv::Mat cloth = untouched(renderer, random);
      cv::Mat fine = cv::Mat::zeros(kFine * cloth.rows, kFine * cloth.cols, CV_32F);
      const double radius_px = diameter_mm / 2 / std::sqrt(sim::kMmPerPx_u * sim::kMmPerPx_v);
      cv::circle(
          fine,
          {static_cast<int>(kFine * (60 + 180 * place(random))), static_cast<int>(kFine * (60 + 110 * place(random)))},
          static_cast<int>(std::lround(kFine * radius_px)), 1.0, -1);
      cv::Mat speck, darkened;
      cv::resize(fine, speck, cloth.size(), 0, 0, cv::INTER_AREA);
      cv::GaussianBlur(speck, speck, {9, 9}, 0.8);
      cloth.convertTo(darkened, CV_32F);
      const cv::Mat left = 1.0 - 0.7 * speck;
      darkened = darkened.mul(left);
      darkened.convertTo(darkened, CV_8U);
      touches += FingerDetector().detect(device::viewOf(darkened)).contact ? 1 : 0;
    }
    EXPECT_EQ(touches, diameter_mm < 2.0 ? 0 : 100) << diameter_mm;
  }
}

TEST(SmallContacts, ThesisModeTellsItsAreaInTheCamerasScale) {
  FingerParameters p;
  p.mode = FingerMode::thesis;
  p.minimum_area_px = 20;
  cv::Mat picture(240, 320, CV_8UC1, cv::Scalar(255));
  picture(cv::Rect(100, 100, 22, 25)).setTo(60);  // 10 mm × 11.667 mm
  const FingerDetection found = FingerDetector(p).detect(device::viewOf(picture));
  ASSERT_TRUE(found.contact);
  EXPECT_NEAR(found.area_mm2, 22 * 25 * (100.0 / 220) * (70.0 / 150), 8.0);  // whole pixels of its smaller picture
  EXPECT_NEAR(found.area_px, found.area_mm2 / (100.0 * 70.0) * 160 * 120, 1e-6);
}

TEST(SmallContacts, APictureWithoutClothHasNoArea) {
  EXPECT_TRUE(std::isnan(FingerDetector().detect({}).area_mm2));
  const cv::Mat black(240, 320, CV_8UC1, cv::Scalar(0));
  EXPECT_TRUE(std::isnan(FingerDetector().detect(device::viewOf(black)).area_mm2));
  cv::Mat cloth(240, 320, CV_8UC1, cv::Scalar(200));
  cloth.at<std::uint8_t>(1, 1) = 199;
  cloth.at<std::uint8_t>(120, 120) = 199;
  EXPECT_EQ(FingerDetector().detect(device::viewOf(cloth)).area_mm2, 0.0);
}

}  // namespace
}  // namespace fyd::sensing
