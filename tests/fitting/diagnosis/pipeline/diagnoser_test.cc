// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Steps of a diagnosis in states that no recording brings about.
#include "fitting/diagnosis/pipeline/diagnoser.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "tests/support/known_failure.h"
#include "tests/support/small_recording.h"
#include "tests/support/unfitted_scene.h"

namespace clothfit {

// A diagnosis whose models are made up.
class DiagnoserPeer {
 public:
  explicit DiagnoserPeer(const Recording& recording)
      : scene_(UnfittedScene(recording)), diagnoser_(recording, scene_.config, options_) {}

  // Candidate `name`, with what it leaves in fitted frames and what it errs by in held-out ones
  // (m).
  FittedModel Physics(const std::string& name, double cost, double error) const {
    FittedModel model{{}, scene_, {{error * error}, true}};
    model.candidate.summary.name = name;
    model.scene.fit.cost_after = cost;
    return model;
  }

  // As the newest effect of the answer. amounts: of the answer, all effects'.
  void Keep(const FittedModel& without, const FittedModel& model,
            std::vector<EffectParameter> amounts = {}) {
    Model described;
    described.effects = diagnosis().effects;
    described.effects.push_back(model.candidate.summary.name);
    described.parameters = std::move(amounts);
    diagnoser_.diagnosis_.models.push_back(described);
    diagnoser_.TakeForAnswer(
        {diagnosis().models.size() - 1, model.candidate, without.scene, without.errors});
  }

  void SetConfidenceSet(const std::vector<std::string>& names) {
    diagnoser_.diagnosis_.confidence_set = names;
  }

  // What the gate lets pass of the recording, and of it with its faults put right.
  void SetGate(double p_value, double p_value_at_last) {
    diagnoser_.diagnosis_.gate_p_value = p_value;
    diagnoser_.last_ranking_.gate_p_value = p_value_at_last;
  }

  void ChooseAgain(FittedModel answer, const std::vector<FittedModel>& competitors) {
    diagnoser_.ChooseAgain(competitors, &answer.scene, &answer.errors);
  }

  // What follows the last round, on the mesh of the models.
  void Withdraw(FittedScene answer) {
    diagnoser_.MeasureAnswer(answer);
    diagnoser_.WithdrawWhatMayBeNothing(&answer);
    diagnoser_.WidenIntervals(answer);
  }

  bool MayRefine() const { return diagnoser_.MayRefine(scene_.scene.mesh); }

  const Diagnosis& diagnosis() const { return diagnoser_.diagnosis_; }

 private:
  DiagnosisOptions options_ = [] {
    DiagnosisOptions options;
    options.validate = false;
    return options;
  }();
  FittedScene scene_;
  Diagnoser diagnoser_;
};

namespace {

using Names = std::vector<std::string>;

// Wind is the answer, and on the finer mesh a gust comes before it.
class OutdoneAnswer : public testing::Test {
 protected:
  void Choose(const Names& confidence_set) {
    const FittedModel wind = peer_.Physics("wind", 20.0, 0.004);
    peer_.Keep(peer_.Physics("", 100.0, 0.01), wind);
    peer_.SetConfidenceSet(confidence_set);
    peer_.ChooseAgain(wind, {peer_.Physics("gust", 10.0, 0.002)});
  }
  const Diagnosis& diagnosis() const { return peer_.diagnosis(); }

 private:
  DiagnoserPeer peer_{MakeSmallRecording({4, 10})};
};

TEST_F(OutdoneAnswer, StaysInTheConfidenceSet) {
  Choose({"wind", "gravity_tilt", "gust"});
  EXPECT_EQ(diagnosis().effects, Names{"gust"});
  EXPECT_EQ(diagnosis().confidence_set, (Names{"gust", "wind", "gravity_tilt"}));
}

// Rivals are taken from the set, which loses none of them as long as one effect alone is named; so
// no recording leads here. In a process of its own, since what is overwritten may be anything.
TEST_F(OutdoneAnswer, MayBeOutdoneByWhatIsNotInTheSet) {
  const auto choose = [&] {
    Choose({"wind"});
    std::_Exit(diagnosis().confidence_set == Names{"gust", "wind"} ? EXIT_SUCCESS : EXIT_FAILURE);
  };
  EXPECT_KNOWN_FAILURE("std::rotate goes on past the end of the set",
                       EXPECT_EXIT(choose(), testing::ExitedWithCode(EXIT_SUCCESS), ""));
}

// A tilt that is sure, and wind beside it that may be nothing.
class WeakWind : public testing::Test {
 protected:
  // As if it had been fitted with these parameters, the newest last.
  FittedModel Named(const std::string& name, const Names& parameters) const {
    FittedModel model = sure_.Physics(name, 10.0, 0.002);
    for (const std::string& parameter : parameters) {
      model.scene.config.parameters.at(parameter).free = true;
      model.scene.values.parameters.at(parameter).free = true;
    }
    model.scene.fit.theta =
        FreeParameters(model.scene.config, model.scene.scene, MakeParameterTable()).start();
    model.candidate.names = {parameters.back()};
    return model;
  }

  void KeepBoth(DiagnoserPeer* peer) const {
    peer->Keep(base_, tilt_, {kTilt});
    peer->Keep(tilt_, both_, {kTilt, kWind});
  }

  const EffectParameter kTilt{"gravity_tilt.angle_1", "rad", 0.3, 0.29, 0.31};
  const EffectParameter kWind{"wind.x", "m/s", 0.0, -0.1, 0.1};
  const Recording recording_ = MakeSmallRecording({4, 20});
  DiagnoserPeer sure_{recording_}, peer_{recording_};
  const FittedModel base_ = sure_.Physics("", 100.0, 0.01);
  const FittedModel tilt_ = Named("gravity_tilt", {kTilt.name});
  const FittedModel both_ = Named("wind", {kTilt.name, kWind.name});
};

TEST_F(WeakWind, IsWithdrawn) {
  KeepBoth(&peer_);
  ASSERT_EQ(peer_.diagnosis().effects, (Names{"gravity_tilt", "wind"}));
  peer_.Withdraw(both_.scene);
  EXPECT_EQ(peer_.diagnosis().effects, Names{"gravity_tilt"});
  ASSERT_TRUE(peer_.diagnosis().answer);
  EXPECT_EQ(peer_.diagnosis().answer->effects, Names{"gravity_tilt"});
  EXPECT_FALSE(peer_.diagnosis().models.back().is_kept);
}

TEST_F(WeakWind, LeavesTheTiltAsSureAsItWasAlone) {
  sure_.Keep(base_, tilt_, {kTilt});
  sure_.Withdraw(tilt_.scene);
  ASSERT_EQ(sure_.diagnosis().effects, Names{"gravity_tilt"});
  KeepBoth(&peer_);
  peer_.Withdraw(both_.scene);
  const EffectParameter& alone = sure_.diagnosis().answer->parameters.front();
  const EffectParameter& left = peer_.diagnosis().answer->parameters.front();
  ASSERT_LT(alone.lower90, kTilt.lower90);
  EXPECT_KNOWN_FAILURE("what mesh and step do is not measured again",
                       EXPECT_DOUBLE_EQ(left.lower90, alone.lower90));
}

TEST_F(WeakWind, LeavesATiltToBeRefined) {
  sure_.Keep(base_, tilt_, {kTilt});
  ASSERT_TRUE(sure_.MayRefine());
  KeepBoth(&peer_);
  peer_.Withdraw(both_.scene);
  EXPECT_KNOWN_FAILURE("nothing is known of how the effect before was kept",
                       EXPECT_TRUE(peer_.MayRefine()));
}

TEST_F(WeakWind, IsWithdrawnBesideAFault) {
  FittedModel fault = tilt_;
  fault.candidate.summary.name = "camera cam1: pose";
  fault.candidate.faults = {0};
  peer_.Keep(base_, fault);
  peer_.Keep(fault, both_, {kWind});
  peer_.SetGate(1e-9, 0.5);
  peer_.Withdraw(both_.scene);
  EXPECT_KNOWN_FAILURE("the gate is that of the recording with its fault",
                       EXPECT_EQ(peer_.diagnosis().effects, Names{"camera cam1: pose"}));
}

}  // namespace
}  // namespace clothfit
