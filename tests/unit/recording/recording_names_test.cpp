// The names of a recording's files: while it grows, when it is whole, and its notes beside it.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "core/recording/file/recording_place.h"
#include "core/recording/reader/review_notes.h"
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

TEST(RecordingNames, NotesAreWrittenBesideARecordingThatIsThereOnly) {
  const Folder folder;
  samples::write(folder.file("a.h5.partial"), "recorded");
  ReviewNotes review;
  review.notes.push_back({.time_s = 1.0, .text = "soft"});
  for (const char* name : {"a.h5", "a.h5.partial"}) EXPECT_TRUE(writeReviewNotes(folder.file(name), review)) << name;
  EXPECT_EQ(readReviewNotes(folder.file("a.h5"))->notes.size(), 1U);
  const auto written = writeReviewNotes(folder.file("gone.h5"), review);
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().text(),
            folder.file("gone.h5") + ": no longer there, moved or deleted: notes would stand beside nothing");
  EXPECT_FALSE(std::filesystem::exists(folder.file("gone.h5.notes.json")));
}

}  // namespace
}  // namespace fyd::recording
