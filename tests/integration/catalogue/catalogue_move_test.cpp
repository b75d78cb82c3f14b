// Moving recordings to shared storage: whatever fails, the source stays whole.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>

#include <cerrno>

#include "core/catalogue/archive_move.h"
#include "tests/integration/catalogue/catalogue_fixture.h"

namespace fyd::catalogue {
namespace {

/// Called with the path of each file or folder that is synced; false: the storage fails.
std::function<bool(const std::string& path)>& syncObserver() {
  static std::function<bool(const std::string&)> observer;
  return observer;
}

}  // namespace
}  // namespace fyd::catalogue

/// Takes the place of the C library's in this program.
extern "C" int fsync(int fd) {
  const auto& observer = fyd::catalogue::syncObserver();
  std::error_code error;
  const std::string path =
      observer ? std::filesystem::read_symlink(fmt::format("/proc/self/fd/{}", fd), error).string() : std::string();
  if (observer && !observer(path)) {
    errno = EIO;
    return -1;
  }
  return static_cast<int>(syscall(SYS_fsync, fd));
}

namespace fyd::catalogue {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

const auto kAccept = [](const std::string&) -> Result<void> { return {}; };

class ArchiveMove : public CatalogueFolder {
 protected:
  void SetUp() override {
    for (std::size_t i = 0; i < 3'000'000; ++i) content += static_cast<char>(i * 2654435761U >> 13U);
    writeText(source, content);
    fs::create_directory(target);
  }
  [[nodiscard]] std::vector<std::string> stored() const {
    std::vector<std::string> out;
    for (const auto& item : fs::directory_iterator(target)) out.push_back(item.path().filename());
    return out;
  }

  std::string source = path("a.h5");
  std::string target = path("share");
  std::string content;
};

TEST_F(ArchiveMove, MovesTheWholeFileAndTellsTheCatalogueFirst) {
  bool both = false;
  const auto moved = moveFile(source, target, [&](const std::string& now) -> Result<void> {
    both = fs::exists(source) && readText(now) == content;
    return {};
  });
  ASSERT_TRUE(moved) << moved.error().text();
  EXPECT_TRUE(both) << "the source goes last";
  EXPECT_EQ(moved->bytes, content.size());
  EXPECT_FALSE(fs::exists(source));
  EXPECT_THAT(stored(), testing::ElementsAre("a.h5"));
  EXPECT_EQ(readText(moved->path), content);
}

TEST_F(ArchiveMove, AnotherFileOfTheNameIsNeverTouched) {
  writeText(target + "/a.h5", "somebody's");
  EXPECT_THAT(moveFile(source, target, kAccept).error().text(), HasSubstr("another file of this name"));
  EXPECT_EQ(readText(target + "/a.h5"), "somebody's");
  EXPECT_EQ(readText(source), content);
  std::string other = content;
  other.back() = static_cast<char>(other.back() + 1);
  writeText(target + "/a.h5", other);
  EXPECT_FALSE(moveFile(source, target, kAccept)) << "the same size is not the same file";
  EXPECT_EQ(readText(source), content);
}

TEST_F(ArchiveMove, ATargetThatIsTheSourceUnderAnotherNameKeepsTheOnlyCopy) {
  const std::string there = target + "/a.h5";
  const auto link = [&](const char* kind) {
    fs::remove(there);
    if (std::string_view(kind) == "symbolic")
      fs::create_symlink(source, there);
    else
      fs::create_hard_link(source, there);
  };
  for (const char* kind : {"symbolic", "hard"}) {
    link(kind);
    const auto moved = moveFile(source, target, kAccept);
    ASSERT_FALSE(moved) << kind;
    EXPECT_THAT(moved.error().text(), HasSubstr(there)) << kind;
    ASSERT_TRUE(fs::is_regular_file(fs::symlink_status(source))) << kind;
    EXPECT_EQ(readText(source), content) << kind;
    fs::remove(there);
    EXPECT_FALSE(moveFile(source, target,
                          [&](const std::string&) -> Result<void> {
                            link(kind);
                            return {};
                          }))
        << kind << ": the copy became a link just before the source would go";
    ASSERT_TRUE(fs::exists(source)) << kind;
    EXPECT_EQ(readText(source), content) << kind;
  }
  fs::remove(there);
  fs::create_symlink(path("nothing"), there);
  EXPECT_THAT(moveFile(source, target, kAccept).error().text(), HasSubstr("expected an ordinary file"));
  EXPECT_EQ(readText(source), content);
}

TEST_F(ArchiveMove, ACatalogueThatRefusesKeepsBothAndAskingAgainFinishes) {
  const auto refused = moveFile(source, target, [](const std::string&) { return Result<void>(fail("server away")); });
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr("server away"));
  EXPECT_EQ(readText(source), content);
  EXPECT_EQ(readText(target + "/a.h5"), content);
  const auto again = moveFile(source, target, kAccept);
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_TRUE(again->was_there);
  EXPECT_FALSE(fs::exists(source));
}

TEST_F(ArchiveMove, ACopyOfAnEarlierMoveIsOnTheStorageBeforeTheSourceGoes) {
  const std::string there = fs::canonical(target) / "a.h5";
  const auto moved = [&](bool works) {
    std::vector<std::string> synced;
    syncObserver() = [&](const std::string& path) {
      if (fs::exists(source)) synced.push_back(path);
      return works;
    };
    const auto result = moveFile(source, target, kAccept);
    syncObserver() = nullptr;
    return std::pair{result, synced};
  };
  fs::copy_file(source, there);
  const auto [refused, tried] = moved(false);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr(there + ": writing failed: Input/output error"));
  EXPECT_THAT(tried, testing::ElementsAre(there));
  EXPECT_EQ(readText(source), content);
  const auto [finished, synced] = moved(true);
  ASSERT_TRUE(finished) << finished.error().text();
  EXPECT_TRUE(finished->was_there);
  EXPECT_THAT(synced, testing::ElementsAre(there, fs::canonical(target).string()));
  EXPECT_FALSE(fs::exists(source));
}

TEST_F(ArchiveMove, AFolderThatIsGoneOrNoneOrTheSameIsNamed) {
  EXPECT_THAT(moveFile(source, path("away"), kAccept).error().text(), HasSubstr("stays at"));
  EXPECT_THAT(moveFile(source, source, kAccept).error().text(), HasSubstr("expected a folder"));
  EXPECT_THAT(moveFile(source, folder_.string(), kAccept).error().text(), HasSubstr("already in"));
  EXPECT_THAT(moveFile(path("none.h5"), target, kAccept).error().text(), HasSubstr("none.h5"));
  EXPECT_THAT(moveFile(target, folder_.string(), kAccept).error().text(), HasSubstr("ordinary file"));
  EXPECT_EQ(readText(source), content);
}

TEST_F(ArchiveMove, AFolderThatMayNotBeWrittenKeepsTheSource) {
  fs::permissions(folder_, fs::perms::all);
  fs::permissions(target,
                  fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
  if (!openToOthers({"", "share", "a.h5"})) GTEST_SKIP() << folder_ << " is in a folder that others may not enter";
  EXPECT_TRUE(unprivileged([&] {
    const auto moved = moveFile(source, target, kAccept);
    return !moved && moved.error().text().find("cannot be written") != std::string::npos;
  }));
  EXPECT_EQ(readText(source), content);
  EXPECT_THAT(stored(), IsEmpty());
}

TEST_F(ArchiveMove, AStorageThatFillsUpKeepsTheSourceAndLeavesNoRest) {
  EXPECT_TRUE(succeeded(inProcess([&] {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1'500'000, 1'500'000};
    setrlimit(RLIMIT_FSIZE, &limit);
    const auto moved = moveFile(source, target, kAccept);
    return !moved && moved.error().text().find("writing failed") != std::string::npos;
  })));
  EXPECT_EQ(readText(source), content);
  EXPECT_THAT(stored(), IsEmpty());
}

TEST_F(ArchiveMove, AFolderThatVanishesBetweenCopyAndCatalogueKeepsTheSource) {
  const auto moved = moveFile(source, target, [&](const std::string&) -> Result<void> {
    fs::remove_all(target);
    return fail("no such folder any more");
  });
  EXPECT_FALSE(moved);
  EXPECT_EQ(readText(source), content);
}

/// Another process spoils a file of the move while it runs. When it comes too late the round is run again.
TEST_F(ArchiveMove, ACopyThatReadsBackDifferentlyKeepsTheSource) {
  std::string said;
  for (int round = 0; round < 100 && said.empty(); ++round) {
    writeText(source, content);
    fs::remove(target + "/a.h5");
    const pid_t storage = inProcess([&]() -> bool {
      for (;;) {
        std::error_code gone;
        for (const auto& item : fs::directory_iterator(target, gone)) {
          std::fstream file(item.path(), std::ios::in | std::ios::out | std::ios::binary);
          file.put('X');
        }
      }
    });
    const auto moved = moveFile(source, target, kAccept);
    kill(storage, SIGKILL);
    waitpid(storage, nullptr, 0);
    if (!moved) said = moved.error().text();
  }
  EXPECT_THAT(said, HasSubstr("reads back differently"));
  EXPECT_EQ(readText(source), content);
  EXPECT_THAT(stored(), IsEmpty());
}

TEST_F(ArchiveMove, ASourceThatGrowsMeanwhileStays) {
  std::string said;
  for (int round = 0; round < 100 && said.empty(); ++round) {
    writeText(source, content);
    fs::remove(target + "/a.h5");
    const pid_t recorder = inProcess([&]() -> bool {
      for (;;) {
        if (!fs::is_empty(target)) std::ofstream(source, std::ios::app | std::ios::binary) << "x";
        usleep(200);
      }
    });
    const auto moved = moveFile(source, target, kAccept);
    kill(recorder, SIGKILL);
    waitpid(recorder, nullptr, 0);
    if (!moved) said = moved.error().text();
  }
  EXPECT_THAT(said, HasSubstr("changed while it was copied"));
  EXPECT_EQ(readText(source).substr(0, content.size()), content);
  EXPECT_THAT(stored(), IsEmpty());
}

TEST_F(ArchiveMove, AMoverKilledAtAnyMomentLosesNothing) {
  for (int round = 0; round < 20; ++round) {
    writeText(source, content);
    fs::remove_all(target);
    fs::create_directory(target);
    const pid_t mover = inProcess([&] { return moveFile(source, target, kAccept).has_value(); });
    usleep(static_cast<useconds_t>(round * 1500));
    kill(mover, SIGKILL);
    waitpid(mover, nullptr, 0);
    const bool here = fs::exists(source) && readText(source) == content;
    const bool there = fs::exists(target + "/a.h5") && readText(target + "/a.h5") == content;
    EXPECT_TRUE(here || there);
    EXPECT_TRUE(!fs::exists(target + "/a.h5") || there) << "never a torn file under the true name";
    if (here) {
      EXPECT_TRUE(moveFile(source, target, kAccept)) << "asking again finishes it";
    }
    EXPECT_EQ(readText(target + "/a.h5"), content);
  }
}

}  // namespace
}  // namespace fyd::catalogue
