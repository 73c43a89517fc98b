// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// data/demo is what its command makes.
#include <filesystem>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/studies/recovery_study.h"

namespace clothfit {
namespace {

// Numbers are written to the micrometre; another machine may round the last digit the other way.
constexpr double kLastDigit = 1.1e-6;  // m

std::filesystem::path DemoFolder() {
  return std::filesystem::path(CLOTHFIT_SOURCE_DIR) / "data" / "demo";
}

TEST(DemoRecording, IsWhatItsOptionsMake) {
  const Recording read = ReadRecording(DemoFolder());
  const SyntheticRecording made = MakeSyntheticRecording(DemoRecording());
  EXPECT_EQ(read.name, made.recording.name);
  EXPECT_EQ(read.frame_count, made.recording.frame_count);
  EXPECT_EQ(read.cloth.size, made.recording.cloth.size);
  ASSERT_EQ(read.markers.size(), made.recording.markers.size());
  ASSERT_FALSE(read.markers.empty());
  for (std::size_t i = 0; i < read.markers.size(); ++i) {
    ASSERT_EQ(read.markers[i].uv, made.recording.markers[i].uv);
    ASSERT_LT(
        (read.markers[i].position - made.recording.markers[i].position).lpNorm<Eigen::Infinity>(),
        kLastDigit)
        << "marker " << i;
  }
  // A term that came later than the recording is off in it.
  const std::map<std::string, double> recorded = ReadTruthParameters(DemoFolder());
  const std::vector<NamedParameter> table = MakeParameterTable();
  for (const auto& [name, value] : made.truth_parameters) {
    const int index = FindParameter(table, name);
    ASSERT_GE(index, 0) << name;
    const auto found = recorded.find(name);
    // Contacts act only where they are asked for.
    const bool acts_if_asked = table[index].term == "contact" || table[index].term == "obstacle";
    if (found == recorded.end() && acts_if_asked) continue;
    EXPECT_EQ(found == recorded.end() ? table[index].parameter.off : found->second, value) << name;
  }
  const std::vector<TruthPoint> truth = ReadTruthPoints(DemoFolder());
  ASSERT_EQ(truth.size(), made.truth_points.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    ASSERT_LT((truth[i].position - made.truth_points[i].position).lpNorm<Eigen::Infinity>(),
              kLastDigit)
        << "truth point " << i;
  }
}

TEST(DemoRecording, IsSmallAndFarFromTheDefaults) {
  std::uintmax_t size = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(DemoFolder())) {
    if (entry.is_regular_file()) size += entry.file_size();
  }
  EXPECT_LT(size, 1000000u);
  const FitConfig config = DefaultConfig(ReadRecording(DemoFolder()));
  int free = 0;
  for (const auto& [name, truth] : ReadTruthParameters(DemoFolder())) {
    const ParameterSetting& setting = config.parameters.at(name);
    if (!setting.free) continue;
    const double factor = std::max(truth / setting.value, setting.value / truth);
    EXPECT_GE(factor, 2.0) << name;
    EXPECT_LE(factor, 15.0 + 1e-9) << name;
    ++free;
  }
  EXPECT_GE(free, 8);
}

TEST(LiftRecording, IsSmallAndHasPicturesOnly) {
  const std::filesystem::path folder = std::filesystem::path(CLOTHFIT_SOURCE_DIR) / "data" / "lift";
  std::uintmax_t size = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) size += entry.file_size();
  }
  EXPECT_LT(size, 8000000u);
  const Recording lift = ReadRecording(folder);
  EXPECT_TRUE(HasPictures(lift));
  EXPECT_TRUE(lift.markers.empty());
  EXPECT_TRUE(lift.tracks.empty());
}

}  // namespace
}  // namespace clothfit
