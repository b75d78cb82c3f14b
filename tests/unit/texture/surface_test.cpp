// Virtual and stored surfaces, their fit from recordings, finger speed, contact detection.
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/signal/welch.h"
#include "core/texture/contact_detector.h"
#include "core/texture/finger_speed.h"
#include "core/texture/method_bank.h"
#include "core/texture/virtual_texture.h"
#include "tests/not_a_number.h"

namespace fyd::texture {
namespace {

double rmsAt(const SurfaceModel& model, double speed_mm_s, double force_N, double seconds = 20.0) {
  VirtualTexture surface(model, 1000.0);
  double energy = 0.0;
  const int count = static_cast<int>(seconds * 1000.0);
  for (int n = 0; n < 200; ++n) (void)surface.step(speed_mm_s, force_N);
  for (int n = 0; n < count; ++n) {
    const double y = surface.step(speed_mm_s, force_N);
    energy += y * y;
  }
  return std::sqrt(energy / count);
}

SurfaceModel ribs() {
  SurfaceModel model;
  model.name = "ribs";
  model.bands = {{.wavelength_mm = 0.4, .quality = 5.0, .rms_g = 0.3},
                 {.frequency_Hz = 200.0, .quality = 2.0, .rms_g = 0.4}};
  return model;
}

TEST(VirtualTexture, HasItsBandsPowerAtTheReference) { EXPECT_NEAR(rmsAt(ribs(), 40.0, 1.0), 0.5, 0.02); }

TEST(VirtualTexture, TakesWhatIsNotFiniteForNothingAndTheTooLargeForTheLargest) {
  constexpr double kEndless = std::numeric_limits<double>::infinity(), kMuch = 1e9;
  for (const double none : {kNaN, kEndless, -kEndless, -1.0}) {
    EXPECT_EQ(rmsAt(ribs(), none, 1.0, 1.0), 0.0) << none;
    EXPECT_EQ(rmsAt(ribs(), 40.0, none, 1.0), 0.0) << none;
  }
  SurfaceModel slow = ribs();
  slow.bands.resize(1);
  slow.bands[0].wavelength_mm = 5.0;  // 200 Hz at the fastest
  EXPECT_GT(rmsAt(slow, kMuch, 1.0, 1.0), 0.1);
  EXPECT_EQ(rmsAt(slow, kMuch, 1.0, 1.0), rmsAt(slow, VirtualTexture::kFastest_mm_s, 1.0, 1.0));
  EXPECT_EQ(rmsAt(ribs(), 40.0, kMuch, 1.0), rmsAt(ribs(), 40.0, VirtualTexture::kHardest_N, 1.0));
}

TEST(VirtualTexture, IsQuietBelowFiveMillimetresPerSecondAndHasNoCutAtSixty) {
  EXPECT_EQ(rmsAt(ribs(), 4.9, 1.0, 1.0), 0.0);
  EXPECT_EQ(rmsAt(ribs(), 0.0, 1.0, 1.0), 0.0);
  EXPECT_GT(rmsAt(ribs(), 7.0, 1.0), 0.01);
  double last = rmsAt(ribs(), 5.0, 1.0);
  for (const double v : {5.5, 6.0, 7.0, 8.0, 10.0, 15.0, 25.0, 40.0, 55.0, 59.0, 61.0, 65.0}) {
    const double now = rmsAt(ribs(), v, 1.0);
    EXPECT_GT(now, 0.95 * last) << v;
    EXPECT_LT(now - last, 0.2) << v;
    last = now;
  }
}

TEST(VirtualTexture, ItsPitchFollowsTheFingerAndItsStrengthTheForce) {
  SurfaceModel model = ribs();
  model.bands.resize(1);
  const auto loudest_Hz = [&](double speed_mm_s) {
    VirtualTexture surface(model, 1000.0);
    std::vector<double> y(60000);
    for (double& v : y) v = surface.step(speed_mm_s, 1.0);
    const auto s = signal::welch(y, 1000.0, 512);
    const auto peak = std::max_element(s.density.begin(), s.density.end()) - s.density.begin();
    return s.frequency_Hz(static_cast<std::size_t>(peak));
  };
  EXPECT_NEAR(loudest_Hz(40.0), 100.0, 12.0);
  EXPECT_NEAR(loudest_Hz(80.0), 200.0, 24.0);
  EXPECT_NEAR(rmsAt(model, 40.0, 4.0) / rmsAt(model, 40.0, 1.0), 2.0, 1e-6);  // force^0.5
}

TEST(VirtualTexture, StaysFiniteAndDeterministicWhateverTheFingerDoes) {
  VirtualTexture a(ribs(), 1000.0, 7);
  VirtualTexture b(ribs(), 1000.0, 7);
  const std::vector<double> wild = {0.0, 1e300, -5.0, std::nan(""), 40.0, 1e-310, 1000.0, INFINITY};
  for (int n = 0; n < 20000; ++n) {
    const double v = wild[static_cast<std::size_t>(n / 50) % wild.size()];
    const double y = a.step(v, v);
    ASSERT_TRUE(std::isfinite(y));
    ASSERT_LT(std::abs(y), 100.0);
    ASSERT_EQ(y, b.step(v, v));
  }
}

TEST(SurfaceModel, EveryStoredTextureReadsAndSounds) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FYD_SOURCE_DIR "/resources/textures")) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream file(entry.path());
    std::stringstream text;
    text << file.rdbuf();
    const auto model = parseSurface(text.str(), entry.path().filename().string());
    ASSERT_TRUE(model) << model.error().text();
    const double rms = rmsAt(*model, model->reference_speed_mm_s, model->reference_force_N, 2.0);
    EXPECT_GT(rms, 0.02) << model->name;
    EXPECT_LT(rms, 2.0) << model->name;
    ++count;
  }
  EXPECT_GE(count, 4);
}

TEST(SurfaceModel, WrittenTextReadsBackEqual) {
  SurfaceModel model = ribs();
  model.description = "odd \"characters\"\nand lines";
  model.speed_exponent = 0.1 + 0.2;
  const auto read = parseSurface(formatSurface(model), "m.toml");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->description, model.description);
  EXPECT_EQ(read->speed_exponent, model.speed_exponent);
  ASSERT_EQ(read->bands.size(), 2U);
  EXPECT_EQ(read->bands[1].frequency_Hz, 200.0);
  EXPECT_EQ(formatSurface(*read), formatSurface(model));
}

TEST(SurfaceModel, WrittenTextOfABandThatMayNotBeIsRefused) {
  for (const SurfaceBand& wrong :
       std::initializer_list<SurfaceBand>{{.wavelength_mm = 0.4, .frequency_Hz = 200.0},
                                          {.wavelength_mm = 0.4, .frequency_Hz = -200.0},
                                          {.wavelength_mm = -0.4, .frequency_Hz = 200.0},
                                          {.wavelength_mm = kNaN, .frequency_Hz = 200.0},
                                          {.wavelength_mm = std::numeric_limits<double>::infinity()},
                                          {}}) {
    SurfaceModel model = ribs();
    model.bands.push_back(wrong);
    EXPECT_FALSE(parseSurface(formatSurface(model), "m.toml")) << wrong.wavelength_mm << " " << wrong.frequency_Hz;
  }
}

TEST(SurfaceModel, RefusesWithFileAndLine) {
  const std::string good = formatSurface(ribs());
  const auto message = [](const std::string& text) {
    const auto result = parseSurface(text, "m.toml");
    return result ? std::string("none") : result.error().text();
  };
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return message(text);
  };
  EXPECT_EQ(message(good), "none");
  EXPECT_EQ(with("rms_g = 0.3", "rms_g = -1"), "m.toml:11: rms_g = -1: expected a number from 0 to 20");
  EXPECT_EQ(with("rms_g = 0.3", "rms_g = nan"), "m.toml:11: rms_g = nan: expected a number from 0 to 20");
  EXPECT_EQ(with("rms_g = 0.3", "rms_g = 'x'"), "m.toml:11: rms_g: expected a number from 0 to 20");
  EXPECT_EQ(with("rms_g = 0.3", "loud = 1"), "m.toml:11: unknown key 'loud' in [[band]]");
  EXPECT_EQ(with("rms_g = 0.3", ""), "m.toml:8: [[band]] without 'rms_g'");
  EXPECT_EQ(with("rms_g = 0.3", "rms_g = 0.3\nfrequency_Hz = 3"),
            "m.toml:8: [[band]]: expected either wavelength_mm or frequency_Hz");
  EXPECT_NE(message("name = 'x'\n"), "none");
  EXPECT_NE(message("band = 3\n"), "none");
  EXPECT_NE(message("= = ="), "none");
}

TEST(SurfaceFit, FindsTheSpectrumAndStrengthOfASurface) {
  VirtualTexture surface(ribs(), 1000.0, 3);
  std::vector<double> z(60000);
  for (double& v : z) v = surface.step(40.0, 1.0);
  const std::vector<double> none(z.size(), 0.0);
  const auto fit = fitSurface(none, none, z, {.name = "copy", .sample_rate_Hz = 1000.0, .speed_mm_s = 40.0});
  ASSERT_TRUE(fit) << fit.error().text();
  EXPECT_GT(fit->spectral_match, 0.9);
  EXPECT_NEAR(rmsAt(fit->model, 40.0, 1.0), rmsAt(ribs(), 40.0, 1.0), 0.05);
  EXPECT_FALSE(fitSurface(none, none, none, {}));
  EXPECT_FALSE(fitSurface({}, {}, {}, {}));
  for (const double speed_mm_s : {-40.0, std::nan(""), 0.5, 1e6}) {
    const auto refused = fitSurface(none, none, z, {.name = "x", .sample_rate_Hz = 1000.0, .speed_mm_s = speed_mm_s});
    ASSERT_FALSE(refused) << speed_mm_s;
    EXPECT_NE(refused.error().text().find("expected 1 … 1000, or none"), std::string::npos);
  }
}

TEST(SurfaceFit, GivesOnlyBandsThatAModelMayHave) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0.0, 0.3);
  std::vector<double> z(20'000);
  for (double& v : z) v = normal(random);
  const std::vector<double> none(z.size(), 0.0);
  const auto fitted = [&](double rate_Hz, double speed_mm_s) {
    return fitSurface(none, none, z, {.name = "noise", .sample_rate_Hz = rate_Hz, .speed_mm_s = speed_mm_s});
  };
  for (const auto& [rate_Hz, speed_mm_s] :
       {std::pair{20'000.0, 0.0}, {1000.0, 1.0}, {20'000.0, 40.0}, {5.0, 0.0}, {50.0, 1000.0}}) {
    const auto fit = fitted(rate_Hz, speed_mm_s);
    ASSERT_TRUE(fit) << rate_Hz << " Hz: " << fit.error().text();
    const auto read = parseSurface(formatSurface(fit->model), "m.toml");
    ASSERT_TRUE(read) << rate_Hz << " Hz, " << speed_mm_s << " mm/s: " << read.error().text();
    EXPECT_EQ(read->bands.size(), fit->model.bands.size());
  }
  // The bands that remain are still the noise's: from 20 Hz to 5 kHz, half of its power.
  const auto high = fitted(20'000.0, 0.0);
  double power = 0.0;
  for (const SurfaceBand& band : high->model.bands) power += band.rms_g * band.rms_g;
  EXPECT_NEAR(power, 0.3 * 0.3, 0.5 * 0.3 * 0.3);
  EXPECT_EQ(fitted(5.0, 1000.0).error().text(),
            "recording of 5 Hz at 1000 mm/s: no band of it can stand in a surface model");
  for (std::size_t i = 0; i < z.size(); ++i) z[i] = 900.0 * std::sin(0.6 * static_cast<double>(i));
  EXPECT_NE(fitted(1000.0, 40.0).error().text().find("expected at most 20 g"), std::string::npos);
}

TEST(Methods, AreMadeForARateThatIsOne) {
  for (const double rate_Hz : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    for (const MethodChoice choice : {MethodChoice::magnitude, MethodChoice::dft321, MethodChoice::soc}) {
      EXPECT_EQ(makeMethod(choice, rate_Hz, 32, 16).error().text(),
                fmt::format("rate = {} Hz: expected more than 0", rate_Hz));
    }
  }
}

TEST(SurfaceFit, RefusesWhatNoSensorGives) {
  const std::vector<double> none(100, 0.0);
  const auto refusal = [&](std::span<const double> x_g, double rate_Hz) {
    const auto fit = fitSurface(x_g, none, none, {.name = "refused", .sample_rate_Hz = rate_Hz});
    return fit ? "accepted" : fit.error().text();
  };
  for (const double wrong_Hz : {0.0, -1.0, 0.5, 1e300, HUGE_VAL, std::nan("")}) {
    EXPECT_EQ(refusal(none, wrong_Hz), fmt::format("rate = {} Hz: expected 1 … 1000000", wrong_Hz));
  }
  for (const double wrong_g : {1001.0, -1e308, HUGE_VAL, std::nan("")}) {
    std::vector<double> x_g = none;
    x_g[7] = wrong_g;
    EXPECT_EQ(refusal(x_g, 1000.0), fmt::format("recording: sample 8 is {} g: expected -1000 … 1000", wrong_g));
  }
}

TEST(FingerSpeed, ComesFromSuccessiveCentroids) {
  FingerSpeed speed;
  EXPECT_EQ(speed.at(instantAt(0.0)), 0.0);
  for (int n = 0; n <= 20; ++n) speed.observe(3.0 * n * 0.05, 4.0 * n * 0.05 * 10.0 / 4.0, instantAt(n * 0.05));
  const double truth = std::hypot(3.0, 10.0);
  EXPECT_NEAR(speed.at(instantAt(1.0)), truth, 1e-3);
  EXPECT_NEAR(speed.at(instantAt(1.1)), truth, 1e-3);  // held between pictures
  EXPECT_NEAR(speed.at(instantAt(1.15)), truth / 2, 1e-3);
  EXPECT_EQ(speed.at(instantAt(1.3)), 0.0);
  speed.observe(std::nan(""), 0.0, instantAt(1.31));
  speed.observe(0.0, 0.0, instantAt(0.5));  // older than the last
  EXPECT_EQ(speed.at(instantAt(1.31)), 0.0);
  speed.observe(50.0, 50.0, instantAt(2.0));  // after a pause: no jump
  EXPECT_EQ(speed.at(instantAt(2.0)), 0.0);
  speed.observe(1e9, 50.0, instantAt(2.001));
  EXPECT_LE(speed.at(instantAt(2.001)), FingerSpeed::kFastest_mm_s);
  speed.lift();
  EXPECT_EQ(speed.at(instantAt(2.001)), 0.0);
}

struct Heard {
  double t_s;
  ContactEvent event;
};

/// 1 s of quiet with gravity, a tap at 1 s, a touch at 2 s that slips from 2.12 s to 2.8 s.
std::vector<Heard> listen(double scale, double rate_Hz) {
  ContactDetector detector({}, rate_Hz);
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  std::vector<Heard> out;
  const auto knock = [&](double since_s) {
    return since_s < 0.0 ? 0.0 : 0.8 * std::exp(-since_s / 0.006) * std::cos(2.0 * 3.14159265 * 150.0 * since_s);
  };
  for (int n = 0; n < static_cast<int>(4.0 * rate_Hz); ++n) {
    const double t = n / rate_Hz;
    const double slip = t > 2.12 && t < 2.8 ? 0.15 * normal(random) : 0.0;
    const double z = knock(t - 1.0) + knock(t - 2.0) + slip + 0.003 * normal(random);
    const Vec3 a = {0.3 * scale * z + 0.002 * scale * normal(random), 0.1, scale * z + 1.0};
    const ContactEvent event = detector.step(n == 1500 ? Vec3{std::nan(""), 0.0, 0.0} : a);
    if (event != ContactEvent::none) out.push_back({t, event});
  }
  return out;
}

TEST(ContactDetector, HearsTouchesAndTheOnsetOfSlipAndNothingElse) {
  for (const double rate_Hz : {1000.0, 2500.0}) {
    for (const double scale : {0.3, 1.0, 5.0}) {
      const auto heard = listen(scale, rate_Hz);
      std::vector<ContactEvent> kinds;
      kinds.reserve(heard.size());
      for (const Heard& h : heard) kinds.push_back(h.event);
      const std::vector<ContactEvent> expected = {ContactEvent::touch, ContactEvent::release, ContactEvent::touch,
                                                  ContactEvent::slip, ContactEvent::release};
      ASSERT_EQ(kinds, expected) << rate_Hz << " " << scale;
      EXPECT_NEAR(heard[0].t_s, 1.0, 0.004);
      EXPECT_NEAR(heard[2].t_s, 2.0, 0.004);
      EXPECT_GT(heard[3].t_s, 2.12);
      EXPECT_LT(heard[3].t_s, 2.2);
    }
  }
}

}  // namespace
}  // namespace fyd::texture
