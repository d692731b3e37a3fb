// SPDX-License-Identifier: MIT
// Files that are not what they should be: clear messages, and never a crash.
#include "engine/recording/recording_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/recorded_run.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// One small recording for all tests of this file.
const test::RecordedRun& sample() {
  static test::RecordedRun run("synthetic:room?frames=24&size=320x240", test::synchronous("svo"));
  static const bool finished = run.finish().ok();
  EXPECT_TRUE(finished);
  return run;
}

struct RecordingFileTest : testing::Test {
  fs::path copy() {
    const fs::path file = folder / "copy.svoscope";
    fs::copy_file(sample().file(), file, fs::copy_options::overwrite_existing);
    return file;
  }
  static bool change(const fs::path& file, const std::string& sql) {
    std::string problem;
    const auto database = Database::open(file, Database::Mode::create, problem);
    return database && database->run(sql);
  }
  static Error errorOf(const fs::path& file) {
    const auto opened = RecordingFile::open(file);
    return opened.ok() ? Error{ErrorKind::internal, "opened", "", ""} : opened.error();
  }
  static void expectInputError(const fs::path& file, const char* text) {
    const Error error = errorOf(file);
    EXPECT_EQ(error.kind, ErrorKind::input);
    EXPECT_THAT(error.message(), HasSubstr(text));
    EXPECT_EQ(error.where, file.string());
    EXPECT_FALSE(error.remedy.empty());
  }
  test::TemporaryFolder folder;
};

TEST_F(RecordingFileTest, KnowsARecordingFromOtherFiles) {
  EXPECT_TRUE(looksLikeRecording(sample().file()));
  fs::copy_file(sample().file(), folder / "renamed.bin");
  EXPECT_TRUE(looksLikeRecording(folder / "renamed.bin"));
  test::writeText(folder / "film.mp4", "no SQLite at all");
  EXPECT_FALSE(looksLikeRecording(folder / "film.mp4"));
  EXPECT_FALSE(looksLikeRecording(folder.path()));
  EXPECT_FALSE(looksLikeRecording("synthetic:room"));
}

TEST_F(RecordingFileTest, ForeignFilesAreNamedAsSuch) {
  test::writeText(folder / "text.svoscope", "this is a text of some length, but not a recording");
  expectInputError(folder / "text.svoscope", "is not a recording: it is no SQLite file");
  test::writeText(folder / "empty.svoscope", "");
  expectInputError(folder / "empty.svoscope", "the file is empty");
  ASSERT_TRUE(change(folder / "other.svoscope", "CREATE TABLE frames (frame INTEGER)"));
  expectInputError(folder / "other.svoscope", "another program's SQLite file");
  expectInputError(folder / "absent.svoscope", "there is no such file");
}

TEST_F(RecordingFileTest, ANewerFormatAsksForANewerProgram) {
  const fs::path file = copy();
  ASSERT_TRUE(change(file, "PRAGMA user_version = 99"));
  expectInputError(file, "written by a newer svoscope (format 99");
}

TEST_F(RecordingFileTest, AnOlderFormatAsksForANewRecording) {
  const fs::path file = copy();
  ASSERT_TRUE(change(file, "PRAGMA user_version = 1"));
  expectInputError(file, "written by an older svoscope (format 1,");
}

TEST_F(RecordingFileTest, ATruncatedFileSaysHowMuchIsLeft) {
  const fs::path file = copy();
  const auto size = fs::file_size(file);
  for (const double part : {0.9, 0.5, 0.05}) {
    fs::resize_file(file, static_cast<std::uintmax_t>(static_cast<double>(size) * part));
    expectInputError(file, "damaged: it ends after");
  }
  fs::resize_file(file, 60);
  expectInputError(file, "damaged: it ends after 60");
}

TEST_F(RecordingFileTest, AMissingTableIsDamage) {
  const fs::path file = copy();
  ASSERT_TRUE(change(file, "DROP TABLE seed_states"));
  expectInputError(file, "the recording is damaged: no such table: seed_states");
}

TEST_F(RecordingFileTest, ARecordingWithoutFramesSaysSo) {
  const fs::path file = copy();
  ASSERT_TRUE(change(file, "DELETE FROM frames"));
  expectInputError(file, "has no frames");
}

TEST_F(RecordingFileTest, DamagedBlobsLeaveTheRow) {
  const fs::path file = copy();
  ASSERT_TRUE(change(
      file,
      "UPDATE seed_states SET data = substr(data, 1, 40) WHERE frame = 20;"
      "UPDATE images SET jpeg = x'ffd8ff00' WHERE frame = 5; DELETE FROM images WHERE frame = 6"));
  auto opened = openRun(file.string(), {});
  ASSERT_TRUE(opened.ok());
  const Runner& runner = *opened.value();
  EXPECT_NE(runner.at(19)->seeds, nullptr);
  const SnapshotPtr damaged = runner.at(20);
  ASSERT_NE(damaged, nullptr);
  EXPECT_EQ(damaged->seeds, nullptr);
  EXPECT_EQ(damaged->record.index, 20);
  const auto events = runner.events(0);
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.back().kind, EventKind::error);
  EXPECT_THAT(events.back().text, HasSubstr("damaged"));
  EXPECT_EQ(runner.at(5)->pyramid, nullptr);
  EXPECT_EQ(runner.at(6)->pyramid, nullptr);
  EXPECT_NE(runner.at(7)->pyramid, nullptr);
}

/// Whatever byte is wrong, a frame is read, or found to be damaged.
TEST_F(RecordingFileTest, WrongBytesNeverCrash) {
  const std::string good = test::readText(sample().file());
  for (int round = 0; round < 40; ++round) {
    std::string bad = good;
    const std::size_t at = 100 + (good.size() - 5000) / 40 * static_cast<std::size_t>(round);
    for (std::size_t i = 0; i < 4000; ++i)
      bad[at + i] = static_cast<char>(bad[at + i] ^ (17 + i * 31 % 200));
    const fs::path file = folder / "bad.svoscope";
    std::ofstream(file, std::ios::binary) << bad;
    auto opened = openRun(file.string(), {});
    if (!opened.ok()) {
      EXPECT_EQ(opened.error().kind, ErrorKind::input);
      continue;
    }
    Runner& runner = *opened.value();
    runner.send({Command::Kind::run_to_frame, 1000, "", ""});
    for (const FrameRecord& record : runner.records(0)) ASSERT_NE(runner.at(record.index), nullptr);
  }
}

}  // namespace
}  // namespace svoscope
