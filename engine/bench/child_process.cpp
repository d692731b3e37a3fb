// SPDX-License-Identifier: MIT
#include "engine/bench/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

namespace svoscope {

namespace {

double nowSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// In the child between fork and exec: only what is safe there.
[[noreturn]] void become(char* const* argv, int log, int null, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // it died before the line above
  dup2(null, STDIN_FILENO);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  execv(argv[0], argv);
  _exit(127);
}

}  // namespace

ChildProcess::ChildProcess(pid_t pid) : pid_(pid), started_s_(nowSeconds()) {}

Result<ChildProcess> ChildProcess::start(const std::vector<std::string>& argv,
                                         const std::filesystem::path& log) {
  std::vector<char*> pointers;
  for (const std::string& argument : argv) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (out < 0)
    return outputError(std::string("cannot be written: ") + std::strerror(errno), log.string(), "");
  const int null = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) become(pointers.data(), out, null, parent);
  const int reason = errno;
  close(out);
  if (null >= 0) close(null);
  if (pid < 0)
    return Error{ErrorKind::internal, std::strerror(reason), argv[0],
                 "no further process can be started"};
  setpgid(pid, pid);  // also here: whoever comes first
  return ChildProcess(pid);
}

std::optional<ChildEnd> ChildProcess::poll() {
  int status = 0;
  const pid_t ended = waitpid(pid_, &status, WNOHANG);
  if (ended != pid_) return std::nullopt;
  if (WIFSIGNALED(status)) return ChildEnd{128 + WTERMSIG(status), WTERMSIG(status)};
  return ChildEnd{WEXITSTATUS(status), 0};
}

void ChildProcess::signal(int number) const { kill(-pid_, number); }

double ChildProcess::seconds() const { return nowSeconds() - started_s_; }

}  // namespace svoscope
