// Part files of exports: those of killed programs are removed, those of running ones and other files stay.
#include "core/recording/file/export_part.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "core/recording/file/export_file.h"
#include "tests/no_free_file.h"
#include "tests/unit/recording/recording_samples.h"
#include "tests/unit/recording/refusal.h"

namespace fyd::recording {
namespace {

namespace fs = std::filesystem;

/// A process in the midst of an export. @return its id; its part file exists
pid_t exportForEver(const std::string& path) {
  std::array<int, 2> ready{};
  if (::pipe(ready.data()) != 0) return -1;
  const pid_t child = ::fork();
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // also after a test that failed
    auto file = ExportFile::create(path, false);
    const bool good = file && file->write("half of it");
    (void)!::write(ready[1], good ? "y" : "n", 1);
    for (;;) ::pause();
  }
  char said = 'n';
  (void)!::read(ready[0], &said, 1);
  ::close(ready[0]);
  ::close(ready[1]);
  return said == 'y' ? child : -1;
}

TEST(ExportPart, HasTheUsersRightsAndLeavesThemToOthers) {
  const samples::Folder folder;
  const mode_t before = ::umask(027);
  std::atomic<int> wrong{0};
  {
    std::vector<std::jthread> exports;
    exports.reserve(4);
    for (int thread = 0; thread < 4; ++thread) {
      exports.emplace_back([&, thread] {
        for (int i = 0; i < 200; ++i) {
          const std::string path = folder.file("export " + std::to_string(thread) + ".csv");
          auto file = ExportFile::create(path, true);
          struct stat info {};
          if (!file || !file->commit() || ::stat(path.c_str(), &info) != 0 || (info.st_mode & 0777) != 0640) ++wrong;
        }
      });
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(::umask(before), mode_t{027});
}

TEST(ExportPart, WithoutAFileToReadTheUmaskFromIsItsUsersAlone) {
  const samples::Folder folder;
  const mode_t before = ::umask(0);
  const int of_the_part = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const auto part = [&] {
    const NoFreeFile no_other;
    ::close(of_the_part);
    return makeExportPart(folder.file("a.csv"));
  }();
  ::umask(before);
  ASSERT_TRUE(part) << part.error().text();
  struct stat info {};
  EXPECT_EQ(::fstat(part->lock, &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0600U);
  ::close(part->lock);
}

TEST(ExportPart, OfAKilledProgramGoesWithTheNextExportAndOneOfALivingProgramStays) {
  const samples::Folder folder;
  const pid_t child = exportForEver(folder.file("long.csv"));
  ASSERT_GT(child, 0);
  {
    auto other = ExportFile::create(folder.file("other.csv"), false);
    ASSERT_TRUE(other && other->write("whole") && other->commit());
  }
  const std::vector<std::string> meanwhile = namesIn(folder.path());
  ASSERT_EQ(meanwhile.size(), 2U);
  EXPECT_TRUE(isExportPart(meanwhile[0])) << meanwhile[0];
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(namesIn(folder.path()), meanwhile);
  auto next = ExportFile::create(folder.file("next.csv"), false);
  ASSERT_TRUE(next && next->write("whole") && next->commit());
  EXPECT_EQ(namesIn(folder.path()), (std::vector<std::string>{"next.csv", "other.csv"}));
}

TEST(ExportPart, NothingElseIsRemoved) {
  const samples::Folder folder;
  const std::vector<std::string> strangers = {".a.fyd-part-12345.csv",
                                              ".a.fyd-part-1234567.csv",
                                              ".a.fyd-part-12345_.csv",
                                              "a.fyd-part-123456.csv",
                                              ".a.part-123456.csv",
                                              ".a.fyd-part-123456.csv.gz",
                                              ".a.fyd-part-123456~",
                                              "fyd-part-123456.csv",
                                              ".fyd-part-123456.csv",
                                              "a.csv",
                                              ".a.csv"};
  for (const std::string& name : strangers) std::ofstream(folder.file(name)) << "mine";
  fs::create_directory(folder.file(".folder.fyd-part-123456.csv"));
  fs::create_symlink(folder.file("a.csv"), folder.file(".link.fyd-part-123456.csv"));
  fs::create_hard_link(folder.file("a.csv"), folder.file(".hard.fyd-part-123456.csv"));
  ASSERT_EQ(::mkfifo(folder.file(".pipe.fyd-part-123456.csv").c_str(), 0600), 0);
  const std::vector<std::string> before = namesIn(folder.path());
  EXPECT_EQ(removeExportLeftovers(folder.path()), 0U);
  EXPECT_EQ(namesIn(folder.path()), before);
  for (const char* left :
       {".a.fyd-part-a1B2c3.csv", ".a.b.fyd-part-a1B2c3", ".a.fyd-part-aaaaaa.fyd-part-a1B2c3.mat"}) {
    std::ofstream(folder.file(left)) << "half";
    EXPECT_EQ(removeExportLeftovers(folder.path()), 1U) << left;
  }
  EXPECT_EQ(namesIn(folder.path()), before);
  EXPECT_EQ(removeExportLeftovers(folder.file("nothing here")), 0U);
}

TEST(ExportPart, OfTwoExportsAtOnceInOneProgramBothStay) {
  const samples::Folder folder;
  auto first = ExportFile::create(folder.file("first.csv"), false);
  auto second = ExportFile::create(folder.file("second.csv"), false);
  ASSERT_TRUE(first && second && first->write("1") && second->write("2"));
  EXPECT_TRUE(first->commit() && second->commit());
  EXPECT_EQ(namesIn(folder.path()), (std::vector<std::string>{"first.csv", "second.csv"}));
}

}  // namespace
}  // namespace fyd::recording
