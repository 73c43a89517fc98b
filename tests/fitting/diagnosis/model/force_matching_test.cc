// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/model/force_matching.h"

#include <gtest/gtest.h>

#include "fitting/diagnosis/model/screening.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "tests/support/small_recording.h"

namespace clothfit {
namespace {

constexpr double kWind = 0.5;  // m/s

// A cloth in a steady wind, and a model that knows of it.
class Matched : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const Recording recording = MakeSmallRecording({5, 30, 0.001, {{"wind.y", kWind}}});
    FitConfig given = DefaultConfig(recording);
    for (auto& [name, setting] : given.parameters) setting.free = name == "air_drag.normal";
    given.parameters.at("wind.y").value = kWind;
    fitted_ = FitAfresh({recording, given}, Start::kPlain, 0, FitRunner());
    ASSERT_TRUE(fitted_);
    FitConfig still = fitted_->values;
    still.parameters.at("wind.y").value = 0.0;
    candidates_ = ListCandidates(still, fitted_->scene, kExtent, {}, 24);
  }

  static ForceMatch Of(const std::string& candidate, const std::string& effect) {
    for (const CandidateTerm& term : candidates_) {
      if (term.name != candidate) continue;
      const std::vector<ForceMatch> matches = MatchForce(*fitted_, {effect}, {term}, kExtent);
      return matches.empty() ? ForceMatch{} : matches.front();
    }
    ADD_FAILURE() << "no candidate " << candidate;
    return {};
  }

  static inline const Extent kExtent{{-0.25, -0.3, -0.5}, {0.25, 0.3, 0.0}, {0.5, 0.5}, 1.2};
  static inline std::optional<FittedScene> fitted_;
  static inline std::vector<CandidateTerm> candidates_;
};

TEST_F(Matched, BestByItself) {
  const ForceMatch wind = Of("wind", "wind");
  EXPECT_GT(wind.share, 0.999);
  ASSERT_EQ(wind.amounts.size(), 3);
  EXPECT_NEAR(wind.amounts[1], kWind, 0.01);
}

TEST_F(Matched, NearlyByWhatCannotBeToldFromIt) {
  EXPECT_GT(Of("gust", "wind").share, 0.9);
  const ForceMatch tilt = Of("gravity_tilt", "wind");
  EXPECT_GT(tilt.share, 0.4);
  EXPECT_LT(tilt.share, 0.99);
}

TEST_F(Matched, HardlyByTheClothItself) {
  for (const char* name : {"shear_friction", "bending_relaxation", "added_mass"})
    EXPECT_LT(Of(name, "wind").share, 0.4) << name;
}

TEST_F(Matched, NotByFactorsOfWhatTheClothHas) {
  EXPECT_EQ(Of("stretch_orthotropy", "wind").share, 0.0);
}

TEST_F(Matched, NothingWhereTheEffectMakesNoForce) {
  EXPECT_TRUE(MatchForce(*fitted_, {"gust"}, candidates_, kExtent).empty());
}

// Between the probes, too.
TEST(MatchForce, FindsThePlace) {
  Recording recording = MakeSmallRecording({5, 30, 0.001, {}});
  FitConfig given = DefaultConfig(recording);
  for (auto& [name, setting] : given.parameters) setting.free = name == "air_drag.normal";
  const FitConfig still = given;
  for (const auto& [name, value] : std::map<std::string, double>{{"attractor.x", 0.1},
                                                                 {"attractor.y", 0.15},
                                                                 {"attractor.z", -0.3},
                                                                 {"attractor.range", 0.2},
                                                                 {"attractor.stiffness", 3.0}})
    given.parameters.at(name).value = value;
  const auto fitted = FitAfresh({recording, given}, Start::kPlain, 0, FitRunner());
  ASSERT_TRUE(fitted);
  const Extent extent{{-0.3, -0.3, -0.6}, {0.3, 0.3, 0.0}, {0.5, 0.5}, 1.2};
  std::vector<CandidateTerm> attractor;
  for (const CandidateTerm& term : ListCandidates(still, fitted->scene, extent, {}, 24)) {
    if (term.name == "attractor") attractor.push_back(term);
  }
  ASSERT_EQ(attractor.size(), 1u);
  const std::vector<ForceMatch> found = MatchForce(*fitted, {"attractor"}, attractor, extent);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_GT(found[0].share, 0.9);
  EXPECT_NEAR(found[0].probe.at("attractor.x"), 0.1, 0.05);
  EXPECT_NEAR(found[0].probe.at("attractor.z"), -0.3, 0.05);
}

}  // namespace
}  // namespace clothfit
