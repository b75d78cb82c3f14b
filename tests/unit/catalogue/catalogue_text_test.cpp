// The catalogue's words, texts and times, without a database.
#include "core/catalogue/catalogue_text.h"

#include <gmock/gmock.h>

#include <limits>

#include "core/catalogue/catalogue_address.h"
#include "tests/integration/catalogue/catalogue_fixture.h"

namespace fyd::catalogue {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(CatalogueAddress, NamesSqliteOrPostgresql) {
  setenv("XDG_DATA_HOME", "/data/home", 1);
  EXPECT_EQ(parseCatalogueAddress("")->target, "/data/home/fyd-console/sessions.sqlite");
  EXPECT_EQ(parseCatalogueAddress("sqlite:/tmp/./a.sqlite")->target, "/tmp/a.sqlite");
  EXPECT_EQ(parseCatalogueAddress("/tmp/a b.db")->key, "/tmp/a b.db");
  EXPECT_EQ(parseCatalogueAddress("none")->kind, CatalogueAddress::Kind::none);
  const auto server = parseCatalogueAddress("postgresql:host=lab dbname=fyd user=o'neill");
  ASSERT_TRUE(server);
  const auto quoted = parseCatalogueAddress(R"(postgresql:user='o\'neill' host=lab dbname=fyd)");
  ASSERT_TRUE(quoted);
  EXPECT_THAT(quoted->target, HasSubstr(R"(user='o\'neill')"));
  EXPECT_EQ(quoted->key, server->key);
  EXPECT_EQ(parseCatalogueAddress("postgresql://jo@lab/fyd")->name, "PostgreSQL catalogue 'fyd' on lab");
  for (const char* wrong : {"postgres", "mysql:x", "sqlite:", "sqlite:/tmp/", "postgresql:lab", "/tmp/\"x.sqlite"}) {
    EXPECT_FALSE(parseCatalogueAddress(wrong)) << wrong;
  }
  unsetenv("XDG_DATA_HOME");
}

TEST(CatalogueAddress, APasswordIsRefusedAndNeverRepeated) {
  for (const char* word : {"postgresql:host=lab password=hunter2", "postgresql:host=lab password = 'hunter2'",
                           "postgresql://jo:hunter2@lab/fyd", "postgresql:host=lab sslpassword=hunter2",
                           "postgresql:host=lab hunter2", "host=lab password=hunter2"}) {
    const auto parsed = parseCatalogueAddress(word);
    ASSERT_FALSE(parsed) << word;
    EXPECT_THAT(parsed.error().text(), Not(HasSubstr("hunter2")));
  }
}

TEST(CatalogueText, TimesNameTheirSpan) {
  const auto day = parseUtc("1970-01-02");
  ASSERT_TRUE(day);
  EXPECT_EQ(day->begin_ms, 86'400'000);
  EXPECT_EQ(day->end_ms, 2 * 86'400'000);
  EXPECT_EQ(parseUtc("1970-01-01T01:02")->end_ms, 3'780'000);
  EXPECT_EQ(parseUtc("1970-01-01 01:02:03Z")->begin_ms, 3'723'000);
  EXPECT_EQ(parseUtc("1970-01-01T00:00:00.25Z")->begin_ms, 250);
  EXPECT_EQ(parseUtc("1970-01-01T00:00:00.123456Z")->end_ms, 124);
  for (const char* wrong : {"", "2026", "2026-02-30", "2026-13-01", "1969-01-01", "2026-11-21T", "2026-11-21T24:00",
                            "2026-11-21T10:00:", "2026-11-21T10:00:00.", "2026-11-21x", "2026-11-21T10:00:00+01:00"}) {
    EXPECT_FALSE(parseUtc(wrong)) << wrong;
  }
}

TEST(CatalogueText, CaseIsFoldedInEveryScript) {
  EXPECT_EQ(foldCase("MÜLLER Ωmega ЖУК"), foldCase("müller ωMEGA жук"));
  EXPECT_EQ(likeAnywhere("50%_!"), "%50!%!_!!%");
  EXPECT_EQ(cleanedText("a\x1b[31m\xff\nb", false), "a [31m b");
}

TEST(CatalogueText, WhatAFileSaysIsMadeToFit) {
  CatalogueEntry entry = entryOf("abc");
  entry.operator_name = std::string(5000, 'A');
  entry.subject = "x" + std::string(2047, 'y') + [] {
    std::string wide;
    for (int i = 0; i < 1100; ++i) wide += "é";  // the cut falls within one
    return wide;
  }();
  entry.notes = std::string(2'000'000, 'n') + "\x1b";
  entry.tags = {std::string(300, 't'), " \t", "", "soft\n"};
  for (int i = 0; i < 200; ++i) entry.tags.push_back(std::to_string(i));
  ASSERT_FALSE(checkEntry(entry));
  const CatalogueEntry fits = withFittingTexts(entry);
  const auto good = checkEntry(fits);
  EXPECT_TRUE(good) << good.error().text();
  EXPECT_EQ(fits.operator_name, std::string(4093, 'A') + "…");
  EXPECT_EQ(fits.tags.size(), 100U);
  EXPECT_EQ(fits.tags[1], "soft ");
  EXPECT_THAT(fits.subject, testing::EndsWith("é…"));
  EXPECT_THAT(fits.notes, testing::EndsWith("n…"));
  EXPECT_EQ(withFittingTexts(entryOf("abc")).notes, entryOf("abc").notes);
  EXPECT_EQ(withFittingTexts(entryOf("abc")).tags, entryOf("abc").tags);
}

TEST(CatalogueText, WhatMayNotGoInIsNamed) {
  const auto refusal = [](auto change) {
    CatalogueEntry entry = entryOf("abc");
    change(entry);
    const auto checked = checkEntry(entry);
    return checked ? std::string("accepted") : checked.error().text();
  };
  EXPECT_EQ(refusal([](auto&) {}), "accepted");
  EXPECT_THAT(refusal([](auto& e) { e.id = "a'; DROP"; }), HasSubstr("id"));
  EXPECT_THAT(refusal([](auto& e) { e.id = ""; }), HasSubstr("id"));
  EXPECT_THAT(refusal([](auto& e) { e.path = "here.h5"; }), HasSubstr("absolute"));
  EXPECT_THAT(refusal([](auto& e) { e.subject = "\xC3("; }), HasSubstr("subject: not UTF-8"));
  EXPECT_THAT(refusal([](auto& e) { e.operator_name = std::string("a\0b", 3); }), HasSubstr("U+0000"));
  EXPECT_THAT(refusal([](auto& e) { e.notes = std::string(2'000'000, 'x'); }), HasSubstr("2000000 bytes"));
  EXPECT_THAT(refusal([](auto& e) { e.tags = {" "}; }), HasSubstr("empty"));
  EXPECT_THAT(refusal([](auto& e) { e.tags.assign(101, "t"); }), HasSubstr("101"));
  EXPECT_THAT(refusal([](auto& e) { e.started_utc = "yesterday"; }), HasSubstr("yesterday"));
  EXPECT_THAT(refusal([](auto& e) { e.duration_s = std::nan(""); }), HasSubstr("duration"));
  EXPECT_THAT(refusal([](auto& e) { e.duration_s = INFINITY; }), HasSubstr("duration"));
  EXPECT_THAT(refusal([](auto& e) { e.bytes = std::numeric_limits<std::uint64_t>::max(); }), HasSubstr("count"));
}

}  // namespace
}  // namespace fyd::catalogue
