// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/surface/truth.h"

#include <gtest/gtest.h>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

TEST(TruthPoints, RoundTripExactly) {
  const TestFolder folder;
  EXPECT_FALSE(HasTruthPoints(folder.path()));
  const std::vector<TruthPoint> points = {{0, {0.1, 1.0 / 3.0}, {1e-17, -2.0, 1.0 / 7.0}},
                                          {7, {0.0, 0.5}, {1.0, 2.0, 3.0}}};
  folder.Write(kTruthPointsFile, TruthPointsAsCsv(points));
  ASSERT_TRUE(HasTruthPoints(folder.path()));
  const std::vector<TruthPoint> again = ReadTruthPoints(folder.path());
  ASSERT_EQ(again.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again[i].frame, points[i].frame);
    EXPECT_EQ(again[i].uv, points[i].uv);
    EXPECT_EQ(again[i].position, points[i].position);
  }
}

TEST(TruthPoints, RefuseMissingAndMalformedFiles) {
  const TestFolder folder;
  EXPECT_THAT(InputErrorOf([&] { ReadTruthPoints(folder.path()); }),
              HasSubstr("truth/points.csv: no such file"));
  folder.Write("truth/points.csv", "frame,u,v,x,y,z\n0,0,0,0,0,\n");
  EXPECT_THAT(InputErrorOf([&] { ReadTruthPoints(folder.path()); }),
              HasSubstr("points.csv: line 2: z: expected a finite number, found ''"));
}

TEST(TruthParameters, RoundTripExactly) {
  const TestFolder folder;
  EXPECT_FALSE(HasTruthParameters(folder.path()));
  const std::map<std::string, double> parameters = {{"air_drag.normal", 0.1},
                                                    {"bending.stiffness", 1.0 / 3.0}};
  folder.Write(kTruthParametersFile, TruthParametersAsYaml(parameters));
  EXPECT_TRUE(HasTruthParameters(folder.path()));
  EXPECT_EQ(ReadTruthParameters(folder.path()), parameters);
  folder.Write(kTruthParametersFile, TruthParametersAsYaml({}));
  EXPECT_TRUE(ReadTruthParameters(folder.path()).empty());
}

TEST(TruthParameters, JoinNestedMaps) {
  const TestFolder folder;
  folder.Write("truth/parameters.yaml", "air_drag: {normal: 0.1, tangential: 2}\nwind.x: 3\n");
  EXPECT_EQ(ReadTruthParameters(folder.path()),
            (std::map<std::string, double>{
                {"air_drag.normal", 0.1}, {"air_drag.tangential", 2.0}, {"wind.x", 3.0}}));
}

TEST(TruthParameters, RefuseMissingAndMalformedFiles) {
  const TestFolder folder;
  EXPECT_THAT(InputErrorOf([&] { ReadTruthParameters(folder.path()); }),
              HasSubstr("truth/parameters.yaml: no such file"));
  folder.Write("truth/parameters.yaml", "a.b: 1\na: {b: 2}\n");
  EXPECT_THAT(InputErrorOf([&] { ReadTruthParameters(folder.path()); }),
              HasSubstr("a.b: appears twice"));
  folder.Write("truth/parameters.yaml", "a: soft\n");
  EXPECT_THAT(InputErrorOf([&] { ReadTruthParameters(folder.path()); }),
              HasSubstr("parameters.yaml: a: expected a finite number, found 'soft'"));
}

}  // namespace
}  // namespace clothfit
