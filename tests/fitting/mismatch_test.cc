// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cstdio>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "fitting/diagnosis/mismatch_class.h"
#include "fitting/diagnosis/mismatch_pictures.h"
#include "tests/support/mismatch_problem.h"

namespace clothfit {
namespace {

void Look(const char* name, const MismatchProblemOptions& options, bool by_source = false) {
  const auto begin = std::chrono::steady_clock::now();
  const auto passed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const MismatchProblem p = MakeMismatchProblem(options);
  std::printf("== %s\nmade %.2f s\n", name, passed());
  ResidualForceOptions force_options;
  force_options.by_source = by_source;
  if (!options.silhouettes_only) force_options.nulls = NoiseNulls(p, 60, 5);
  const auto missing = EstimateMissingForce(p.scene, p.config, *p.free, p.theta, force_options);
  ASSERT_TRUE(missing);
  std::printf("estimated %.2f s, %d controls\n", passed(), missing->layout.size());
  std::printf("prior %.3g noise %.3f evidence %.1f sums %.1f -> %.1f of %.0f theta %.3f %.3f -> %.3f %.3f\n",
              missing->prior_sigma, missing->noise_factor, missing->log_evidence,
              missing->sum_before, missing->sum_after, missing->system.rows, p.theta[0], p.theta[1],
              missing->theta[0], missing->theta[1]);
  const Location l = Locate(p.scene, *missing);
  std::printf("located %.2f s: p %.3f frames %d-%d uv %.3f %.3f - %.3f %.3f course %d score %.1f\n",
              passed(), l.mismatch.p_value, l.mismatch.first_frame, l.mismatch.last_frame,
              l.mismatch.low_uv.x(), l.mismatch.low_uv.y(), l.mismatch.high_uv.x(),
              l.mismatch.high_uv.y(), static_cast<int>(l.patch.course), l.patch.score);
  std::printf("amplitude %.3f %.3f %.3f peak %.3f +- %.3f\n%s\n", l.patch.amplitude[0],
              l.patch.amplitude[1], l.patch.amplitude[2], l.mismatch.peak, l.mismatch.peak_sigma,
              l.mismatch.words.c_str());
  const MismatchReport r = ClassifyMismatch(p.scene, *missing, l);
  std::printf("class %.2f s: net %.1f moment %.1f coherence %.3f testable %d power %.3g +- %.2g\n",
              passed(), r.mismatch_class.net_force_sigmas, r.mismatch_class.net_moment_sigmas,
              r.balance.coherence, r.balance.is_testable, r.mismatch_class.power,
              r.mismatch_class.power_sigma);
  for (const Tie& tie : r.ties)
    std::printf("  %-9s %-45s evidence %8.1f explained %.2f\n", tie.to.c_str(), tie.family.c_str(),
                tie.log_evidence, tie.explained);
  std::printf("%s\n", r.mismatch_class.words.c_str());
  for (const SourceShift& s : WhoseMismatch(p.scene.recording, *missing, l.patch))
    std::printf("  %s kept %.2f p %.2g blame %d\n", s.name.c_str(), s.kept, s.p_value, s.is_to_blame);
  cv::imwrite(std::string("/tmp/locate_map_") + name + ".png", DrawForceMap(p.scene, *missing, l));
  cv::imwrite(std::string("/tmp/locate_arrows_") + name + ".png",
              DrawForceArrows(p.scene, *missing, l));
}

TEST(Look, Clean) { Look("clean", {}); }
TEST(Look, Patch) {
  MismatchProblemOptions o;
  o.planted = {{0.2, 0.2}, {0.4, 0.4}, 20, 40, 0.3};
  Look("patch", o);
}
TEST(Look, PatchMiddle) {
  MismatchProblemOptions o;
  o.planted = {{0.05, 0.1}, {0.25, 0.3}, 33, 50, 0.3};
  Look("patchmiddle", o);
}
TEST(Look, PatchStrong) {
  MismatchProblemOptions o;
  o.planted = {{0.0, 0.2}, {0.2, 0.4}, 12, 45, 1.0};
  Look("strong", o);
}
TEST(Look, Gust) {
  MismatchProblemOptions o;
  o.missing = {{"gust.y", 1.5}, {"gust.onset", 0.3}, {"gust.duration", 0.5}, {"gust.u", 0.3}, {"gust.v", 0.3}, {"gust.radius", 0.08}};
  Look("gust", o);
}
TEST(Look, Wind) {
  MismatchProblemOptions o;
  o.missing = {{"wind.y", 0.4}};
  Look("wind", o);
}
TEST(Look, Friction) {
  MismatchProblemOptions o;
  o.missing = {{"bending_friction.moment", 5e-4}, {"bending_friction.onset", 5.0}};
  Look("friction", o);
}
TEST(Look, Relaxation) {
  MismatchProblemOptions o;
  o.missing = {{"bending_relaxation.share", 0.5}, {"bending_relaxation.time", 0.3}};
  Look("relaxation", o);
}
TEST(Look, HeavyPatch) {
  MismatchProblemOptions o;
  o.missing = {{"heavy_patch.share", 0.5}, {"heavy_patch.u", 0.3}, {"heavy_patch.v", 0.3}, {"heavy_patch.radius", 0.08}};
  Look("heavy", o);
}
TEST(Look, Tracks) {
  MismatchProblemOptions o;
  o.tracks_only = true;
  o.planted = {{0.2, 0.2}, {0.4, 0.4}, 20, 40, 0.3};
  Look("tracks", o, true);
}
TEST(Look, Camera) {
  MismatchProblemOptions o;
  o.tracks_only = true;
  o.shifted_camera = {2.0, 1.0};
  Look("camera", o, true);
}
TEST(Look, Silhouettes) {
  MismatchProblemOptions o;
  o.silhouettes_only = true;
  o.planted = {{0.2, 0.2}, {0.4, 0.4}, 20, 40, 1.0};
  Look("silhouettes", o);
}
TEST(Look, Shear) {
  MismatchProblemOptions o;
  o.missing = {{"shear_friction.stress", 0.5}, {"shear_friction.onset", 0.02}};
  Look("shear", o);
}
TEST(Look, Viscous) {
  MismatchProblemOptions o;
  o.missing = {{"bending.damping", 2e-4}};
  Look("viscous", o);
}
TEST(Look, Big) {
  MismatchProblemOptions o;
  o.particles = 11;
  o.frames = 150;
  o.planted = {{0.2, 0.2}, {0.4, 0.4}, 60, 90, 0.3};
  Look("big", o);
}

}  // namespace
}  // namespace clothfit
