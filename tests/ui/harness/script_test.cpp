// SPDX-License-Identifier: MIT
#include "ui/harness/script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <thread>

#include "tests/support/support.h"

namespace svoscope::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Script, ReadsCommandsWordsQuotesAndComments) {
  const Result<Script> script = parseScript(
      "# a demo\n"
      "open synthetic:room   # the sequence\n"
      "\n"
      "step 12\n"
      "  click \"Run to keyframe\"\n"
      "click Play#2\n",
      "demo.script");
  ASSERT_TRUE(script.ok()) << script.error().message();
  const auto& commands = script.value().commands;
  ASSERT_EQ(commands.size(), 4u);
  EXPECT_EQ(script.value().sequence(), "synthetic:room");
  EXPECT_EQ(commands[1].name, "step");
  EXPECT_EQ(commands[1].line, 4);
  EXPECT_THAT(commands[1].arguments, ElementsAre("12"));
  EXPECT_THAT(commands[2].arguments, ElementsAre("Run to keyframe"));
  EXPECT_THAT(commands[3].arguments, ElementsAre("Play#2"));
}

std::string errorOf(const std::string& text) {
  const Result<Script> script = parseScript(text, "demo.script");
  return script ? "" : script.error().message();
}

TEST(Script, ErrorsNameTheLineAndWhatIsKnown) {
  EXPECT_THAT(errorOf("step\nstpe 3\n"), HasSubstr("demo.script:2"));
  EXPECT_THAT(errorOf("stpe 3\n"), HasSubstr("unknown command 'stpe'"));
  EXPECT_THAT(errorOf("stpe 3\n"), HasSubstr("run-to"));
  EXPECT_THAT(errorOf("drag Slider 3\n"), HasSubstr("drag LABEL DX DY"));
  EXPECT_THAT(errorOf("click \"Play\n"), HasSubstr("quote"));
  EXPECT_THAT(errorOf("step\nopen x\n"), HasSubstr("first command"));
}

TEST(Script, HelpListsEveryCommand) {
  for (const char* name : {"open", "step", "run-to", "select", "shot", "expect", "drag"})
    EXPECT_THAT(scriptHelp(), HasSubstr(name));
}

TEST(Script, PicturesArePng) {
  EXPECT_THAT(errorOf("step\nshot a.jpg\n"),
              HasSubstr("demo.script:2: 'a.jpg' does not end in .png"));
  EXPECT_EQ(errorOf("shot a\nshot sub/a.png Image\n"), "");
}

TEST(Script, AFolderIsNoScript) {
  const test::TemporaryFolder folder;
  const Result<Script> script = readScript(folder.path());
  ASSERT_FALSE(script.ok());
  EXPECT_EQ(script.error().kind, ErrorKind::input);
  EXPECT_THAT(script.error().message(), HasSubstr("folder"));
}

TEST(Script, APipeIsReadAndNamedInMessages) {
  const test::TemporaryFolder folder;
  const std::string pipe = (folder / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { test::writeText(pipe, "step\nstpe\n"); });
  const Result<Script> script = readScript(pipe);
  writer.join();
  ASSERT_FALSE(script.ok());
  EXPECT_THAT(script.error().message(), HasSubstr(pipe + ":2"));
}

TEST(Script, AnUnreadableFileIsAnInputError) {
  const Result<Script> script = readScript("/nowhere/x.script");
  ASSERT_FALSE(script.ok());
  EXPECT_EQ(script.error().kind, ErrorKind::input);
}

}  // namespace
}  // namespace svoscope::ui
