// A PostgreSQL server for the test, in a temporary folder, reachable by a Unix socket only. PostgreSQL refuses
// to run as root; then the server runs as the user `postgres`. It ends with the test, also when the test is killed.
#pragma once

#include <fcntl.h>
#include <grp.h>
#include <pwd.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace fyd::catalogue {

class PostgresServer {
 public:
  PostgresServer() {
    std::string name = "/tmp/fyd-postgres-XXXXXX";  // a socket's path may have 107 characters
    folder_ = mkdtemp(name.data());
    if (geteuid() == 0) {
      user_ = getpwnam("postgres");
      if (!user_ || chown(folder_.c_str(), user_->pw_uid, user_->pw_gid) != 0) return;
    }
    made_ = !binaries().empty() &&
            wait(run({"initdb", "--pgdata=" + data(), "--auth=trust", "--username=fyd", "--encoding=UTF8",
                      "--locale=C.UTF-8", "--no-sync", "--no-instructions"})) == 0;
  }
  PostgresServer(const PostgresServer&) = delete;
  PostgresServer& operator=(const PostgresServer&) = delete;
  ~PostgresServer() {
    stop(SIGQUIT);
    std::filesystem::remove_all(folder_);
  }

  /// The folder of the newest version's programs; empty when PostgreSQL is not installed.
  static std::string binaries() {
    std::vector<std::string> found;
    std::error_code error;
    for (const auto& version : std::filesystem::directory_iterator("/usr/lib/postgresql", error)) {
      if (std::filesystem::exists(version.path() / "bin/initdb")) found.push_back(version.path() / "bin");
    }
    return found.empty() ? "" : *std::ranges::max_element(found);
  }

  [[nodiscard]] bool start() {
    if (!made_) return false;
    server_ = run({"postgres", "-D", data(), "-k", folder_, "-c", "listen_addresses=", "-c", "fsync=off"});
    for (int attempt = 0; attempt < 600; ++attempt) {
      if (wait(run({"pg_isready", "--quiet", "--host=" + folder_})) == 0) return true;
      usleep(50'000);
    }
    return false;
  }
  /// SIGQUIT: at once, as `pg_ctl stop -m immediate`; SIGINT: cleanly.
  void stop(int signal) {
    if (server_ <= 0) return;
    kill(server_, signal);
    wait(server_);
    server_ = -1;
  }
  /// Makes an empty database.
  [[nodiscard]] bool makeDatabase(const std::string& name) {
    return wait(run({"createdb", "--host=" + folder_, "--username=fyd", name})) == 0;
  }
  [[nodiscard]] std::string word(const std::string& database) const {
    return "postgresql:host=" + folder_ + " user=fyd dbname=" + database;
  }
  [[nodiscard]] std::string log() const { return folder_ + "/log"; }

 private:
  [[nodiscard]] std::string data() const { return folder_ + "/data"; }

  [[nodiscard]] pid_t run(const std::vector<std::string>& words) const {
    const std::string program = binaries() + "/" + words.front();
    std::vector<char*> arguments;
    arguments.reserve(words.size());
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    if (user_ && (setgroups(0, nullptr) != 0 || setgid(user_->pw_gid) != 0 || setuid(user_->pw_uid) != 0)) _exit(126);
    prctl(PR_SET_PDEATHSIG, SIGQUIT);
    const int output = open(log().c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    if (chdir(folder_.c_str()) != 0) _exit(125);
    execv(program.c_str(), arguments.data());
    _exit(127);
  }
  static int wait(pid_t child) {
    int status = -1;
    waitpid(child, &status, 0);
    return status;
  }

  std::string folder_;
  passwd* user_ = nullptr;
  bool made_ = false;
  pid_t server_ = -1;
};

}  // namespace fyd::catalogue
