// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/model/order.h"

#include <gtest/gtest.h>

namespace clothfit {
namespace {

// A model of so many unknowns, as it comes out of a race.
struct Finisher {
  const char* name;
  int unknowns;
  double cost, error;  // error: m, in every held-out frame
};

HeldOutErrors Errors(double error) { return {{error * error, error * error}, true}; }

// The first of them, of a fit without at cost 1000 and 50 mm.
std::string First(const std::vector<Finisher>& finishers, double by_mesh = 0.0) {
  std::vector<FittedModel> models;
  for (const Finisher& finisher : finishers) {
    RankedCandidate candidate;
    candidate.summary.name = finisher.name;
    candidate.names.resize(static_cast<std::size_t>(finisher.unknowns));
    models.push_back({candidate, {}, Errors(finisher.error)});
    models.back().scene.fit.cost_after = finisher.cost;
  }
  PutBestPredictionFirst(1000.0, Errors(0.05), by_mesh, &models);
  return models.front().candidate.summary.name;
}

TEST(ModelOrder, TheBestPredictionComesFirst) {
  EXPECT_EQ(First({{"attractor", 5, 100.0, 0.015}, {"wind", 3, 110.0, 0.012}}), "wind");
}

TEST(ModelOrder, ExplainingLessIsNotMadeUpByPrediction) {
  EXPECT_EQ(First({{"attractor", 5, 100.0, 0.015}, {"wind", 3, 300.0, 0.012}}), "attractor");
}

TEST(ModelOrder, OfEqualPredictionsTheSimplestComesFirst) {
  EXPECT_EQ(First({{"attractor", 5, 100.0, 0.0118}, {"wind", 3, 110.0, 0.0119}}), "wind");
  EXPECT_EQ(First({{"attractor", 5, 100.0, 0.0118}, {"tilt", 2, 110.0, 0.0130}}), "attractor");
}

TEST(ModelOrder, WhatNeedsMoreUnknownsToExplainLessHasToPredictClearlyBetter) {
  EXPECT_EQ(First({{"wind", 3, 100.0, 0.016}, {"gust", 8, 110.0, 0.012}}), "wind");
  EXPECT_EQ(First({{"wind", 3, 100.0, 0.022}, {"gust", 8, 110.0, 0.012}}), "gust");
  EXPECT_EQ(First({{"wind", 3, 110.0, 0.016}, {"gust", 8, 100.0, 0.012}}), "gust");
  // By more than mesh and step do to a prediction; the cheapest of those that need fewer.
  EXPECT_EQ(First({{"wind", 3, 100.0, 0.022}, {"gust", 8, 110.0, 0.012}}, 0.02), "wind");
  EXPECT_EQ(First({{"wind", 3, 100.0, 0.024}, {"gust", 8, 110.0, 0.012}}, 0.02), "gust");
  EXPECT_EQ(First({{"wind", 3, 100.0, 0.022}, {"tilt", 2, 105.0, 0.018}, {"gust", 8, 110.0, 0.012}},
                  0.02),
            "wind");
}

}  // namespace
}  // namespace clothfit
