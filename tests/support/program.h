// SPDX-License-Identifier: MIT
// Runs the program as users and their scripts do.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

#include "tests/support/support.h"

namespace svoscope::test {

struct Outcome {
  int exit_code = -1;
  std::string out, err;
};

/// Runs the program through the shell, without input. `prefix` goes before it: "timeout 5".
inline Outcome runProgram(const std::string& arguments, const std::string& prefix = "") {
  const TemporaryFolder folder;
  const std::string err = (folder / "err").string();
  const std::string command =
      prefix + " '" + SVOSCOPE_PROGRAM + "' " + arguments + " 2>'" + err + "' </dev/null";
  Outcome outcome;
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return outcome;
  std::array<char, 4096> buffer;
  while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) {
    outcome.out.append(buffer.data(), n);
  }
  const int status = pclose(pipe);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  outcome.err = readText(err);
  return outcome;
}

}  // namespace svoscope::test
