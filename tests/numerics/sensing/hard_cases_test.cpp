// Whatever comes in: no NaN, no value beyond its limits, no allocation in the step, no crash on any picture.
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "app/bench/parts/allocation_count.h"
#include "app/bench/parts/labelled_pictures.h"
#include "app/bench/parts/pressed_cloth.h"
#include "core/sensing/finger_detector.h"
#include "core/sensing/indentation.h"
#include "core/sensing/stiffness_estimator.h"
#include "core/sensing/tare.h"

namespace fyd::sensing {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
const double kNasty[] = {0.0,    -0.0, 1.0,   -1.0, 5e-324, -5e-324, 1e-300, 1e300,
                         -1e300, kInf, -kInf, 6.0,  0.5,    1e12,    -1e12,  std::nan("")};

bool sane(const IndentationEstimate& e) {
  return e.indentation_mm >= -20 && e.indentation_mm <= 100 && e.sigma_mm >= 0 && e.sigma_mm <= 1e4;
}
bool sane(const StiffnessEstimate& k) {
  return k.stiffness_N_per_mm >= 0 && k.stiffness_N_per_mm <= StiffnessEstimator::kLargest_N_per_mm &&
         k.sigma_N_per_mm >= 0 && k.sigma_N_per_mm <= StiffnessEstimator::kLargest_N_per_mm;
}

/// For presses made with the membrane's own formula.
IndentationParameters membraneMode() {
  IndentationParameters p;
  p.mode = IndentationMode::membrane;
  return p;
}

TEST(HardCases, StiffnessStaysFiniteForAnyForceDepthUncertaintyAndTime) {
  for (const auto mode : {StiffnessMode::slope, StiffnessMode::thesis}) {
    StiffnessParameters p;
    p.mode = mode;
    StiffnessEstimator estimator(p);
    std::uint64_t n = 0;
    for (const double t : kNasty) {
      for (const double force : kNasty) {
        for (const double depth : kNasty) {
          for (const double sigma : {0.0, 1e-300, 0.3, 1e300, kInf, std::nan(""), -1.0}) {
            IndentationEstimate e;
            e.indentation_mm = depth;
            e.sigma_mm = sigma;
            e.available = true;
            e.touched = true;
            const Instant now = instantAt(t);
            const StiffnessEstimate k = estimator.step(now, {.value = force, .taken = now, .count = ++n}, e);
            ASSERT_TRUE(sane(k)) << t << ' ' << force << ' ' << depth << ' ' << sigma;
            ASSERT_FALSE(k.observable && !(depth >= p.minimum_indentation_mm && force >= p.minimum_force_N));
          }
        }
      }
    }
    IndentationEstimate good;
    good.indentation_mm = 6;
    good.sigma_mm = 0.2;
    good.available = good.touched = true;
    StiffnessEstimate k;
    for (int i = 0; i < 200; ++i) {
      k = estimator.step(instantAt(10 + 0.008 * i), {.value = 3, .taken = instantAt(10 + 0.008 * i), .count = ++n},
                         good);
    }
    EXPECT_NEAR(k.stiffness_N_per_mm, 0.5, 0.05) << "it does not recover";
  }
}

TEST(HardCases, ForceWithoutIndentationAndTheReverseAreNotObservable) {
  StiffnessEstimator estimator;
  IndentationEstimate e;
  e.available = e.touched = true;
  e.sigma_mm = 0.2;
  const Timed<double> force{.value = 5, .taken = instantAt(1), .count = 1};
  EXPECT_EQ(estimator.step(instantAt(1), force, e).reason, StiffnessReason::indentation_too_small);
  e.indentation_mm = -2;
  EXPECT_EQ(estimator.step(instantAt(1), force, e).reason, StiffnessReason::indentation_too_small);
  e.indentation_mm = 6;
  EXPECT_EQ(estimator.step(instantAt(1), {.value = 0, .taken = instantAt(1), .count = 2}, e).reason,
            StiffnessReason::force_too_small);
  EXPECT_EQ(estimator.step(instantAt(1), {.value = -3, .taken = instantAt(1), .count = 3}, e).reason,
            StiffnessReason::force_too_small);
}

TEST(HardCases, IndentationStaysFiniteForRandomCodesPlacesAndTimes) {
  std::mt19937_64 random(4);
  IndentationParameters narrow;
  narrow.frame_half_width_mm = 200;
  narrow.frame_half_depth_mm = 10;
  narrow.cloth_tension_ratio = 0.05;
  std::vector<IndentationParameters> all;
  for (const auto mode : {IndentationMode::membrane, IndentationMode::thesis, IndentationMode::contact}) {
    for (IndentationParameters p : {IndentationParameters(), narrow}) {
      p.mode = mode;
      all.push_back(p);
    }
  }
  for (const IndentationParameters& p : all) {
    IndentationEstimator estimator(p);
    Timed<IrCounts> ir;
    Timed<FingerDetection> finger;
    Timed<double> force;
    for (int i = 0; i < 20000; ++i) {
      const auto pick = [&] { return kNasty[random() % std::size(kNasty)]; };
      const Instant now = instantAt(random() % 3 == 0 ? pick() : 1e-3 * i);
      IrCounts counts;
      const std::size_t sensors = random() % 6;
      for (std::size_t s = 0; s < sensors; ++s) {
        const std::uint16_t codes[] = {0, 4095, 65535, 524, 3408, static_cast<std::uint16_t>(random() % 4096)};
        (void)counts.push(codes[random() % 6]);
      }
      if (random() % 2 == 0) ir.set(counts, random() % 4 == 0 ? instantAt(pick()) : now);
      FingerDetection seen;
      seen.contact = random() % 4 != 0;
      seen.x_mm = random() % 2 == 0 ? pick() : 10.0;
      seen.y_mm = random() % 2 == 0 ? pick() : 10.0;
      if (random() % 4 != 0) seen.area_mm2 = random() % 2 == 0 ? pick() : 50.0;
      if (random() % 2 == 0) finger.set(seen, random() % 4 == 0 ? instantAt(pick()) : now);
      if (random() % 2 == 0) force.set(random() % 2 == 0 ? pick() : 3.0, random() % 4 == 0 ? instantAt(pick()) : now);
      const IndentationEstimate e = estimator.step(now, ir, finger, force);
      ASSERT_TRUE(sane(e)) << i << ": " << e.indentation_mm << " ± " << e.sigma_mm;
    }
  }
}

TEST(HardCases, IrCodeZeroAndFullScaleAreInvalidNotADistance) {
  IndentationEstimator estimator(membraneMode());
  for (const std::uint16_t code : {std::uint16_t{0}, std::uint16_t{4095}}) {
    Timed<IrCounts> ir;
    IrCounts counts;
    for (int i = 0; i < 3; ++i) (void)counts.push(code);
    ir.set(counts, instantAt(1));
    Timed<FingerDetection> finger;
    finger.set({.contact = true}, instantAt(1));
    const IndentationEstimate e = estimator.step(instantAt(1), ir, finger);
    EXPECT_FALSE(e.available);
    EXPECT_EQ(e.reason, IndentationReason::too_few_sensors);
    EXPECT_TRUE(std::isnan(e.distance_mm[0]));
    estimator.reset();
  }
}

struct Spoilt {
  IndentationEstimate last;
  double rms_mm = std::nan("");  ///< of the estimates that were available after 0.5 s
  int samples = 0;               ///< how many those are, of 3000
};

/// Presses and lets `spoil` change the readings.
template <class Spoil>
Spoilt withSpoiltReadings(Spoil spoil, double x_mm = 5) {
  bench::PressedClothOptions o;
  o.x_mm = x_mm;
  o.y_mm = 5;
  bench::PressedCloth cloth(o);
  IndentationEstimator estimator(membraneMode());
  Spoilt out;
  double squares = 0;
  for (int i = 0; i < 3000; ++i) {
    cloth.step();
    Timed<IrCounts> ir = cloth.ir;
    if (!ir.value.empty()) spoil(ir, cloth.sinceTouch_s());
    out.last = estimator.step(cloth.now, ir, cloth.finger);
    EXPECT_TRUE(sane(out.last));
    if (cloth.sinceTouch_s() < 0.5 || !out.last.available) continue;
    squares += std::pow(out.last.indentation_mm - cloth.depth_mm, 2);
    ++out.samples;
  }
  if (out.samples > 0) out.rms_mm = std::sqrt(squares / out.samples);
  return out;
}

TEST(HardCases, AStuckSensorIsLeftOut) {
  const auto [e, rms, samples] = withSpoiltReadings([](Timed<IrCounts>& ir, double) { ir.value[0] = 1700; });
  EXPECT_FALSE(e.valid[0]);
  EXPECT_EQ(e.reason, IndentationReason::some_invalid);
  EXPECT_TRUE(e.available);
}

TEST(HardCases, ASaturatedSensorIsLeftOut) {
  const auto [e, rms, samples] = withSpoiltReadings([](Timed<IrCounts>& ir, double) { ir.value[2] = 4095; });
  EXPECT_FALSE(e.valid[2]);
  EXPECT_GT(samples, 2000);
  EXPECT_LT(rms, 1.5);
}

TEST(HardCases, AJumpingSensorDoesNotCarryTheEstimateAway) {
  std::uint64_t n = 0;
  const auto [e, rms, samples] = withSpoiltReadings([&](Timed<IrCounts>& ir, double) {
    if (ir.count % 10 == 0) ir.value[1] = static_cast<std::uint16_t>(n++ % 2 == 0 ? 600 : 3300);
  });
  EXPECT_GT(samples, 2000);
  EXPECT_LT(rms, 1.5);
}

TEST(HardCases, SwappedSensorsRaiseTheUncertainty) {
  const auto [good, good_rms, good_samples] = withSpoiltReadings([](Timed<IrCounts>&, double) {}, 20);
  const auto [e, rms, samples] =
      withSpoiltReadings([](Timed<IrCounts>& ir, double) { std::swap(ir.value[0], ir.value[2]); }, 20);
  EXPECT_GT(good_samples, 2000);
  EXPECT_LT(good_rms, 0.6);
  EXPECT_GT(e.sigma_mm, 2 * good.sigma_mm);
  EXPECT_EQ(e.reason, IndentationReason::inconsistent) << toString(e.reason);
}

TEST(HardCases, LateReadingsBecomeUnavailable) {
  const auto [e, rms, samples] = withSpoiltReadings([](Timed<IrCounts>& ir, double since) {
    if (since > 1) ir.taken -= std::chrono::milliseconds(150);
  });
  EXPECT_FALSE(e.available);
  EXPECT_EQ(e.reason, IndentationReason::ir_stale);
}

TEST(HardCases, AForceThatHasNothingToDoWithTheClothIsNotBelieved) {
  for (const double lie : {0.0, 0.3, -5.0, 9.0, std::nan(""), 1e300}) {
    bench::PressedCloth cloth({});
    IndentationEstimator estimator(membraneMode());
    double squares = 0;
    int samples = 0;
    for (int i = 0; i < 3500; ++i) {
      cloth.step();
      Timed<double> force = cloth.force_N;
      if (cloth.sinceTouch_s() > 1) force.value = lie;  // the load cell dies in mid-press
      const IndentationEstimate e = estimator.step(cloth.now, cloth.ir, cloth.finger, force);
      ASSERT_TRUE(sane(e));
      if (cloth.sinceTouch_s() < 2) continue;
      squares += std::pow(e.indentation_mm - cloth.depth_mm, 2);
      ++samples;
    }
    EXPECT_LT(std::sqrt(squares / samples), 1.0) << lie;
  }
}

TEST(HardCases, NearlyCollinearSensorsAreRefusedAndTheirConditionIsKnown) {
  IndentationParameters p;
  p.mode = IndentationMode::thesis;
  p.ir_y_mm = listOf(-3, -2.5, -3);
  IndentationEstimator estimator(p);
  EXPECT_GT(estimator.conditionNumber(), 20);
  bench::PressedCloth cloth({});
  IndentationEstimate e;
  for (int i = 0; i < 500; ++i) {
    cloth.step();
    e = estimator.step(cloth.now, cloth.ir, cloth.finger);
  }
  EXPECT_FALSE(e.available);
  EXPECT_EQ(e.reason, IndentationReason::too_few_sensors);
}

TEST(HardCases, TheStepDoesNotAllocate) {
  for (const auto mode : {IndentationMode::membrane, IndentationMode::thesis}) {
    IndentationParameters p;
    p.mode = mode;
    IndentationEstimator indentation(p);
    StiffnessEstimator stiffness;
    bench::PressedCloth cloth({});
    Tare tare;
    tare.start(instantAt(0));
    const bench::AllocationCount counted;
    for (int i = 0; i < 1000; ++i) {
      cloth.step();
      const IndentationEstimate e = indentation.step(cloth.now, cloth.ir, cloth.finger, cloth.force_N);
      (void)stiffness.step(cloth.now, cloth.force_N, e);
      (void)tare.step(cloth.now, e, cloth.force_N);
      if (i % 100 == 0) indentation.configure(p);
    }
    EXPECT_EQ(counted.count(), 0U);
  }
}

TEST(HardCases, TheDetectorAllocatesOnlyAtTheFirstPicture) {
  bench::LabelledPictures frames(9);
  FingerDetector detector;
  frames.next();
  (void)detector.detect(frames.picture());
  std::uint64_t inside = 0;
  for (int i = 0; i < 100; ++i) {
    frames.next();
    const bench::AllocationCount counted;
    (void)detector.detect(frames.picture());
    inside += counted.count();
  }
  EXPECT_EQ(inside, 0U);
}

TEST(HardCases, TheDetectorSurvivesAnyPicture) {
  std::mt19937 random(11);
  FingerDetector detector;
  std::vector<std::uint8_t> pixels(std::size_t{700} * 500 * 3);
  for (int i = 0; i < 300; ++i) {
    const int kind = static_cast<int>(random() % 5);
    const int width = static_cast<int>(random() % 700) + 1;
    const int height = static_cast<int>(random() % 500) + 1;
    const int channels = random() % 2 == 0 ? 1 : 3;
    const int bytes = width * height * channels;
    const auto size = static_cast<std::size_t>(bytes);
    for (std::size_t k = 0; k < size; ++k) {
      pixels[k] = kind == 0   ? static_cast<std::uint8_t>(random())           // noise
                  : kind == 1 ? static_cast<std::uint8_t>((k / 3) % 2 * 255)  // stripes
                  : kind == 2 ? static_cast<std::uint8_t>(k * 255 / size)     // ramp
                  : kind == 3 ? static_cast<std::uint8_t>(k * 7 % size > size / 2 ? 255 : 0)
                              : static_cast<std::uint8_t>(i);
    }
    FingerParameters p;
    p.mode = random() % 4 == 0 ? FingerMode::thesis : FingerMode::adaptive;
    p.roi_x_px = static_cast<int>(random() % 300);
    p.roi_y_px = static_cast<int>(random() % 300);
    p.roi_width_px = 16 + static_cast<int>(random() % 600);
    p.roi_height_px = 16 + static_cast<int>(random() % 400);
    p.stride_px = 1 + static_cast<int>(random() % 8);
    detector.configure(p);
    const FingerDetection found = detector.detect({.data = pixels.data(),
                                                   .width = width,
                                                   .height = height,
                                                   .stride = std::ptrdiff_t{width} * channels,
                                                   .channels = channels});
    ASSERT_TRUE(std::isfinite(found.x_mm) && std::isfinite(found.y_mm) && std::isfinite(found.quality));
    ASSERT_TRUE(found.area_px >= 0 && found.area_px <= 320 * 240) << found.area_px;
    ASSERT_TRUE(found.quality >= 0 && found.quality <= 1);
    if (!found.contact) continue;
    ASSERT_TRUE(found.x_px >= 0 && found.x_px < width && found.y_px >= 0 && found.y_px < height);
  }
}

}  // namespace
}  // namespace fyd::sensing
