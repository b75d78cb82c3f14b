// The catalogue in SQLite: two writers, a lock, damage, entries that wait, files that move.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <fstream>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "core/catalogue/catalogue_database.h"
#include "core/catalogue/catalogue_delivery.h"
#include "core/catalogue/catalogue_pending.h"
#include "core/catalogue/catalogue_rebuild.h"
#include "tests/integration/catalogue/catalogue_behaviour.h"
#include "tests/wait.h"

namespace fyd::catalogue {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SqliteCatalogue : public CatalogueFolder {
 protected:
  [[nodiscard]] std::string word() const { return "sqlite:" + path("sessions.sqlite"); }
  /// Another program that holds the file's write lock until it is killed.
  [[nodiscard]] pid_t lockElsewhere() const {
    int ready[2] = {};
    if (pipe(ready) != 0) return -1;
    const std::string options = "dbname=" + path("sessions.sqlite");
    const pid_t child = inProcess([&] {
      soci::session sql(soci::sqlite3, options);
      sql << "BEGIN IMMEDIATE";
      if (write(ready[1], "x", 1) != 1) return false;
      for (;;) pause();
    });
    char byte = 0;
    if (read(ready[0], &byte, 1) != 1) return -1;
    close(ready[0]);
    close(ready[1]);
    return child;
  }
  /// A catalogue whose last pages are damaged, while its first entry, with notes, can be read.
  void makeDamaged() const {
    {
      auto catalogue = Catalogue::open(word());
      std::vector<CatalogueEntry> many;
      many.reserve(300);
      for (int i = 0; i < 300; ++i) many.push_back(entryOf(fmt::format("id-{:04}", i)));
      ASSERT_TRUE(catalogue->add(many));
      ASSERT_TRUE(catalogue->setNotes("id-0000", "written here"));
    }
    std::string bytes = readText(path("sessions.sqlite"));
    std::fill(bytes.end() - 8192, bytes.end(), '\xA5');
    writeText(path("sessions.sqlite"), bytes);
  }
  static void end(pid_t child) {
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }
};

TEST_F(SqliteCatalogue, StoresAndFinds) { checkStoresAndFinds(word()); }
TEST_F(SqliteCatalogue, TwoWritersAtOnceLoseNothing) { checkTwoWriters(word()); }

TEST_F(SqliteCatalogue, ALockedOneIsNamedWithItsHolderAndTheEntryWaits) {
  ASSERT_TRUE(Catalogue::open(word())->add(entryOf("first")));
  const pid_t holder = lockElsewhere();
  ASSERT_GT(holder, 0);
  const auto delivered = deliverEntry(word(), entryOf("second"));
  ASSERT_FALSE(delivered);
  EXPECT_THAT(delivered.error().text(), HasSubstr(fmt::format("(process {})", holder)));
  EXPECT_THAT(delivered.error().text(), HasSubstr("pending.sqlite"));
  EXPECT_TRUE(Catalogue::open(word())->get("first")) << "reading goes on";
  end(holder);
  auto catalogue = Catalogue::open(word());
  ASSERT_TRUE(catalogue);
  EXPECT_EQ(catalogue->pending().delivered, 1U);
  EXPECT_TRUE(catalogue->get("second"));
  EXPECT_EQ(Catalogue::open(word())->pending().delivered, 0U) << "once";
}

TEST_F(SqliteCatalogue, DamageOfWhatWaitsIsToldAsThat) {
  ASSERT_TRUE(queueEntry(path("sessions.sqlite"), entryOf("here"), "away"));
  {
    std::fstream file(pendingPath(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(100);  // behind SQLite's own header
    file << std::string(4000, '\xff');
  }
  auto catalogue = Catalogue::open(word());
  ASSERT_TRUE(catalogue) << "the catalogue itself is well";
  const std::string told = catalogue->pending().problem.text();
  EXPECT_THAT(
      told, AllOf(HasSubstr("pending.sqlite: what waits for catalogues is damaged"), HasSubstr("Move the file away")));
  std::filesystem::rename(pendingPath(), pendingPath() + ".away");
  EXPECT_TRUE(Catalogue::open(word())->pending().problem.empty());
}

TEST_F(SqliteCatalogue, WaitingEntriesGoOnlyToTheirOwnCatalogue) {
  ASSERT_TRUE(queueEntry(path("other.sqlite"), entryOf("there"), "away"));
  ASSERT_TRUE(queueEntry(path("sessions.sqlite"), entryOf("here"), "away"));
  ASSERT_TRUE(queueEntry(path("sessions.sqlite"), entryOf("here"), "away")) << "twice is once";
  auto catalogue = Catalogue::open(word());
  EXPECT_EQ(catalogue->pending().delivered, 1U);
  EXPECT_EQ(catalogue->count({}).value(), 1U);
  EXPECT_EQ(catalogue->get("here")->file_modified_ns, entryOf("here").file_modified_ns);
  EXPECT_TRUE(Catalogue::open(path("other.sqlite"))->get("there"));
}

TEST_F(SqliteCatalogue, AnEntryThatCannotGoInDoesNotHoldTheOthersBack) {
  CatalogueEntry bad = entryOf("bad");
  bad.subject = "\x01";
  ASSERT_TRUE(queueEntry(path("sessions.sqlite"), bad, "away"));
  ASSERT_TRUE(queueEntry(path("sessions.sqlite"), entryOf("good"), "away"));
  auto catalogue = Catalogue::open(word());
  EXPECT_EQ(catalogue->pending().delivered, 1U);
  EXPECT_EQ(catalogue->pending().waiting, 1U);
  EXPECT_THAT(catalogue->pending().problem.text(), HasSubstr("subject"));
  EXPECT_TRUE(catalogue->get("good"));
}

TEST_F(SqliteCatalogue, WhatTheDatabaseRefusesOfOneEntryDoesNotHoldTheOthersBack) {
  ASSERT_TRUE(Catalogue::open(word()));
  soci::session(soci::sqlite3, "dbname=" + path("sessions.sqlite"))
      << "CREATE TRIGGER no BEFORE INSERT ON sessions WHEN NEW.id = 'bad' BEGIN SELECT RAISE(ABORT, 'no'); END";
  for (const char* id : {"bad", "good"}) ASSERT_TRUE(queueEntry(path("sessions.sqlite"), entryOf(id), "away"));
  auto catalogue = Catalogue::open(word());
  ASSERT_TRUE(catalogue) << catalogue.error().text();
  EXPECT_EQ(catalogue->pending().waiting, 1U);
  EXPECT_TRUE(catalogue->get("good"));
}

TEST_F(SqliteCatalogue, WhatWaitsSaysItsWholenessInWordsAndTheNumbersOfEarlierQueuesAreRead) {
  for (const char* id : {"word", "number"}) {
    CatalogueEntry entry = entryOf(id);
    entry.wholeness = recording::Wholeness::crashed;
    ASSERT_TRUE(queueEntry(path("sessions.sqlite"), entry, "away"));
  }
  {
    soci::session queue(soci::sqlite3, "dbname=" + pendingPath());
    std::string text;
    queue << "SELECT entry FROM pending WHERE id = 'word'", soci::into(text);
    EXPECT_THAT(text, HasSubstr(R"("wholeness":"crashed")"));
    queue << R"(UPDATE pending SET entry = replace(entry, '"crashed"', '2') WHERE id = 'number')";
  }
  auto catalogue = Catalogue::open(word());
  ASSERT_TRUE(catalogue) << catalogue.error().text();
  for (const char* id : {"word", "number"}) {
    ASSERT_TRUE(catalogue->get(id)) << id;
    EXPECT_EQ(catalogue->get(id)->wholeness, recording::Wholeness::crashed) << id;
  }
}

TEST_F(SqliteCatalogue, AReviewsLongNoteIsCutAndItsTagsArrive) {
  ASSERT_TRUE(Catalogue::open(word())->add(entryOf("aaaa")));
  ReviewChange change{.tags_added = {"reviewed"}};
  change.note.emplace();
  change.note->text = std::string(std::size_t{2} << 20, 'x');
  const auto entered = catalogueReview(word(), "aaaa", change);
  ASSERT_TRUE(entered) << entered.error().text();
  const auto entry = Catalogue::open(word())->get("aaaa");
  EXPECT_TRUE(entry->notes.starts_with("first try\nxxx") && entry->notes.ends_with("…"));
  EXPECT_THAT(entry->tags, testing::Contains("reviewed"));
}

TEST_F(SqliteCatalogue, ANewerOneIsRefused) {
  ASSERT_TRUE(Catalogue::open(word()));
  soci::session(soci::sqlite3, "dbname=" + path("sessions.sqlite")) << "UPDATE catalogue_version SET version = 99";
  EXPECT_THAT(Catalogue::open(word()).error().text(), HasSubstr("newer version"));
}

TEST_F(SqliteCatalogue, NoFolderNoPermissionNoFileAreNamed) {
  fs::create_directory(path("folder.sqlite"));
  EXPECT_THAT(Catalogue::open(path("folder.sqlite")).error().text(), HasSubstr("a folder"));
  writeText(path("file"), "x");
  EXPECT_THAT(Catalogue::open(path("file/x.sqlite")).error().text(), HasSubstr("is no folder"));
  EXPECT_FALSE(Catalogue::open("none"));
  EXPECT_TRUE(deliverEntry("none", entryOf("a"))) << "no catalogue is a choice";
}

TEST_F(SqliteCatalogue, ADamagedOneIsPutAsideAndBuiltAgain) {
  const std::string a = path("data/a.h5");
  writeText(a, "aaaa");
  writeText(path("data/deep/b.h5"), "bbbb");
  {
    auto catalogue = Catalogue::open(word());
    ASSERT_TRUE(catalogue->addFolder(path("data"), readMadeUp));
    ASSERT_TRUE(catalogue->setNotes("aaaa", "written here"));
  }
  const std::string file = path("sessions.sqlite");
  // The first page says that this is a database, and where the tables are.
  std::string bytes = readText(file);
  ASSERT_GT(bytes.size(), 8192U);
  std::fill(bytes.begin(), bytes.begin() + 2048, 'x');
  writeText(file, bytes);
  const auto opened = Catalogue::open(word());
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().text(), HasSubstr("--rebuild"));
  EXPECT_THAT(deliverEntry(word(), entryOf("cccc")).error().text(), HasSubstr("waits"));

  const auto rebuilt = rebuildCatalogue(word(), {path("data")}, readMadeUp);
  ASSERT_TRUE(rebuilt) << rebuilt.error().text();
  EXPECT_EQ(readText(rebuilt->moved_aside), bytes) << "as it was";
  EXPECT_EQ(rebuilt->scan.added, 2U);
  auto catalogue = Catalogue::open(word());
  ASSERT_TRUE(catalogue);
  EXPECT_TRUE(catalogue->get("aaaa"));
  EXPECT_TRUE(catalogue->get("cccc")) << "what waited came in";
  EXPECT_THAT(catalogue->folders().value(), ElementsAre(fs::canonical(path("data")).string()));
}

TEST_F(SqliteCatalogue, WhatADamagedOneStillSaysIsTakenOver) {
  makeDamaged();
  ASSERT_FALSE(Catalogue::open(word()));
  const auto rebuilt = rebuildCatalogue(word(), {}, readMadeUp);
  ASSERT_TRUE(rebuilt) << rebuilt.error().text();
  EXPECT_GT(rebuilt->rescued, 100U);
  EXPECT_EQ(Catalogue::open(word())->get("id-0000")->notes, "written here");
}

TEST_F(SqliteCatalogue, WhatWaitsForADamagedOneKeepsTheNotesThatWereTakenOver) {
  makeDamaged();
  CatalogueEntry newer = entryOf("id-0000");
  newer.samples = 777;
  EXPECT_THAT(deliverEntry(word(), newer).error().text(), HasSubstr("waits"));
  const auto rebuilt = rebuildCatalogue(word(), {}, readMadeUp);
  ASSERT_TRUE(rebuilt) << rebuilt.error().text();
  const auto entry = Catalogue::open(word())->get("id-0000");
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->notes, "written here");
  EXPECT_EQ(entry->samples, 777U) << "what waited is newer than what was taken over";
}

TEST_F(SqliteCatalogue, ARebuildThatCannotWriteLeavesTheDamagedOneForTheNext) {
  makeDamaged();
  const std::string bytes = readText(path("sessions.sqlite"));
  EXPECT_TRUE(succeeded(inProcess([&] {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{65'536, 65'536};  // room for the tables, not for the entries
    setrlimit(RLIMIT_FSIZE, &limit);
    return !rebuildCatalogue(word(), {}, readMadeUp);
  })));
  EXPECT_EQ(readText(path("sessions.sqlite")), bytes) << "in its place, as it was";
  const auto rebuilt = rebuildCatalogue(word(), {}, readMadeUp);
  ASSERT_TRUE(rebuilt) << rebuilt.error().text();
  EXPECT_EQ(Catalogue::open(word())->get("id-0000")->notes, "written here");
  for (const auto& item : fs::directory_iterator(folder_)) {
    EXPECT_THAT(item.path().filename().string(), testing::Not(HasSubstr(".new"))) << "no rest is left";
  }
}

TEST_F(SqliteCatalogue, AnotherProgramsDamagedDatabaseStaysWhereItIs) {
  const std::string file = path("sessions.sqlite");
  {
    soci::session sql(soci::sqlite3, "dbname=" + file);
    sql << "CREATE TABLE letters (text TEXT)";
    const std::string letter(3000, 'a');
    for (int i = 0; i < 20; ++i) sql << "INSERT INTO letters VALUES (:text)", soci::use(letter);
  }
  // Its first page, which lists its tables, is whole: of the others, once the last and once all are damaged.
  const std::string whole = readText(file);
  ASSERT_GT(whole.size(), 16'384U);
  for (const std::size_t from : {whole.size() - 4096, std::size_t{4096}}) {
    std::string bytes = whole;
    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end(), '\xA5');
    writeText(file, bytes);
    const auto opened = Catalogue::open(word());
    ASSERT_FALSE(opened) << from;
    EXPECT_THAT(opened.error().text(), testing::Not(HasSubstr("--rebuild"))) << from;
    const auto rebuilt = rebuildCatalogue(word(), {}, readMadeUp);
    ASSERT_FALSE(rebuilt) << from;
    EXPECT_THAT(rebuilt.error().text(), HasSubstr("is no catalogue")) << from;
    EXPECT_EQ(readText(file), bytes) << from;
  }
}

TEST_F(SqliteCatalogue, RebuildingAHealthyOneKeepsIt) {
  ASSERT_TRUE(Catalogue::open(word())->add(entryOf("aaaa")));
  const auto rebuilt = rebuildCatalogue(word(), {}, readMadeUp);
  ASSERT_TRUE(rebuilt);
  EXPECT_THAT(rebuilt->moved_aside, IsEmpty());
  EXPECT_TRUE(Catalogue::open(word())->get("aaaa"));
}

TEST_F(SqliteCatalogue, FoldersAreReadOnceAndCopiesAndRubbishAreNamed) {
  writeText(path("data/a.h5"), "aaaa");
  writeText(path("data/z/copy.h5"), "aaaa");
  writeText(path("data/b.h5.partial"), "bbbb");
  writeText(path("data/empty.h5"), "");
  writeText(path("data/notes.txt"), "cccc");
  fs::create_directory_symlink(path("data"), path("data/loop"));
  auto catalogue = Catalogue::open(word());
  int reads = 0;
  const EntryReader counted = [&](const std::string& file) {
    ++reads;
    return readMadeUp(file);
  };
  const auto first = catalogue->addFolder(path("data"), counted);
  ASSERT_TRUE(first) << first.error().text();
  EXPECT_EQ(first->added, 2U);
  EXPECT_THAT(first->copies, ElementsAre(fs::canonical(path("data/z/copy.h5")).string()));
  ASSERT_EQ(first->unreadable.size(), 1U);
  EXPECT_THAT(first->unreadable[0].text(), HasSubstr("empty.h5"));
  EXPECT_EQ(reads, 4);
  const auto second = catalogue->addFolder(path("data"), counted);
  EXPECT_EQ(second->added, 0U);
  EXPECT_EQ(second->known, 2U);
  EXPECT_EQ(reads, 6) << "only the copy and the rubbish again";
  EXPECT_FALSE(catalogue->addFolder(path("nowhere"), counted));
}

TEST_F(SqliteCatalogue, MovedChangedReplacedAndMissingFilesAreFound) {
  for (const char* id : {"stay", "move", "grow", "swap", "lost"}) writeText(path(fmt::format("data/{}.h5", id)), id);
  fs::create_directory(path("archive"));
  auto catalogue = Catalogue::open(word());
  ASSERT_TRUE(catalogue->addFolder(path("archive"), readMadeUp));
  ASSERT_TRUE(catalogue->addFolder(path("data"), readMadeUp));
  EXPECT_THAT(catalogue->checkFiles(readMadeUp).value(), IsEmpty());
  CatalogueEntry foreign = entryOf("elsewhere");
  foreign.station = "another";
  ASSERT_TRUE(catalogue->add(foreign));

  fs::create_directory(path("archive/2026"));
  fs::rename(path("data/move.h5"), path("archive/2026/renamed.h5"));
  fs::last_write_time(path("data/grow.h5"), fs::file_time_type::clock::now() + std::chrono::hours(1));
  writeText(path("data/swap.h5"), "another");
  fs::rename(path("data/lost.h5"), path("lost.away"));
  const auto check = [&] {
    std::vector<std::string> out;
    const auto changes = catalogue->checkFiles(readMadeUp);
    if (!changes) return std::vector{changes.error().text()};
    for (const FileChange& change : *changes) out.push_back(change.id + " " + toString(change.kind));
    return out;
  };
  EXPECT_THAT(check(), testing::UnorderedElementsAre("move moved", "grow changed", "swap replaced", "lost missing"));
  EXPECT_EQ(catalogue->get("move")->path, fs::canonical(path("archive/2026/renamed.h5")).string());
  EXPECT_EQ(catalogue->get("lost")->file_state, FileState::missing);
  EXPECT_EQ(catalogue->get("swap")->file_state, FileState::replaced);
  EXPECT_EQ(catalogue->get("elsewhere")->file_state, FileState::present) << "that station looks after it";
  fs::rename(path("lost.away"), path("data/lost.h5"));
  EXPECT_THAT(check(), testing::UnorderedElementsAre("lost returned", "swap replaced"));
  EXPECT_EQ(catalogue->get("lost")->file_state, FileState::present);
}

TEST_F(SqliteCatalogue, AnotherStationsEntryKeepsItsPathUntilItsFileIsNamedHere) {
  auto catalogue = Catalogue::open(word());
  CatalogueEntry foreign = entryOf("aaaa");
  foreign.station = "another";
  ASSERT_TRUE(catalogue->add(foreign));
  writeText(path("data/a.h5"), "aaaa");
  const std::string here = fs::canonical(path("data/a.h5"));
  const auto scan = catalogue->addFolder(path("data"), readMadeUp);
  ASSERT_TRUE(scan) << scan.error().text();
  EXPECT_THAT(scan->copies, ElementsAre(here));
  EXPECT_EQ(scan->added + scan->known, 0U);
  EXPECT_EQ(catalogue->get("aaaa")->path, foreign.path);
  EXPECT_EQ(catalogue->get("aaaa")->station, "another");

  CatalogueEntry same_path = entryOf("aaaa");
  ASSERT_TRUE(catalogue->add(same_path));
  EXPECT_EQ(catalogue->get("aaaa")->station, "another") << "who looks after that path does not change";
  ASSERT_TRUE(catalogue->add(readMadeUp(here).value()));
  EXPECT_EQ(catalogue->get("aaaa")->path, here);
  EXPECT_EQ(catalogue->get("aaaa")->station, stationName());
}

TEST_F(SqliteCatalogue, AFileIsNoCopyWhenAnotherHasTheOldPath) {
  writeText(path("data/m.h5"), "aaaa");
  auto catalogue = Catalogue::open(word());
  ASSERT_TRUE(catalogue->addFolder(path("data"), readMadeUp));
  fs::rename(path("data/m.h5"), path("data/a.h5"));  // looked at before the old path
  writeText(path("data/m.h5"), "another");
  const auto scan = catalogue->addFolder(path("data"), readMadeUp);
  ASSERT_TRUE(scan) << scan.error().text();
  EXPECT_THAT(scan->copies, IsEmpty());
  EXPECT_EQ(catalogue->get("aaaa")->path, fs::canonical(path("data/a.h5")).string());
  EXPECT_EQ(catalogue->get("another")->path, fs::canonical(path("data/m.h5")).string());
}

TEST_F(SqliteCatalogue, ARecordingThatCannotBeReadIsNotCalledReplaced) {
  writeText(path("data/a.h5"), "aaaa");
  auto catalogue = Catalogue::open(word());
  ASSERT_TRUE(catalogue->addFolder(path("data"), readMadeUp));
  writeText(path("data/a.h5"), "");
  const auto changes = catalogue->checkFiles(readMadeUp);
  ASSERT_TRUE(changes) << changes.error().text();
  ASSERT_EQ(changes->size(), 1U);
  EXPECT_STREQ(toString(changes->front().kind), "unreadable");
  EXPECT_THAT(changes->front().problem.text(), HasSubstr("no recording"));
  EXPECT_EQ(catalogue->get("aaaa")->file_state, FileState::present);
}

TEST_F(SqliteCatalogue, AFolderThatCannotBeListedCostsOnlyWhatIsInIt) {
  writeText(path("data/a/a.h5"), "aaaa");
  writeText(path("data/z/z.h5"), "zzzz");
  // Folders within folders, until their path is longer than the system takes.
  const std::string name(200, 'm');
  int folder = open(path("data").c_str(), O_RDONLY | O_DIRECTORY);
  for (int depth = 0; depth < 21; ++depth) {
    ASSERT_EQ(mkdirat(folder, name.c_str(), 0700), 0);
    const int next = openat(folder, name.c_str(), O_RDONLY | O_DIRECTORY);
    close(folder);
    folder = next;
  }
  close(folder);
  auto catalogue = Catalogue::open(word());
  const auto scan = catalogue->addFolder(path("data"), readMadeUp);
  ASSERT_TRUE(scan) << scan.error().text();
  EXPECT_EQ(scan->added, 2U);
  ASSERT_EQ(scan->unreadable.size(), 1U);
  EXPECT_THAT(scan->unreadable[0].text(), testing::EndsWith("m: File name too long"));

  fs::remove(path("data/a/a.h5"));
  const auto changes = catalogue->checkFiles(readMadeUp);
  ASSERT_TRUE(changes) << changes.error().text();
  ASSERT_EQ(changes->size(), 1U);
  EXPECT_STREQ(toString(changes->front().kind), "unreadable") << "it may be where nobody could look";
  EXPECT_EQ(changes->front().problem, scan->unreadable[0]);
  EXPECT_EQ(catalogue->get("aaaa")->file_state, FileState::present);
  fs::remove_all(path("data") + "/" + name);
  EXPECT_STREQ(toString(catalogue->checkFiles(readMadeUp)->front().kind), "missing");
}

TEST_F(SqliteCatalogue, WhatIsTheSystemsAloneIsNoFolderOfRecordings) {
  writeText(path("data/a.h5"), "aaaa");
  for (const char* name : {"data/lost+found", "data/.Trash-1001", "data/deep/lost+found"}) makeShutFolder(name);
  if (!openToOthers({"", "data", "data/deep"})) GTEST_SKIP() << folder_ << " is in a folder that others may not enter";
  EXPECT_TRUE(unprivileged([&] {
    const FoundRecordings disk = recordingsIn(path("data"), true);
    const FoundRecordings asked = recordingsIn(path("data/lost+found"), true);
    return disk.files.size() == 1 && disk.problems.empty() && asked.files.empty() && asked.problems.size() == 1;
  }));
}

TEST_F(SqliteCatalogue, AnotherUsersFolderIsNamed) {
  writeText(path("data/a.h5"), "aaaa");
  makeShutFolder("data/anna");
  if (!openToOthers({"", "data"})) GTEST_SKIP() << folder_ << " is in a folder that others may not enter";
  EXPECT_TRUE(unprivileged([&] {
    const FoundRecordings disk = recordingsIn(path("data"), true);
    return disk.files.size() == 1 && disk.problems.size() == 1 &&
           disk.problems[0].text().ends_with("anna: Permission denied");
  }));
}

TEST_F(SqliteCatalogue, APathThatCannotBeAskedForIsAnError) {
  const auto damaged = isDamaged(path(std::string(300, 'x')));
  ASSERT_FALSE(damaged);
  EXPECT_THAT(damaged.error().text(), HasSubstr("File name too long"));
  EXPECT_FALSE(isDamaged(path("none.sqlite")).value());
}

TEST_F(SqliteCatalogue, AKilledWriterLeavesWholeEntries) {
  ASSERT_TRUE(Catalogue::open(word()));
  const pid_t writer = inProcess([&] {
    auto catalogue = Catalogue::open(word());
    for (int i = 0;; ++i) {
      if (!catalogue->add(entryOf(fmt::format("k-{:06}", i)))) return false;
    }
  });
  auto catalogue = Catalogue::open(word());
  EXPECT_TRUE(comesTrue("20 entries", [&] { return catalogue->count({}).value_or(0) >= 20; }));
  end(writer);
  auto again = Catalogue::open(word());
  ASSERT_TRUE(again) << again.error().text();
  const auto entries = again->search({});
  ASSERT_TRUE(entries);
  EXPECT_GE(entries->size(), 20U);
  for (const CatalogueEntry& entry : *entries) EXPECT_EQ(entry.tags.size(), 2U) << entry.id;
}

}  // namespace
}  // namespace fyd::catalogue
