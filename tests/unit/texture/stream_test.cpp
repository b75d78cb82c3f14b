// The uniform stream of accelerations (jitter, gaps, clock jumps), and recordings of accelerations.
#include "core/texture/uniform_stream.h"

#include <limits>

#include <gtest/gtest.h>

#include "app/bench/parts/allocation_count.h"
#include "core/texture/recording.h"
#include "tests/not_a_number.h"

namespace fyd::texture {
namespace {

AccelerationSample sample(double t_ms, double value) { return {instantAt(t_ms * 1e-3), {value, 0.0, -value}}; }

struct Streamed {
  std::vector<double> values;  // NaN where a gap was
  std::uint64_t gaps = 0;
  std::uint64_t refused = 0;
};

/// Calls at 1 kHz; every sample is handed over in the first call after its stamp plus `late_ms`.
Streamed run(const std::vector<AccelerationSample>& samples, int steps, double delay_ms, double gap_ms,
             double late_ms = 0.0) {
  UniformStream stream(1000.0);
  stream.configure(delay_ms, gap_ms);
  Streamed out;
  std::size_t next = 0;
  for (int n = 0; n < steps; ++n) {
    const Instant now = instantAt(n * 1e-3);
    std::vector<AccelerationSample> bunch;
    while (next < samples.size() && samples[next].taken + fromSeconds(late_ms * 1e-3) <= now)
      bunch.push_back(samples[next++]);
    stream.push(now, bunch);
    const auto step = stream.step(now);
    out.values.push_back(step.gap ? kNaN : step.acceleration_g.x);
  }
  out.gaps = stream.gaps();
  out.refused = stream.refused();
  return out;
}

std::vector<double> numbers(const std::vector<double>& values) {
  std::vector<double> out;
  for (const double v : values) {
    if (!std::isnan(v)) out.push_back(v);
  }
  return out;
}

TEST(UniformStream, ASensorAtTheRateGoesThroughUnchangedInSpiteOfJitter) {
  std::vector<AccelerationSample> in;
  std::vector<double> expected;
  for (int n = 0; n < 1000; ++n) {
    in.push_back(sample(n + 0.1 + 0.35 * std::sin(n * 1.7), n));
    expected.push_back(n);
  }
  const Streamed r = run(in, 1010, 0.5, 2.5);
  EXPECT_EQ(numbers(r.values), expected);
  EXPECT_EQ(r.refused, 0U);
  EXPECT_LE(r.gaps, 1U);  // the end
}

TEST(UniformStream, RepeatedReadingsOfAFasterLoopAreAveragedWithinTheirPeriod) {
  std::vector<AccelerationSample> in;
  in.reserve(2500);
  for (int n = 0; n < 2500; ++n) in.push_back(sample(n * 0.4, std::floor(n * 0.4)));
  const Streamed r = run(in, 900, 0.5, 2.5);
  const auto values = numbers(r.values);
  ASSERT_GT(values.size(), 890U);
  for (std::size_t n = 1; n < values.size(); ++n) {
    EXPECT_NEAR(values[n] - values[n - 1], 1.0, 0.51);
    EXPECT_NEAR(values[n], static_cast<double>(n), 1.0);
  }
  EXPECT_EQ(r.gaps, 0U);
}

TEST(UniformStream, AMissingStretchIsAGapAndNothingIsInvented) {
  std::vector<AccelerationSample> in;
  for (int n = 0; n < 100; ++n) {
    if (n < 40 || n >= 50) in.push_back(sample(n, 1.0));
  }
  const Streamed r = run(in, 100, 0.5, 2.5);
  int silent = 0;
  for (std::size_t n = 5; n < 95; ++n) silent += std::isnan(r.values[n]) ? 1 : 0;
  EXPECT_EQ(silent, 10);
  EXPECT_EQ(r.gaps, 1U);
}

TEST(UniformStream, OneMissingSampleIsBridgedOnlyWhereTheLimitAllows) {
  std::vector<AccelerationSample> in;
  for (int n = 0; n < 100; ++n) {
    if (n != 40) in.push_back(sample(n, n));
  }
  const Streamed bridged = run(in, 90, 0.5, 2.5);
  EXPECT_EQ(bridged.gaps, 0U);
  EXPECT_EQ(numbers(bridged.values)[40], 40.0);  // the middle of the line from 39 to 41
  EXPECT_EQ(run(in, 90, 0.5, 1.5).gaps, 1U);
}

TEST(UniformStream, ASensorMayChangeItsRate) {
  std::vector<AccelerationSample> in;
  double t_ms = 0.0;
  while (t_ms < 600.0) {  // 1 kHz, 2.5 kHz, 500 Hz; the value is the time
    in.push_back(sample(t_ms, t_ms));
    t_ms += t_ms < 200.0 ? 1.0 : (t_ms < 400.0 ? 0.4 : 2.0);
  }
  const Streamed r = run(in, 590, 1.5, 2.5);
  EXPECT_EQ(r.gaps, 0U);
  EXPECT_EQ(r.refused, 0U);
  for (std::size_t n = 10; n < r.values.size(); ++n) {
    const double late = static_cast<double>(n) - r.values[n];
    ASSERT_GT(late, 0.9) << n;
    ASSERT_LT(late, 3.1) << n;
  }
}

TEST(UniformStream, RefusesWhatCannotBeTrusted) {
  UniformStream stream(1000.0);
  stream.configure(0.5, 2.5);
  const double huge = 1e300;
  const std::vector<AccelerationSample> bad = {
      sample(10.0, kNaN), sample(10.0, std::numeric_limits<double>::infinity()), sample(10.0, huge), sample(99.0, 1.0)};
  stream.push(instantAt(0.0101), bad);
  EXPECT_EQ(stream.refused(), 4U);
  EXPECT_TRUE(stream.step(instantAt(0.0101)).gap);
  const std::vector<AccelerationSample> unordered = {sample(10.1, 1.0), sample(9.0, 1.0)};
  stream.push(instantAt(0.0101), unordered);
  EXPECT_EQ(stream.refused(), 5U);
  std::vector<AccelerationSample> flood(1000, sample(10.1, 1.0));
  stream.push(instantAt(0.0101), flood);
  EXPECT_GT(stream.refused(), 700U);
}

TEST(UniformStream, GoesOnAfterTheClockJumpsEitherWay) {
  UniformStream stream(1000.0);
  stream.configure(0.5, 2.5);
  int values = 0;
  double t_ms = 1e6;
  for (int n = 0; n < 300; ++n) {
    if (n == 100) t_ms -= 9e5;
    if (n == 200) t_ms += 5e6;
    t_ms += 1.0;
    const std::vector<AccelerationSample> one = {sample(t_ms, 1.0)};
    stream.push(instantAt(t_ms * 1e-3), one);
    const auto step = stream.step(instantAt(t_ms * 1e-3));
    values += step.gap ? 0 : 1;
  }
  EXPECT_GT(values, 285);
  const auto stood_still = stream.step(instantAt(t_ms * 1e-3));
  EXPECT_TRUE(stood_still.gap || std::isfinite(stood_still.acceleration_g.x));
}

TEST(Recording, ReadsTimesPlainColumnsAndNoHeader) {
  const auto timed = parseRecording("az,t_s,ax,ay\n3,10,1,2\n6,10.001,4,5\n", "r.csv", 0.0);
  ASSERT_TRUE(timed) << timed.error().text();
  EXPECT_EQ(timed->rate_Hz, 1000.0);
  EXPECT_EQ(timed->start_s, 10.0);
  EXPECT_EQ(timed->samples[1].acceleration_g, (Vec3{4, 5, 6}));
  const auto plain = parseRecording("1,2,3\n4,5,6\n", "r.csv", 500.0);
  ASSERT_TRUE(plain) << plain.error().text();
  EXPECT_EQ(plain->samples[1].taken, instantAt(0.002));
  const auto named = parseRecording("u,v,w\n1,2,3\n", "r.csv", 500.0);
  ASSERT_TRUE(named) << named.error().text();
  EXPECT_EQ(named->samples[0].acceleration_g, (Vec3{1, 2, 3}));
}

TEST(Recording, SaysWhatIsWrongAndWhere) {
  const auto message = [](std::string_view text, double rate_Hz = 0.0) {
    const auto result = parseRecording(text, "r.csv", rate_Hz);
    return result ? std::string("none") : result.error().text();
  };
  EXPECT_EQ(message("t_s,ax,ay,az\n0,1,1,1\n0.2,1,1,1\n0.1,1,1,1\n"),
            "r.csv:4: t_s = 0.1 after 0.2: expected times that do not go backwards");
  EXPECT_EQ(message("t_s,ax,ay,az\n0,1,1,1\nnan,1,1,1\n"), "r.csv:3: t_s = nan: expected a finite time in seconds");
  EXPECT_EQ(message("ax,ay,az\n1,1,1\n"), "r.csv: without a column t_s the sample rate must be given");
  EXPECT_NE(message("t_s,ax,ay\n0,1,1\n", 0.0), "none");
  EXPECT_NE(message("t_s,ax,ay,az\n"), "none");
  EXPECT_EQ(message("t_s,ax,ay,az\n0,nan,1,1\n0.001,2,2,2\n"), "none");
  const auto far = parseRecording("t_s,ax,ay,az\n0,1,1,1\n0.001,1,1,1\n8e4,1,1,1\n", "r.csv", 0.0);
  ASSERT_TRUE(far);
  EXPECT_FALSE(makeUniform(*far, 1000.0));
}

TEST(Recording, TimesThatAreNoSecondsAreRefused) {
  const auto message = [](std::string_view text, double rate_Hz) {
    const auto result = parseRecording(text, "r.csv", rate_Hz);
    return result ? std::string("none") : result.error().text();
  };
  const std::string slow = "r.csv: 1 rows a second; expected 10 and more: are the times in seconds?";
  for (const double rate_Hz : {0.0, 1000.0}) {
    EXPECT_EQ(message("t_s,ax,ay,az\n0,1,1,1\n1,1,1,1\n2,1,1,1\n", rate_Hz), slow);
    EXPECT_EQ(message("t_s,ax,ay,az\n0,1,1,1\n0.001,1,1,1\n1e9,1,1,1\n", rate_Hz),
              "r.csv: 1000000000 s from the first row to the last; expected at most 86400: are the times in seconds?");
  }
  EXPECT_EQ(message("t_s,ax,ay,az\n0,1,1,1\n0.1,1,1,1\n0.2,1,1,1\n", 0.0), "none");
  EXPECT_EQ(message("ax,ay,az\n1,1,1\n2,2,2\n", 1.0), "none") << "a table without times is as slow as it is said to be";
  EXPECT_EQ(message("t_s,ax,ay,az\n0,1,1,1\n0,1,1,1\n", 1.0), "none");
}

TEST(Recording, TimesWithinANanosecondAreOneInstant) {
  const std::string text = "t_s,ax,ay,az\n0,1,1,1\n1e-12,1,1,1\n";
  const auto refused = parseRecording(text, "r.csv", 0.0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text(), "r.csv: fewer than two different times: the sample rate is unknown");
  const auto known = parseRecording(text, "r.csv", 500.0);
  ASSERT_TRUE(known);
  EXPECT_EQ(known->rate_Hz, 500.0);
  const auto uniform = makeUniform(*known, 500.0);
  ASSERT_TRUE(uniform);
  EXPECT_EQ(uniform->steps.size(), 1U);
}

TEST(Recording, OfALineOfManyNamesOnlyAsManyAreKeptAsATableMayHave) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "a name of twenty bytes,";
  const bench::AllocationCount allocations;
  const auto refused = parseRecording(text + "\n1\n", "r.csv", 0.0);
  EXPECT_LT(allocations.count(), 10'000U);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text(), "r.csv:1: more than 1000 columns; expected a table of measurements");
}

TEST(Recording, ResamplesToAnotherRate) {
  Recording fast{.rate_Hz = 2000.0};
  for (int n = 0; n < 2000; ++n) fast.samples.push_back(sample(n * 0.5, n * 0.5));
  const auto uniform = makeUniform(fast, 1000.0);
  ASSERT_TRUE(uniform);
  EXPECT_EQ(uniform->gaps, 0U);
  EXPECT_EQ(uniform->refused, 0U);
  for (std::size_t n = 1; n + 2 < uniform->steps.size(); ++n) {
    EXPECT_NEAR(uniform->steps[n].acceleration_g.x, static_cast<double>(n), 0.51);
  }
  Recording slow{.rate_Hz = 100.0};
  for (int n = 0; n < 100; ++n) slow.samples.push_back(sample(n * 10.0, n * 10.0));
  const auto lines = makeUniform(slow, 1000.0);
  ASSERT_TRUE(lines);
  EXPECT_EQ(lines->gaps, 0U);
  for (std::size_t n = 20; n + 20 < lines->steps.size(); ++n) {
    EXPECT_NEAR(lines->steps[n].acceleration_g.x, static_cast<double>(n), 0.6) << n;
  }
}

}  // namespace
}  // namespace fyd::texture
