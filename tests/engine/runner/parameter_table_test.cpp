// SPDX-License-Identifier: MIT
// The table of parameters against the structs, the documentation and what a run does.
#include "engine/runner/parameter_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "engine/io/frames_csv.h"
#include "engine/runner/make_runner.h"
#include "tests/support/field_count.h"
#include "tests/support/generated_docs.h"
#include "tests/support/memory_sequence.h"

namespace svoscope {
namespace {

/// Fields of the struct that have a row or a reason to have none, without those of structs inside.
template <typename S, typename... Inner>
void expectCovered(const Parameters& p, const char* name, const S& part, const Inner&... inner) {
  const auto within = [](const auto& whole, const void* field) {
    const char* at = static_cast<const char*>(field);
    const char* begin = reinterpret_cast<const char*>(&whole);
    return at >= begin && at < begin + sizeof(whole);
  };
  std::set<const void*> known;
  const auto note = [&](const void* field) {
    if (within(part, field) && !(within(inner, field) || ...)) known.insert(field);
  };
  visitParameters(p, [&](const ParameterInfo&, const auto& field) { note(&field); });
  visitFixed(p, [&](const char*, const auto& field) { note(&field); });
  EXPECT_EQ(known.size() + sizeof...(inner), test::fieldCount<S>())
      << "a field of " << name << " is neither in visitParameters nor in visitFixed";
}

TEST(ParameterTable, EveryFieldHasARowOrAReason) {
  const Parameters p;
  const TrackerParameters& t = p.tracker;
  const MappingParameters& m = t.mapping;
  expectCovered(p, "TrackerParameters", t, t.start, t.alignment, t.reproject, t.pose, t.keyframe,
                t.quality, t.relocalize, t.mapping);
  expectCovered(p, "InitializerParameters", t.start, t.start.klt);
  expectCovered(p, "KltParameters", t.start.klt);
  expectCovered(p, "SparseAlignmentParameters", t.alignment);
  expectCovered(p, "ReprojectorParameters", t.reproject);
  expectCovered(p, "PoseRefinementParameters", t.pose);
  expectCovered(p, "KeyframeParameters", t.keyframe);
  expectCovered(p, "QualityParameters", t.quality);
  expectCovered(p, "RelocalizerParameters", t.relocalize);
  expectCovered(p, "MappingParameters", m, m.detector, m.search, m.alignment, m.filter, m.segments,
                m.local_ba);
  expectCovered(p, "DetectorParameters", m.detector);
  expectCovered(p, "EpipolarParameters", m.search);
  expectCovered(p, "FeatureAlignmentParameters", m.alignment);
  expectCovered(p, "DepthFilterParameters", m.filter, m.filter.rules);
  expectCovered(p, "RuleSettings", m.filter.rules, m.filter.rules.js);
  expectCovered(p, "JsSwitches", m.filter.rules.js);
  expectCovered(p, "SegmentParameters", m.segments, m.segments.detector);
  expectCovered(p, "SegmentDetectorParameters", m.segments.detector);
  expectCovered(p, "LocalAdjustmentParameters", m.local_ba);
}

std::string tableRow(const ParameterView& v) {
  const bool flag = v.type == "bool";
  const std::string value =
      flag ? v.default_value : fmt::format("{:.6g}", std::stod(v.default_value));
  const std::string bounds = flag ? "" : fmt::format("{:g} to {:g}", v.minimum, v.maximum);
  return fmt::format("| `{}` | {} | {} | {} | {} |\n", v.key, value, v.unit, bounds, v.meaning);
}

TEST(GeneratedDocs, TablesOfParameters) {
  std::map<std::string, std::string> tables;
  std::string alone;  // a key without a group stands before the rows of the next one
  for (const ParameterView& view : listParameters({})) {
    const auto dot = view.key.find('.');
    if (dot == std::string::npos) {
      alone += tableRow(view);
      continue;
    }
    std::string& table = tables[view.key.substr(0, dot)];
    if (table.empty())
      table = "| key | default | unit | bounds | meaning |\n| --- | ---: | --- | --- | --- |\n" +
              std::exchange(alone, "");
    table += tableRow(view);
  }
  EXPECT_TRUE(alone.empty());
  for (const auto& [group, table] : tables)
    test::expectGenerated("parameters.md", "parameters " + group, table);
}

/// Parameters whose effect this run cannot show: it is short, the camera never stands and is never
/// lost, and one start suffices; filter.shadow changes what is seen and not the run.
const std::set<std::string> kNotShown = {
    "keyframe.still_px",           "keyframe.still_distance",
    "keyframe.min_angle_deg",      "filter.shadow",
    "segments.max_failures",       "adjust.keyframes",
    "adjust.fixed_keyframes",      "adjust.depth_floor",
    "adjust.max_time_ms",          "quality.min_tried_fraction",
    "quality.relocalized_inliers", "quality.relocalized_fraction",
    "quality.relocalized_noise",   "quality.fresh_lost_frames",
    "quality.lost_frames",         "quality.fresh_map_keyframes",
    "relocalize.candidates",       "relocalize.places",
    "relocalize.min_similarity",   "relocalize.min_patches",
    "start.min_inlier_ratio",      "start.max_references",
    "start.max_samples",
};

class Effect : public testing::Test {
 protected:
  static constexpr int kFrames = 40;

  static std::unique_ptr<Runner> runner(const Parameters& parameters) {
    static const auto images = [] {
      std::vector<cv::Mat> all;
      const auto rendered = test::openBuiltIn(kSpec);
      for (int i = 0; i < kFrames; ++i) all.push_back(rendered->read(i).value().gray);
      return all;
    }();
    RunnerOptions options;
    options.method = "it-svo";
    options.threaded = false;
    options.publish_snapshots = false;
    options.parameters = parameters;
    auto sequence = std::make_unique<Rendered>(test::openBuiltIn(kSpec), images);
    return std::move(makeRunner(std::move(sequence), options).value());
  }

  /// The next row of frames.csv without its times.
  static std::string step(Runner& r) {
    r.send({Command::Kind::step, -1, "", ""});
    while (r.pump()) {
    }
    FrameRecord record = r.records(0).back();
    record.time_ms.fill(0);
    return framesCsvRow(record);
  }

  static bool changesTheRun(const std::string& key, const std::string& value) {
    static const std::vector<std::string> usual = [] {
      std::vector<std::string> rows;
      const auto r = runner({});
      for (int i = 0; i < kFrames; ++i) rows.push_back(step(*r));
      return rows;
    }();
    Parameters parameters;
    EXPECT_TRUE(setParameter(parameters, key, value).ok()) << key << "=" << value;
    const auto r = runner(parameters);
    for (const std::string& row : usual)
      if (step(*r) != row) return true;
    return false;
  }

 private:
  static constexpr const char* kSpec = "synthetic:room?size=320x240&frames=40";

  class Rendered : public test::ChangedSequence {
   public:
    Rendered(std::unique_ptr<Sequence> base, const std::vector<cv::Mat>& images)
        : ChangedSequence(std::move(base), nullptr), images_(images) {}
    Result<SequenceImage> read(int index) override {
      return SequenceImage{index, timestamp(index), images_[static_cast<std::size_t>(index)]};
    }

   private:
    const std::vector<cv::Mat>& images_;
  };
};

TEST_F(Effect, EveryParameterChangesTheRun) {
  for (const ParameterView& view : listParameters({})) {
    if (kNotShown.count(view.key)) continue;
    std::vector<std::string> values = {fmt::format("{}", view.minimum),
                                       fmt::format("{}", view.maximum)};
    if (view.type == "bool") values = {view.value == "true" ? "false" : "true"};
    bool shown = false;
    for (const std::string& value : values) shown = shown || changesTheRun(view.key, value);
    EXPECT_TRUE(shown) << view.key << " has no effect";
  }
}

}  // namespace
}  // namespace svoscope
