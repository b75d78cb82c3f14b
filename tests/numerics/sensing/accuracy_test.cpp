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

struct Presses {
  sim::ClothKind cloth;
  double most_x_mm, most_y_mm, deep_mm;
  bool with_force;
};
// As far as it is solved (resources/cloths): the estimator knows nothing of how it was made.
constexpr Presses kSolved{sim::ClothKind::membrane, 41.5, 27.0, 7.5, true};
// Made with the estimator's own shape.
constexpr Presses kByTheFormula{sim::ClothKind::ideal, 43.0, 28.0, 8.0, false};

/// Root mean square error over the whole cloth, from 0.1 s after each touch.
double error_mm(const Presses& presses, IndentationMode mode) {
  double squares = 0.0;
  int samples = 0, unavailable = 0;
  std::uint64_t seed = 1;
  for (const double x : stepsTo(-presses.most_x_mm, presses.most_x_mm, presses.most_x_mm / 4.0)) {
    for (const double y : stepsTo(-presses.most_y_mm, presses.most_y_mm, presses.most_y_mm / 2.0)) {
      for (const double depth : {3.0, presses.deep_mm}) {
        bench::PressedClothOptions o;
        o.x_mm = x;
        o.y_mm = y;
        o.depth_mm = depth;
        o.cloth = presses.cloth;
        o.seed = ++seed;
        bench::PressedCloth cloth(o);
        IndentationParameters p;
        p.mode = mode;
        IndentationEstimator estimator(p);
        for (int i = 0; i < 1500; ++i) {
          cloth.step();
          const Timed<double> force = presses.with_force ? cloth.force_N : Timed<double>{};
          const IndentationEstimate e = estimator.step(cloth.now, cloth.ir, cloth.finger, force);
          if (cloth.sinceTouch_s() < 0.1) continue;
          unavailable += e.available ? 0 : 1;
          squares += std::pow(e.indentation_mm - cloth.depth_mm, 2);
          ++samples;
        }
      }
    }
  }
  EXPECT_GT(samples, 100'000);
  EXPECT_EQ(unavailable, 0);
  return std::sqrt(squares / samples);
}

TEST(IndentationAccuracy, HalvesTheThesisErrorOverTheWholeCloth) {
  const double ours = error_mm(kSolved, IndentationParameters{}.mode);
  const double thesis = error_mm(kSolved, IndentationMode::thesis);
  EXPECT_LE(ours, 0.5 * thesis) << ours << " mm against " << thesis << " mm";
  EXPECT_LE(ours, 0.75);  // 1 mm is promised
}

/// The cloth is the mode's own formula: what is left is the filter and the noise, without the force.
TEST(IndentationAccuracy, WithoutTheForceAClothThatObeysTheFormulaIsFollowed) {
  const double membrane = error_mm(kByTheFormula, IndentationMode::membrane);
  const double thesis = error_mm(kByTheFormula, IndentationMode::thesis);
  EXPECT_LE(membrane, 0.5 * thesis) << membrane << " mm against " << thesis << " mm";
  EXPECT_LE(membrane, 0.85);
}

}  // namespace
}  // namespace fyd::sensing
