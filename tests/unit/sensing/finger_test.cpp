// The finger detector: the printed algorithm by hand, and the adaptive one on each kind of picture.
#include <algorithm>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/sensing/dark_runs.h"
#include "core/sensing/finger_detector.h"

namespace fyd::sensing {
namespace {

struct Picture {
  int width = 320;
  int height = 240;
  int channels = 1;
  std::vector<std::uint8_t> pixels;

  explicit Picture(std::uint8_t grey, int w = 320, int h = 240, int c = 1)
      : width(w), height(h), channels(c), pixels(placeIn(0, h), grey) {}
  [[nodiscard]] std::size_t placeIn(int x, int y) const {
    const int pixel = y * width + x;
    return static_cast<std::size_t>(pixel) * static_cast<std::size_t>(channels);
  }
  void set(int x, int y, int grey) {
    for (int c = 0; c < channels; ++c) {
      pixels[placeIn(x, y) + static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(grey);
    }
  }
  void rectangle(int x0, int y0, int x1, int y1, int grey) {
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) set(x, y, grey);
    }
  }
  void disc(double x, double y, double radius, int grey) {
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        if (std::hypot(u - x, v - y) <= radius) set(u, v, grey);
      }
    }
  }
  void noise(double sigma, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, sigma);
    for (auto& p : pixels) p = static_cast<std::uint8_t>(std::clamp(std::lround(p + normal(random)), 0L, 255L));
  }
  [[nodiscard]] ImageView view() const {
    return {.data = pixels.data(),
            .width = width,
            .height = height,
            .stride = std::ptrdiff_t{width} * channels,
            .channels = channels};
  }
};

/// Region of 160 × 120, so that the thesis' resize changes nothing and every number can be worked out.
FingerParameters thesisParameters() {
  FingerParameters p;
  p.mode = FingerMode::thesis;
  p.roi_x_px = 40;
  p.roi_y_px = 45;
  p.roi_width_px = 160;
  p.roi_height_px = 120;
  return p;
}

TEST(ThesisFinger, WeighsByDarknessAsPrinted) {
  Picture picture(255);
  picture.rectangle(40 + 40, 45 + 30, 40 + 50, 45 + 40, 100);  // µ = 100, weight 1
  picture.rectangle(40 + 50, 45 + 30, 40 + 60, 45 + 40, 131);  // σ = 155/5 = 31: weight e^−½ = 0.6065307
  FingerDetector detector(thesisParameters());
  const FingerDetection found = detector.detect(picture.view());
  ASSERT_TRUE(found.contact);
  EXPECT_EQ(found.area_px, 200);
  // (44.5 + 54.5·0.6065307)/1.6065307 = 48.275407; y = 34.5
  EXPECT_NEAR(found.x_px, 40 + 48.275407, 1e-5);
  EXPECT_NEAR(found.y_px, 45 + 34.5, 1e-9);
  EXPECT_NEAR(found.x_mm, (48.275407 - 80) * 0.46875, 1e-5);
  EXPECT_NEAR(found.y_mm, (60 - 34.5) * 0.46875, 1e-9);
}

TEST(ThesisFinger, NeedsMoreThanTheMinimumAreaDarkerThanTheThreshold) {
  FingerDetector detector(thesisParameters());
  Picture picture(255);
  picture.rectangle(60, 60, 75, 70, 209);  // 150 px
  EXPECT_FALSE(detector.detect(picture.view()).contact);
  EXPECT_EQ(detector.detect(picture.view()).reason, FingerReason::too_small);
  picture.set(75, 60, 209);  // 151
  EXPECT_TRUE(detector.detect(picture.view()).contact);
  Picture at_threshold(255);
  at_threshold.rectangle(60, 60, 90, 90, 210);
  EXPECT_FALSE(detector.detect(at_threshold.view()).contact);
  EXPECT_EQ(detector.detect(at_threshold.view()).area_px, 0);
}

TEST(ThesisFinger, KeepsThePositionWithoutContact) {
  FingerDetector detector(thesisParameters());
  Picture picture(255);
  picture.rectangle(60, 60, 90, 90, 100);
  const FingerDetection before = detector.detect(picture.view());
  const FingerDetection lifted = detector.detect(Picture(255).view());
  EXPECT_FALSE(lifted.contact);
  EXPECT_EQ(lifted.x_mm, before.x_mm);
  EXPECT_EQ(lifted.y_mm, before.y_mm);
}

TEST(ThesisFinger, AnswersAFlatPictureInsteadOfDividingByZero) {
  FingerDetector detector(thesisParameters());
  EXPECT_EQ(detector.detect(Picture(100).view()).reason, FingerReason::flat_picture);  // dark everywhere, σ = 0
  EXPECT_EQ(detector.detect(Picture(0).view()).reason, FingerReason::black_picture);
  EXPECT_EQ(detector.detect(Picture(255).view()).reason, FingerReason::saturated);
  EXPECT_FALSE(detector.detect(Picture(100).view()).contact);
}

TEST(ThesisFinger, ShrinksTheRegionTo160By120) {
  FingerParameters p;
  p.mode = FingerMode::thesis;
  Picture picture(255);
  picture.rectangle(40 + 55, 45 + 50, 40 + 110, 45 + 100, 100);  // 55 × 50 px → 40 × 40
  const FingerDetection found = FingerDetector(p).detect(picture.view());
  ASSERT_TRUE(found.contact);
  EXPECT_NEAR(found.area_px, 1600, 90);  // soft edges of the resize count too
  EXPECT_NEAR(found.x_px, 40 + 82, 0.6);
  EXPECT_NEAR(found.y_px, 45 + 74.5, 0.6);
}

TEST(AdaptiveFinger, FindsADiscWithItsAreaAndPlaceInMillimetres) {
  Picture picture(200);
  picture.disc(172, 105, 15, 80);
  picture.noise(2);
  const FingerDetection found = FingerDetector().detect(picture.view());
  ASSERT_TRUE(found.contact);
  EXPECT_EQ(found.reason, FingerReason::found);
  EXPECT_NEAR(found.x_px, 172, 0.1);
  EXPECT_NEAR(found.y_px, 105, 0.1);
  EXPECT_NEAR(found.x_mm, 10.0, 0.05);  // (172 − 150)·100/220
  EXPECT_NEAR(found.y_mm, 7.0, 0.05);   // (120 − 105)·70/150
  EXPECT_NEAR(found.area_px, 709, 14);
  EXPECT_NEAR(found.area_mm2, 150.4, 3.0);  // 709 px of 100/220 × 70/150 mm²
  EXPECT_GT(found.quality, 0.9);
}

TEST(AdaptiveFinger, AppliesRotationAndMirror) {
  FingerParameters p;
  p.scale_x_mm_per_px = 0.5;
  p.scale_y_mm_per_px = 0.4;
  p.rotation_deg = 90;
  double x = 0, y = 0;
  toMillimetres(p, 160, 130, x, y);  // (5, −4) turned by 90°: (4, 5)
  EXPECT_NEAR(x, 4.0, 1e-12);
  EXPECT_NEAR(y, 5.0, 1e-12);
  p.mirror = true;
  toMillimetres(p, 160, 130, x, y);  // (−5, −4) → (4, −5)
  EXPECT_NEAR(x, 4.0, 1e-12);
  EXPECT_NEAR(y, -5.0, 1e-12);
}

TEST(AdaptiveFinger, NamesWhatIsWrongWithAPicture) {
  FingerDetector detector;
  EXPECT_EQ(detector.detect({}).reason, FingerReason::no_picture);
  EXPECT_EQ(detector.detect(Picture(100, 40, 40).view()).reason, FingerReason::no_picture);  // region outside
  EXPECT_EQ(detector.detect(Picture(0).view()).reason, FingerReason::black_picture);
  EXPECT_EQ(detector.detect(Picture(255).view()).reason, FingerReason::saturated);
  EXPECT_EQ(detector.detect(Picture(128).view()).reason, FingerReason::flat_picture);
  Picture dark(1);
  dark.noise(2);
  EXPECT_EQ(detector.detect(dark.view()).reason, FingerReason::black_picture);
  Picture empty(200);
  empty.noise(4);
  EXPECT_EQ(detector.detect(empty.view()).reason, FingerReason::no_finger);
  Picture small(200);
  small.disc(150, 120, 2, 60);  // 13 px: 2.8 mm²
  small.noise(2);
  const FingerDetection too_small = detector.detect(small.view());
  EXPECT_EQ(too_small.reason, FingerReason::too_small);
  EXPECT_FALSE(too_small.contact);
  EXPECT_GT(too_small.area_px, 8);
  Picture edge(200);
  edge.disc(40, 120, 20, 60);
  edge.noise(2);
  EXPECT_EQ(detector.detect(edge.view()).reason, FingerReason::at_edge);
}

TEST(AdaptiveFinger, DoesNotSayUntouchedWhereItCannotTellTheLight) {
  Picture board(200);
  for (int y = 0; y < board.height; ++y) {
    for (int x = 0; x < board.width; ++x) board.set(x, y, (x / 20 + y / 20) % 2 == 0 ? 220 : 30);
  }
  board.disc(160, 120, 20, 10);
  const FingerDetection seen = FingerDetector().detect(board.view());
  EXPECT_TRUE(seen.contact || !showsCloth(seen.reason)) << toString(seen.reason);
}

TEST(AdaptiveFinger, TakesTheLargestLeastContrast) {
  FingerParameters parameters;
  parameters.minimum_contrast = 0.9;
  Picture picture(200);
  picture.disc(172, 105, 15, 4);
  picture.noise(2);
  EXPECT_TRUE(FingerDetector(parameters).detect(picture.view()).contact);
}

TEST(FingerDetector, TakesNoPictureWhoseRowsOverlap) {
  for (const FingerMode mode : {FingerMode::adaptive, FingerMode::thesis}) {
    for (const int channels : {1, 3}) {
      Picture picture(200, 320, 240, channels);
      picture.disc(150, 120, 20, 60);
      FingerParameters parameters;
      parameters.mode = mode;
      FingerDetector detector(parameters);
      ASSERT_NE(detector.detect(picture.view()).reason, FingerReason::no_picture);
      ImageView view = picture.view();
      for (const std::ptrdiff_t stride : {std::ptrdiff_t{0}, view.stride - 1, 1 - view.stride}) {
        view.stride = stride;
        EXPECT_EQ(detector.detect(view).reason, FingerReason::no_picture) << stride;
      }
    }
  }
}

TEST(AdaptiveFinger, FindsAFingerOnAnOverexposedCloth) {
  Picture picture(255);
  picture.disc(140, 110, 18, 90);
  const FingerDetection found = FingerDetector().detect(picture.view());
  ASSERT_TRUE(found.contact);
  EXPECT_NEAR(found.x_px, 140, 0.1);
}

TEST(AdaptiveFinger, SaysWhenTheEdgeIsBlurred) {
  Picture picture(200);
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      const double outside = std::hypot(x - 150, y - 120) - 25;
      picture.set(x, y,
                  static_cast<int>(std::lround(200 - 120 * 0.5 * std::erfc(outside / (6.0 * std::numbers::sqrt2)))));
    }
  }
  const FingerDetection found = FingerDetector().detect(picture.view());
  EXPECT_TRUE(found.contact);
  EXPECT_EQ(found.reason, FingerReason::blurred);
  EXPECT_NEAR(found.x_px, 150, 0.3);
  EXPECT_LT(found.quality, 0.5);
}

TEST(AdaptiveFinger, StaysWithTheNearerOfTwoFingers) {
  FingerDetector detector;
  Picture one(200);
  one.disc(90, 120, 13, 70);
  one.noise(3);
  ASSERT_NEAR(detector.detect(one.view()).x_px, 90, 0.3);
  Picture two(200);
  two.disc(95, 120, 13, 70);
  two.disc(200, 110, 25, 60);  // larger, but farther
  two.noise(3);
  const FingerDetection found = detector.detect(two.view());
  EXPECT_EQ(found.reason, FingerReason::several);
  EXPECT_NEAR(found.x_px, 95, 0.3);
  detector.reset();
  EXPECT_NEAR(detector.detect(two.view()).x_px, 200, 0.3);  // nothing known: the larger
}

TEST(AdaptiveFinger, FollowsLightThatJumps) {
  FingerDetector detector;
  for (const int cloth : {220, 90, 240, 60}) {
    Picture picture(static_cast<std::uint8_t>(cloth));
    picture.disc(150, 120, 16, cloth / 3);
    picture.noise(1.5);
    const FingerDetection found = detector.detect(picture.view());
    ASSERT_TRUE(found.contact) << cloth;
    EXPECT_NEAR(found.x_px, 150, 0.2) << cloth;
    EXPECT_NEAR(found.area_px, 797, 26) << cloth;  // 797 px in the disc
  }
}

TEST(AdaptiveFinger, FollowsAFingerWhoseDarknessJumps) {
  FingerDetector detector;
  for (const int grey : {40, 140, 60, 130}) {
    Picture picture(200);
    picture.disc(150, 120, 20, grey);
    picture.noise(6);
    const FingerDetection found = detector.detect(picture.view());
    ASSERT_TRUE(found.contact) << grey;
    EXPECT_NEAR(found.x_px, 150, 0.3) << grey;
    EXPECT_NEAR(found.area_px, 1257, 38) << grey;  // 1257 px in the disc
  }
}

TEST(AdaptiveFinger, ColourAndGreyAgree) {
  Picture grey(200);
  Picture colour(200, 320, 240, 3);
  grey.disc(130, 100, 14, 70);
  colour.disc(130, 100, 14, 70);
  const FingerDetection a = FingerDetector().detect(grey.view());
  const FingerDetection b = FingerDetector().detect(colour.view());
  ASSERT_TRUE(a.contact && b.contact);
  EXPECT_NEAR(a.x_px, b.x_px, 0.02);
  EXPECT_NEAR(a.area_px, b.area_px, 1.0);
}

TEST(AdaptiveFinger, WorksOnEveryNthPixel) {
  for (const int stride : {2, 3, 4}) {
    FingerParameters p;
    p.stride_px = stride;
    Picture picture(200);
    picture.disc(172, 105, 20, 80);
    picture.noise(2);
    const FingerDetection found = FingerDetector(p).detect(picture.view());
    ASSERT_TRUE(found.contact) << stride;
    EXPECT_NEAR(found.x_px, 172, 0.5) << stride;
    EXPECT_NEAR(found.area_px, 1257, 43) << stride;
  }
}

TEST(AdaptiveFinger, ClipsARegionThatLeavesThePicture) {
  FingerParameters p;
  p.roi_x_px = 200;
  p.roi_width_px = 500;
  FingerDetector detector(p);
  Picture picture(200);
  picture.disc(260, 120, 15, 80);
  const FingerDetection found = detector.detect(picture.view());
  EXPECT_TRUE(found.contact);
  EXPECT_EQ(detector.region().width, 120);
}

TEST(FingerOverlay, MarksTheFingerAndOtherBlobs) {
  FingerDetector detector;
  Picture picture(200);
  picture.disc(90, 120, 20, 70);
  picture.disc(220, 120, 13, 70);
  (void)detector.detect(picture.view());
  std::vector<std::uint8_t> mask(std::size_t{220} * 150, 77);
  detector.drawOverlay(mask);
  EXPECT_EQ(mask[(120 - 45) * 220 + (90 - 40)], 255);
  EXPECT_EQ(mask[(120 - 45) * 220 + (220 - 40)], 128);
  EXPECT_EQ(mask[0], 0);
  std::vector<std::uint8_t> too_small(10, 77);
  detector.drawOverlay(too_small);
  EXPECT_EQ(too_small[0], 77);
}

TEST(DarkRuns, JoinsWhatTouchesAndCountsIt) {
  const char* rows[] = {"#..#....", "#..#.##.", "####...#", ".......#", "##......"};
  DarkRuns runs;
  runs.resize(8, 5);
  runs.clear();
  for (int y = 0; y < 5; ++y) {
    std::vector<std::uint8_t> marks(8 + 8, 0);
    for (std::size_t x = 0; x < 8; ++x) marks[x] = rows[y][x] == '#' ? 255 : 0;
    runs.addRow(y, marks.data());
  }
  runs.finish();
  ASSERT_EQ(runs.blobs().size(), 3U);
  EXPECT_EQ(runs.blobs()[0].pixels, 8);  // the U
  EXPECT_EQ(runs.blobs()[1].pixels, 4);  // joined over the corner
  EXPECT_EQ(runs.blobs()[2].pixels, 2);
  EXPECT_NEAR(runs.blobs()[0].x(), 1.5, 1e-12);
  EXPECT_EQ(runs.blobs()[1].left, 5);
  EXPECT_EQ(runs.blobs()[1].right, 8);
  EXPECT_EQ(runs.blobs()[1].bottom, 4);
}

}  // namespace
}  // namespace fyd::sensing
