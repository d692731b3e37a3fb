// SPDX-License-Identifier: MIT
// Tables of the documentation that follow from lists in the code. A test holds the page to the
// list; with SVOSCOPE_WRITE_DOCS in the environment it writes the table into the page instead.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/support.h"

namespace svoscope::test {

/// The part of docs/`page` between the comments "generated: `name`" and "end of `name`" is `text`.
inline void expectGenerated(const std::string& page, const std::string& name,
                            const std::string& text) {
  const auto file = std::filesystem::path(SVOSCOPE_SOURCE_DIR) / "docs" / page;
  const std::string all = readText(file);
  const std::string begin = "<!-- generated: " + name + " -->\n", end = "<!-- end of " + name;
  const auto from = all.find(begin), to = all.find(end);
  ASSERT_NE(from, std::string::npos) << page << " lacks: " << begin;
  ASSERT_NE(to, std::string::npos) << page << " lacks: " << end;
  const auto first = from + begin.size();
  if (std::getenv("SVOSCOPE_WRITE_DOCS")) {
    writeText(file, all.substr(0, first) + text + all.substr(to));
    return;
  }
  EXPECT_EQ(all.substr(first, to - first), text)
      << "docs/" << page
      << " is not what the code says: SVOSCOPE_WRITE_DOCS=1 ./run test -R GeneratedDocs";
}

}  // namespace svoscope::test
