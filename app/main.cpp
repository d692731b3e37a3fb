// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>

#include "app/cli.h"

namespace {

/// The build uses AVX2 and FMA by default; an older processor would only say "illegal instruction".
bool processorIsNewEnough() {
#if defined(__AVX2__) && defined(__FMA__)
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return true;
#endif
}

}  // namespace

int main(int argc, char** argv) {
  if (!processorIsNewEnough()) {
    std::fputs(
        "svoscope: error: this processor has no AVX2 and FMA "
        "(configure with -DSVOSCOPE_MARCH= to build without them)\n",
        stderr);
    return 1;
  }
  try {
    return svoscope::runCommandLine({argv + 1, argv + argc});
  } catch (const std::exception& e) {
    std::fprintf(stderr, "svoscope: internal error: %s\n", e.what());
  } catch (...) {
    std::fputs("svoscope: internal error\n", stderr);
  }
  return 1;
}
