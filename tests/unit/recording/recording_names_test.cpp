// The names of a recording's files: while it grows, when it is whole, and its notes beside it.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "core/recording/file/recording_place.h"
#include "recording_damage.h"
#include "tests/temporary_folder.h"

namespace fyd::recording {
namespace {

TEST(RecordingNames, OfAPartialOneIsTheNameThatItWillHave) {
  EXPECT_EQ(partialOf("a/b.h5"), "a/b.h5.partial");
  EXPECT_EQ(wholeOf("a/b.h5.partial"), "a/b.h5");
  EXPECT_EQ(wholeOf("a/b.h5"), "a/b.h5");
  EXPECT_EQ(wholeOf("a/b.partial.h5"), "a/b.partial.h5");
}

TEST(RecordingNames, NotesStayWithARecordingThatGetsItsName) {
  const Folder folder;
  const std::string notes = folder.file("a.h5.notes.json");
  const std::string former = folder.file("a.h5.partial.notes.json");
  for (const std::string& recording : {folder.file("a.h5"), folder.file("a.h5.partial")})
    EXPECT_EQ(reviewNotesPath(recording), notes) << "where they would stand";
  samples::write(former, "{}");
  for (const std::string& recording : {folder.file("a.h5"), folder.file("a.h5.partial")})
    EXPECT_EQ(reviewNotesPath(recording), former) << "an earlier version's, alone";
  samples::write(notes, "{}");
  for (const std::string& recording : {folder.file("a.h5"), folder.file("a.h5.partial")})
    EXPECT_EQ(reviewNotesPath(recording), notes) << "before an earlier version's";
}

TEST(RecordingNames, NotesOfALinkAreThoseOfItsFile) {
  const Folder folder;
  const std::filesystem::path root = std::filesystem::canonical(folder.file("."));
  const std::string notes = root / "b.h5.notes.json";
  const std::string beside = folder.file("a.h5.notes.json");
  samples::write(folder.file("b.h5"), "x");
  std::filesystem::create_symlink("b.h5", folder.file("a.h5"));
  EXPECT_EQ(reviewNotesPath(folder.file("a.h5")), notes);
  samples::write(beside, "{}");
  EXPECT_EQ(reviewNotesPath(folder.file("a.h5")), beside) << "an earlier version's, alone";
  samples::write(notes, "{}");
  EXPECT_EQ(reviewNotesPath(folder.file("a.h5")), notes);
  EXPECT_EQ(reviewNotesPath(folder.file("b.h5")), folder.file("b.h5.notes.json")) << "a plain name stays as it is";

  std::filesystem::rename(folder.file("b.h5"), folder.file("b.h5.partial"));
  std::filesystem::remove(folder.file("a.h5"));
  std::filesystem::create_symlink("b.h5.partial", folder.file("c.h5.partial"));
  EXPECT_EQ(reviewNotesPath(folder.file("c.h5")), notes) << "of one that grows";
  std::filesystem::create_symlink("nothing", folder.file("d.h5"));
  EXPECT_EQ(reviewNotesPath(folder.file("d.h5")), folder.file("d.h5.notes.json"));
}

}  // namespace
}  // namespace fyd::recording
