// The catalogue in PostgreSQL, on a real server which the test starts, stops and kills.
#include <gmock/gmock.h>

#include "core/catalogue/catalogue_database.h"
#include "core/catalogue/catalogue_delivery.h"
#include "tests/integration/catalogue/catalogue_behaviour.h"
#include "tests/integration/catalogue/catalogue_postgres_server.h"
#include "tests/wait.h"

namespace fyd::catalogue {
namespace {

using testing::HasSubstr;

class PostgresCatalogue : public CatalogueFolder {
 protected:
  static void SetUpTestSuite() {
    if (PostgresServer::binaries().empty()) return;
    server = std::make_unique<PostgresServer>();
    ASSERT_TRUE(server->start()) << readText(server->log());
  }
  static void TearDownTestSuite() { server.reset(); }
  void SetUp() override {
    if (!server) {
      fprintf(stderr,
              "\n*** SKIPPED: PostgreSQL is not installed (package postgresql); nothing of it was tested ***\n");
      GTEST_SKIP() << "PostgreSQL is not installed (package postgresql)";
    }
    static int number = 0;
    const std::string name = "fyd" + std::to_string(++number);
    ASSERT_TRUE(server->makeDatabase(name)) << readText(server->log());
    word_ = server->word(name);
  }

  static inline std::unique_ptr<PostgresServer> server;
  std::string word_;
};

TEST_F(PostgresCatalogue, StoresAndFinds) { checkStoresAndFinds(word_); }
TEST_F(PostgresCatalogue, TwoWritersAtOnceLoseNothing) { checkTwoWriters(word_); }

TEST_F(PostgresCatalogue, NoServerNoDatabaseAreNamedAndTheEntryWaits) {
  const std::string nowhere = "postgresql:host=127.0.0.1 port=1 dbname=fyd user=jo";
  EXPECT_THAT(Catalogue::open(nowhere).error().text(), HasSubstr("'fyd' on 127.0.0.1"));
  EXPECT_THAT(deliverEntry(nowhere, entryOf("aaaa")).error().text(), HasSubstr("waits in"));
  EXPECT_THAT(Catalogue::open(server->word("absent")).error().text(), HasSubstr("does not exist"));
}

TEST_F(PostgresCatalogue, ALockOfAnotherStationEndsInAnErrorNotInWaiting) {
  ASSERT_TRUE(Catalogue::open(word_)->add(entryOf("aaaa")));
  auto other = CatalogueDatabase::open(*parseCatalogueAddress(word_), catalogueSchema());
  ASSERT_TRUE(other);
  const auto undone = (*other)->write([&](soci::session& sql) -> Result<void> {
    sql << "LOCK TABLE sessions IN ACCESS EXCLUSIVE MODE";
    const auto delivered = deliverEntry(word_, entryOf("bbbb"));
    EXPECT_FALSE(delivered);
    if (!delivered) {
      EXPECT_THAT(delivered.error().text(), HasSubstr("lock timeout"));
    }
    return fail("unlock");
  });
  EXPECT_EQ(undone.error().text(), "unlock");
  auto catalogue = Catalogue::open(word_);
  EXPECT_EQ(catalogue->pending().delivered, 1U);
  EXPECT_TRUE(catalogue->get("bbbb"));
}

TEST_F(PostgresCatalogue, AnOpenCatalogueFindsARestartedServerAgain) {
  auto catalogue = Catalogue::open(word_);
  ASSERT_TRUE(catalogue->add(entryOf("aaaa")));
  server->stop(SIGINT);
  EXPECT_FALSE(catalogue->add(entryOf("bbbb")));
  EXPECT_FALSE(catalogue->get("aaaa"));
  ASSERT_TRUE(server->start());
  EXPECT_TRUE(catalogue->add(entryOf("bbbb")));
  EXPECT_EQ(catalogue->count({}).value(), 2U);
}

/// A station records and records; its server is killed in the middle of a write, and comes back.
TEST_F(PostgresCatalogue, AServerKilledInTheMiddleOfWritingLosesNothing) {
  ASSERT_TRUE(Catalogue::open(word_));
  constexpr int kSessions = 120;  // at least: until one of them found no server
  constexpr int kKillAfter = 30;
  const auto idOf = [](int i) { return fmt::format("s-{:04}", i); };
  const pid_t station = inProcess([&] {
    int waiting = 0;
    int i = 0;
    const auto end = std::chrono::steady_clock::now() + kPatience;
    for (; (i < kSessions || waiting == 0) && std::chrono::steady_clock::now() < end; ++i) {
      const auto delivered = deliverEntry(word_, entryOf(idOf(i)));
      if (delivered) continue;
      ++waiting;
      if (delivered.error().text().find("waits in") == std::string::npos) {
        return fprintf(stderr, "%s\n", delivered.error().text().c_str()), false;
      }
    }
    std::ofstream(path("recorded")) << i;
    return waiting > 0;
  });
  {
    auto watcher = Catalogue::open(word_);
    EXPECT_TRUE(comesTrue("30 sessions", [&] { return watcher->count({}).value_or(0) >= kKillAfter; }));
  }
  server->stop(SIGQUIT);
  EXPECT_TRUE(succeeded(station)) << "each entry that did not arrive was kept, and said so";
  ASSERT_TRUE(server->start()) << readText(server->log());
  auto catalogue = Catalogue::open(word_);
  ASSERT_TRUE(catalogue) << catalogue.error().text();
  EXPECT_GT(catalogue->pending().delivered, 0U);
  EXPECT_EQ(catalogue->pending().waiting, 0U) << catalogue->pending().problem.text();
  const auto entries = catalogue->search({});
  ASSERT_TRUE(entries);
  EXPECT_EQ(entries->size(), std::stoul(readText(path("recorded"))));
  for (const CatalogueEntry& entry : *entries) EXPECT_EQ(entry.tags.size(), 2U) << entry.id << ": half written";
}

}  // namespace
}  // namespace fyd::catalogue
