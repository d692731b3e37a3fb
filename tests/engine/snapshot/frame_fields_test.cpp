// SPDX-License-Identifier: MIT
#include "engine/snapshot/frame_fields.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "engine/io/frames_csv.h"
#include "engine/recording/schema.h"
#include "tests/support/fake_world.h"
#include "tests/support/field_count.h"
#include "tests/support/generated_docs.h"

namespace svoscope {
namespace {

std::string joined(const char* const* names, std::size_t count, const char* between) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? between : "") + std::string(names[i]);
  return text;
}

TEST(FrameFields, EveryMemberIsListed) {
  std::set<const void*> members;
  std::size_t listed = 0;
  const FrameRecord record;
  visitFrameFields(record, [&](const FrameField& field, const auto& value) {
    EXPECT_TRUE(members.insert(&value).second) << field.name << " is there twice";
    ++listed;
  });
  constexpr std::size_t kFunnel = test::fieldCount<Funnel>();
  // The funnel and the times are one member each.
  constexpr std::size_t kMembers = test::fieldCount<FrameRecord>() - 2 + kFunnel + kStageCount;
  EXPECT_EQ(kFunnel, 12u);
  EXPECT_EQ(listed, kMembers) << "a member of FrameRecord or Funnel is not in frame_fields.h";
}

TEST(FrameFields, NamesAreUniqueAndDescribed) {
  std::set<std::string> names;
  const FrameRecord record;
  visitFrameFields(record, [&](const FrameField& field, const auto&) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_FALSE(std::string(field.meaning).empty()) << field.name;
  });
}

TEST(FrameFields, NumbersAreThoseThatApply) {
  FrameRecord record;
  record.reprojection_px = 0.5;
  record.seeds = 7;
  const auto number = [&](const char* name) {
    return frameNumbers(record).at(frameFieldIndex(name).value());
  };
  EXPECT_EQ(number("seeds"), 7);
  EXPECT_TRUE(std::isnan(number("reason"))) << "a text";
  EXPECT_TRUE(std::isnan(number("reprojection_px"))) << "of no pose";
  record.pose_good = true;
  EXPECT_EQ(number("reprojection_px"), 0.5);
  EXPECT_EQ(number("pose_good"), 1);
  EXPECT_FALSE(frameFieldIndex("nonsense"));
}

TEST(FrameFields, RecordingsAndFramesCsvHaveTheSameColumns) {
  std::string recorded;
  for (const char c : recordColumns().names)
    if (c != ' ') recorded += c;
  const std::string header = framesCsvHeader();
  EXPECT_EQ(recorded.substr(recorded.find(',')), header.substr(header.find(',')));
  EXPECT_EQ(recorded.substr(0, 6), "frame,");
}

TEST(GeneratedDocs, ColumnsOfFramesCsv) {
  std::string table = "| column | unit | meaning |\n| --- | --- | --- |\n";
  const FrameRecord record;
  visitFrameFields(record, [&](const FrameField& field, const auto&) {
    const std::string name =
        *field.name ? field.name : joined(kPoseColumns, std::size(kPoseColumns), " ");
    table += fmt::format("| `{}` | {} | {} |\n", name, field.unit, field.meaning);
  });
  test::expectGenerated("commands.md", "columns of frames.csv", table);
}

}  // namespace
}  // namespace svoscope
