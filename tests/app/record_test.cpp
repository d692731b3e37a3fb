// SPDX-License-Identifier: MIT
// svoscope run --record and opening what it wrote, as users do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "engine/recording/open_run.h"
#include "engine/recording/recording_file.h"
#include "tests/support/program.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::runProgram;
using testing::HasSubstr;

struct RecordTest : testing::Test {
  test::TemporaryFolder folder;
  std::string path(const std::string& name) const { return (folder / name).string(); }
  Outcome record(const std::string& options, const std::string& prefix = "") {
    return runProgram(
        "run 'synthetic:room?size=320x240' --record --out " + path("out") + " " + options, prefix);
  }
  fs::path recording() const { return folder / "out" / "run.svoscope"; }
};

TEST_F(RecordTest, WritesOneFileAndChangesNothingElse) {
  ASSERT_EQ(record("--sync --max-frames 40 --method it-svo").exit_code, 0);
  EXPECT_FALSE(fs::exists(recording().string() + "-wal"));
  auto opened = RecordingFile::open(recording());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  EXPECT_EQ(opened.value()->frames().size(), 40u);
  EXPECT_TRUE(opened.value()->run().complete);
  EXPECT_FALSE(opened.value()->run().version.empty());
  ASSERT_EQ(
      runProgram("run 'synthetic:room?size=320x240' --sync --max-frames 40 --method it-svo --out " +
                 path("plain"))
          .exit_code,
      0);
  for (const char* name : {"trajectory.txt", "keyframes.txt", "map.ply"}) {
    EXPECT_EQ(test::readText(folder / "out" / name), test::readText(folder / "plain" / name))
        << name;
  }
}

TEST_F(RecordTest, AKilledRunKeepsWhatWasCommitted) {
  // Killed without a chance to clean up, once its log has grown.
  const std::string log = recording().string() + "-wal";
  const Outcome killed = record("& pid=$!; for i in $(seq 1200); do test \"$(stat -c %s " + log +
                                " 2>/dev/null || echo 0)\" -gt 900000 && break; sleep 0.05; done; "
                                "kill -9 $pid; wait $pid; exit $?; true");
  EXPECT_EQ(killed.exit_code, 137) << killed.err;
  ASSERT_TRUE(fs::exists(log));
  auto opened = RecordingFile::open(recording());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  RecordingFile& file = *opened.value();
  EXPECT_FALSE(file.run().complete);
  ASSERT_GT(file.frames().size(), 8u);
  const auto runner = openRun(recording().string(), {});
  ASSERT_TRUE(runner.ok());
  runner.value()->send({Command::Kind::run_to_frame, 100000, "", ""});
  EXPECT_THAT(runner.value()->events(0).back().text, HasSubstr("was not closed"));
  for (std::size_t i = 0; i < file.frames().size(); ++i) {
    EXPECT_EQ(file.frames()[i].record.index, static_cast<int>(i));
    const auto frame = file.values(i);
    ASSERT_TRUE(frame.ok()) << frame.error().message();
    EXPECT_NE(file.pyramid(static_cast<int>(i)), nullptr);
  }
}

TEST_F(RecordTest, AFolderThatCannotBeWrittenIsAnOutputError) {
  fs::create_directories(recording());  // in the way
  test::writeText(recording() / "keep", "");
  const Outcome outcome = record("--sync --max-frames 3");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("recording cannot be written"));
  EXPECT_TRUE(fs::exists(recording() / "keep"));
}

TEST_F(RecordTest, AFullDiskEndsTheRecordingNotTheRun) {
  // A file may not grow beyond 1 MB: as if the disk were full.
  const Outcome outcome = record("--sync --max-frames 60", "trap '' XFSZ; ulimit -f 2000;");
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("run.svoscope: the recording cannot be written"));
  EXPECT_TRUE(fs::exists(folder / "out" / "metrics.json"));
}

TEST_F(RecordTest, ARecordingIsOpenedInPlaceOfASequence) {
  ASSERT_EQ(record("--sync --max-frames 30").exit_code, 0);
  test::writeText(folder / "look.script",
                  "run-to 25\nexpect frame == 25\nexpect landmarks > 10\nlayout Seeds\n"
                  "select seed any\nwait 3\nexpect seed.held > 0\nshot seeds.png\n");
  const Outcome shot = runProgram("shot " + recording().string() + " --script " +
                                  path("look.script") + " --out " + path("shots"));
  EXPECT_EQ(shot.exit_code, 0) << shot.err;
  EXPECT_TRUE(fs::exists(folder / "shots" / "seeds.png"));
  const Outcome method = runProgram("shot " + recording().string() + " --method svo --script " +
                                    path("look.script") + " --out " + path("shots"));
  EXPECT_EQ(method.exit_code, 2);
  EXPECT_THAT(method.err, HasSubstr("brings its own method"));
  EXPECT_EQ(runProgram("run " + recording().string() + " --out " + path("again")).exit_code, 2);
  fs::resize_file(recording(), fs::file_size(recording()) / 2);
  const Outcome damaged =
      runProgram("view --headless " + recording().string() + " --out " + path("shots"));
  EXPECT_EQ(damaged.exit_code, 3);
  EXPECT_THAT(damaged.err, HasSubstr("damaged"));
}

}  // namespace
}  // namespace svoscope
