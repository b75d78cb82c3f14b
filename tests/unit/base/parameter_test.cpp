// Described parameters and profile text: defaults, round trip, refusal of bad values with file and line.
#include "core/base/parameter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/profile_text.h"

namespace fyd {
namespace {

enum class Colour { red, green };
constexpr std::array<std::string_view, 2> kColours = {"red", "green"};

struct Sample {
  double gain = 2.5;
  int count = 3;
  bool on = true;
  Colour colour = Colour::green;
  ParameterList points{{1.0, 2.0}, 2};
  std::string where = "here";

  template <class Visitor>
  void describe(Visitor& v) {
    v.real("room.gain", gain,
           {.unit = "mm", .minimum = 0, .maximum = 10, .help = "A gain.", .live = true, .formerly = "room.factor"});
    v.integer("room.count", count, {.minimum = 1, .maximum = 9});
    v.boolean("room.on", on, {});
    v.choice("other.colour", colour, kColours, {});
    v.list("other.points", points, {.minimum = -5, .maximum = 5});
    v.text("other.where", where, {});
  }
};

std::string problem(std::string_view text) {
  Sample sample;
  const auto result = parseProfile(text, "p.toml", bindParameters(sample));
  return result ? "none" : result.error().text();
}

TEST(Parameter, DefaultsAreTheInitialisers) {
  Sample sample;
  const auto parameters = bindParameters(sample);
  ASSERT_EQ(parameters.size(), 6U);
  EXPECT_EQ(parameters[0].value(), 2.5);
  EXPECT_EQ(parameters[3].value(), 1.0);
  EXPECT_EQ(formatParameter(parameters[4]), "[1, 2]");
}

TEST(Parameter, IsReadByItsFormerIdAndWrittenByItsPresentOne) {
  Sample sample;
  const auto parameters = bindParameters(sample);
  EXPECT_EQ(findParameter(parameters, "room.factor"), parameters.data());
  EXPECT_EQ(findParameter(parameters, ""), nullptr);
  ASSERT_TRUE(parseProfile("[room]\nfactor = 4\n", "p.toml", parameters));
  EXPECT_EQ(sample.gain, 4.0);
  EXPECT_EQ(formatProfile(parameters).find("factor"), std::string::npos);
  EXPECT_EQ(problem("[room]\nfactor = 40\n"), problem("[room]\ngain = 40\n"));
}

TEST(Parameter, AProfileRoundTrips) {
  Sample written;
  written.gain = 0.1 + 0.2;
  written.on = false;
  written.colour = Colour::red;
  written.points.clear();
  written.where = R"(modbus-rtu:"odd\name" [x]=1 # é)";
  Sample read;
  const auto result = parseProfile(formatProfile(bindParameters(written)), "p.toml", bindParameters(read));
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_EQ(read.gain, written.gain);
  EXPECT_FALSE(read.on);
  EXPECT_EQ(read.colour, Colour::red);
  EXPECT_TRUE(read.points.empty());
  EXPECT_EQ(read.where, written.where);
}

TEST(Parameter, MinusZeroIsZeroWhicheverWayItComesIn) {
  Sample sample;
  const auto parameters = bindParameters(sample);
  const Parameter& gain = parameters[0];
  const Parameter& points = parameters[4];
  ASSERT_TRUE(assignParameter(gain, "-0"));
  EXPECT_FALSE(std::signbit(sample.gain));
  ASSERT_TRUE(assignParameter(points, "[-1, -0, -0.0]"));
  EXPECT_EQ(formatParameter(points), "[-1, 0, 0]");
  ASSERT_TRUE(parseProfile("[room]\ngain = -0.0\n[other]\npoints = [-0.0]\n", "p.toml", parameters));
  EXPECT_FALSE(std::signbit(sample.gain));
  EXPECT_EQ(formatParameter(points), "[0]");
  const auto checked = checkParameter(gain, -0.0);
  ASSERT_TRUE(checked);
  EXPECT_FALSE(std::signbit(*checked));
}

TEST(Parameter, ATextIsOneLineAndNeverANumber) {
  Sample sample;
  const auto parameters = bindParameters(sample);
  const Parameter& where = parameters[5];
  EXPECT_FALSE(where.isNumber());
  EXPECT_TRUE(assignParameter(where, " 127.0.0.1:502 "));
  EXPECT_EQ(sample.where, "127.0.0.1:502");
  EXPECT_TRUE(assignParameter(where, ""));
  EXPECT_EQ(sample.where, "");
  EXPECT_FALSE(assignParameter(where, "two\nlines"));
  EXPECT_FALSE(assignParameter(where, std::string(kParameterTextLimit + 1, 'x')));
  for (const char* no_utf8 : {"/tmp/k\xffy", "\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80"}) {
    const auto refused = assignParameter(where, no_utf8);
    ASSERT_FALSE(refused) << no_utf8;
    EXPECT_EQ(refused.error().text(), "other.where: not UTF-8");
  }
  EXPECT_FALSE(checkParameter(where, 1.0));
  EXPECT_EQ(sample.where, "");
  EXPECT_TRUE(assignParameter(where, "/tmp/é–\U0001F9F5"));
  EXPECT_NE(problem("[other]\nwhere = 5").find("p.toml:2: other.where: expected a line"), std::string::npos);
  EXPECT_NE(problem("[other]\nwhere = \"a\\nb\"").find("control characters"), std::string::npos);
}

TEST(Parameter, ARefusalNamesFileLineValueAndRange) {
  EXPECT_EQ(problem("[room]\ngain = 11\n"), "p.toml:2: room.gain = 11: expected a number from 0 to 10 mm");
  EXPECT_EQ(problem("[room]\n\ngain = nan\n"), "p.toml:3: room.gain = nan: expected a number from 0 to 10 mm");
  EXPECT_EQ(problem("[room]\ngain = \"big\"\n"), "p.toml:2: room.gain: expected a number from 0 to 10 mm");
  EXPECT_EQ(problem("[room]\ncount = 1.5\n"), "p.toml:2: room.count = 1.5: expected a whole number from 1 to 9");
  EXPECT_EQ(problem("[room]\non = 1\n"), "p.toml:2: room.on: expected true or false");
  EXPECT_EQ(problem("[other]\ncolour = \"blue\"\n"), "p.toml:2: other.colour = \"blue\": expected one of red, green");
  EXPECT_EQ(problem("[other]\npoints = [1, 6]\n"),
            "p.toml:2: other.points = 6: expected a list of numbers, each from -5 to 5");
  EXPECT_EQ(problem("[room]\nsize = 1\n"),
            "p.toml:2: unknown parameter 'room.size'; 'fyd params' lists those there are");
  EXPECT_EQ(problem("gain = 1\n"), "p.toml:1: 'gain' stands outside a table; expected a table such as [control]");
}

TEST(Parameter, AKeyOfManyPartsIsRefused) {
  std::string parts = "a";
  for (int i = 0; i < 200'000; ++i) parts += ".a";
  const std::string refusal = "p.toml:2: a key of more than 16 parts; expected a table and a name";
  EXPECT_EQ(problem("\n[" + parts + "]\n"), refusal);
  EXPECT_EQ(problem("\n[[" + parts + "]]\n"), refusal);
  EXPECT_EQ(problem("\n" + parts + " = 1\n"), refusal);
  EXPECT_EQ(problem("#\"\nx = { " + parts + " = 1 }\n"), refusal);
  std::string quoted = "\",\"";
  for (int i = 0; i < 200'000; ++i) quoted += " . \"\\\",=\".'#\"'";
  EXPECT_EQ(problem("\n" + quoted + " = 1\n"), refusal);
  const std::string next = "\n" + parts + " = 1\n";
  for (const std::string before :
       {"x = \"\"\"a\"b\\\"\"\"\"\"\"", "x = '''a'b'''''", "x = '\\'", "x = \"\\\\\"", "x = ''", "x = 1 # '"}) {
    EXPECT_EQ(problem(before + next), refusal) << before;
  }
}

TEST(Parameter, DotsElsewhereThanInAKeyAreNotCounted) {
  const std::string many(100, '.');
  EXPECT_EQ(problem("# " + many + "\n[other]\nwhere = \"" + many + "\"\n"), "none");
  EXPECT_EQ(problem("[other]\nwhere = '" + many + "'  # " + many + "\n"), "none");
  EXPECT_EQ(problem("[other]\nwhere = \"\"\"" + many +
                    "\"\"\"\"\"\npoints = [0.5,0.5,0.5,0.5,0.5,0.5,0.5,0.5,0.5,0.5,"
                    "0.5,0.5,0.5,0.5,0.5,0.5]\n"),
            "none");
  EXPECT_NE(problem("a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p = 1\n"), problem("a.b.c.d.e.f.g.h.i.j.k.l.m.n.o.p.q = 1\n"));
}

TEST(Parameter, ARefusedProfileChangesNothing) {
  Sample sample;
  EXPECT_FALSE(parseProfile("[room]\ngain = 1\ncount = 99\n", "p.toml", bindParameters(sample)));
  EXPECT_EQ(sample.gain, 2.5);
}

TEST(Parameter, AHalfWrittenProfileIsRefused) {
  Sample sample;
  std::string text = formatProfile(bindParameters(sample));
  text.resize(text.find("on = ") + 5);
  EXPECT_FALSE(parseProfile(text, "p.toml", bindParameters(sample)));
}

TEST(Parameter, TextAssignmentIsAsStrict) {
  Sample sample;
  const auto parameters = bindParameters(sample);
  EXPECT_TRUE(assignParameter(parameters[0], " 7.5 "));
  EXPECT_EQ(sample.gain, 7.5);
  EXPECT_FALSE(assignParameter(parameters[0], "7.5x"));
  EXPECT_FALSE(assignParameter(parameters[0], "inf"));
  EXPECT_TRUE(assignParameter(parameters[2], "false"));
  EXPECT_FALSE(assignParameter(parameters[2], "0"));
  EXPECT_TRUE(assignParameter(parameters[3], "red"));
  EXPECT_TRUE(assignParameter(parameters[4], "[ -1, 2.5 ]"));
  EXPECT_EQ(sample.points.size(), 2U);
  EXPECT_FALSE(assignParameter(parameters[4], "[1, 9]"));
  EXPECT_EQ(sample.points.size(), 2U);
}

}  // namespace
}  // namespace fyd
