// Exports of a recording made in memory: values, ranges, files whole or absent, flat memory.
#include "core/export/export_recording.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/videoio.hpp>

#include "core/base/csv.h"
#include "core/export/export_csv_text.h"
#include "core/export/export_words.h"
#include "core/recording/reader/review_notes.h"
#include "tests/files_of_at_most.h"
#include "tests/unit/recording/fake_recording.h"
#include "tests/unit/recording/recording_samples.h"

namespace fyd::exports {
namespace {

namespace fs = std::filesystem;
using pipeline::TelemetrySample;
using testing::HasSubstr;

/// Rows with numbers that are hard to print; 40 steps are lost after row 499.
recording::FakeRecording session(std::uint64_t rows = 1500) {
  recording::FakeRecording recording(rows, [](std::uint64_t row) {
    const std::uint64_t lost = row < 500 ? 0 : 40;
    TelemetrySample sample =
        recording::FakeRecording::sampleAt(0.001 * static_cast<double>(row + lost), row + 1 + lost);
    sample.force_N = row % 7 == 3 ? pipeline::kNone : 1.0 / (1.0 + static_cast<double>(row));
    sample.indentation_mm = row == 0 ? 5e-324 : (row == 1 ? 1.7976931348623157e308 : -0.1 * static_cast<double>(row));
    sample.stiffness_N_per_mm = row == 2 ? std::numeric_limits<double>::infinity() : 0.1 + 0.2;
    return sample;
  });
  recording.notes_.push_back({instantAt(100.7), recording::NoteKind::note, "said \"wet\", then\nslipped"});
  recording.notes_.push_back({instantAt(100.1), recording::NoteKind::bookmark, "first"});
  recording.events_.push_back({instantAt(100.2),
                               {.kind = pipeline::EventKind::state_changed,
                                .state = pipeline::SafetyState::held,
                                .fault = pipeline::Fault::robot_lost}});
  return recording;
}

void addPictures(recording::FakeRecording& recording, const std::vector<double>& times_s, cv::Size size = {64, 48}) {
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    cv::Mat whole(size, CV_8UC1);
    cv::randu(whole, 0, 256);
    recording.pictures_.push_back({.time_s = times_s[i],
                                   .number = 10 + i,
                                   .whole = whole,
                                   .region = whole(cv::Rect(3, 5, 31, 21)).clone(),
                                   .region_px = cv::Rect(3, 5, 31, 21)});
  }
  recording.info_.frames = recording.pictures_.size();
}

class Export : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "fyd-export-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] static std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }
  static ExportResult done(Result<ExportResult> result) {
    EXPECT_TRUE(result) << result.error().text();
    return result.value_or(ExportResult{});
  }

  fs::path folder_;
};

bool same(double a, double b) { return std::isnan(a) ? std::isnan(b) : a == b; }

TEST_F(Export, CsvReadsBackEqualInEveryField) {
  const recording::FakeRecording recording = session();
  EXPECT_EQ(done(exportRecording(recording, path("a.csv"), {})).rows, 1500U);
  std::vector<std::string> columns = {"time_s [s]"};
  for (const auto& field : pipeline::telemetryFields()) columns.push_back(columnTitle(field));
  const auto table = readCsv(path("a.csv"), columns);
  ASSERT_TRUE(table) << table.error().text();
  ASSERT_EQ(table->rows(), 1500U);
  std::vector<TelemetrySample> rows(1500);
  ASSERT_TRUE(recording.telemetry(0, rows));
  for (std::size_t row = 0; row < rows.size(); ++row) {
    ASSERT_EQ(table->values[0][row], secondsInto(recording.info(), rows[row].now));
    for (std::size_t f = 0; f + 1 < columns.size(); ++f) {
      ASSERT_TRUE(same(table->values[f + 1][row], pipeline::telemetryFields()[f].read(rows[row])))
          << columns[f + 1] << " in row " << row;
    }
  }
  EXPECT_EQ(table->values[2][499], 500.0);  // the step, before and after the lost ones
  EXPECT_EQ(table->values[2][500], 541.0);
}

TEST_F(Export, CsvEventsStandInOrderAndQuoted) {
  EXPECT_EQ(done(exportRecording(session(), path("a.csv"), {})).lines, 3U);
  const std::string text = read(path("a.events.csv"));
  EXPECT_THAT(text, testing::StartsWith("time_s [s],kind,text,value\n0.1,bookmark,first,nan\n0.2,state changed,"));
  EXPECT_THAT(text, HasSubstr("0.7,note,\"said \"\"wet\"\", then\nslipped\",nan\n"));
  EXPECT_THAT(text, HasSubstr("Held: "));
}

TEST_F(Export, RangeAndFieldsAreHonoured) {
  const auto result =
      done(exportRecording(session(), path("a.csv"), {.from_s = 0.1, .to_s = 0.2, .fields = {"force_N", "step"}}));
  EXPECT_EQ(result.rows, 101U);  // both ends
  EXPECT_EQ(result.lines, 2U);
  const std::string text = read(path("a.csv"));
  EXPECT_THAT(text, testing::StartsWith("time_s [s],force_N [N],step [1]\n0.1,"));
  EXPECT_THAT(text, HasSubstr("\n0.2,"));
  EXPECT_THAT(text, testing::Not(HasSubstr("\n0.201,")));
}

TEST_F(Export, OfARecordedFileTheRowsAtBothEndsBelongToTheRange) {
  auto writer = recording::RecordingWriter::create(path("a.h5"), recording::samples::header());
  ASSERT_TRUE(writer) << writer.error().text();
  for (std::uint64_t row = 0; row < 300; ++row) ASSERT_TRUE((*writer)->append(recording::samples::plainStep(row)));
  ASSERT_TRUE((*writer)->close());
  const auto recording = recording::Recording::open(path("a.h5"));
  ASSERT_TRUE(recording) << recording.error().text();
  for (const double to_s : {0.1, 0.2, 0.255, 0.299}) {  // a row each millisecond
    const auto first = static_cast<std::uint64_t>(std::llround(1000.0 * to_s));
    EXPECT_EQ(done(exportRecording(**recording, path("one.csv"), {.from_s = to_s, .to_s = to_s, .replace = true})).rows,
              1U)
        << to_s;
    EXPECT_EQ(done(exportRecording(**recording, path("all.csv"), {.to_s = to_s, .replace = true})).rows, first + 1)
        << to_s;
  }
}

TEST_F(Export, WrongWishesAreRefusedByNameAndLeaveNoFile) {
  const recording::FakeRecording recording = session();
  const auto refused = [&](const std::string& name, const ExportOptions& options) {
    const auto result = exportRecording(recording, path(name), options);
    EXPECT_FALSE(result) << name;
    EXPECT_EQ(files(), 0U) << name;
    return result ? std::string() : result.error().text();
  };
  EXPECT_THAT(refused("a.xls", {}), HasSubstr(".csv, .mat"));
  EXPECT_THAT(refused("a.csv", {.fields = {"force"}}), testing::AllOf(HasSubstr("\"force\""), HasSubstr("force_N")));
  EXPECT_THAT(refused("a.csv", {.fields = {"step", "step"}}), HasSubstr("twice"));
  EXPECT_THAT(refused("a.csv", {.from_s = 2.0, .to_s = 1.0}), HasSubstr("2 s to 1 s"));
  EXPECT_THAT(refused("a.csv", {.from_s = pipeline::kNone}), HasSubstr("nan"));
  for (const char* name : {"a.csv", "a.mat", "a.mcap"})
    for (const ExportOptions& outside :
         {ExportOptions{.from_s = 100.0}, {.to_s = -1.0}, {.to_s = -std::numeric_limits<double>::infinity()}})
      EXPECT_THAT(refused(name, outside), HasSubstr("no samples"));
  EXPECT_THAT(refused("a.mkv", {}), HasSubstr("no picture"));
  EXPECT_THAT(refused("nowhere/a.csv", {}), HasSubstr("nowhere/a.csv"));
}

TEST_F(Export, AnExistingFileIsReplacedOnlyWhenAsked) {
  for (const char* name : {"a.csv", "b.events.csv"}) std::ofstream(path(name)) << "mine";
  for (const char* name : {"a.csv", "b.csv"}) {
    const auto result = exportRecording(session(), path(name), {});
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().text(), HasSubstr("exists already"));
  }
  EXPECT_EQ(files(), 2U);
  EXPECT_EQ(read(path("a.csv")), "mine");
  done(exportRecording(session(), path("a.csv"), {.replace = true}));
  EXPECT_THAT(read(path("a.csv")), testing::StartsWith("time_s [s]"));
}

TEST_F(Export, ADamagedRecordingOrAFullDiskLeavesNothing) {
  recording::FakeRecording recording = session(20'000);
  std::vector<double> times_s;
  times_s.reserve(30);
  for (int i = 0; i < 30; ++i) times_s.push_back(0.1 * i);
  addPictures(recording, times_s);
  recording.failure_ = "block 7: checksum";
  for (const char* name : {"a.csv", "a.mat", "a.mcap"}) {
    const auto result = exportRecording(recording, path(name), {});
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().text(), HasSubstr("block 7"));
    EXPECT_EQ(files(), 0U);
  }
  recording.failure_.clear();
  std::vector<std::string> messages;
  std::size_t left = 0;
  {
    const FilesOfAtMost small(20'000);
    for (const char* name : {"a.csv", "a.mat", "a.mcap", "a.mkv"}) {
      const auto result = exportRecording(recording, path(name), {});
      messages.push_back(result ? "no error" : result.error().text());
      left += files();
    }
  }
  EXPECT_THAT(messages, testing::Each(testing::AllOf(HasSubstr("writ"), HasSubstr("/a."))))
      << testing::PrintToString(messages);
  EXPECT_EQ(left, 0U);
}

TEST_F(Export, ReviewNotesComeAlsoByALink) {
  recording::FakeRecording recording = session();
  std::ofstream(path("r.h5")) << "a recording";
  fs::create_symlink("r.h5", path("link.h5"));
  ASSERT_TRUE(recording::writeReviewNotes(
      path("r.h5"), recording.info_.header.id,
      {.notes = {{.time_s = 0.5, .text = "seen later"}}, .tags = std::vector<std::string>{"good"}}));
  recording.info_.path = path("link.h5");
  const auto lines = logLines(recording, 0.0);
  ASSERT_TRUE(lines) << lines.error().text();
  EXPECT_EQ(std::ranges::count(*lines, "seen later", &LogLine::text), 1);
  EXPECT_THAT(recording::tagsInForce(recording.info()), testing::ElementsAre("good"));
}

TEST_F(Export, AMatFileCutAnywhereIsNoFile) {
  const recording::FakeRecording recording = session(2000);
  const ExportOptions options{.fields = {"step", "force_N"}};
  done(exportRecording(recording, path("whole.mat"), options));
  const auto whole = fs::file_size(path("whole.mat"));
  const auto samples = 2000 * 3 * sizeof(double);
  ASSERT_GT(whole, samples + 1000);
  std::vector<std::uintmax_t> taken;  // with these limits it came to a result
  for (std::uintmax_t limit = samples; limit <= whole; limit += std::clamp<std::uintmax_t>(whole - limit, 1, 97)) {
    const FilesOfAtMost small(limit);
    if (exportRecording(recording, path("cut.mat"), options)) taken.push_back(limit);
  }
  EXPECT_THAT(taken, testing::ElementsAre(whole));
  EXPECT_EQ(files(), 2U);
}

TEST_F(Export, TellsHowFarItIsAndLeavesNothingWhenEnded) {
  recording::FakeRecording recording = session(5000);
  addPictures(recording, {0.0, 0.1, 0.2, 0.3});
  for (const char* name : {"all.csv", "all.mat", "all.mcap", "all.mkv"}) {
    std::vector<double> told;
    const auto tell = [&](double share) {
      told.push_back(share);
      return true;
    };
    done(exportRecording(recording, path(name), {.progress = tell}));
    ASSERT_GE(told.size(), 3U) << name;
    EXPECT_GE(told.front(), 0.0) << name;
    EXPECT_LE(told.back(), 1.0) << name;
  }
  const std::size_t before = files();
  for (const char* name : {"no.csv", "no.mat", "no.mcap", "no.mkv"}) {
    int asked = 0;
    const auto ended = exportRecording(recording, path(name), {.progress = [&](double) { return ++asked < 2; }});
    ASSERT_FALSE(ended) << name;
    EXPECT_THAT(ended.error().text(), HasSubstr("cancelled"));
    EXPECT_EQ(asked, 2) << name;
  }
  EXPECT_EQ(files(), before);
}

TEST_F(Export, NeverReadsMoreThanABlock) {
  recording::FakeRecording recording = session(200'000);
  for (const char* name : {"a.csv", "a.mat", "a.mcap"})
    done(exportRecording(recording, path(name), {.fields = {"force_N"}}));
  EXPECT_LE(recording.largest_read_, 1000U);
}

TEST_F(Export, VideoWithoutLossHoldsThePicturesAtTheirTimes) {
  recording::FakeRecording recording = session();
  addPictures(recording, {0.0, 0.1, 0.2, 0.31, 0.6, 0.7});  // 10 a second; two are missing
  const auto result = done(exportRecording(recording, path("a.mkv"), {}));
  EXPECT_DOUBLE_EQ(result.rate_Hz, 10.0);
  EXPECT_EQ(result.pictures, 6U);
  EXPECT_EQ(result.repeated, 2U);
  cv::VideoCapture video(path("a.mkv"));
  cv::Mat frame;
  const std::vector<std::size_t> expected = {0, 1, 2, 3, 3, 3, 4, 5};
  for (const std::size_t index : expected) {
    ASSERT_TRUE(video.read(frame));
    std::vector<cv::Mat> planes;
    cv::split(frame, planes);
    EXPECT_EQ(cv::norm(planes[0], recording.pictures_[index].whole, cv::NORM_INF), 0.0) << index;
  }
  EXPECT_FALSE(video.read(frame));
  EXPECT_THAT(read(path("a.times.csv")), HasSubstr("3,3,13,0.31\n4,3,13,0.31\n5,3,13,0.31\n6,4,14,0.6\n"));
}

TEST_F(Export, AVideosKindIsInItsEndingHoweverThatIsWritten) {
  recording::FakeRecording recording = session();
  addPictures(recording, {0.0, 0.1, 0.2});
  for (const char* name : {"a.Mkv", "b.mKV", "c.MKV"}) {
    done(exportRecording(recording, path(name), {}));
    cv::VideoCapture video(path(name));
    cv::Mat frame;
    for (const auto& picture : recording.pictures_) {
      ASSERT_TRUE(video.read(frame)) << name;
      std::vector<cv::Mat> planes;
      cv::split(frame, planes);
      EXPECT_EQ(cv::norm(planes[0], picture.whole, cv::NORM_INF), 0.0) << name << ": without loss";
    }
  }
}

TEST_F(Export, AStartThatNanosecondsCannotTellIsNoTime) {
  recording::FakeRecording recording = session(10);
  recording.notes_.clear();
  const auto seconds = [&](const char* started_utc) {
    recording.info_.header.started_utc = started_utc;
    done(exportRecording(recording, path("a.mcap"), {.replace = true}));
    const std::string text = read(path("a.mcap"));
    const std::string key = R"("timestamp":{"sec":)";
    const std::size_t at = text.find(key);
    return at == text.npos ? std::string("none") : text.substr(at + key.size(), text.find(',', at) - at - key.size());
  };
  EXPECT_EQ(seconds("2026-03-14T09:26:53.500Z"), "1773480413");  // date -u -d 2026-03-14T09:26:53Z +%s
  EXPECT_EQ(seconds("2262-04-11T23:47:15Z"), "9223372035");
  for (const char* wrong : {"2262-04-11T23:47:16Z", "9999-01-01T00:00:00", "1969-12-31T23:59:59Z",
                            "0001-01-01T00:00:00", "2026-03-14T09:26:53.5e300Z", "today"}) {
    EXPECT_EQ(seconds(wrong), "0") << wrong;
  }
  recording.info_.header.started = instantAt(90.0);  // the first line comes ten seconds later, beyond the last one
  EXPECT_EQ(seconds("2262-04-11T23:47:15Z"), "9223372036");
}

TEST_F(Export, VideoOfTheRegionOfARangeHasAnEvenSize) {
  recording::FakeRecording recording = session();
  addPictures(recording, {0.0, 0.1, 0.2, 0.3, 0.4});
  EXPECT_EQ(done(exportRecording(recording, path("a.avi"), {.from_s = 0.1, .to_s = 0.3, .region = true})).pictures, 3U);
  const cv::VideoCapture video(path("a.avi"));
  EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_WIDTH), 32.0);
  EXPECT_EQ(video.get(cv::CAP_PROP_FRAME_HEIGHT), 22.0);
  recording.pictures_[2].region = cv::Mat(10, 10, CV_8UC1, cv::Scalar(0));
  const auto mixed = exportRecording(recording, path("b.avi"), {.region = true});
  ASSERT_FALSE(mixed);
  EXPECT_THAT(mixed.error().text(), HasSubstr("10 × 10"));
}

TEST_F(Export, ALongBreakOfTheCameraIsCut) {
  recording::FakeRecording recording = session();
  addPictures(recording, {0.0, 0.1, 0.2, 3600.0, 3600.1});
  const auto result = done(exportRecording(recording, path("a.mkv"), {}));
  EXPECT_EQ(result.pictures, 5U);
  EXPECT_EQ(result.repeated, 99U);
}

TEST(ExportWords, TextThatIsNoUtf8IsMadeWhole) {
  EXPECT_EQ(cleanText("ä\n\t€😀"), "ä\n\t€😀");
  EXPECT_EQ(cleanText("a\xff\x01z"), "a\xEF\xBF\xBD\xEF\xBF\xBDz");
  EXPECT_EQ(cleanText("\xe2\x82"), "\xEF\xBF\xBD\xEF\xBF\xBD");
}

TEST(ExportWords, AParameterIsNamedWithItsUnitOrItsWord) {
  const auto changed = [](std::uint16_t index, double value) {
    return describeEvent({.kind = pipeline::EventKind::parameter_changed, .index = index, .value = value});
  };
  EXPECT_EQ(changed(0, 40.0), "pipeline.finger_maximum_age_ms = 40 ms");
  EXPECT_EQ(changed(10, 1.0), "sensing.finger_mode = thesis");
  EXPECT_EQ(changed(60'000, 1.5), "parameter 60000 = 1.5");
  EXPECT_THAT(changed(10, pipeline::kNone), HasSubstr("nan"));
  for (const double wild : {-1.0, 1e300, 1.8446744073709552e19, std::numeric_limits<double>::infinity()})
    EXPECT_EQ(changed(10, wild), fmt::format("sensing.finger_mode = {}", wild));
}

TEST(ExportWords, ANumberThatThisProgramDoesNotKnowIsShown) {
  EXPECT_EQ(describeEvent({.kind = pipeline::EventKind::state_changed,
                           .state = pipeline::SafetyState::held,
                           .fault = static_cast<pipeline::Fault>(40)}),
            "Held: a reason that this program does not know (code 40)");
  EXPECT_EQ(describeEvent({.kind = static_cast<pipeline::EventKind>(41), .value = 2.0}), "code 41, value 2");
  EXPECT_EQ(toString(static_cast<pipeline::EventKind>(41)), "unknown");
}

TEST(ExportWords, TheNumbersOfEventsInFilesStay) {
  // As written by the program that gave them numbers; a new one is added here and never changed.
  const std::array<std::string_view, 9> names{"state changed", "arm refused",       "tare done",
                                              "tare failed",   "parameter changed", "parameter refused",
                                              "robot command", "target clamped",    "time reversed"};
  for (std::size_t number = 0; number < names.size(); ++number) {
    EXPECT_EQ(toString(static_cast<pipeline::EventKind>(number)), names[number]);
  }
  EXPECT_EQ(toString(static_cast<pipeline::EventKind>(200)), "unknown");
}

}  // namespace
}  // namespace fyd::exports
