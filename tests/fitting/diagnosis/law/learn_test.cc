// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/law/learn.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "fitting/diagnosis/model/switch_on.h"
#include "tests/support/small_recording.h"

namespace clothfit {
namespace {

constexpr double kForce = 0.3;  // N/m^2 along x

// A cloth with an even force on it, and a fit without.
class LearnedLaw : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const Recording recording = MakeSmallRecording({5, 24, 0.001, {{"law_field.c_x", kForce}}});
    FitConfig config = DefaultConfig(recording);
    for (auto& [name, setting] : config.parameters) setting.free = false;
    config.parameters.at("stretch.stiffness").free = true;
    baseline_ = FitAfresh({recording, config}, Start::kPlain, 8, FitRunner());
    ASSERT_TRUE(baseline_);
  }

  static inline std::optional<FittedScene> baseline_;
};

TEST_F(LearnedLaw, IsTheForceThatWasLeftOut) {
  const std::optional<LearnedFit> law = LearnLaw(*baseline_, baseline_->config, {}, {});
  ASSERT_TRUE(law);
  EXPECT_LT(law->scene.fit.cost_after, 0.2 * baseline_->fit.cost_after);
  ASSERT_FALSE(law->terms.empty());
  EXPECT_EQ(law->terms.front(), "law_field");
  EXPECT_NEAR(law->scene.values.parameters.at("law_field.c_x").value, kForce, 0.1 * kForce);
  // What its interval holds for nothing is taken out again.
  const auto all = static_cast<std::ptrdiff_t>(13);
  EXPECT_LT(std::count_if(law->names.begin(), law->names.end(),
                          [](const std::string& n) { return n.rfind("law_field.", 0) == 0; }),
            all);
  const std::string formula = LawFormula(*law, {});
  EXPECT_NE(formula.find("force per area along x = 0."), std::string::npos) << formula;
  EXPECT_NE(formula.find("N/m^2"), std::string::npos) << formula;
}

TEST_F(LearnedLaw, HasNoSecondFamilyWhereNothingIsLeft) {
  Ranking ranking;
  ranking.null_mean = 2.0 * baseline_->fit.cost_after;
  const std::optional<LearnedFit> law = LearnLaw(*baseline_, baseline_->config, ranking, {});
  ASSERT_TRUE(law);
  EXPECT_EQ(law->terms.size(), 1u);
}

}  // namespace
}  // namespace clothfit
