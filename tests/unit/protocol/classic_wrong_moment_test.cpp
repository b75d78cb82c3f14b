// Datagrams of the classic protocol that are right in themselves and come at the wrong moment, or from almost the right
// address. The bytes are those of manual/protocol-classic.md.
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/protocol/classic/classic_robot_end.h"
#include "core/protocol/classic/classic_touchpad_end.h"
#include "tests/unit/protocol/classic_text.h"

namespace fyd::protocol {
namespace {

constexpr std::string_view kReferenceInTurn = "0'00100:1'00200.\n";

class ClassicRobotInTurn : public testing::Test {
 protected:
  RobotReception give(std::string_view text) { return robot.handle(bytesOf(text), at, now); }
  void tick() {
    now += std::chrono::milliseconds(100);  // the settings' time for a reply
    static_cast<void>(robot.tick(now, {}));
  }
  void connect() {
    tick();
    for (const char* text : {"00005", "board", "^010^0'04200^1'04200"}) static_cast<void>(give(text));
    ASSERT_EQ(robot.phase(), RobotPhase::running);
  }

  const Endpoint at = *parseEndpoint("10.0.0.100:3490");
  Instant now = instantAt(100.0);
  ClassicRobotEnd robot{{}, at};
};

TEST_F(ClassicRobotInTurn, ATouchBeforeTheHandshakeIsCompleteIsRefused) {
  tick();
  EXPECT_FALSE(give(kTouch).touch);
  EXPECT_EQ(robot.counters().refused, 1U);
  EXPECT_EQ(robot.phase(), RobotPhase::handshake);
}

TEST_F(ClassicRobotInTurn, InfoValuesThatAreCutAreRefusedAndTheWholeOnesTaken) {
  tick();
  static_cast<void>(give("00005"));
  static_cast<void>(give("board"));
  EXPECT_FALSE(give("^010^0'04200^1'0420").connected);
  EXPECT_EQ(robot.counters().refused, 1U);
  EXPECT_TRUE(give("^010^0'04200^1'04200").connected);
}

TEST_F(ClassicRobotInTurn, BytesOfAPictureThatReadLikeATouchAreThePictures) {
  connect();
  ASSERT_TRUE(robot.command(pipeline::RobotCommand::images_on));
  tick();
  EXPECT_TRUE(give(kTouch).touch);
  static_cast<void>(give("000034"));
  const RobotReception got = give(kTouch);
  EXPECT_FALSE(got.touch);
  EXPECT_TRUE(got.image);
  EXPECT_EQ(std::string(robot.image().begin(), robot.image().end()), kTouch);
}

TEST_F(ClassicRobotInTurn, ThreePicturesThatDoNotComeTurnThemOffWhereverTheCycleStopped) {
  connect();
  ASSERT_TRUE(robot.command(pipeline::RobotCommand::send_info_and_pause));
  tick();
  static_cast<void>(give(kTouch));
  tick();  // no info came: a cycle cut short, of no picture
  EXPECT_EQ(robot.counters().cycles_cut_short, 1U);
  static_cast<void>(give(kTouch));
  ASSERT_TRUE(robot.command(pipeline::RobotCommand::images_on));
  tick();
  static_cast<void>(give(kTouch));
  static_cast<void>(give("000034"));
  ASSERT_TRUE(robot.command(pipeline::RobotCommand::send_info_and_pause));
  tick();  // the length came, the bytes did not: the first
  static_cast<void>(give(kTouch));
  tick();  // neither info nor picture: the second
  static_cast<void>(give(kTouch));
  EXPECT_TRUE(robot.replyDue()) << "a picture is still waited for";
  tick();  // the third
  EXPECT_EQ(robot.counters().cycles_cut_short, 4U);
  static_cast<void>(give(kTouch));
  EXPECT_FALSE(robot.replyDue());
}

TEST(ClassicTouchpadInTurn, MotorReferencesAfterTheGoodbyeAreOutOfTurn) {
  const Endpoint robot = *parseEndpoint("10.0.0.1:3490");
  ClassicTouchpadEnd pad{LinkParameters{}};
  const Instant now = instantAt(100.0);
  EXPECT_EQ(pad.silence(now), Duration::zero()) << "nobody was heard";
  const auto give = [&](std::string_view text) { return pad.handle(bytesOf(text), robot, now, {}).motor_reference; };
  // Commands 10 ":" and 9, each with zeros.
  static_cast<void>(give("ACK"));
  static_cast<void>(give("?:,0'00000:0'00000:0'00000:0,0'00000:0'00000:0'00000:0'00000.\n"));
  EXPECT_TRUE(give(kReferenceInTurn));
  static_cast<void>(give("?9,0'00000:0'00000:0'00000:0,0'00000:0'00000:0'00000:0'00000.\n"));
  EXPECT_EQ(pad.phase(), pipeline::LinkPhase::closed);
  EXPECT_FALSE(give(kReferenceInTurn));
  EXPECT_EQ(pad.counters().out_of_turn, 1U);
}

TEST(ClassicTouchpadInTurn, ARobotOfAnotherInterfacePortOrFamilyIsAnother) {
  const Endpoint robot = *parseEndpoint("[fe80::1]:3490");
  ClassicTouchpadEnd pad{LinkParameters{}};
  const Instant now = instantAt(100.0);
  static_cast<void>(pad.handle(bytesOf("ACK"), robot, now, {}));
  Endpoint scope = robot;
  Endpoint port = robot;
  Endpoint family = robot;
  scope.scope = 1;
  port.port = 3491;
  family.v6 = false;
  std::uint64_t strangers = 0;
  for (const Endpoint& other : {scope, port, family}) {
    EXPECT_TRUE(pad.handle(bytesOf(kReferenceInTurn), other, now, {}).replies.empty());
    EXPECT_EQ(pad.counters().wrong_peer, ++strangers);
  }
}

}  // namespace
}  // namespace fyd::protocol
