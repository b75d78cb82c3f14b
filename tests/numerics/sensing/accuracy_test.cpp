// The errors the project promises, over labelled pictures and over the whole cloth. Speed is `fyd bench`'s matter.
#include <gtest/gtest.h>

#include "app/bench/parts/labelled_pictures.h"
#include "app/bench/parts/pressed_cloth.h"
#include "core/sensing/finger_detector.h"
#include "core/sensing/indentation.h"
#include "tests/sweep.h"

namespace fyd::sensing {
namespace {

TEST(FingerAccuracy, HoldsOverTwoThousandLabelledFrames) {
  constexpr int kFrames = 2000;
  bench::LabelledPictures frames(20);
  const FingerParameters p;
  FingerDetector detector(p);
  double squares = 0;
  int cut = 0;
  for (int i = 0; i < kFrames; ++i) {
    frames.next();
    const bench::FrameLabel& truth = frames.label();
    const FingerDetection found = detector.detect(frames.picture());
    const auto what = [&] {
      return fmt::format("frame {}: radius {:.1f}, noise {:.1f}, blur {:.1f}, contrast {:.2f}, gradient {:.2f}, {}", i,
                         truth.radius_px, truth.noise, truth.blur_px, truth.contrast, truth.gradient,
                         toString(found.reason));
    };
    ASSERT_TRUE(found.contact) << what();
    const double error =
        std::hypot((found.x_px - truth.x_px) * p.scale_x_mm_per_px, (found.y_px - truth.y_px) * p.scale_y_mm_per_px);
    ASSERT_LE(error, 0.5) << what();
    squares += error * error;
    const double area = found.area_px;
    ASSERT_NEAR(area / truth.area_px, 1.0, 0.03) << what();
    cut += truth.cut ? 1 : 0;
  }
  EXPECT_LE(std::sqrt(squares / kFrames), 0.15);
  EXPECT_GT(cut, 100);  // the pictures do contain fingers at the edge
}

TEST(IndentationAccuracy, HalvesTheThesisErrorOverTheWholeCloth) {
  double squares[2] = {0, 0};
  int samples[2] = {0, 0};
  std::uint64_t seed = 1;
  for (const double x : stepsTo(-43, 43.1, 10.75)) {
    for (const double y : stepsTo(-28, 28.1, 14)) {
      for (const double depth : {3.0, 8.0}) {
        ++seed;
        for (const auto mode : {IndentationMode::membrane, IndentationMode::thesis}) {
          bench::PressedClothOptions o;
          o.x_mm = x;
          o.y_mm = y;
          o.depth_mm = depth;
          o.seed = seed;
          bench::PressedCloth cloth(o);
          IndentationParameters p;
          p.mode = mode;
          IndentationEstimator estimator(p);
          for (int i = 0; i < 1500; ++i) {
            cloth.step();
            const IndentationEstimate e = estimator.step(cloth.now, cloth.ir, cloth.finger);
            if (cloth.sinceTouch_s() < 0.1) continue;
            ASSERT_TRUE(e.available);
            squares[static_cast<int>(mode)] += std::pow(e.indentation_mm - cloth.depth_mm, 2);
            ++samples[static_cast<int>(mode)];
          }
        }
      }
    }
  }
  const double membrane = std::sqrt(squares[0] / samples[0]);
  const double thesis = std::sqrt(squares[1] / samples[1]);
  EXPECT_LE(membrane, 0.5 * thesis) << membrane << " mm against " << thesis << " mm";
  EXPECT_LE(membrane, 1.0);
}

}  // namespace
}  // namespace fyd::sensing
