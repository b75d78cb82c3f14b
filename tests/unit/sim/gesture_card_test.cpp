// Gesture cards: reading, writing, trimming, refusal with line, playing through the whole chain.
#include "core/sim/gesture_card.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "core/sim/touchpad/lockstep.h"
#include "tests/temporary_folder.h"

namespace fyd::sim {
namespace {

const std::string kHead = "format = \"FYD gesture 1\"\nname = \"a stroke\"\n";
const std::string kRows = "t_s,x_mm,y_mm,depth_mm\n0,-10,5,2\n1,10,5,3\n1.5,10,5,0\n";

std::string errorOf(const std::string& text) {
  const auto card = parseGesture(text, "card");
  return card ? "accepted" : card.error().text();
}

TEST(GestureCard, IsReadAsItStandsAndPlayed) {
  const GestureCard card =
      parseGesture(kHead + "speed = 2\nloop = false\nsource = \"a.fyd, touch 3\"\n---\n" + kRows, "card").value();
  EXPECT_EQ(card.name, "a stroke");
  EXPECT_EQ(card.source, "a.fyd, touch 3");
  EXPECT_EQ(card.duration_s(), 1.5);
  const FingerPath path = card.path();
  EXPECT_DOUBLE_EQ(path.at(0.25).x_mm, 0.0);  // half of the way in half the time
  EXPECT_DOUBLE_EQ(path.at(0.25).indentation_mm, 2.5);
  EXPECT_TRUE(path.at(0.76).lifted);
  EXPECT_TRUE(path.at(100.0).lifted) << "once";
}

TEST(GestureCard, AFingerIsPutDownAndLiftedAlongTheLineToDepth0) {
  const FingerPath path =
      parseGesture(kHead + "---\nt_s,x_mm,y_mm,depth_mm\n0,0,0,0\n2,4,0,5\n4,4,8,0\n5,9,8,0\n", "card").value().path();
  EXPECT_TRUE(path.at(0.0).lifted);
  for (const double t : {0.01, 1.0, 1.99, 2.01, 3.0, 3.99}) {
    EXPECT_FALSE(path.at(t).lifted) << t;
    EXPECT_NEAR(path.at(t).indentation_mm, t < 2.0 ? 2.5 * t : 10.0 - 2.5 * t, 1e-12) << t;
    EXPECT_NEAR(path.at(t).x_mm, std::min(2.0 * t, 4.0), 1e-12) << t;
    EXPECT_NEAR(path.at(t).y_mm, t < 2.0 ? 0.0 : 4.0 * t - 8.0, 1e-12) << t;
  }
  EXPECT_TRUE(path.at(4.5).lifted);
  EXPECT_EQ(path.at(4.5).indentation_mm, 0.0);
  EXPECT_NEAR(path.at(4.5).x_mm, 6.5, 1e-12) << "a lifted finger goes straight too";
}

TEST(GestureCard, LoopsUnlessItIsToBePlayedOnce) {
  const FingerPath path = parseGesture(kHead + "---\n" + kRows, "card").value().path();
  EXPECT_FALSE(path.at(0.5).lifted);
  EXPECT_TRUE(path.at(1.9).lifted) << "half a second between two times";
  EXPECT_FALSE(path.at(2.5).lifted);
  EXPECT_NEAR(path.at(2.5).x_mm, path.at(0.5).x_mm, 1e-9);
}

TEST(GestureCard, LinesMayEndAsAnotherEditorEndsThem) {
  const auto withCarriageReturns = [](std::string_view text) {
    std::string out;
    for (const char c : text) out += c == '\n' ? std::string("\r\n") : std::string(1, c);
    return out;
  };
  const GestureCard card = parseGesture(withCarriageReturns(kHead + "loop = false\n---\n" + kRows), "card").value();
  EXPECT_EQ(card.name, "a stroke");
  EXPECT_FALSE(card.loop);
  ASSERT_EQ(card.rows.size(), 3U);
  EXPECT_EQ(card.rows[1].state.indentation_mm, 3.0);
  EXPECT_THAT(errorOf(withCarriageReturns(kHead + "---\nt_s,x_mm,y_mm,depth_mm\n0,-10,5,2\n1,90,5,3\n")),
              testing::HasSubstr("card:6: x_mm is 90"));
}

TEST(GestureCard, IsWrittenAsItIsRead) {
  GestureCard card = parseGesture(kHead + "---\n" + kRows, "card").value();
  card.name = "quotes \" and \\ and é";
  card.speed = 0.1;
  card.loop = false;
  card.rows[1].state.x_mm = 1.0 / 3.0;
  const std::string text = formatGesture(card).value();
  EXPECT_TRUE(isGestureCard(text));
  const GestureCard again = parseGesture(text, "again").value();
  EXPECT_EQ(again.name, card.name);
  EXPECT_EQ(again.speed, card.speed);
  EXPECT_EQ(again.loop, card.loop);
  ASSERT_EQ(again.rows.size(), card.rows.size());
  for (std::size_t i = 0; i < card.rows.size(); ++i) {
    EXPECT_EQ(again.rows[i].time_s, card.rows[i].time_s);
    EXPECT_EQ(again.rows[i].state.x_mm, card.rows[i].state.x_mm);
    EXPECT_EQ(again.rows[i].state.lifted, card.rows[i].state.lifted);
  }
}

TEST(GestureCard, WhatIsWrongIsNamedWithItsLine) {
  const auto row = [](const std::string& text) {
    return errorOf(kHead + "---\nt_s,x_mm,y_mm,depth_mm\n0,0,0,1\n" + text);
  };
  EXPECT_EQ(row("1,50,0,1\n"), "card:6: x_mm is 50; expected −45 to 45");
  EXPECT_EQ(row("1,0,-31,1\n"), "card:6: y_mm is -31; expected −30 to 30");
  EXPECT_EQ(row("1,0,0,9\n"), "card:6: depth_mm is 9; expected 0 to 8");
  EXPECT_EQ(row("1,0,0,-1\n"), "card:6: depth_mm is -1; expected 0 to 8");
  EXPECT_EQ(row("1,nan,0,1\n"), "card:6: x_mm is nan; expected −45 to 45");
  EXPECT_EQ(row("0,0,0,1\n"), "card:6: t_s is 0 after 0; time must increase from row to row");
  EXPECT_EQ(row("601,0,0,1\n"), "card:6: t_s is 601; expected 0 to 600 s");
  EXPECT_EQ(row("inf,0,0,1\n"), "card:6: t_s is inf; expected 0 to 600 s");
  EXPECT_EQ(row(""), "card: 1 rows: expected two and more");
  EXPECT_THAT(row("1,0,x,1\n"), ::testing::HasSubstr("card"));
  EXPECT_EQ(errorOf(kHead + kRows), "card: no line --- between the card's head and its rows; expected one");
  EXPECT_EQ(errorOf("format = \"FYD gesture 2\"\nname = \"a\"\n---\n" + kRows),
            "card:1: format = \"FYD gesture 2\": expected \"FYD gesture 1\"");
  EXPECT_EQ(errorOf(kHead + "colour = 1\n---\n" + kRows),
            "card:3: colour: expected one of format, name, source, speed, loop");
  EXPECT_EQ(errorOf(kHead + "speed = \"fast\"\n---\n" + kRows), "card:3: speed: expected a number");
  EXPECT_EQ(errorOf(kHead + "speed = nan\n---\n" + kRows), "card: speed = nan: expected 0.05 to 20");
  EXPECT_EQ(errorOf(kHead + "speed = 0\n---\n" + kRows), "card: speed = 0: expected 0.05 to 20");
  EXPECT_EQ(errorOf(kHead + "loop = 1\n---\n" + kRows), "card:3: loop: expected true or false");
  EXPECT_EQ(errorOf("format = \"FYD gesture 1\"\nname = \"\"\n---\n" + kRows),
            "card: name of 0 bytes: expected 1 to 200 that can be printed");
  EXPECT_EQ(errorOf("format = \"FYD gesture 1\"\n---\n" + kRows), "card:1: name: expected a text in quotes");
  EXPECT_THAT(errorOf(kHead + "speed = = 1\n---\n" + kRows), ::testing::StartsWith("card:3"));
  GestureCard bad = parseGesture(kHead + "---\n" + kRows, "card").value();
  bad.rows[1].state.x_mm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(formatGesture(bad).error().text(), ::testing::StartsWith("gesture, row 2: x_mm is nan"));
}

TEST(GestureCard, IsTrimmedToBeginAtItsOwnZero) {
  const GestureCard card = parseGesture(kHead + "---\n" + kRows, "card").value();
  const GestureCard part = trimmed(card, 0.5, 1.6).value();
  ASSERT_EQ(part.rows.size(), 2U);
  EXPECT_EQ(part.rows[0].time_s, 0.0);
  EXPECT_EQ(part.rows[0].state.x_mm, 10.0);
  EXPECT_EQ(part.rows[1].time_s, 0.5);
  EXPECT_THAT(trimmed(card, 1.2, 9.0).error().text(), ::testing::HasSubstr("1 rows from 1.2 to 9 s"));
}

TEST(GestureCard, AFileIsACardOrARecording) {
  const Folder folder;
  const std::string file = folder.file("card");
  const auto path = [&](const std::string& text) {
    std::ofstream(file) << text;
    return readFingerFile(file);
  };
  EXPECT_EQ(path(kHead + "---\n" + kRows).value().rows(), 3U);
  EXPECT_EQ(path("# mine\n\n" + kHead + "---\n" + kRows).value().rows(), 3U);
  EXPECT_EQ(path("name = \"a\"\nformat = \"FYD gesture 1\"\r\n---\r\n" + kRows).value().rows(), 3U);
  EXPECT_EQ(path("t_s,x_mm,y_mm,z_mm\n0,1,2,-1\n1,2,3,-1\n").value().rows(), 2U);
  EXPECT_THAT(path(kHead + kRows).error().text(), ::testing::HasSubstr("no line ---"));
  EXPECT_FALSE(path(""));
  EXPECT_THAT(readGestureFile("nowhere.gesture").error().text(), ::testing::StartsWith("nowhere.gesture: "));
}

// Through the step: the touchpad sees the finger of the card, and only an armed session moves the robot by it.
TEST(GestureCard, IsPlayedThroughTheWholeChain) {
  LockstepOptions options;
  options.finger =
      parseGesture(kHead + "---\nt_s,x_mm,y_mm,depth_mm\n0,-10,5,3\n2,-10,5,3\n4,10,5,3\n6,10,5,3\n", "card")
          .value()
          .path();
  for (const bool armed : {false, true}) {
    Lockstep session(options);
    session.run(1.0);
    if (armed) (void)session.next.commands.push({.action = pipeline::OperatorAction::arm});
    double seen_mm = 0.0;
    session.run(4.5, [&](const pipeline::Outputs& outputs) { seen_mm = outputs.telemetry.finger_x_mm; });
    EXPECT_NEAR(seen_mm, 10.0, 1.0);
    EXPECT_NEAR(session.outputs().touch.position_mm.x, armed ? 20.0 : 0.0, armed ? 1.5 : 0.0);
  }
}

}  // namespace
}  // namespace fyd::sim
