// Reasons of failed system calls: the system's own English text, so that it can be looked up.
#include "core/base/system_reason.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace fyd {
namespace {

TEST(SystemReason, IsWhatTheSystemSays) {
  for (int error = 1; error < 134; ++error) {
    const std::string said = std::strerror(error);  // its own copy: the next call may free the text of an unknown number
    EXPECT_EQ(systemReason(error).text(), said) << error;
  }
  EXPECT_EQ(systemReason(std::make_error_code(std::errc::no_such_file_or_directory)).text(), std::strerror(ENOENT));
}

TEST(SystemReason, WhatPeopleMeetIsAPhraseThatCanBeTranslated) {
  for (const int error : {ENOENT, EACCES, ENOSPC, EROFS, EIO, EBUSY, EADDRINUSE, ECONNREFUSED, EMFILE}) {
    EXPECT_TRUE(systemReason(error).values.empty()) << std::strerror(error);
  }
}

}  // namespace
}  // namespace fyd
