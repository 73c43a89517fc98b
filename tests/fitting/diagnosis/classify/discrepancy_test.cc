// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A force that a model lacks is estimated, located and classified, where the truth is known.
#include <cmath>
#include <cstdio>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fitting/diagnosis/classify/discrepancy_class.h"
#include "fitting/diagnosis/locate/discrepancy_pictures.h"
#include "fitting/diagnosis/locate/force_equations.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "tests/support/discrepancy_problem.h"

#ifdef CLOTHFIT_PICTURES
#include <opencv2/imgcodecs.hpp>
#endif

namespace clothfit {
namespace {

// A system with fewer rows than unknowns, and correlations.
struct SmallSystem {
  LinearSystem system;
  Eigen::MatrixXd factor;
};
SmallSystem MakeSmallSystem() {
  ForceLayout layout;
  layout.nodes = {2, 2};
  layout.num_knots = 3;
  layout.frames_per_knot = 4;
  layout.frame_rate = 40.0;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd jacobian(20, layout.size());
  Eigen::VectorXd residuals(20), white(layout.size());
  for (Eigen::Index i = 0; i < jacobian.size(); ++i) jacobian.data()[i] = normal(random);
  for (Eigen::Index i = 0; i < residuals.size(); ++i) residuals[i] = normal(random);
  for (Eigen::Index i = 0; i < white.size(); ++i) white[i] = normal(random);
  const Eigen::MatrixXd factor = layout.CorrelationFactor(0.7, 0.15);
  residuals += jacobian * (factor * white);
  return {{jacobian.transpose() * jacobian, jacobian.transpose() * residuals,
           residuals.squaredNorm(), 20.0},
          factor};
}

TEST(PosteriorForce, IsThatOfTheNormalEquations) {
  const SmallSystem small = MakeSmallSystem();
  const double strength = 0.6, noise = 1.7;
  const PosteriorForce posterior(small.system, small.factor, strength, noise);
  const Eigen::MatrixXd prior = strength * strength * small.factor * small.factor.transpose();
  const Eigen::MatrixXd gain = (small.system.information + prior.inverse()).inverse();
  const Eigen::MatrixXd covariance = noise * noise * gain;
  const Eigen::MatrixXd of_noise = noise * noise * gain * small.system.information * gain;
  const Eigen::Index size = gain.rows();
  const Eigen::MatrixXd functions = Eigen::MatrixXd::Random(4, size);
  // The prior's inverse has a condition of some 1e3.
  EXPECT_LT((posterior.Mean(small.system.data) - gain * small.system.data).norm(), 1e-10);
  EXPECT_LT(
      (posterior.Covariance(functions) - functions * covariance * functions.transpose()).norm(),
      1e-10);
  EXPECT_LT(
      (posterior.NoiseCovariance(functions) - functions * of_noise * functions.transpose()).norm(),
      1e-10);
  for (Eigen::Index i = 0; i < size; i += 3) {
    EXPECT_LT((posterior.Blocks().middleCols<3>(i) - covariance.block<3, 3>(i, i)).norm(), 1e-10);
    EXPECT_LT((posterior.NoiseBlocks().middleCols<3>(i) - of_noise.block<3, 3>(i, i)).norm(),
              1e-10);
  }
}

// log N(residuals; 0, noise^2 I + J prior J'), by its definition.
TEST(Evidence, IsTheMarginalLikelihoodOfTheResiduals) {
  const SmallSystem small = MakeSmallSystem();
  const Evidence best = MaximiseEvidence(small.system, small.factor);
  const auto log_likelihood = [&](double strength, double* noise) {
    // det(I + J P J') = det(I + L'J'J L s^2), and r'(I + J P J')^-1 r = r'r - b'(N + P^-1)^-1 b.
    const Eigen::MatrixXd prior = strength * strength * small.factor * small.factor.transpose();
    const Eigen::MatrixXd system =
        Eigen::MatrixXd::Identity(prior.rows(), prior.cols()) + prior * small.system.information;
    const double sum =
        small.system.sum -
        small.system.data.col(0).dot((small.system.information + prior.inverse()).inverse() *
                                     small.system.data.col(0));
    *noise = std::sqrt(std::max(1.0, sum / small.system.rows));
    return -0.5 * (small.system.rows * std::log(*noise * *noise) + sum / (*noise * *noise) +
                   std::log(system.determinant()));
  };
  double noise = 0.0;
  const double at_best = log_likelihood(best.strength, &noise);
  EXPECT_NEAR(noise, best.noise, 1e-9);
  const double none = std::sqrt(std::max(1.0, small.system.sum / small.system.rows));
  const double without =
      -0.5 * (small.system.rows * std::log(none * none) + small.system.sum / (none * none));
  EXPECT_NEAR(best.log_evidence, at_best - without, 1e-8);
  for (const double factor : {0.3, 0.6, 1.7, 3.0}) {
    EXPECT_LT(log_likelihood(best.strength * factor, &noise), at_best + 1e-9) << factor;
  }
}

// Frame by frame, by three kinds of rows, with a force there: J'r is half the sum's gradient.
TEST(ForceEquations, GradientAgreesWithDifferences) {
  int checked = 0;
  for (const auto& [tracks_only, held] : {std::pair{false, false}, std::pair{true, false},
                                          std::pair{false, true}, std::pair{true, true}}) {
    DiscrepancyProblemOptions options;
    options.frames = 20;
    options.tracks_only = tracks_only;
    options.held = held;
    const DiscrepancyProblem p = MakeDiscrepancyProblem(options);
    const ForceLayout layout = MakeForceLayout(p.scene.mesh, {3, 2}, 60.0, 19, 0.08);
    const ResidualForceOptions force_options;
    ForceEquations equations(p.scene, p.config, *p.free, layout, force_options);
    ForceUnknowns at = {p.theta, Eigen::VectorXd(0), Eigen::VectorXd::Zero(layout.size())};
    for (int i = 0; i < layout.size(); ++i) at.force[i] = 0.3 * std::sin(1.0 + 2.0 * i);
    const std::optional<NormalSums> sums = equations.Linearise(at);
    ASSERT_TRUE(sums);
    EXPECT_NEAR(sums->sum, *equations.Sum(at), 1e-5 * sums->sum);
    for (const int i : {0, 1, 5, layout.Index(1, 4, 0), layout.Index(2, 5, 1)}) {
      const double step = 1e-3;
      ForceUnknowns less = at, more = at;
      less.force[i] -= step;
      more.force[i] += step;
      const double difference = (*equations.Sum(more) - *equations.Sum(less)) / (4.0 * step);
      // Steps are solved to 1e-7 of an edge, which the sum over a thousand rows sees as 1e-5.
      EXPECT_NEAR(sums->data(p.free->size() + i, 0), difference, 1e-3 * std::abs(difference) + 1e-4)
          << i;
      ++checked;
    }
  }
  EXPECT_EQ(checked, 20);
}

struct Found {
  DiscrepancyProblem problem;
  MissingForce missing;
  Location location;
  DiscrepancyReport report;
};

Found Find(const char* name, const DiscrepancyProblemOptions& options, bool by_source = false) {
  Found found{MakeDiscrepancyProblem(options), {}, {}, {}};
  const DiscrepancyProblem& p = found.problem;
  ResidualForceOptions force_options;
  force_options.by_source = by_source;
  force_options.iterations = 6;
  force_options.nulls = NoiseNulls(p, 40, 5);
  const auto missing = EstimateMissingForce(p.scene, p.config, *p.free, p.theta, force_options);
  EXPECT_TRUE(missing);
  if (!missing) return found;
  found.missing = *missing;
  found.location = Locate(p.scene, *missing);
  found.report = ClassifyDiscrepancy(p.scene, *missing, found.location);
  const Discrepancy& m = found.location.discrepancy;
  std::printf("%s: prior %.3g, noise %.3f, sum %.0f to %.0f of %.0f, p %.3f\n%s\n", name,
              missing->prior_sigma, missing->noise_factor, missing->sum_before, missing->sum_after,
              missing->system.rows, m.p_value, m.words.c_str());
  std::printf("frames %d to %d, u %.3f to %.3f, v %.3f to %.3f, score %.0f\n", m.first_frame,
              m.last_frame, m.low_uv.x(), m.high_uv.x(), m.low_uv.y(), m.high_uv.y(),
              found.location.patch.score);
  std::printf("free %.1f sigmas, coherence %.2f, power %.2g +- %.1g W; %s\n",
              found.report.discrepancy_class.net_moment_sigmas, found.report.balance.coherence,
              found.report.discrepancy_class.power, found.report.discrepancy_class.power_sigma,
              found.report.discrepancy_class.words.c_str());
  for (const TriedTie& tie : found.report.ties)
    std::printf("  %8.1f %.2f %s %s\n", tie.log_evidence, tie.explained, tie.to.c_str(),
                tie.family.c_str());
#ifdef CLOTHFIT_PICTURES
  cv::imwrite(std::string("/tmp/locate_map_") + name + ".png",
              DrawForceMap(p.scene, *missing, found.location));
  cv::imwrite(std::string("/tmp/locate_arrows_") + name + ".png",
              DrawForceArrows(p.scene, *missing, found.location));
#endif
  std::fflush(stdout);
  return found;
}

PlantedForce Patch() { return {{0.2, 0.2}, {0.4, 0.4}, 14, 32, 0.5}; }

void ExpectPatch(const Found& found, const PlantedForce& planted) {
  const Discrepancy& m = found.location.discrepancy;
  EXPECT_TRUE(m.is_significant);
  EXPECT_LE(m.p_value, 0.05);
  EXPECT_GE(IntersectionOverUnion(planted.low_uv, planted.high_uv, m.low_uv, m.high_uv), 0.5);
  EXPECT_LE(std::abs(m.first_frame - planted.first_frame), 2);
}

TEST(Locate, FindsAPlantedPush) {
  DiscrepancyProblemOptions options;
  options.planted = Patch();
  const Found found = Find("patch", options);
  ExpectPatch(found, options.planted);
  // Along the normal, as it was planted; its amplitude is the truth's to a third.
  const Eigen::Vector3d amplitude = found.location.patch.amplitude;
  EXPECT_GT(amplitude[0] / amplitude.norm(), 0.9);
  EXPECT_NEAR(amplitude[0], 0.5, 0.17);
  const Discrepancy& m = found.location.discrepancy;
  EXPECT_NEAR(m.even, amplitude.norm(), 1e-6);  // found by a search that knows no sigma
  EXPECT_GT(m.even_sigma, 0.0);
  EXPECT_LT(m.even_sigma / m.even, m.peak_sigma / m.peak);
}

TEST(Locate, FindsNothingInACleanRecording) {
  for (const bool held : {false, true}) {
    DiscrepancyProblemOptions options;
    options.held = held;
    const Found found = Find(held ? "clean held" : "clean", options);
    EXPECT_GT(found.location.discrepancy.p_value, 0.1);
    EXPECT_FALSE(found.location.discrepancy.is_significant);
  }
}

// What was seen pulls, and what it has to pull for is the force.
TEST(Locate, FindsAPushAlongANudgedMotion) {
  for (const bool tracks_only : {false, true}) {
    DiscrepancyProblemOptions options;
    options.held = true;
    options.tracks_only = tracks_only;
    options.planted = Patch();
    const Found found = Find(tracks_only ? "held tracks" : "held", options);
    ExpectPatch(found, options.planted);
    const Eigen::Vector3d amplitude = found.location.patch.amplitude;
    EXPECT_GT(amplitude[0] / amplitude.norm(), 0.9);
    EXPECT_NEAR(amplitude[0], 0.5, 0.17);
  }
}

TEST(Locate, FindsAPushInTracksAndBlamesNoCamera) {
  DiscrepancyProblemOptions options;
  options.tracks_only = true;
  options.planted = Patch();
  const Found found = Find("tracks", options, true);
  ExpectPatch(found, options.planted);
  const std::vector<SourceShift> shifts =
      WhoseDiscrepancy(found.problem.scene.recording, found.missing, found.location.patch);
  ASSERT_EQ(shifts.size(), 3u);
  for (const SourceShift& shift : shifts) {
    std::printf("  %s kept %.2f p %.2g\n", shift.name.c_str(), shift.kept, shift.p_value);
    EXPECT_FALSE(shift.is_to_blame) << shift.name;
    EXPECT_GT(shift.kept, 0.7) << shift.name;
  }
}

TEST(Locate, BlamesTheCameraThatIsOff) {
  DiscrepancyProblemOptions options;
  options.tracks_only = true;
  options.shifted_camera = {3.0, 2.0};
  const Found found = Find("camera", options, true);
  EXPECT_TRUE(found.location.discrepancy.is_significant);
  int blamed = 0;
  for (const SourceShift& shift :
       WhoseDiscrepancy(found.problem.scene.recording, found.missing, found.location.patch)) {
    std::printf("  %s kept %.2f p %.2g\n", shift.name.c_str(), shift.kept, shift.p_value);
    EXPECT_EQ(shift.is_to_blame, shift.camera == 1) << shift.name;
    blamed += shift.is_to_blame ? 1 : 0;
  }
  EXPECT_EQ(blamed, 1);
}

TEST(DiscrepancyClass, WindComesFromOutside) {
  DiscrepancyProblemOptions options;
  options.missing = {{"wind.y", 0.6}};
  const Found found = Find("wind", options);
  EXPECT_TRUE(found.location.discrepancy.is_significant);
  EXPECT_TRUE(found.report.discrepancy_class.is_from_outside);
  EXPECT_THAT(found.report.discrepancy_class.words, testing::HasSubstr("comes from outside"));
  EXPECT_GT(found.report.discrepancy_class.net_moment_sigmas, 3.0);
}

TEST(DiscrepancyClass, FrictionIsNotSaidToComeFromOutside) {
  DiscrepancyProblemOptions options;
  options.missing = {{"bending_friction.moment", 5e-4}, {"bending_friction.onset", 5.0}};
  const Found found = Find("friction", options);
  EXPECT_FALSE(found.report.discrepancy_class.is_from_outside);
  EXPECT_THAT(found.report.discrepancy_class.words, testing::HasSubstr("cannot be told"));
  EXPECT_FALSE(found.report.discrepancy_class.is_driving);
  // The material parameters that is free takes most of it.
  EXPECT_LT(found.missing.sum_after, 1.1 * found.missing.system.rows);
}

}  // namespace
}  // namespace clothfit
