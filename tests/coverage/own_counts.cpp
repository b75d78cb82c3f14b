// Linked into whatever is counted: each process leaves its counts in a folder of its own, which coverage.py adds up; what
// it forks, without another program, shares that.
// GCC adds them to one file for all of them. But where another program's linker took an inline function from another unit,
// and where a process was killed while it wrote, those of the whole unit are lost from then on, with a complaint on the
// standard error of every later program.
#include <errno.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace {

[[gnu::constructor]] void keepCountsApart() {
  const std::string folder = std::string(FYD_COUNTS) + "/" + program_invocation_short_name;
  ::setenv("GCOV_PREFIX", (folder + "/" + std::to_string(::getpid())).c_str(), 1);
}

}  // namespace
