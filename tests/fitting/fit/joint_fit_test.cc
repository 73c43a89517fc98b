// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Several recordings of one cloth in one fit.
#include "fitting/fit/joint_fit.h"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/evaluation.h"
#include "fitting/fit/search.h"
#include "fitting/rollout/joint_rollout.h"
#include "fitting/rollout/shooting_windows.h"
#include "fitting/studies/recovery_study.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

// One cloth, made by the mesh that it is fitted with.
SyntheticRecording Motion(SyntheticScenario scenario, int frames, std::uint64_t seed) {
  SyntheticOptions options = DemoRecording();
  options.resolution = {5, 5};
  options.markers = {5, 5};
  options.scenario = scenario;
  options.frame_count = frames;
  options.seed = seed;
  options.buckling = false;  // what is shared is tested
  return MakeSyntheticRecording(options);
}

// A recording with its config and scene, at one place in memory.
struct Take {
  explicit Take(const SyntheticRecording& made, int initial_order = -1)
      : truth(made.truth_parameters), config(DefaultConfig(made.recording)) {
    config.window = 0.1;
    config.buckling = false;
    config.initial_order = initial_order;
    scene = MakeScene(made.recording, config);
  }
  Take(const Take&) = delete;
  Take& operator=(const Take&) = delete;
  NamedScene Named(const std::string& name) const { return {name, &scene, &config}; }

  std::map<std::string, double> truth;
  FitConfig config;
  Scene scene;
};

const SyntheticRecording& Swing() {
  static const SyntheticRecording made = Motion(SyntheticScenario::kTwoCornerSwing, 40, 1);
  return made;
}
const SyntheticRecording& Shake() {
  static const SyntheticRecording made = Motion(SyntheticScenario::kTwoCornerShake, 30, 2);
  return made;
}

std::vector<int> OwnEntries(const JointScenes& scenes, std::size_t recording) {
  std::vector<int> own;
  for (const int entry : scenes.free().EntriesOf(recording))
    if (!scenes.free().IsShared(entry)) own.push_back(entry);
  return own;
}

TEST(JointVector, HasSharedEntriesOnceAndOwnOnesOfEach) {
  Take swing(Swing(), 0), shake(Shake(), 0);
  swing.config.parameters.at("wind.x").free = shake.config.parameters.at("wind.x").free = true;
  const JointScenes scenes({swing.Named("a"), shake.Named("b")});
  const JointVector& free = scenes.free();
  const int of_one = scenes[0].free.size();
  ASSERT_EQ(scenes[1].free.size(), of_one);
  const std::vector<int> own_a = OwnEntries(scenes, 0), own_b = OwnEntries(scenes, 1);
  EXPECT_EQ(own_a.size(), 7u);  // three offsets of positions, three of velocities, and the wind
  EXPECT_EQ(own_b.size(), own_a.size());
  EXPECT_EQ(free.size(), of_one + static_cast<int>(own_b.size()));
  int shared = 0;
  for (int i = 0; i < free.size(); ++i) {
    const std::string& name = free.entries()[static_cast<std::size_t>(i)].name;
    const bool is_own = name.rfind("a/", 0) == 0 || name.rfind("b/", 0) == 0;
    EXPECT_NE(is_own, free.IsShared(i)) << name;
    shared += name.rfind("stretch.", 0) == 0 || name.rfind("air_drag.", 0) == 0 ? 1 : 0;
  }
  EXPECT_EQ(shared, 5);
  // What is known of all is known once: with the priors of one and of the other's own.
  EXPECT_EQ(free.prior_jacobian().rows(), free.size());
  const Eigen::VectorXd at = Eigen::VectorXd::LinSpaced(free.size(), -1.0, 1.0);
  const Eigen::VectorXd of_a = scenes[0].free.PriorResiduals(free.Of(0, at));
  const Eigen::VectorXd of_b = scenes[1].free.PriorResiduals(free.Of(1, at));
  double of_shared = 0.0;
  for (int i = 0; i < of_one; ++i)
    if (free.IsShared(free.EntriesOf(1)[static_cast<std::size_t>(i)]))
      of_shared += of_b[i] * of_b[i];
  EXPECT_NEAR(free.PriorResiduals(at).squaredNorm(),
              of_a.squaredNorm() + of_b.squaredNorm() - of_shared, 1e-12 * of_a.squaredNorm());
}

TEST(JointVector, FollowsTheConfigInWhatIsShared) {
  Take swing(Swing()), shake(Shake());
  for (Take* take : {&swing, &shake}) {
    take->config.parameters.at("wind.x").free = true;
    take->config.parameters.at("wind.x").shared = true;
    take->config.parameters.at("bending.stiffness").shared = false;
  }
  const JointScenes scenes({swing.Named("a"), shake.Named("b")});
  std::vector<std::string> names;
  for (const FreeEntry& entry : scenes.free().entries()) names.push_back(entry.name);
  EXPECT_THAT(names, testing::Contains("wind.x"));
  EXPECT_THAT(names, testing::IsSupersetOf({"a/bending.stiffness", "b/bending.stiffness"}));
  EXPECT_THAT(names, testing::Not(testing::Contains("bending.stiffness")));
}

// J'r against central differences of half the sum of squares, and no recording differentiated by
// another's own entries.
template <class Evaluate>
void ExpectDifferentiated(const JointScenes& scenes, const Evaluate& evaluate) {
  const Eigen::VectorXd at = scenes.free().start();
  Eigen::VectorXd residuals, unused;
  RowMajorMatrix jacobian;
  ASSERT_TRUE(evaluate(at, &unused, nullptr));
  ASSERT_TRUE(evaluate(at, &residuals, &jacobian));
  EXPECT_NEAR(residuals.norm(), unused.norm(), 1e-9 * residuals.norm());
  const Eigen::VectorXd gradient = jacobian.transpose() * residuals;
  const auto cost = [&](const Eigen::VectorXd& theta) {
    Eigen::VectorXd r;
    EXPECT_TRUE(evaluate(theta, &r, nullptr));
    return 0.5 * r.squaredNorm();
  };
  ASSERT_GT(gradient.norm(), 0.0);
  for (int i = 0; i < at.size(); ++i) {
    constexpr double kStep = 1e-5;  // a shaken cloth is far from linear in its start
    Eigen::VectorXd step = Eigen::VectorXd::Zero(at.size());
    step[i] = kStep;
    const double difference = (cost(at + step) - cost(at - step)) / (2.0 * kStep);
    EXPECT_NEAR(gradient[i], difference, 1e-4 * gradient.cwiseAbs().maxCoeff())
        << scenes.free().entries()[static_cast<std::size_t>(i)].name;
  }
}

TEST(JointRollout, IsDifferentiated) {
  Take swing(Swing(), 0), shake(Shake(), 0);
  swing.config.tolerance = shake.config.tolerance = 1e-11;
  const JointScenes scenes({swing.Named("a"), shake.Named("b")});
  JointRollout rollout(scenes, false, nullptr);
  const std::vector<WindowStart> starts = rollout.FirstStarts(scenes.free().start());
  ExpectDifferentiated(
      scenes, [&](const Eigen::VectorXd& at, Eigen::VectorXd* residuals, RowMajorMatrix* jacobian) {
        return rollout.Evaluate(starts, at, JointRollout::kAllFrames, WindowRows::kCompressed,
                                residuals, jacobian);
      });
  Eigen::VectorXd residuals;
  RowMajorMatrix jacobian;
  ASSERT_TRUE(rollout.Evaluate(scenes.free().start(), WindowRows::kAll, &residuals, &jacobian));
  ASSERT_EQ(residuals.size(), scenes.NumResiduals());
  const int of_first = scenes[0].observations.Count(0, swing.scene.last_fitted_frame);
  const RowMajorMatrix above = jacobian.topRows(of_first);
  const RowMajorMatrix below = jacobian.bottomRows(jacobian.rows() - of_first);
  for (const int entry : OwnEntries(scenes, 1)) EXPECT_TRUE(above.col(entry).isZero(0.0));
  for (const int entry : OwnEntries(scenes, 0)) EXPECT_TRUE(below.col(entry).isZero(0.0));
  for (const int entry : OwnEntries(scenes, 0)) EXPECT_GT(above.col(entry).norm(), 0.0);
}

// Another recording's own entries take no simulation: as many differentiated frames as both take
// by themselves.
TEST(JointRollout, CostsWhatItsRecordingsCost) {
  Take swing(Swing(), 0), shake(Shake(), 0);
  const auto work = [](std::vector<NamedScene> named) {
    const JointScenes scenes(std::move(named));
    JointRollout rollout(scenes, false, nullptr);
    Eigen::VectorXd residuals;
    RowMajorMatrix jacobian;
    EXPECT_TRUE(
        rollout.Evaluate(scenes.free().start(), WindowRows::kCompressed, &residuals, &jacobian));
    return rollout.differentiated_frames();
  };
  EXPECT_DOUBLE_EQ(work({swing.Named("a"), shake.Named("b")}),
                   work({swing.Named("a")}) + work({shake.Named("b")}));
}

TEST(ShootingWindows, OfSeveralRecordingsAreDifferentiated) {
  Take swing(Swing(), 0), shake(Shake(), 0);
  swing.config.tolerance = shake.config.tolerance = 1e-11;
  const JointScenes scenes({swing.Named("a"), shake.Named("b")});
  ShootingWindows windows(scenes, nullptr);
  // The second has no more than one window of so many frames.
  ASSERT_TRUE(windows.Lay(scenes.free().start(), {6, 100}));
  EXPECT_EQ(windows.size(), (swing.scene.last_fitted_frame + 5) / 6 + 1);
  ExpectDifferentiated(
      scenes, [&](const Eigen::VectorXd& at, Eigen::VectorXd* residuals, RowMajorMatrix* jacobian) {
        return windows.Evaluate(at, residuals, jacobian);
      });
}

TEST(WindowLengths, OfAShorterRecordingEndWithAllOfItsFrames) {
  Take longer(Motion(SyntheticScenario::kTwoCornerSwing, 120, 1)), shorter(Shake());
  const JointScenes scenes({shorter.Named("a"), longer.Named("b")});
  const std::vector<WindowLength> lengths = WindowLengths(scenes);
  const std::vector<int> of_longer = WindowLengths(longer.scene, longer.config);
  const std::vector<int> of_shorter = WindowLengths(shorter.scene, shorter.config);
  ASSERT_EQ(lengths.size(), of_longer.size());
  ASSERT_LT(of_shorter.size(), of_longer.size());
  for (std::size_t k = 0; k < lengths.size(); ++k) {
    EXPECT_EQ(lengths[k].frames[1], of_longer[k]);
    EXPECT_EQ(lengths[k].frames[0],
              k < of_shorter.size() ? of_shorter[k] : shorter.scene.last_fitted_frame);
  }
}

double Width(const ParameterEstimate& estimate) { return estimate.upper95 - estimate.lower95; }

TEST(JointFit, FindsTheClothWithNarrowerIntervals) {
  Take swing(Swing()), shake(Shake());
  const FitResult joint = RunJointFit({swing.Named("a"), shake.Named("b")}, {}, nullptr, true);
  EXPECT_EQ(joint.status, FitStatus::kConverged);
  ASSERT_EQ(joint.recordings.size(), 2u);
  ASSERT_TRUE(joint.misfit);
  EXPECT_TRUE(joint.misfit->IsNoise()) << joint.misfit->chi_square;
  const FitResult alone[] = {FitByStrategy(swing.scene, swing.config),
                             FitByStrategy(shake.scene, shake.config)};
  int checked = 0, held = 0;
  for (const ParameterEstimate& estimate : joint.estimates) {
    if (!estimate.free || !estimate.determined) continue;
    ++checked;
    const double truth = swing.truth.at(estimate.name);
    held += estimate.lower95 <= truth && truth <= estimate.upper95 ? 1 : 0;
    for (const FitResult& one : alone) {
      for (const ParameterEstimate& other : one.estimates) {
        if (other.name != estimate.name) continue;
        EXPECT_LT(Width(estimate), Width(other)) << other.name;
      }
    }
  }
  EXPECT_GE(checked, 6);
  EXPECT_GE(held, checked - 1);  // of seven intervals of 95 % one misses in every third fit
  // Each recording is told of as by itself, with the same material.
  for (const FitResult& one : joint.recordings) {
    ASSERT_TRUE(one.misfit);
    EXPECT_TRUE(one.misfit->IsNoise()) << one.misfit->chi_square;
    EXPECT_LT(*one.after.marker_rms, *one.before.marker_rms);
    EXPECT_EQ(one.parameters, joint.recordings[0].parameters);
  }
  // The costs of both are that of the whole, which counts the priors of what is shared once.
  const JointScenes scenes({swing.Named("a"), shake.Named("b")});
  EXPECT_NEAR(joint.recordings[0].cost_after + joint.recordings[1].cost_after,
              joint.cost_after + 0.5 * scenes.free().PriorResiduals(joint.theta).squaredNorm(),
              1e-9 * joint.cost_after);
}

TEST(JointFit, DoesNotDependOnTheNumberOfThreads) {
  Take swing(Swing()), shake(Shake());
  swing.config.max_iterations = shake.config.max_iterations = 2;
  const std::vector<NamedScene> scenes = {swing.Named("a"), shake.Named("b")};
  const FitResult many = RunJointFit(scenes);
  const InsideParallelWork one_thread;
  const FitResult one = RunJointFit(scenes);
  EXPECT_EQ(many.theta, one.theta);
  EXPECT_EQ(many.cost_after, one.cost_after);
}

TEST(JointFit, OfOneRecordingIsThatFit) {
  Take swing(Swing(), 0);
  swing.config.max_iterations = 3;
  const FitResult joint = RunJointFit({swing.Named("a")}, {}, nullptr, true);
  const FitResult alone = FitByStrategy(swing.scene, swing.config);
  EXPECT_EQ(joint.theta, alone.theta);
  EXPECT_EQ(joint.cost_after, alone.cost_after);
  ASSERT_EQ(joint.estimates.size(), alone.estimates.size());
  for (std::size_t i = 0; i < joint.estimates.size(); ++i) {
    EXPECT_EQ(joint.estimates[i].name, alone.estimates[i].name);
    EXPECT_EQ(joint.estimates[i].upper95, alone.estimates[i].upper95);
  }
}

// A recording of the same cloth is predicted by what another one found of its material.
TEST(JointFit, PredictsARecordingThatItDidNotSee) {
  Take swing(Swing());
  Take shake(Shake(), 0);
  shake.config.hold_out = true;
  shake.scene = MakeScene(Shake().recording, shake.config);
  EXPECT_EQ(shake.scene.last_fitted_frame, 0);
  const FitResult fit = RunJointFit({swing.Named("a")});
  const FitResult predicted = PredictRecording(shake.scene, shake.config, fit);
  EXPECT_FALSE(predicted.after.marker_rms);
  ASSERT_TRUE(predicted.after.held_out_marker_rms && predicted.before.held_out_marker_rms);
  const double noise = std::sqrt(3.0) * shake.scene.marker_sigma;
  EXPECT_LT(*predicted.after.held_out_marker_rms, 1.2 * noise);
  EXPECT_GT(*predicted.before.held_out_marker_rms, 1.5 * noise);
  int shared = 0, own = 0;
  for (const ParameterEstimate& estimate : predicted.estimates) {
    if (!estimate.free) continue;
    const auto same = std::find_if(fit.estimates.begin(), fit.estimates.end(),
                                   [&](const auto& one) { return one.name == estimate.name; });
    const bool is_own = estimate.name.rfind("initial.", 0) == 0;
    (is_own ? own : shared) += 1;
    if (is_own) {
      EXPECT_EQ(estimate.value, 0.0);
      EXPECT_FALSE(estimate.determined);
    } else {
      EXPECT_EQ(estimate.value, same->value);
      EXPECT_EQ(estimate.upper95, same->upper95);
    }
  }
  EXPECT_GE(shared, 6);
  EXPECT_EQ(own, 6);
}

TEST(JointFit, RefusesRecordingsOfUnlikeCloths) {
  Take swing(Swing()), shake(Shake());
  EXPECT_NO_THROW(CheckJoint({swing.Named("a"), shake.Named("b")}));
  shake.config.parameters.at("cloth.areal_density").value *= 2.0;
  EXPECT_THAT(
      InputErrorOf([&] {
        CheckJoint({swing.Named("a"), shake.Named("b")});
      }),
      testing::AllOf(HasSubstr("cloth.areal_density"), HasSubstr("one value of one cloth")));
  shake.config.parameters.at("cloth.areal_density").shared = false;
  EXPECT_THAT(InputErrorOf([&] {
                CheckJoint({swing.Named("a"), shake.Named("b")});
              }),
              HasSubstr("shared"));
  swing.config.parameters.at("cloth.areal_density").shared = false;
  EXPECT_NO_THROW(CheckJoint({swing.Named("a"), shake.Named("b")}));
  shake.config.optimiser = "bobyqa";
  EXPECT_THAT(InputErrorOf([&] {
                CheckJoint({swing.Named("a"), shake.Named("b")});
              }),
              HasSubstr("fitted by lm"));
}

}  // namespace
}  // namespace clothfit
