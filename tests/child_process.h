// A process of a test's own, which never outlives it.
#pragma once

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace fyd {

/// In a child: it ends with `parent`, however that ends. To be asked for again after a change of user, with which the
/// kernel forgets it.
inline void endWithParent(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it ended before it could be asked for
}

/// Runs something in a child process. The child ends with this object, and with this process however that ends.
class ChildProcess {
 public:
  /// @param work returns the child's exit code, or never
  template <class Work>
  explicit ChildProcess(Work work) {
    const pid_t parent = ::getpid();
    id_ = ::fork();
    if (id_ != 0) return;
    endWithParent(parent);  // PR_SET_PDEATHSIG
    ::_exit(work());
  }
  ~ChildProcess() { (void)kill(); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  [[nodiscard]] pid_t id() const { return id_; }

  /// Waits for its end. @return its status, as waitpid() gives it; -1: there is none (any more)
  [[nodiscard]] int wait() {
    int status = -1;
    if (id_ > 0 && ::waitpid(id_, &status, 0) != id_) status = -1;
    id_ = -1;
    return status;
  }
  /// Ends it at once. @return as wait()
  int kill() {
    if (id_ > 0) ::kill(id_, SIGKILL);
    return wait();
  }

 private:
  pid_t id_ = -1;
};

}  // namespace fyd
