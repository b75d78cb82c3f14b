// Any values written to a recording are read back bit for bit.
#include <gtest/gtest.h>

#include "core/recording/format/recording_format.h"
#include "recording_samples.h"

namespace fyd::recording {
namespace {

using namespace samples;

TEST(RecordingFormat, EveryTelemetryFieldIsAColumnAndNothingElse) {
  const auto& columns = layoutOf(Table::telemetry).columns;
  const auto fields = pipeline::telemetryFields();
  ASSERT_EQ(columns.size(), fields.size() + 1);
  EXPECT_EQ(columns[0].name, "now_ns");
  RandomSteps random(7);
  for (int i = 0; i < 50; ++i) {
    const auto sample = random.next().telemetry;
    const auto row = toRow(sample);
    for (std::size_t f = 0; f < fields.size(); ++f) {
      EXPECT_EQ(columns[f + 1].name, fields[f].name);
      EXPECT_EQ(columns[f + 1].unit, fields[f].unit);
      EXPECT_EQ(std::bit_cast<std::uint64_t>(numberIn(row.data(), telemetryColumn(f))),
                std::bit_cast<std::uint64_t>(fields[f].read(sample)))
          << fields[f].name;
    }
  }
}

struct Anything {
  template <class T>
  operator T() const;
};
template <class T, std::size_t Count = 0>
constexpr std::size_t membersOf() {
  constexpr bool kTakesOneMore = []<std::size_t... I>(std::index_sequence<I...>) {
    return requires { T{(static_cast<void>(I), Anything())...}; };
  }
  (std::make_index_sequence<Count + 1>());
  if constexpr (kTakesOneMore)
    return membersOf<T, Count + 1>();
  else
    return Count;
}
/// Whether every member is described: one that is not would be lost in every recording.
template <class T>
bool describesAll(std::size_t parts_of_members = 0) {
  std::size_t fields = 0;
  forEachField<T>([&](auto, const auto& field) {
    if (std::is_lvalue_reference_v<FieldResult<decltype(field), T>>) ++fields;
  });
  return fields == membersOf<T>() + parts_of_members;
}

TEST(RecordingFormat, EveryMemberOfADescribedStructIsDescribed) {
  constexpr std::size_t kOfAVector = 2;  // three components are one member
  EXPECT_TRUE(describesAll<pipeline::TelemetrySample>());
  EXPECT_TRUE(describesAll<sensing::FingerDetection>());
  EXPECT_TRUE(describesAll<sensing::BridgeReading>());
  EXPECT_TRUE(describesAll<control::MotorFeedback>());
  EXPECT_TRUE(describesAll<control::MotorCommand>());
  EXPECT_TRUE(describesAll<pipeline::RobotState>(kOfAVector));
  EXPECT_TRUE(describesAll<pipeline::RobotMotorReference>());
  EXPECT_TRUE(describesAll<texture::AccelerationSample>(kOfAVector));
  EXPECT_TRUE(describesAll<pipeline::OperatorCommand>());
  EXPECT_TRUE(describesAll<pipeline::ParameterChange>());
  EXPECT_TRUE(describesAll<pipeline::Event>());
  EXPECT_TRUE(describesAll<LinkRow>());
  EXPECT_TRUE(describesAll<NoteIndex>());
  // The robot's five are in Inputs through one member.
  EXPECT_EQ(kFieldCount<pipeline::Inputs> + kInputTableCount,
            membersOf<pipeline::Inputs>() - 1 + membersOf<pipeline::RobotInputs>());
}

TEST(RecordingFormat, ColumnsLieInOrderWithinTheirRow) {
  for (std::size_t i = 0; i < kTableCount; ++i) {
    const TableLayout& layout = layoutOf(static_cast<Table>(i));
    std::vector<bool> taken(layout.row_bytes);
    for (const Column& column : layout.columns)
      for (std::size_t b = 0; b < column.bytes(); ++b) {
        ASSERT_LT(column.offset + b, layout.row_bytes) << layout.path;
        EXPECT_FALSE(taken[column.offset + b]) << layout.path << " " << column.name;
        taken[column.offset + b] = true;
      }
  }
}

TEST(RecordingFormat, TheInputsTablesAreThoseOfTheirNumbers) {
  EXPECT_STREQ(layoutOf(Table::finger).path, "/inputs/finger");
  EXPECT_STREQ(layoutOf(Table::motor_reference).path, "/inputs/motor_reference");
  EXPECT_STREQ(layoutOf(Table::changes).path, "/inputs/changes");
  for (std::size_t i = 0; i < kTableCount; ++i) EXPECT_NE(layoutOf(static_cast<Table>(i)).row_bytes, 0U) << i;
}

TEST(RecordingFile, RandomStepsComeBackBitForBit) {
  const Folder folder;
  auto writer = RecordingWriter::create(folder.file(), header());
  ASSERT_TRUE(writer) << writer.error().text();
  RandomSteps random(1);
  std::vector<StepRecord> steps;
  steps.reserve(1103);
  for (int i = 0; i < 1103; ++i) {
    steps.push_back(random.next());
    ASSERT_TRUE((*writer)->append(steps.back()));
    if (i % 317 == 0) {
      ASSERT_TRUE((*writer)->commit());
    }
  }
  ASSERT_TRUE((*writer)->close());
  const auto opened = Recording::open(folder.file());
  ASSERT_TRUE(opened) << opened.error().text();
  const Recording& recording = **opened;
  EXPECT_EQ(recording.info().wholeness, Wholeness::whole);
  ASSERT_EQ(recording.info().committed_samples, steps.size());
  std::vector<pipeline::TelemetrySample> telemetry(steps.size());
  ASSERT_TRUE(recording.telemetry(0, telemetry));
  std::vector<double> force(steps.size());
  ASSERT_TRUE(recording.field(11, 0, force));
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto step = recording.step(i);
    ASSERT_TRUE(step) << step.error().text();
    ASSERT_TRUE(sameRecord(*step, steps[i])) << i;
    ASSERT_TRUE(same(telemetry[i], steps[i].telemetry)) << i;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(force[i]), std::bit_cast<std::uint64_t>(steps[i].telemetry.force_N));
  }
}

TEST(RecordingFile, NumbersThatALaterProgramGaveMeaningStayAndCostNothingElse) {
  const Folder folder;
  auto writer = RecordingWriter::create(folder.file(), header());
  ASSERT_TRUE(writer);
  StepRecord step = plainStep(0);
  step.telemetry.fault = static_cast<pipeline::Fault>(40);
  step.telemetry.state = static_cast<pipeline::SafetyState>(41);
  step.telemetry.link = static_cast<pipeline::LinkPhase>(42);
  step.inputs.robot.phase = static_cast<pipeline::LinkPhase>(42);
  step.inputs.finger.value.reason = static_cast<sensing::FingerReason>(43);
  step.inputs.finger.count = 1;
  (void)step.inputs.commands.push({.action = static_cast<pipeline::OperatorAction>(44)});
  (void)step.inputs.robot.commands.push(static_cast<pipeline::RobotCommand>(45));
  (void)step.events.push({.kind = static_cast<pipeline::EventKind>(46), .fault = static_cast<pipeline::Fault>(40)});
  ASSERT_TRUE((*writer)->append(step));
  ASSERT_TRUE((*writer)->append(plainStep(1)));
  ASSERT_TRUE((*writer)->append({.when = instantAt(1000.0), .kind = static_cast<NoteKind>(47), .text = "later"}));
  ASSERT_TRUE((*writer)->close());
  const auto recording = Recording::open(folder.file());
  ASSERT_TRUE(recording) << recording.error().text();
  ASSERT_EQ((*recording)->info().committed_samples, 2U);
  const auto back = (*recording)->step(0);
  ASSERT_TRUE(back) << back.error().text();
  EXPECT_TRUE(sameRecord(*back, step));
  EXPECT_TRUE((*recording)->step(1));
  std::vector<pipeline::TelemetrySample> samples(2);
  EXPECT_TRUE((*recording)->telemetry(0, samples));
  const auto events = (*recording)->events();
  ASSERT_TRUE(events) << events.error().text();
  ASSERT_EQ(events->size(), 1U);
  const auto notes = (*recording)->notes();
  ASSERT_TRUE(notes) << notes.error().text();
  EXPECT_EQ(notes->at(0).text, "later");
}

TEST(RecordingFile, HeaderComesBack) {
  const Folder folder;
  const RecordingHeader wanted = header();
  auto writer = RecordingWriter::create(folder.file(), wanted);
  ASSERT_TRUE(writer);
  ASSERT_TRUE((*writer)->close());
  const auto recording = Recording::open(folder.file());
  ASSERT_TRUE(recording) << recording.error().text();
  const RecordingHeader& h = (*recording)->info().header;
  EXPECT_EQ(h.id, wanted.id);
  EXPECT_EQ(h.started_utc, wanted.started_utc);
  EXPECT_EQ(h.started, wanted.started);
  EXPECT_EQ(h.operator_name, wanted.operator_name);
  EXPECT_EQ(h.tags, wanted.tags);
  EXPECT_EQ(h.profile, wanted.profile);
  EXPECT_EQ(h.surface, "");
  EXPECT_EQ(h.step_state, wanted.step_state);
  EXPECT_EQ((*recording)->info().samples, 0U);
  EXPECT_EQ((*recording)->info().duration_s, 0.0);
}

TEST(RecordingFile, NotesLinksAndPicturesComeBack) {
  const Folder folder;
  auto writer = RecordingWriter::create(folder.file(), header());
  ASSERT_TRUE(writer);
  const Note note{instantAt(1000.5), NoteKind::trial_start, "Versuch 1: weich – µ"};
  ASSERT_TRUE((*writer)->append(note));
  ASSERT_TRUE((*writer)->append(Note{instantAt(1000.7), NoteKind::note, ""}));
  ASSERT_TRUE((*writer)->append(LinkRow{instantAt(1001.0), 1.5, pipeline::kNone, 0.25, 10, 20, 3}));
  for (std::uint64_t i = 0; i < 600; ++i) ASSERT_TRUE((*writer)->append(plainStep(i)));
  (*writer)->countLost(4);
  ASSERT_TRUE((*writer)->append(plainStep(604)));
  ASSERT_TRUE((*writer)->close());
  const auto recording = Recording::open(folder.file());
  ASSERT_TRUE(recording);
  const auto notes = (*recording)->notes();
  ASSERT_TRUE(notes) << notes.error().text();
  ASSERT_EQ(notes->size(), 2U);
  EXPECT_EQ((*notes)[0].text, note.text);
  EXPECT_EQ((*notes)[0].kind, note.kind);
  EXPECT_EQ((*notes)[0].when, note.when);
  const auto links = (*recording)->linkRows();
  ASSERT_TRUE(links);
  ASSERT_EQ(links->size(), 1U);
  EXPECT_EQ((*links)[0].touches_sent, 20U);
  EXPECT_TRUE(std::isnan((*links)[0].jitter_ms));
  EXPECT_EQ((*recording)->info().gaps, 4U);
  EXPECT_NEAR((*recording)->info().duration_s, 0.604, 1e-9);
  EXPECT_FALSE((*recording)->pictureAt(1.0));
}

}  // namespace
}  // namespace fyd::recording
