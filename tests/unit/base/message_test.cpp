// A message: its English, and how a translation of its format is filled.
#include "core/base/message.h"

#include <gtest/gtest.h>

namespace fyd {
namespace {

constexpr std::string_view kSilent = sentence("the robot is silent");

TEST(Message, ItsTextIsTheFormatWithTheValuesFilledIn) {
  const std::string path = "/tmp/a {b}.toml";
  EXPECT_EQ(say("{}: {:04o}, {:.2f} of {} %, {{so}} {}", path, 0644, 1.005, 7U, true).text(),
            "/tmp/a {b}.toml: 0644, 1.00 of 7 %, {so} true");
  EXPECT_EQ(say("{1} before {0}", 1, "two").text(), "two before 1");
  EXPECT_EQ(say("from {} to {}", std::uint64_t{18446744073709551615U}, std::int64_t{-3}).text(),
            "from 18446744073709551615 to -3");
  EXPECT_EQ(Message{}.text(), "");
}

TEST(Message, AMessageMayBeAValueOfAnother) {
  const Message message = about("x.fyd", say("Not armed: {}.", phrase(kSilent)));
  EXPECT_EQ(message.text(), "x.fyd: Not armed: the robot is silent.");
  EXPECT_EQ(message, about("x.fyd", say("Not armed: {}.", phrase(kSilent))));
  EXPECT_NE(message, about("x.fyd", say("Not armed: {}.", phrase("another"))));
}

TEST(Message, WordsOfOthersAreAValue) {
  EXPECT_EQ(verbatim("{} % {0:").text(), "{} % {0:");
  EXPECT_TRUE(verbatim("").empty());
}

TEST(Message, AFormWhosePlacesFitIsFilledInItsOwnOrder) {
  const Message message = say("{} of {:.1f} N: {}", 3, 2.5, phrase(kSilent));
  EXPECT_EQ(filledIn("{2}: {1:.1f} N, {0}", message), "the robot is silent: 2.5 N, 3");
  EXPECT_EQ(
      filledIn("{} {:.1f} {}", message, [](const Value&, std::string_view spec) { return std::string(spec) + '!'; }),
      "! .1f! !");
}

TEST(Message, AFormWhosePlacesDoNotFitIsNotFilled) {
  const Message message = say("{} of {:.1f} N", 3, 2.5);
  for (const char* form :
       {"{}", "{} {:.1f} {}", "{0} {0}", "{0} {2:.1f}", "{:.1f} {}", "{} {:.2f}", "{} {1:.1f}", "{} {:.1f} {",
        "} {} {:.1f}", "{a} {:.1f}", "{0} {1:.1f} {-1}", "{99999999999999999999} {1:.1f}", ""}) {
    EXPECT_EQ(filledIn(form, message), std::nullopt) << form;
  }
}

TEST(Message, TheKindIsTheRoomThatSpeaks) {
  using message_detail::kindOf;
  EXPECT_EQ(kindOf("/core/x/core/device/fri_robot.cpp"), MessageKind::device);
  EXPECT_EQ(kindOf("../core/sensing/tare.cpp"), MessageKind::algorithm);
  EXPECT_EQ(kindOf("app/cli/main.cpp"), MessageKind::command);
  EXPECT_EQ(say("said by {}", "a test").kind, MessageKind::command);
  EXPECT_EQ(toString(MessageKind::recording), "recording");
}

TEST(Message, AFormatOfPlacesOnlySaysNothing) {  // and `say` does not compile with one
  static_assert(!message_detail::hasWords("{}: {:.3f} ({x})"));
  static_assert(message_detail::hasWords("{} mm"));
  static_assert(message_detail::hasWords("{:g} %: é"));
}

}  // namespace
}  // namespace fyd
