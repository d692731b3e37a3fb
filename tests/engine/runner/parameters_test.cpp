// SPDX-License-Identifier: MIT
#include "engine/runner/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <set>

#include "engine/runner/make_runner.h"
#include "tests/support/memory_sequence.h"
#include "tests/support/support.h"

namespace svoscope {
namespace {

using testing::HasSubstr;

std::string errorOf(const std::string& key, const std::string& value) {
  Parameters parameters;
  const Status status = setParameter(parameters, key, value);
  return status.ok() ? "ok" : status.error().message();
}

std::string loadError(const std::string& text) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "p.yaml", text);
  Parameters parameters;
  const Status status = loadParameters(parameters, folder / "p.yaml");
  return status.ok() ? "ok" : status.error().message();
}

TEST(Parameters, EveryDefaultLiesWithinItsBoundsAndIsDescribed) {
  std::set<std::string> keys;
  for (const ParameterView& view : listParameters({})) {
    EXPECT_TRUE(keys.insert(view.key).second) << view.key;
    EXPECT_FALSE(view.key.empty() || view.key.front() == '.' || view.key.back() == '.') << view.key;
    EXPECT_FALSE(view.meaning.empty()) << view.key;
    EXPECT_EQ(view.value, view.default_value);
    EXPECT_EQ(errorOf(view.key, view.value), "ok") << view.key << " = " << view.value;
  }
  EXPECT_GT(keys.size(), 40u);
}

TEST(Parameters, SettingChangesTheFieldAndTheList) {
  Parameters parameters;
  ASSERT_TRUE(setParameter(parameters, "reproject.cell_px", "41").ok());
  ASSERT_TRUE(setParameter(parameters, "align.estimate_gain", "off").ok());
  ASSERT_TRUE(setParameter(parameters, "search.sigmas", "2.5").ok());
  EXPECT_EQ(parameters.tracker.reproject.cell_px, 41);
  EXPECT_FALSE(parameters.tracker.alignment.estimate_gain);
  EXPECT_EQ(parameters.tracker.mapping.search.search_sigmas, 2.5);
  int changed = 0;
  for (const ParameterView& view : listParameters(parameters))
    changed += view.value != view.default_value;
  EXPECT_EQ(changed, 3);
}

TEST(Parameters, UnknownKeysNameTheKnownOnes) {
  EXPECT_THAT(errorOf("reproject.cell", "30"), HasSubstr("reproject.cell_px"));
  EXPECT_THAT(errorOf("nonsense.cell", "30"), HasSubstr("groups are"));
  EXPECT_THAT(errorOf("", "30"), HasSubstr("groups are"));
}

TEST(Parameters, BadValuesNameTheKeyAndWhatIsAllowed) {
  EXPECT_THAT(errorOf("reproject.cell_px", "7"), HasSubstr("allowed are 8 to 200"));
  EXPECT_THAT(errorOf("reproject.cell_px", "201"), HasSubstr("reproject.cell_px"));
  for (const char* value : {"", "ten", "30px", "30.5", "1e400", " 30"})
    EXPECT_THAT(errorOf("reproject.cell_px", value), HasSubstr("not a valid int")) << value;
  for (const char* value : {"nan", "inf", "", "3,5"})
    EXPECT_THAT(errorOf("search.sigmas", value), HasSubstr("not a valid float")) << value;
  EXPECT_THAT(errorOf("align.estimate_gain", "maybe"), HasSubstr("true or false"));
  EXPECT_THAT(errorOf("align.estimate_gain", "2"), HasSubstr("true or false"));
}

TEST(Parameters, ARefusedValueChangesNothing) {
  Parameters parameters;
  EXPECT_FALSE(setParameter(parameters, "reproject.cell_px", "7").ok());
  EXPECT_EQ(parametersYaml(parameters, "svo"), parametersYaml({}, "svo"));
}

TEST(Parameters, YamlRoundTrip) {
  Parameters parameters;
  // Every numeric parameter off its default, with digits that must survive.
  for (const ParameterView& view : listParameters(parameters)) {
    if (view.type == "bool") {
      ASSERT_TRUE(setParameter(parameters, view.key, view.value == "true" ? "false" : "true").ok());
    } else if (view.type == "float") {
      const double value = view.minimum + (view.maximum - view.minimum) / 3.0;
      ASSERT_TRUE(setParameter(parameters, view.key, std::to_string(value)).ok()) << view.key;
    } else if (view.type == "int") {
      const int value = static_cast<int>(view.minimum + (view.maximum - view.minimum) / 3.0);
      ASSERT_TRUE(setParameter(parameters, view.key, std::to_string(value)).ok()) << view.key;
    }
  }
  const test::TemporaryFolder folder;
  test::writeText(folder / "p.yaml", parametersYaml(parameters, "svo"));
  Parameters loaded;
  const Status status = loadParameters(loaded, folder / "p.yaml");
  ASSERT_TRUE(status.ok()) << status.error().message();
  EXPECT_EQ(parametersYaml(loaded, "svo"), parametersYaml(parameters, "svo"));
  EXPECT_NE(parametersYaml(loaded, "svo"), parametersYaml({}, "svo"));
}

TEST(Parameters, YamlNamesEachGroupOnce) {
  const YAML::Node root = YAML::Load(parametersYaml({}, "svo"));
  std::set<std::string> names;
  for (const auto& entry : root)
    EXPECT_TRUE(names.insert(entry.first.as<std::string>()).second) << entry.first;
  std::size_t values = 0;
  for (const ParameterView& view : listParameters({})) {
    const auto dot = view.key.find('.');
    const YAML::Node value = dot == std::string::npos
                                 ? root[view.key]
                                 : root[view.key.substr(0, dot)][view.key.substr(dot + 1)];
    EXPECT_TRUE(value.IsScalar()) << view.key;
    values += value.IsScalar();
  }
  EXPECT_EQ(values, listParameters({}).size());
}

TEST(Parameters, ValuesOutOfBoundsAreFoundInTheFields) {
  Parameters parameters;
  EXPECT_TRUE(checkParameters(parameters).ok());
  parameters.tracker.start.min_tracks = 2;
  const Status status = checkParameters(parameters);
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().message(), HasSubstr("start.min_tracks"));
  EXPECT_EQ(status.error().kind, ErrorKind::usage);
  RunnerOptions options;
  options.parameters = parameters;
  const auto made = makeRunner(test::openBuiltIn("synthetic:room?size=160x120&frames=2"), options);
  ASSERT_FALSE(made.ok());
  EXPECT_THAT(made.error().message(), HasSubstr("start.min_tracks"));
  EXPECT_THAT(errorOf("start.half_patch", "17"), HasSubstr("allowed are 2 to 16"));
}

TEST(Parameters, ThoseOfTheStartNeedAReset) {
  for (const ParameterView& view : listParameters({}))
    EXPECT_EQ(view.needs_reset, view.key.rfind("start.", 0) == 0) << view.key;
}

TEST(Parameters, FilesMaySetAFew) {
  EXPECT_EQ(loadError("reproject:\n  cell_px: 40\nsearch: {sigmas: 2}\n"), "ok");
  EXPECT_EQ(loadError("{}"), "ok");
}

TEST(Parameters, DamagedFilesNameTheirFault) {
  EXPECT_THAT(loadError("reproject: [1, 2"), HasSubstr("p.yaml"));
  EXPECT_THAT(loadError("- 1\n- 2\n"), HasSubstr("not a map"));
  EXPECT_THAT(loadError("reproject: 5\n"), HasSubstr("'reproject' is not a map"));
  EXPECT_THAT(loadError("reproject: {cell_px: big}\n"), HasSubstr("reproject.cell_px"));
  EXPECT_THAT(loadError("reproject: {cell: 4}\n"), HasSubstr("known are"));
  EXPECT_THAT(loadError("reproject: {cell_px: [1]}\n"), HasSubstr("p.yaml"));
  EXPECT_NE(loadError("reproject: {cell_px: }\n"), "ok");
  EXPECT_NE(loadError("\x01\x02\xff"), "ok");
  Parameters parameters;
  const Status absent = loadParameters(parameters, "/nonexistent/p.yaml");
  ASSERT_FALSE(absent.ok());
  EXPECT_EQ(absent.error().kind, ErrorKind::input);
  EXPECT_THAT(absent.error().message(), HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace svoscope
