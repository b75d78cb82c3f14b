// Parameters recorded by older or newer programs are matched by their names.
#include "core/recording/reader/recorded_profile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/profile_text.h"

namespace fyd::recording {
namespace {

using pipeline::Parameters;

std::string profile() {
  Parameters parameters;
  return formatProfile(bindParameters(parameters));
}

/// Today's profile with one line left out, put in or replaced, as another program would have written it.
RecordingHeader changed(const std::string& from, const std::string& to) {
  RecordingHeader header;
  header.profile = profile();
  const std::size_t at = header.profile.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  header.profile.replace(at, from.size(), to);
  return header;
}

std::uint16_t indexOf(std::string_view id) {
  Parameters parameters;
  const auto bound = bindParameters(parameters);
  return static_cast<std::uint16_t>(findParameter(bound, id) - bound.data());
}

std::string lineOf(const std::string& key) {
  const std::string text = profile();
  const std::size_t at = text.find("\n" + key + " = ") + 1;
  return text.substr(at, text.find('\n', at) - at + 1);
}

std::pair<std::uint16_t, double> translated(const RecordingHeader& header, std::uint16_t index, double value = 1.0) {
  RecordedIndices(header).translate(index, value);
  return {index, value};
}

TEST(RecordedIndices, AreTodaysWhenTheProfileIs) {
  RecordingHeader header;
  header.profile = profile();
  Parameters parameters;
  for (std::size_t i = 0; i < bindParameters(parameters).size(); ++i) {
    EXPECT_EQ(translated(header, static_cast<std::uint16_t>(i)).first, i);
  }
}

TEST(RecordedIndices, FollowTheNameWhenAParameterWasInsertedSince) {
  const RecordingHeader header = changed(lineOf("motion_scale"), "");
  const std::uint16_t before = indexOf("pipeline.absolute_motion");
  const std::uint16_t after = indexOf("control.kp");
  EXPECT_EQ(translated(header, before).first, before);
  EXPECT_EQ(translated(header, static_cast<std::uint16_t>(after - 1)).first, after);
}

TEST(RecordedIndices, FollowTheNameWhenAParameterWasRemovedSince) {
  const RecordingHeader header =
      changed(lineOf("motion_scale"), lineOf("motion_scale") + "gone = 3  # a number from 1 to 5\n");
  const std::uint16_t at = static_cast<std::uint16_t>(indexOf("pipeline.motion_scale") + 1);
  EXPECT_EQ(translated(header, at).first, RecordedIndices::kUnknown);
  EXPECT_EQ(translated(header, static_cast<std::uint16_t>(indexOf("control.kp") + 1)).first, indexOf("control.kp"));
  EXPECT_EQ(translated(header, 60'000).first, RecordedIndices::kUnknown);
}

TEST(RecordedIndices, FollowAChoicesWordWhenWordsWereInsertedOrRemoved) {
  const RecordingHeader header = changed("one of single, soc,", "one of single, forgotten, soc,");
  const std::uint16_t method = indexOf("texture.method");
  EXPECT_EQ(translated(header, method, 0.0), std::pair(method, 0.0));
  EXPECT_EQ(translated(header, method, 2.0), std::pair(method, 1.0)) << "soc";
  EXPECT_EQ(translated(header, method, 1.0).first, RecordedIndices::kUnknown) << "forgotten";
}

TEST(RecordedParameters, BeyondTodaysRangeAreTakenWhenTheyCanBeSetLive) {
  const RecordingHeader header = changed(lineOf("kp"), "kp = 1e13\n");
  const auto parameters = recordedParameters(header);
  ASSERT_TRUE(parameters) << parameters.error().text();
  EXPECT_EQ(parameters->control.kp, 1e13);
  const auto refused = recordedParameters(changed(lineOf("frame_half_width_mm"), "frame_half_width_mm = 1e13\n"));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), testing::HasSubstr("sensing.frame_half_width_mm"));
}

TEST(ProfileEntries, TellListsAndWordsAndPassOverWhatIsNoLine) {
  const auto entries = profileEntries("x = 1\n# y = 2\n[a]\none = [1, 2]  # a list\ntwo = 'b'  # one of a, b\nthree\n");
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].id, "a.one");
  EXPECT_TRUE(entries[0].list);
  EXPECT_EQ(entries[1].id, "a.two");
  EXPECT_THAT(entries[1].choices, testing::ElementsAre("a", "b"));
}

}  // namespace
}  // namespace fyd::recording
