// Signals that end a program: its loop reads them as a number; only a later one ends the process at once.
#include "core/base/end_signals.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <thread>

#include "core/base/whole_file.h"
#include "tests/temporary_folder.h"

namespace fyd {
namespace {

/// Runs `work` in a process of its own. @return its id; `work` has begun to wait when `told` can be read
struct Child {
  explicit Child(const std::function<int(int tell)>& work) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return;
    id = ::fork();
    if (id == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // also after a test that failed
      ::close(ends[0]);
      ::_exit(work(ends[1]));
    }
    ::close(ends[1]);
    told = ends[0];
  }
  ~Child() {
    ::kill(id, SIGKILL);
    ::close(told);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// What it says next; -1: it has ended
  [[nodiscard]] int next() const {
    unsigned char byte = 0;
    return ::read(told, &byte, 1) == 1 ? byte : -1;
  }
  [[nodiscard]] int status() const {
    int status = 0;
    ::waitpid(id, &status, 0);
    return status;
  }

  pid_t id = -1;
  int told = -1;
};

void tell(int to, int value) {
  const auto byte = static_cast<unsigned char>(value);
  (void)!::write(to, &byte, 1);
}

/// Tells 0 when it watches, then each signal it is asked about, and never ends by itself.
int stubborn(int to) {
  watchForEnd();
  tell(to, 0);
  pollfd asked{.fd = endSignalDescriptor(), .events = POLLIN, .revents = 0};
  while (::poll(&asked, 1, -1) != 1) {
  }
  tell(to, endSignal());
  for (;;) ::pause();
}

TEST(EndSignals, TheFirstReachesTheLoopAndALaterOneEndsTheProgram) {
  const Child child(stubborn);
  ASSERT_EQ(child.next(), 0);
  ::kill(child.id, SIGTERM);
  EXPECT_EQ(child.next(), SIGTERM);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  ::kill(child.id, SIGHUP);  // never is the last word
  ::kill(child.id, SIGINT);
  const int status = child.status();
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGINT);
}

TEST(EndSignals, SeveralAtOnceAreOneWish) {
  const Child child([](int to) {
    watchForEnd();
    for (const int signal : {SIGHUP, SIGTERM, SIGHUP, SIGINT, SIGTERM}) ::raise(signal);
    tell(to, endSignal());
    return 0;
  });
  EXPECT_EQ(child.next(), SIGHUP);
  EXPECT_EQ(child.status(), 0);
}

TEST(EndSignals, EndAReadingOfAPipeThatNobodyWrites) {
  const Folder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const Child child([&](int to) {
    watchForEnd();
    tell(to, 0);
    const auto read = readWholeFile(pipe, 100, FileKind::pipe_too);
    tell(to, !read && read.error().text() == pipe + ": not read to its end: the program was asked to end" ? 1 : 2);
    return 0;
  });
  ASSERT_EQ(child.next(), 0);
  ::kill(child.id, SIGTERM);
  EXPECT_EQ(child.next(), 1);
  EXPECT_EQ(child.status(), 0);
}

TEST(EndSignals, AnIgnoredHangUpStaysIgnored) {
  const Child child([](int to) {
    ::signal(SIGHUP, SIG_IGN);
    watchForEnd();
    ::raise(SIGHUP);
    tell(to, endSignal());
    return 0;
  });
  EXPECT_EQ(child.next(), 0);
}

TEST(EndSignals, FailedWritesAreErrors) {
  const Child child([](int to) {
    makeFailedWritesErrors();
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return 1;
    ::close(ends[0]);
    tell(to, ::write(ends[1], "x", 1) < 0 ? errno : 0);
    const rlimit limit{.rlim_cur = 1, .rlim_max = 1};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::FILE* file = std::tmpfile();
    const int number = ::fileno(file);
    (void)!::write(number, "xy", 2);
    tell(to, ::write(number, "z", 1) < 0 ? errno : 0);
    return 0;
  });
  EXPECT_EQ(child.next(), EPIPE);
  EXPECT_EQ(child.next(), EFBIG);
}

TEST(EndSignals, ClosedStandardDescriptorsLendTheirNumbersToNothing) {
  const Child child([](int to) {
    for (const int each : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::close(each);
    makeFailedWritesErrors();
    tell(to, ::open("/dev/null", O_WRONLY) > STDERR_FILENO ? 1 : 0);
    tell(to, ::write(STDOUT_FILENO, "x", 1) < 0 ? errno : 0);
    tell(to, ::write(STDERR_FILENO, "x", 1) < 0 ? errno : 0);
    return 0;
  });
  EXPECT_EQ(child.next(), 1);
  EXPECT_EQ(child.next(), EBADF);
  EXPECT_EQ(child.next(), EBADF);
}

}  // namespace
}  // namespace fyd
