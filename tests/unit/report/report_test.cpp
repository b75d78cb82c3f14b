// The report's content and its two formats: escaped, complete, also for a session without any touch.
#include "core/report/report.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/base/profile_text.h"
#include "core/pipeline/parameters.h"
#include "core/report/chart_text.h"
#include "tests/unit/recording/fake_recording.h"

namespace fyd::report {
namespace {

using pipeline::TelemetrySample;
using testing::HasSubstr;
using testing::Not;

/// Two touches; 300 steps are lost in between.
recording::FakeRecording session() {
  recording::FakeRecording recording(3000, [](std::uint64_t row) {
    const std::uint64_t lost = row < 1500 ? 0 : 300;
    TelemetrySample sample =
        recording::FakeRecording::sampleAt(0.001 * static_cast<double>(row + lost), row + 1 + lost);
    sample.contact = (row > 500 && row < 1000) || (row > 2000 && row < 2500);
    sample.force_N = sample.contact ? 3.25 : 0.0;
    sample.indentation_mm = sample.contact ? 4.5 : 0.0;
    sample.stiffness_observable = sample.contact;
    sample.stiffness_N_per_mm = row < 1500 ? 0.58 : 0.3;
    sample.reachable_target_N_per_mm = 0.6;
    sample.missed_cycles = 5.0 + (row < 2000 ? 0.0 : 2.0);
    return sample;
  });
  recording.info_.header.subject = "<script>alert('S7')</script>";
  recording.info_.header.operator_name = "Ann & Bo\xff";
  return recording;
}

ReportContent contentOf(const recording::Recording& recording) {
  auto content = gatherReport(recording);
  EXPECT_TRUE(content) << content.error().text();
  return content.value_or(ReportContent{});
}

const ReportTable& tableOf(const ReportContent& content, std::string_view heading) {
  for (const ReportTable& table : content.tables) {
    if (table.heading == heading) return table;
  }
  ADD_FAILURE() << "no table " << heading;
  return content.tables.front();
}

TEST(Report, TouchesStandWithErrorAndSettling) {
  const ReportContent content = contentOf(session());
  const ReportTable& touches = tableOf(content, "Touches");
  ASSERT_EQ(touches.rows.size(), 2U);
  EXPECT_THAT(touches.rows[0],
              testing::ElementsAre("1", "0.50", "0.50", "3.25", "4.50", "0.580", "0.600", "−3.3", "0.00", "0.0", "–"));
  EXPECT_EQ(touches.rows[1][8], "never");
  EXPECT_EQ(touches.rows[1][7], "−50.0");
}

TEST(Report, HealthCountsWhatWasLost) {
  recording::FakeRecording recording = session();
  recording.info_.wholeness = recording::Wholeness::crashed;
  recording.link_rows_ = {{.round_trip_ms = 1.0, .states_received = 1000, .refused = 4},
                          {.round_trip_ms = 9.5, .states_received = 1900, .refused = 6}};
  std::string all;
  const ReportContent content = contentOf(recording);
  for (const auto& row : tableOf(content, "Health").rows) all += row[0] + "=" + row[1] + ";";
  EXPECT_THAT(all, HasSubstr("File=crashed"));
  EXPECT_THAT(all, HasSubstr("Samples lost=300 (breaks: 1);"));
  EXPECT_THAT(all, HasSubstr("Missed cycles of the loop=2;"));
  EXPECT_THAT(all, HasSubstr("worst 9.50 ms"));
  EXPECT_THAT(all, HasSubstr("900 states in, 0 touches out, 2 refused"));
  EXPECT_THAT(all, HasSubstr("Link: jitter=–;"));
}

TEST(Report, GainsComeFromTheProfileWithTheirDefaults) {
  pipeline::Parameters parameters;
  const auto all = bindParameters(parameters);
  ASSERT_TRUE(assignParameter(*findParameter(all, "control.ki"), "7.5"));
  ASSERT_TRUE(assignParameter(*findParameter(all, "sensing.frame_half_width_mm"), "61"));
  const ReportTable table = profileTable(formatProfile(all) + "\n[link]\nstate_rate_Hz = 500.0\n");
  const auto row = [&](std::string_view id) {
    for (const auto& cells : table.rows) {
      if (cells[0] == id) return cells;
    }
    return std::vector<std::string>{};
  };
  EXPECT_THAT(row("control.ki"), testing::ElementsAre("control.ki", "7.5", "1/s", Not("=")));
  EXPECT_THAT(row("control.kp"), testing::ElementsAre("control.kp", testing::_, testing::_, "="));
  EXPECT_EQ(row("sensing.frame_half_width_mm").size(), 4U);  // only because it is not at its default
  EXPECT_TRUE(row("sensing.frame_half_depth_mm").empty());
  EXPECT_THAT(profileTable("[control\n").remark, HasSubstr("cannot be read"));
  EXPECT_THAT(profileTable("").remark, HasSubstr("no profile"));
  EXPECT_FALSE(profileTable("control = 3\n").rows.empty());
  EXPECT_FALSE(profileTable("[control]\nkp = \"<b>\"\nki = [1, 2]\nkd = 1979-05-27\n").rows.empty());
}

// A key that a recording lacks had the value from before there was the key, as in its replay; not today's default.
TEST(Report, AnOlderRecordingsGainsAreThoseItHadNotTodaysDefaults) {
  pipeline::Parameters parameters;
  std::size_t checked = 0;
  const ReportTable table = profileTable("[control]\nkp = 1.5\n");
  for (const Parameter& each : bindParameters(parameters)) {
    if (!each.info.before_it_was || each.value() == *each.info.before_it_was) continue;
    const std::string today = formatParameter(each);
    each.set(*each.info.before_it_was);
    const auto row = std::ranges::find(table.rows, std::string(each.id), [](const auto& cells) { return cells[0]; });
    ASSERT_NE(row, table.rows.end()) << each.id;
    EXPECT_THAT(*row, testing::ElementsAre(std::string(each.id), formatParameter(each), testing::_, today));
    ++checked;
  }
  EXPECT_GT(checked, 2U);
  const auto area =
      std::ranges::find(table.rows, "sensing.finger_minimum_area_mm2", [](const auto& cells) { return cells[0]; });
  ASSERT_NE(area, table.rows.end());
  EXPECT_EQ((*area)[1], "54.6875");  // 150 of 160 × 120 pixels of 100 × 70 mm, in the thesis' days
}

TEST(Report, HtmlIsEscapedAndFetchesNothing) {
  recording::FakeRecording recording = session();
  recording.notes_.push_back({instantAt(101.0), recording::NoteKind::note, "<img src=x onerror=alert(1)> \"quoted\""});
  recording.info_.header.notes = "</dd><script>x</script>";
  const auto html = reportHtml(contentOf(recording));
  ASSERT_TRUE(html) << html.error().text();
  EXPECT_THAT(*html, HasSubstr("&lt;script&gt;alert(&#39;S7&#39;)"));
  EXPECT_THAT(*html, Not(HasSubstr("<script")));
  EXPECT_THAT(*html, Not(HasSubstr("<img")));
  EXPECT_THAT(*html, HasSubstr("Ann &amp; Bo\xEF\xBF\xBD"));
  EXPECT_THAT(*html, HasSubstr("<svg"));
  EXPECT_THAT(*html, Not(HasSubstr("src=\"")));
  EXPECT_THAT(*html, Not(HasSubstr("href=\"http")));
}

TEST(Report, ASessionWithoutATouchSaysSo) {
  const recording::FakeRecording calm(100, [](std::uint64_t row) {
    return recording::FakeRecording::sampleAt(0.001 * static_cast<double>(row), row + 1);
  });
  const recording::FakeRecording empty(0, [](std::uint64_t) { return TelemetrySample{}; });
  for (const recording::FakeRecording* recording : {&calm, &empty}) {
    const ReportContent content = contentOf(*recording);
    EXPECT_THAT(tableOf(content, "Touches").remark, HasSubstr("No touch"));
    const auto html = reportHtml(content);
    ASSERT_TRUE(html) << html.error().text();
    EXPECT_THAT(*html, HasSubstr("No touch"));
    const auto pdf = reportPdf(content);
    ASSERT_TRUE(pdf) << pdf.error().text();
    EXPECT_THAT(*pdf, testing::StartsWith("%PDF-"));
    EXPECT_EQ(html->find("<svg") == std::string::npos, recording == &empty);
  }
}

TEST(Report, PdfGoesOnOverPagesForLongNotesAndManyEvents) {
  recording::FakeRecording recording = session();
  for (int i = 0; i < 3000; ++i) recording.info_.header.notes += "word ";
  recording.info_.header.notes += std::string(20'000, 'x');
  recording.notes_.push_back({instantAt(100.5), recording::NoteKind::note, std::string(30'000, 'y')});
  for (int i = 0; i < 1000; ++i) recording.notes_.push_back({instantAt(100.6), recording::NoteKind::bookmark, "b"});
  const auto pdf = reportPdf(contentOf(recording));
  ASSERT_TRUE(pdf) << pdf.error().text();
  std::size_t pages = 0;
  for (std::size_t at = pdf->find("/Type /Page\n"); at != std::string::npos; at = pdf->find("/Type /Page\n", at + 1))
    ++pages;
  if (pages == 0) {
    for (std::size_t at = pdf->find("/Type /Page "); at != std::string::npos; at = pdf->find("/Type /Page ", at + 1))
      ++pages;
  }
  EXPECT_GT(pages, 10U);
}

TEST(Report, ALongLogKeepsEveryHoldAndStop) {
  recording::FakeRecording recording = session();
  for (int i = 0; i < 1000; ++i) {
    recording.events_.push_back({instantAt(100.0 + 0.001 * i), {.kind = pipeline::EventKind::parameter_changed}});
    recording.events_.push_back({instantAt(100.0 + 0.001 * i),
                                 {.kind = pipeline::EventKind::state_changed, .state = pipeline::SafetyState::active}});
  }
  recording.events_.push_back(
      {instantAt(103.0), {.kind = pipeline::EventKind::state_changed, .state = pipeline::SafetyState::stopped}});
  const ReportContent content = contentOf(recording);
  const ReportTable& log = tableOf(content, "Events, parameter changes and notes");
  ASSERT_EQ(log.rows.size(), 300U);
  EXPECT_EQ(log.rows.back()[0], "2001");
  EXPECT_THAT(log.remark, HasSubstr("300 of 2001"));
  ASSERT_FALSE(content.time.marks.empty());
  EXPECT_EQ(content.time.marks.back().label, "2001");
  EXPECT_EQ(content.time.marks.back().colour, kDangerRgb);
  EXPECT_THAT(content.legend, HasSubstr("1701 lines of the log are left out"));

  for (auto& event : recording.events_) event.event = recording.events_.back().event;  // all of them stops
  const ReportContent stops = contentOf(recording);
  EXPECT_EQ(stops.time.marks.size(), 2001U);
  EXPECT_EQ(tableOf(stops, "Events, parameter changes and notes").rows.size(), 2001U);
  EXPECT_THAT(stops.legend, Not(HasSubstr("left out")));
}

TEST(Report, EveryBreakIsInTheFigureHoweverManyThereAre) {
  const recording::FakeRecording recording(40'000, [](std::uint64_t row) {
    // Each tenth step is lost for 20 000 rows; then 5 s are, in the middle of whole ones.
    const std::uint64_t lost = std::min<std::uint64_t>(row, 20'000) / 10 + (row < 30'000 ? 0 : 5000);
    return recording::FakeRecording::sampleAt(0.001 * static_cast<double>(row + lost), row + 1 + lost);
  });
  const ReportContent content = contentOf(recording);
  ASSERT_GE(content.time.gaps.size(), 2U);
  EXPECT_LE(content.time.gaps.size(), 1000U);
  EXPECT_NEAR(content.time.gaps[content.time.gaps.size() - 2].to_s, 22.0, 0.05);
  EXPECT_NEAR(content.time.gaps.back().from_s, 32.0, 0.05);
  EXPECT_NEAR(content.time.gaps.back().to_s, 37.0, 0.05);
  std::string all;
  for (const auto& row : tableOf(content, "Health").rows) all += row[0] + "=" + row[1] + ";";
  EXPECT_THAT(all, HasSubstr("Samples lost=7000 (breaks: 2001);"));
}

TEST(Report, TheFileAppearsWholeAndIsNotReplacedUnasked) {
  std::string folder = (std::filesystem::temp_directory_path() / "fyd-report-XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const std::string path = folder + "/r.pdf";
  EXPECT_TRUE(writeReport(session(), path, false));
  EXPECT_THAT(writeReport(session(), path, false).error().text(), HasSubstr("exists already"));
  EXPECT_TRUE(writeReport(session(), path, true));
  EXPECT_THAT(writeReport(session(), folder + "/r.doc", false).error().text(), HasSubstr(".html or .pdf"));
  recording::FakeRecording damaged = session();
  damaged.failure_ = "block 2: checksum";
  EXPECT_THAT(writeReport(damaged, folder + "/d.html", false).error().text(), HasSubstr("block 2"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
  std::filesystem::remove_all(folder);
}

TEST(Chart, TicksAreRoundAndWithinBounds) {
  EXPECT_THAT(axisTicks(0.0, 4.2, 5), testing::ElementsAre(0.0, 1.0, 2.0, 3.0, 4.0));
  EXPECT_THAT(axisTicks(-30.0, 30.0, 4), testing::ElementsAre(-20.0, 0.0, 20.0));
  EXPECT_TRUE(axisTicks(1.0, 1.0, 5).empty());
  EXPECT_TRUE(axisTicks(0.0, pipeline::kNone, 5).empty());
  EXPECT_TRUE(axisTicks(0.0, std::numeric_limits<double>::infinity(), 5).empty());
  EXPECT_LE(axisTicks(-1e308, 0.7e308, 5).size(), 6U);
}

TEST(Chart, TheColoursAreTheLightWindows) {
  // The core may not include the window's theme; the table of colours stands in both, and this keeps them equal.
  std::ifstream file(FYD_SOURCE_DIR "/widgets/basics/theme.cpp");
  const std::string theme{std::istreambuf_iterator<char>(file), {}};
  const std::string light = theme.substr(theme.find("Theme lightTheme"));
  const std::pair<const char*, Rgb> colours[] = {{"force", kForceRgb},         {"indentation", kIndentationRgb},
                                                 {"stiffness", kStiffnessRgb}, {"vibration", kVibrationRgb},
                                                 {"text", kTextRgb},           {"muted", kMutedRgb},
                                                 {"danger", kDangerRgb}};
  for (const auto& [name, colour] : colours) {
    EXPECT_THAT(light, HasSubstr(fmt::format("t.{} = QColor(0x{:02x}, 0x{:02x}, 0x{:02x})", name, colour >> 16 & 0xFF,
                                             colour >> 8 & 0xFF, colour & 0xFF)));
  }
}

}  // namespace
}  // namespace fyd::report
