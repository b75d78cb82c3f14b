// Checks that every catalogue must pass, with any database: each is run on SQLite and on PostgreSQL.
#pragma once

#include <gmock/gmock.h>

#include <string>

#include "tests/integration/catalogue/catalogue_fixture.h"

namespace fyd::catalogue {

inline std::vector<std::string> idsOf(const Result<std::vector<CatalogueEntry>>& found) {
  std::vector<std::string> out;
  if (!found) return {found.error().text()};
  for (const CatalogueEntry& entry : *found) out.push_back(entry.id);
  return out;
}

inline void checkStoresAndFinds(const std::string& word) {
  using testing::ElementsAre;
  using testing::IsEmpty;
  auto opened = Catalogue::open(word);
  ASSERT_TRUE(opened) << opened.error().text();
  Catalogue& catalogue = *opened;

  CatalogueEntry first = entryOf("aaaa1111");
  first.subject = "'; DROP TABLE sessions; --";
  first.notes = "Seide, 50 % gedehnt\nÜbung_1 :word0 $1 \\";
  first.operator_name = "Müller";
  first.duration_s = 0.1 + 0.2;
  CatalogueEntry second = entryOf("aaaa2222");
  second.started_utc = "2026-11-22T00:00:00.000Z";
  second.tags = {"pilot"};
  second.wholeness = recording::Wholeness::crashed;
  second.health = "damaged";
  ASSERT_TRUE(catalogue.add(first));
  ASSERT_TRUE(catalogue.add(second));
  ASSERT_TRUE(catalogue.add(first)) << "twice is once";
  EXPECT_EQ(catalogue.count({}).value(), 2);

  const auto back = catalogue.get("aaaa1111");
  ASSERT_TRUE(back) << back.error().text();
  EXPECT_EQ(back->subject, first.subject);
  EXPECT_EQ(back->notes, first.notes);
  EXPECT_EQ(back->duration_s, first.duration_s) << "to the last bit";
  EXPECT_EQ(back->file_modified_ns, first.file_modified_ns);
  EXPECT_THAT(back->tags, ElementsAre("Cotton", "pilot"));
  EXPECT_EQ(catalogue.get("aaaa2222")->wholeness, recording::Wholeness::crashed);
  EXPECT_EQ(catalogue.get("aaaa11")->id, "aaaa1111");
  EXPECT_THAT(catalogue.get("aaaa").error().text(), testing::HasSubstr("several"));
  EXPECT_FALSE(catalogue.get("bbbb"));
  EXPECT_FALSE(catalogue.get("aaa%"));

  const auto find = [&](const SessionFilter& filter) { return idsOf(catalogue.search(filter)); };
  EXPECT_THAT(find({}), ElementsAre("aaaa2222", "aaaa1111")) << "newest first";
  EXPECT_THAT(find({.descending = false}), ElementsAre("aaaa1111", "aaaa2222"));
  EXPECT_THAT(find({.text = "seide MÜLLER"}), ElementsAre("aaaa1111"));
  EXPECT_THAT(find({.text = "50 %"}), ElementsAre("aaaa1111"));
  EXPECT_THAT(find({.text = "5%n"}), IsEmpty()) << "a per cent sign is one";
  EXPECT_THAT(find({.text = "drop"}), ElementsAre("aaaa1111"));
  EXPECT_THAT(find({.text = "cotton"}), ElementsAre("aaaa1111"));
  EXPECT_THAT(find({.tags = {"PILOT"}}), ElementsAre("aaaa2222", "aaaa1111"));
  EXPECT_THAT(find({.tags = {"pilot", "cotton"}}), ElementsAre("aaaa1111"));
  EXPECT_THAT(find({.tags = {"pil"}}), IsEmpty());
  EXPECT_THAT(find({.since = "2026-11-22"}), ElementsAre("aaaa2222"));
  EXPECT_THAT(find({.until = "2026-11-21"}), ElementsAre("aaaa1111")) << "the day itself is in";
  EXPECT_THAT(find({.until = "2026-11-21T14:04"}), IsEmpty());
  EXPECT_THAT(find({.subject = "'; DROP TABLE sessions; --"}), ElementsAre("aaaa1111"));
  EXPECT_THAT(find({.operator_name = "' OR '1'='1"}), IsEmpty());
  EXPECT_THAT(find({.health = "damaged"}), ElementsAre("aaaa2222"));
  EXPECT_THAT(find({.station = stationName(), .limit = 1, .offset = 1}), ElementsAre("aaaa1111"));
  EXPECT_THAT(find({.offset = 5}), IsEmpty());
  EXPECT_FALSE(catalogue.search({.since = "tomorrow"}));
  EXPECT_FALSE(catalogue.search({.text = "\xff"}));

  ASSERT_TRUE(catalogue.setNotes("aaaa1111", "Wolle"));
  ASSERT_TRUE(catalogue.setTags("aaaa1111", {"Wool", "wool", "pilot"}));
  ASSERT_TRUE(catalogue.add(first)) << "reading the file again";
  EXPECT_EQ(catalogue.get("aaaa1111")->notes, "Wolle") << "what was written here stays";
  EXPECT_EQ(catalogue.get("aaaa1111")->tags.size(), 2U);
  EXPECT_THAT(find({.text = "seide"}), IsEmpty());
  EXPECT_THAT(find({.text = "wolle wool"}), ElementsAre("aaaa1111"));
  second.robot = "classic:0.0.0.0:25000";
  second.tags = {};
  ASSERT_TRUE(catalogue.update(second));
  EXPECT_EQ(catalogue.get("aaaa2222")->robot, second.robot);
  EXPECT_THAT(find({.tags = {"pilot"}}), ElementsAre("aaaa1111"));
  EXPECT_FALSE(catalogue.update(entryOf("cccc")));
  EXPECT_FALSE(catalogue.setNotes("cccc", ""));
  EXPECT_FALSE(catalogue.setTags("cccc", {"x"}));

  CatalogueEntry foreign = entryOf("ffff");
  foreign.station = "another";
  ASSERT_TRUE(catalogue.add(foreign));
  ASSERT_TRUE(catalogue.add(entryOf("ffff")));
  EXPECT_EQ(catalogue.get("ffff")->station, "another") << "found again at its path";
  ASSERT_TRUE(catalogue.addAsOwn(entryOf("ffff")));
  EXPECT_EQ(catalogue.get("ffff")->station, stationName()) << "named here, at the same path";
  ASSERT_TRUE(catalogue.remove("ffff"));

  CatalogueEntry bad = entryOf("dddd");
  bad.notes = "\xff";
  const std::vector<CatalogueEntry> mixed = {entryOf("eeee"), bad};
  EXPECT_FALSE(catalogue.add(mixed));
  EXPECT_FALSE(catalogue.get("eeee")) << "all or none";
  ASSERT_TRUE(catalogue.remove("aaaa1111"));
  EXPECT_FALSE(catalogue.remove("aaaa1111"));
  EXPECT_EQ(catalogue.count({}).value(), 1);
}

/// Two processes add 200 entries each, at the same time, to a catalogue that does not exist yet.
inline void checkTwoWriters(const std::string& word) {
  const auto writer = [&word](char letter) {
    return inProcess([&word, letter] {
      auto catalogue = Catalogue::open(word);
      if (!catalogue) return fprintf(stderr, "%s\n", catalogue.error().text().c_str()), false;
      for (int i = 0; i < 200; ++i) {
        const auto added = catalogue->add(entryOf(fmt::format("{}-{:04}", letter, i)));
        if (!added) return fprintf(stderr, "%s\n", added.error().text().c_str()), false;
      }
      return true;
    });
  };
  const pid_t one = writer('a');
  const pid_t two = writer('b');
  EXPECT_TRUE(succeeded(one));
  EXPECT_TRUE(succeeded(two));
  auto catalogue = Catalogue::open(word);
  ASSERT_TRUE(catalogue) << catalogue.error().text();
  EXPECT_EQ(catalogue->count({}).value(), 400);
  EXPECT_EQ(catalogue->count({.tags = {"pilot", "cotton"}}).value(), 400) << "with their tags";
}

}  // namespace fyd::catalogue
