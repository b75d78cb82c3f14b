// FYD Link's messages: every field at its limits and beyond, every truncation, and the published bytes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "core/protocol/link/link_codec.h"
#include "core/protocol/link/message_budget.h"
#include "tests/not_a_number.h"
#include "tests/unit/protocol/link_pair.h"

namespace fyd::protocol {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

const PositionCode kTouchCode = *PositionCode::make(asOnTheWire(TouchpadHello{}.workspace));
const PositionCode kRobotCode = *PositionCode::make(asOnTheWire(RobotHello{}.workspace));

using Buffer = std::array<std::uint8_t, kMaximumLinkMessage>;
Bytes written(const Buffer& buffer, std::size_t size) { return Bytes(buffer).first(size); }

TEST(PositionCode, PaperWorkspaceNeeds8000PointsAnd13Bits) {
  const auto code = PositionCode::make({.minimum_mm = {-80, -65, -65}, .maximum_mm = {80, 65, 65}});
  ASSERT_TRUE(code);
  EXPECT_EQ(code->points(), (std::array<std::uint32_t, 3>{8000, 6500, 6500}));
  EXPECT_EQ(code->bitsPerAxis(), 13U);
  EXPECT_EQ(PositionCode::make({.maximum_mm = {163.84, 1, 1}})->bitsPerAxis(), 13U);  // 8192 points
  EXPECT_EQ(PositionCode::make({.maximum_mm = {163.86, 1, 1}})->bitsPerAxis(), 14U);  // 8193
}

TEST(PositionCode, ErrorIsAtMostHalfAStepInEveryCellAndAtItsBorders) {
  for (const Workspace& workspace :
       {TouchpadHello{}.workspace, RobotHello{}.workspace,
        Workspace{.minimum_mm = {-80, -65, 3}, .maximum_mm = {80, 65, 3.5}, .precision_mm = 0.02},
        Workspace{.minimum_mm = {1e4, -1, -1}, .maximum_mm = {1.01e4, 1, 1}, .precision_mm = 0.00012}}) {
    const PositionCode code = *PositionCode::make(workspace);
    const double lowest[3] = {workspace.minimum_mm.x, workspace.minimum_mm.y, workspace.minimum_mm.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double step = code.step_mm()[axis];
      EXPECT_LE(step, workspace.precision_mm * (1.0 + 2e-6));
      double worst = 0.0;
      for (std::uint32_t cell = 0; cell < code.points()[axis]; ++cell) {
        for (const double within : {0.0, 1e-6, 0.3, 0.5, 1.0 - 1e-6, 1.0}) {
          Vec3 position = workspace.minimum_mm;
          const double value = lowest[axis] + (cell + within) * step;
          (axis == 0 ? position.x : axis == 1 ? position.y : position.z) = value;
          const auto decoded = code.decode(code.encode(position));
          ASSERT_TRUE(decoded);
          const double got = axis == 0 ? decoded->x : axis == 1 ? decoded->y : decoded->z;
          worst = std::max(worst, std::abs(got - value));
        }
      }
      EXPECT_LE(worst, 0.5 * step + 1e-11 * std::abs(lowest[axis]) + 1e-12) << "axis " << axis;
    }
  }
}

TEST(PositionCode, OutsideIsHeldAtTheBorderAndNotANumberAtZero) {
  const PositionCode code = *PositionCode::make({.minimum_mm = {-1, 5, -9}, .maximum_mm = {1, 6, -8}});
  const Vec3 far = *code.decode(code.encode({kInf, -1e300, 1e300}));
  EXPECT_NEAR(far.x, 0.0, 0.011);  // infinity is not a number to follow
  EXPECT_NEAR(far.y, 5.01, 1e-9);
  EXPECT_NEAR(far.z, -8.01, 1e-9);
  EXPECT_NEAR(code.decode(code.encode({kNaN, kNaN, kNaN}))->y, 5.01, 1e-9);  // of 5…6, nearest to zero
}

TEST(PositionCode, RefusesWorkspacesThatCannotBeCoded) {
  EXPECT_FALSE(PositionCode::make({.maximum_mm = {0, 1, 1}}));
  EXPECT_FALSE(PositionCode::make({.maximum_mm = {1, -1, 1}}));
  EXPECT_FALSE(PositionCode::make({.maximum_mm = {1, kNaN, 1}}));
  EXPECT_FALSE(PositionCode::make({.minimum_mm = {-kInf, 0, 0}, .maximum_mm = {1, 1, 1}}));
  EXPECT_FALSE(PositionCode::make({.maximum_mm = {1, 1, 1}, .precision_mm = 0}));
  EXPECT_FALSE(PositionCode::make({.maximum_mm = {1, 1, 1}, .precision_mm = kNaN}));
  EXPECT_FALSE(PositionCode::make({.maximum_mm = {1, 1, 1}, .precision_mm = 1e-7}));  // 10⁷ points
  EXPECT_TRUE(PositionCode::make({.maximum_mm = {1, 1, 1}, .precision_mm = 5}));      // one point
}

TEST(PositionCode, RefusesCodesNoPositionHas) {
  const PositionCode code = *PositionCode::make({.maximum_mm = {160, 160, 160}});
  EXPECT_TRUE(code.decode(7999));
  EXPECT_FALSE(code.decode(8000));
  EXPECT_FALSE(code.decode(std::uint64_t{8000} << 13));
  EXPECT_FALSE(code.decode(std::uint64_t{1} << 39));
}

TEST(MessageBudget, IsdnAtTenMillisecondsCarriesTheWholeTouch) {
  const TouchFields all{.force = true, .indentation = true, .orientation = true};
  const auto budget = messageBudget({160, 130, 130}, 0.02, 64'000, 10, all);
  ASSERT_TRUE(budget);
  EXPECT_EQ(budget->points_per_axis, 8000U);
  EXPECT_EQ(budget->bits_per_axis, 13U);
  EXPECT_DOUBLE_EQ(budget->max_message_bits, 640.0);
  EXPECT_EQ(budget->message_bits, 416U);   // 10 header, 7 envelope, 4, 5 position, 2, 2, 6, 16 tag: 52 bytes
  EXPECT_EQ(budget->datagram_bits, 640U);  // and 28 of IPv4 and UDP
  EXPECT_TRUE(budget->fits);
  EXPECT_EQ(budget->fields, all);
}

TEST(MessageBudget, LeavesOutFieldsInOrderUntilItFits) {
  const TouchFields all{.force = true, .indentation = true, .orientation = true};
  const auto fields = [&](double flow) { return messageBudget({160, 130, 130}, 0.02, flow, 10, all)->fields; };
  EXPECT_EQ(fields(63'900), (TouchFields{.force = true, .indentation = true, .orientation = false}));
  EXPECT_EQ(fields(59'100), (TouchFields{.force = true, .indentation = false, .orientation = false}));
  EXPECT_EQ(fields(57'500), (TouchFields{.force = false, .indentation = false, .orientation = false}));
  EXPECT_FALSE(messageBudget({160, 130, 130}, 0.02, 55'000, 10, all)->fits);
}

TEST(MessageBudget, SaysWhichValueIsWrong) {
  const auto message = [](Vec3 extent, double precision, double flow, double period) {
    return messageBudget(extent, precision, flow, period, {}).error().text();
  };
  EXPECT_THAT(message({0, 1, 1}, 0.02, 1, 1), ::testing::HasSubstr("every side"));
  EXPECT_THAT(message({1, 0, 1}, 0.02, 1, 1), ::testing::HasSubstr("every side"));
  EXPECT_THAT(message({1, 1, -1}, 0.02, 1, 1), ::testing::HasSubstr("every side"));
  EXPECT_THAT(message({kNaN, 1, 1}, 0.02, 1, 1), ::testing::HasSubstr("every side"));
  EXPECT_THAT(message({1, 1, 1}, 0, 1, 1), ::testing::HasSubstr("precision 0"));
  EXPECT_THAT(message({1, 1, 1}, kInf, 1, 1), ::testing::HasSubstr("precision inf"));
  EXPECT_THAT(message({1, 1, 1}, 0.02, kInf, 1), ::testing::HasSubstr("flow inf"));
  EXPECT_THAT(message({1, 1, 1}, 0.02, 1, kInf), ::testing::HasSubstr("period inf"));
  EXPECT_THAT(message({1, 1, 1}, kNaN, 1, 1), ::testing::HasSubstr("precision"));
  EXPECT_THAT(message({1, 1, 1}, 0.02, -5, 1), ::testing::HasSubstr("flow -5"));
  EXPECT_THAT(message({1, 1, 1}, 0.02, 1, 0), ::testing::HasSubstr("period 0"));
  EXPECT_THAT(message({1e9, 1, 1}, 0.02, 1, 1), ::testing::HasSubstr("1048576 points"));
}

// --- messages against the bytes of the second implementation

LinkTouch sampleTouch() {
  return {.sequence = 7,
          .age_s = 500e-6,
          .position_mm = {10, -5, -2.5},
          .in_contact = true,
          .force_N = 1.0,
          .indentation_mm = 2.5};
}
LinkState sampleState() {
  LinkState state{.sequence = 9, .robot = {.stiffness_N_per_mm = 0.62, .position_mm = {1, 2, -3}, .force_N = 1.5}};
  EXPECT_TRUE(state.accelerations.push({.age_s = 2e-3, .acceleration_g = {0.5, -0.25, 1}}));
  EXPECT_TRUE(state.accelerations.push({.age_s = 1e-3, .acceleration_g = {-5, 5, 0}}));
  return state;
}
RobotHello sampleRobotHello() { return {.sent_us = 1'000'000, .capabilities = 11, .text = "robot"}; }
TouchpadHello sampleTouchpadHello() {
  return {.sent_us = 5'000'000,
          .echo_us = 1'000'000,
          .held_us = 250,
          .rates = {.state_Hz = 100, .touch_Hz = 50},
          .capabilities = 11,
          .k_vib = 1.5,
          .reference_ticks = {4200, -4200},
          .board_text = "board"};
}

template <class Encode>
Packet encoded(Encode&& encode) {
  Buffer buffer{};
  const Bytes bytes = written(buffer, encode(std::span<std::uint8_t>(buffer)));
  return {bytes.begin(), bytes.end()};
}

std::map<std::string, Packet> sampleMessages() {
  const std::array<std::uint8_t, 5> picture{'h', 'e', 'l', 'l', 'o'};
  std::map<std::string, Packet> out;
  out["heartbeat"] =
      encoded([](auto b) { return encodeLink(LinkHeartbeat{.echo_us = 5'000'000, .held_us = 1234}, 1'010'000, b); });
  out["touch"] = encoded([](auto b) { return encodeLink(sampleTouch(), kTouchCode, 5'020'000, b); });
  out["state"] = encoded([](auto b) { return encodeLink(sampleState(), kRobotCode, 1'030'000, b); });
  out["command"] = encoded([](auto b) {
    return encodeLink(LinkCommand{.id = 1, .command = pipeline::RobotCommand::vibration_up}, 1'040'000, b);
  });
  out["command_ack"] = encoded([](auto b) { return encodeLink(LinkCommandAck{.id = 1}, 5'050'000, b); });
  out["info"] = encoded([](auto b) {
    return encodeLink(LinkInfo{.k_vib = 1.5, .reference_ticks = {4200, -4200}, .board_text = "board"}, 5'060'000, b);
  });
  out["goodbye"] =
      encoded([](auto b) { return encodeLink(LinkGoodbye{.reason = GoodbyeReason::operator_left}, 1'070'000, b); });
  out["image"] = encoded([&](auto b) {
    return encodeLink(LinkImageFragment{.picture = 3, .size = 5, .index = 0, .bytes = picture}, 5'080'000, b);
  });
  return out;
}

// Reads any message and writes what was read.
LinkRefusal reread(Bytes message, Packet& again) {
  const auto envelope = decodeEnvelope(message);
  if (!envelope.ok()) return envelope.refusal;
  const LinkTime at = envelope.value.sent_us;
  const auto finish = [&](const auto& decoded, auto&& encode) {
    if (decoded.ok()) again = encoded([&](auto b) { return encode(decoded.value, b); });
    return decoded.refusal;
  };
  const auto plain = [at](const auto& value, auto b) { return encodeLink(value, at, b); };
  switch (envelope.value.type) {
    case LinkMessage::touch:
      return finish(decodeTouch(envelope.value, kTouchCode),
                    [&](const auto& value, auto b) { return encodeLink(value, kTouchCode, at, b); });
    case LinkMessage::state:
      return finish(decodeState(envelope.value, kRobotCode),
                    [&](const auto& value, auto b) { return encodeLink(value, kRobotCode, at, b); });
    case LinkMessage::command: return finish(decodeCommand(envelope.value), plain);
    case LinkMessage::command_ack: return finish(decodeCommandAck(envelope.value), plain);
    case LinkMessage::heartbeat: return finish(decodeHeartbeat(envelope.value), plain);
    case LinkMessage::info: return finish(decodeInfo(envelope.value), plain);
    case LinkMessage::goodbye: return finish(decodeGoodbye(envelope.value), plain);
    case LinkMessage::image: return finish(decodeImageFragment(envelope.value), plain);
  }
  return LinkRefusal::message;
}

TEST(LinkCodec, WritesTheBytesOfTheSecondImplementation) {
  for (const auto& [name, bytes] : sampleMessages()) EXPECT_EQ(bytes, vectorBytes(name)) << name;
  EXPECT_EQ(encoded([](auto b) { return encodeHello(sampleRobotHello(), b); }), vectorBytes("robot_hello"));
  EXPECT_EQ(encoded([](auto b) { return encodeHello(sampleTouchpadHello(), b); }), vectorBytes("touchpad_hello"));
}

TEST(LinkCodec, ReadsWhatItWrites) {
  for (const auto& [name, bytes] : sampleMessages()) {
    Packet again;
    EXPECT_EQ(reread(bytes, again), LinkRefusal::none) << name;
    EXPECT_EQ(again, bytes) << name;
  }
  const auto touch = decodeTouch(decodeEnvelope(vectorBytes("touch")).value, kTouchCode);
  EXPECT_EQ(touch.value.sequence, 7);
  EXPECT_TRUE(touch.value.in_contact);
  EXPECT_NEAR(touch.value.position_mm.x, 10.0, 0.0101);
  EXPECT_NEAR(touch.value.position_mm.z, -2.5, 0.0101);
  EXPECT_NEAR(*touch.value.force_N, 1.0, 1e-4);
  EXPECT_NEAR(*touch.value.indentation_mm, 2.5, 5e-4);
  EXPECT_FALSE(touch.value.orientation);
  EXPECT_NEAR(touch.value.age_s, 500e-6, 1e-9);
  const auto state = decodeState(decodeEnvelope(vectorBytes("state")).value, kRobotCode);
  ASSERT_EQ(state.value.accelerations.size(), 2U);
  EXPECT_NEAR(state.value.accelerations[0].age_s, 2e-3, 1e-9);
  EXPECT_NEAR(state.value.accelerations[1].acceleration_g.x, -5.0, 1.0 / 6553);
  EXPECT_NEAR(state.value.robot.stiffness_N_per_mm, 0.62, 1e-7);
  const auto hello_bytes = vectorBytes("touchpad_hello");  // the decoded text stands in them
  const auto hello = decodeTouchpadHello(hello_bytes);
  ASSERT_TRUE(hello.ok());
  EXPECT_EQ(hello.value.board_text, "board");
  EXPECT_EQ(hello.value.rates.touch_Hz, 50.0);
  EXPECT_EQ(hello.value.reference_ticks[1], -4200.0);
}

TEST(LinkCodec, EveryTruncationAndEveryLongerMessageIsRefused) {
  for (const auto& [name, bytes] : sampleMessages()) {
    Packet again;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      EXPECT_NE(reread(Bytes(bytes).first(size), again), LinkRefusal::none) << name << " cut to " << size;
    }
    Packet longer = bytes;
    longer.push_back(0);
    EXPECT_NE(reread(longer, again), LinkRefusal::none) << name;
  }
  for (const std::string name : {"robot_hello", "touchpad_hello"}) {
    const Packet bytes = vectorBytes(name);
    for (std::size_t size = 0; size <= bytes.size(); ++size) {
      const Bytes cut = Bytes(bytes).first(size);
      const bool ok = name == "robot_hello" ? decodeRobotHello(cut).ok() : decodeTouchpadHello(cut).ok();
      EXPECT_EQ(ok, size == bytes.size()) << name << " cut to " << size;
    }
  }
}

// There is one way to write a message: whatever is accepted after a bit is turned says something else.
TEST(LinkCodec, EverySingleBitFlipIsRefusedOrReadAsExactlyWhatItSays) {
  for (const auto& [name, bytes] : sampleMessages()) {
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
      Packet flipped = bytes;
      flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
      Packet again;
      if (reread(flipped, again) == LinkRefusal::none) {
        EXPECT_EQ(again, flipped) << name << " bit " << bit;
      }
    }
  }
}

TEST(LinkCodec, TouchFieldsSaturateAtTheirLimits) {
  const auto roundTrip = [](const LinkTouch& touch) {
    Buffer buffer{};
    const std::size_t size = encodeLink(touch, kTouchCode, 1, buffer);
    return decodeTouch(decodeEnvelope(written(buffer, size)).value, kTouchCode).value;
  };
  LinkTouch high{.sequence = 65'535,
                 .age_s = 1e9,
                 .position_mm = {1e9, 1e9, 1e9},
                 .in_contact = true,
                 .force_N = kInf,
                 .indentation_mm = 1e300,
                 .orientation = Orientation{.alpha_rad = std::numbers::pi, .beta_rad = -1.0, .gamma_rad = 1e6}};
  const LinkTouch h = roundTrip(high);
  EXPECT_EQ(h.sequence, 65'535);
  EXPECT_NEAR(h.age_s, 0.65535, 1e-9);
  EXPECT_NEAR(h.position_mm.x, 35.0, 0.011);
  EXPECT_NEAR(*h.force_N, 13.107, 1e-9);
  EXPECT_NEAR(*h.indentation_mm, 65.535, 1e-9);
  EXPECT_NEAR(std::cos(h.orientation->alpha_rad), -1.0, 1e-8);  // π and −π are one angle
  EXPECT_NEAR(h.orientation->beta_rad, -1.0, 5e-5);
  EXPECT_NEAR(std::sin(h.orientation->gamma_rad), std::sin(1e6), 1e-4);
  const LinkTouch low = roundTrip(
      {.age_s = -5, .position_mm = {-1e9, -1e9, -1e9}, .in_contact = true, .force_N = -1, .indentation_mm = -1});
  EXPECT_EQ(low.age_s, 0.0);
  EXPECT_NEAR(low.position_mm.z, -70.0, 0.011);
  EXPECT_EQ(*low.force_N, 0.0);
  EXPECT_EQ(*low.indentation_mm, 0.0);
  const LinkTouch none = roundTrip({.age_s = kNaN,
                                    .position_mm = {1, kNaN, 3},
                                    .in_contact = true,
                                    .force_N = kNaN,
                                    .indentation_mm = kNaN,
                                    .orientation = Orientation{.alpha_rad = kNaN, .beta_rad = kInf}});
  EXPECT_FALSE(none.in_contact);
  EXPECT_EQ(*none.force_N, 0.0);
  EXPECT_EQ(none.orientation->alpha_rad, 0.0);
  EXPECT_EQ(none.orientation->beta_rad, 0.0);
}

TEST(LinkCodec, StateFieldsSaturateAtTheirLimits) {
  LinkState state{
      .robot = {.stiffness_N_per_mm = kInf, .position_mm = {kNaN, 1e9, -1e9}, .button = true, .force_N = 1e9},
      .motor_reference = pipeline::RobotMotorReference{1e12, -kInf}};
  EXPECT_TRUE(state.accelerations.push({.age_s = kNaN, .acceleration_g = {kInf, -kInf, kNaN}}));
  Buffer buffer{};
  const std::size_t size = encodeLink(state, kRobotCode, kLastCounter, buffer);
  const auto envelope = decodeEnvelope(written(buffer, size)).value;
  EXPECT_EQ(envelope.sent_us, kLastCounter);
  const auto decoded = decodeState(envelope, kRobotCode);
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(decoded.value.robot.stiffness_N_per_mm, 1e6);
  EXPECT_TRUE(decoded.value.robot.button);
  EXPECT_NEAR(decoded.value.robot.force_N, 65.535, 1e-9);
  EXPECT_EQ(decoded.value.motor_reference->first_ticks, 1e6);
  EXPECT_EQ(decoded.value.motor_reference->second_ticks, -1e6);
  const Vec3 a = decoded.value.accelerations[0].acceleration_g;
  EXPECT_NEAR(a.x, 32'767 / 6553.0, 1e-12);
  EXPECT_NEAR(a.y, -32'767 / 6553.0, 1e-12);
  EXPECT_EQ(a.z, 0.0);
}

TEST(LinkCodec, RefusesFieldsOutOfTheirRange) {
  const auto refusal = [](const std::string& name, std::size_t at, std::initializer_list<std::uint8_t> bytes) {
    Packet packet = vectorBytes(name);
    std::ranges::copy(bytes, packet.begin() + static_cast<std::ptrdiff_t>(at));
    Packet again;
    return reread(packet, again);
  };
  EXPECT_EQ(refusal("command", 0, {0}), LinkRefusal::message);
  EXPECT_EQ(refusal("command", 0, {9}), LinkRefusal::message);
  EXPECT_EQ(refusal("command", 0, {3 | 0x20}), LinkRefusal::field);  // flags nobody defined
  EXPECT_EQ(refusal("command", 9, {0}), LinkRefusal::field);
  EXPECT_EQ(refusal("command", 9, {12}), LinkRefusal::field);
  EXPECT_EQ(refusal("goodbye", 7, {2}), LinkRefusal::field);
  EXPECT_EQ(refusal("state", 9, {0, 0, 0xC0, 0x7F}), LinkRefusal::field);  // stiffness NaN
  EXPECT_EQ(refusal("state", 9, {0, 0, 0x80, 0xBF}), LinkRefusal::field);  // −1
  EXPECT_EQ(refusal("state", 9, {0, 0, 0x80, 0x7F}), LinkRefusal::field);  // infinite
  EXPECT_EQ(refusal("touch", 15, {0xFF}), LinkRefusal::field);             // beyond the workspace's points
  EXPECT_EQ(refusal("info", 7, {0, 0, 0xC0, 0xFF}), LinkRefusal::field);   // k_vib NaN
  EXPECT_EQ(refusal("info", 21, {'\n'}), LinkRefusal::field);              // a line end in a name
  EXPECT_EQ(refusal("image", 13, {1}), LinkRefusal::field);                // offset behind the end
  EXPECT_EQ(refusal("image", 9, {6}), LinkRefusal::size);                  // says more than it brings
  EXPECT_EQ(refusal("image", 11, {3}), LinkRefusal::field);                // longer than any picture

  const auto hello = [](std::size_t at, std::initializer_list<std::uint8_t> bytes) {
    Packet packet = vectorBytes("robot_hello");
    std::ranges::copy(bytes, packet.begin() + static_cast<std::ptrdiff_t>(at));
    return decodeRobotHello(packet).refusal;
  };
  EXPECT_EQ(hello(6, {0, 0}), LinkRefusal::field);               // no states at all
  EXPECT_EQ(hello(6, {0x11, 0x27}), LinkRefusal::field);         // 10 001 Hz
  EXPECT_EQ(hello(10, {0, 0, 0xC0, 0x7F}), LinkRefusal::field);  // workspace NaN
  EXPECT_EQ(hello(10, {0, 0, 0x48, 0x43}), LinkRefusal::field);  // of no extent
  EXPECT_EQ(hello(34, {0, 0, 0, 0}), LinkRefusal::field);        // precision 0
  EXPECT_EQ(hello(38, {16}), LinkRefusal::field);                // capability nobody knows
}

TEST(LinkCodec, TextIsCutAndMadePrintable) {
  std::string text(1'500, 'b');
  text += '\x01';
  Buffer buffer{};
  const std::size_t size = encodeLink(LinkInfo{.board_text = text}, 1, buffer);
  EXPECT_EQ(decodeInfo(decodeEnvelope(written(buffer, size)).value).value.board_text, std::string(1'000, 'b'));
  const std::size_t odd = encodeLink(LinkInfo{.board_text = "a\n\xc3\xa9"}, 1, buffer);
  EXPECT_EQ(decodeInfo(decodeEnvelope(written(buffer, odd)).value).value.board_text, "a???");
}

TEST(LinkCodec, TheLargestMessagesFitADatagram) {
  Buffer buffer{};
  LinkState state{.orientation = Orientation{}, .motor_reference = pipeline::RobotMotorReference{}};
  while (state.accelerations.push({})) {
  }
  const PositionCode finest = *PositionCode::make({.maximum_mm = {1000, 1000, 1000}, .precision_mm = 0.001});
  EXPECT_EQ(finest.bitsPerAxis(), 20U);
  EXPECT_GT(encodeLink(state, finest, 1, buffer), 0U);
  const std::vector<std::uint8_t> picture(kImageFragment);
  EXPECT_GT(encodeLink(LinkImageFragment{.size = 5'000, .bytes = picture}, 1, buffer), 0U);
  EXPECT_LE(kMaximumLinkMessage + kSealOverhead + kNoiseOverhead, kMaximumLinkDatagram + 32);
  EXPECT_LE(kMaximumLinkMessage + kSealOverhead, kMaximumLinkDatagram);
  EXPECT_EQ(encodeLink(LinkGoodbye{}, 1, std::span<std::uint8_t>(buffer).first(7)), 0U);  // one byte too few
}

}  // namespace
}  // namespace fyd::protocol
