// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Scores of diagnoses that are made up: right, wrong, ambiguous, alarmed for nothing.
#include "fitting/trials/score.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fitting/jobs/run_jobs.h"
#include "fitting/trials/run.h"
#include "fitting/trials/summary.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

Trial FirstOf(const std::string& plan, const std::string& only = "") {
  TrialPlanOptions options;
  options.frame_count = 25;
  options.resolution = 5;
  options.same_generator = true;
  if (!only.empty()) options.only = {only};
  return MakeTrialPlan("PLAN", plan, options).front();
}

// Of a heavy patch, which acts in frames 5 to 20 on a quarter of the cloth.
struct Case {
  Trial trial = FirstOf("listed", "heavy_patch");
  TrialTruth truth = PlantedTruth(trial);
  Diagnosis diagnosis;

  Case() {
    truth.parameters = {{"heavy_patch.share", 2.0},
                        {"heavy_patch.u", 0.3},
                        {"heavy_patch.v", 0.35},
                        {"heavy_patch.radius", 0.1}};
    truth.force.acts = true;
    truth.force.low_uv = {0.25, 0.25};
    truth.force.high_uv = {0.5, 0.5};
    truth.force.first_frame = 5;
    truth.force.last_frame = 20;
    diagnosis.verdict = Verdict::kNamed;
    diagnosis.effects = {"heavy_patch"};
    diagnosis.confidence_set = {"heavy_patch", "hem"};
    Candidate heavy, hem;
    heavy.name = "heavy_patch";
    heavy.detection_limit = 0.5;
    hem.name = "hem";
    diagnosis.ranking = {heavy, hem};
    Model answer;
    answer.effects = {"heavy_patch"};
    answer.parameters = {{"heavy_patch.share", "1", 2.1, 1.9, 2.3},
                         {"heavy_patch.u", "m", 0.33, 0.32, 0.34}};
    answer.validation.before = 0.008;
    answer.validation.after = 0.004;
    diagnosis.answer = answer;
  }
  TrialScore Score(std::optional<double> held_out_true = 0.003) const {
    return ScoreDiagnosis(trial, truth, diagnosis, held_out_true);
  }
};

TEST(TrialScore, OfARightAnswer) {
  const TrialScore score = Case().Score();
  EXPECT_EQ(score.truth, "heavy_patch");
  EXPECT_EQ(score.named, "heavy_patch");
  EXPECT_EQ(score.named_first, true);
  EXPECT_EQ(score.top_right, true);
  EXPECT_EQ(score.in_ambiguity, true);
  EXPECT_EQ(score.ambiguity_size, 2);
  ASSERT_TRUE(score.over_limit);
  EXPECT_DOUBLE_EQ(*score.over_limit, 4.0);
  ASSERT_TRUE(score.parameter_error);
  EXPECT_NEAR(*score.parameter_error, 0.05, 1e-12);
  EXPECT_EQ(score.intervals, 2);
  EXPECT_EQ(score.covered, 1);  // the place lies outside its interval
  ASSERT_TRUE(score.gap_closed);
  EXPECT_NEAR(*score.gap_closed, 0.8, 1e-12);
  EXPECT_FALSE(score.false_alarm);
  EXPECT_FALSE(score.flagged);
}

TEST(TrialScore, OfAWrongAnswer) {
  Case wrong;
  wrong.diagnosis.effects = {"hem"};
  wrong.diagnosis.confidence_set = {"hem"};
  wrong.diagnosis.answer->effects = {"hem"};
  wrong.diagnosis.answer->parameters = {{"hem.high_v", "kg/m", 0.02, 0.01, 0.03}};
  const TrialScore score = wrong.Score();
  EXPECT_EQ(score.named_first, false);
  EXPECT_EQ(score.top_right, true);  // the ranking had it first
  EXPECT_EQ(score.in_ambiguity, false);
  EXPECT_EQ(score.ambiguity_size, 1);
  EXPECT_FALSE(score.parameter_error);
  EXPECT_EQ(score.intervals, 0);
}

TEST(TrialScore, OfAnAmbiguousAnswer) {
  Case ambiguous;
  ambiguous.diagnosis.effects = {"hem"};
  const TrialScore score = ambiguous.Score();
  EXPECT_EQ(score.named_first, false);
  EXPECT_EQ(score.in_ambiguity, true);
}

TEST(TrialScore, OfNoAnswer) {
  Case silent;
  silent.diagnosis = Diagnosis();
  silent.diagnosis.baseline_fit.after.held_out_marker_rms = 0.008;
  const TrialScore score = silent.Score();
  EXPECT_EQ(score.verdict, "nothing-missing");
  EXPECT_EQ(score.named_first, false);
  EXPECT_EQ(score.in_ambiguity, false);
  EXPECT_FALSE(score.ambiguity_size);
  EXPECT_FALSE(score.over_limit);
  ASSERT_TRUE(score.gap_closed);
  EXPECT_EQ(*score.gap_closed, 0.0);
}

TEST(TrialScore, HasNoGapWhereTheTrueModelIsNoBetter) {
  EXPECT_FALSE(Case().Score(0.008).gap_closed);
  EXPECT_FALSE(Case().Score(std::nullopt).gap_closed);
}

TEST(TrialScore, OfAVectorGoesByItsLength) {
  Case wind;
  wind.trial = FirstOf("listed", "wind");
  wind.truth = PlantedTruth(wind.trial);
  wind.truth.parameters = {{"wind.y", -0.5}};
  wind.diagnosis.effects = {"wind"};
  wind.diagnosis.ranking[0].name = "wind";
  wind.diagnosis.ranking[0].detection_limit = 0.25;
  wind.diagnosis.answer->effects = {"wind"};
  wind.diagnosis.answer->parameters = {{"wind.x", "m/s", 0.03, -0.1, 0.1},
                                       {"wind.y", "m/s", -0.46, -0.6, -0.4},
                                       {"wind.z", "m/s", 0.0, 0.0, 0.0}};
  const TrialScore score = wind.Score();
  EXPECT_NEAR(score.parameter_error.value_or(NAN), 0.1, 1e-12);
  EXPECT_NEAR(score.over_limit.value_or(NAN), 2.0, 1e-12);
  EXPECT_FALSE(IsFair(score));
  EXPECT_EQ(score.intervals, 2);  // one has no width
  EXPECT_EQ(score.covered, 2);
}

TEST(TrialScore, OfPlaceTimeAndClass) {
  Case place;
  Discrepancy discrepancy;
  discrepancy.is_significant = true;
  discrepancy.first_frame = 6;
  discrepancy.last_frame = 20;
  discrepancy.low_uv = {0.25, 0.0};
  discrepancy.high_uv = {0.5, 0.5};
  place.diagnosis.discrepancy = discrepancy;
  DiscrepancyClass found;
  found.is_from_outside = true;
  found.tied_to = "world";
  place.diagnosis.discrepancy_class = found;
  const TrialScore score = place.Score();
  EXPECT_NEAR(score.region_overlap.value_or(NAN), 0.5, 1e-12);
  EXPECT_EQ(score.onset_error, 1);
  EXPECT_EQ(score.class_right, true);
  EXPECT_EQ(score.tie_right, false);  // it goes with the material

  place.truth.effect_class.is_internal = true;
  EXPECT_EQ(place.Score().class_right, false);
  place.diagnosis.discrepancy_class->is_from_outside = false;
  EXPECT_FALSE(place.Score().class_right);  // nothing is said of it
  place.truth.force.first_frame = 0;        // there from the start: no onset to be found
  EXPECT_FALSE(place.Score().onset_error);
  place.diagnosis.discrepancy->is_significant = false;
  EXPECT_FALSE(place.Score().region_overlap);
}

TEST(TrialScore, OfClassContradictsEnergyTheWrongWay) {
  Case friction;
  friction.truth.effects = {"shear_friction"};
  friction.truth.effect_class = ClassOf("shear_friction");
  friction.truth.effect_class.is_internal = false;  // which is a matter of its own
  DiscrepancyClass found;
  found.is_from_outside = true;
  friction.diagnosis.discrepancy_class = found;
  EXPECT_EQ(friction.Score().class_right, true);
  friction.diagnosis.discrepancy_class->is_driving = true;
  EXPECT_EQ(friction.Score().class_right, false);
  friction.diagnosis.discrepancy_class->is_driving = false;
  friction.diagnosis.discrepancy_class->is_dissipative = true;
  EXPECT_EQ(friction.Score().class_right, true);
}

TEST(TrialScore, OfACleanRecordingIsAnyAlarm) {
  const Trial trial = FirstOf("clean");
  const TrialTruth truth = PlantedTruth(trial);
  Diagnosis diagnosis;
  for (const Verdict verdict : {Verdict::kNothingMissing, Verdict::kUndecided}) {
    diagnosis.verdict = verdict;
    EXPECT_EQ(ScoreDiagnosis(trial, truth, diagnosis, {}).false_alarm, false);
  }
  for (const Verdict verdict :
       {Verdict::kNamed, Verdict::kObservationFault, Verdict::kNoneOfTheAbove}) {
    diagnosis.verdict = verdict;
    EXPECT_EQ(ScoreDiagnosis(trial, truth, diagnosis, {}).false_alarm, true);
  }
}

TEST(TrialScore, OfAFaultyCameraIsPhysicsThatIsBlamed) {
  Trial trial = FirstOf("fault", "camera-pose");
  trial.fault->camera = 2;
  const TrialTruth truth = PlantedTruth(trial);
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::kObservationFault;
  diagnosis.effects = {"camera 2: pose"};
  TrialScore score = ScoreDiagnosis(trial, truth, diagnosis, {});
  EXPECT_EQ(score.false_alarm, false);
  EXPECT_EQ(score.fault_named, true);
  diagnosis.effects = {"camera 1: pose"};
  EXPECT_EQ(ScoreDiagnosis(trial, truth, diagnosis, {}).fault_named, false);
  diagnosis.effects = {"camera 2: pose", "wind"};
  EXPECT_EQ(ScoreDiagnosis(trial, truth, diagnosis, {}).false_alarm, true);
  diagnosis.effects = {};
  diagnosis.verdict = Verdict::kNothingMissing;
  score = ScoreDiagnosis(trial, truth, diagnosis, {});
  EXPECT_EQ(score.false_alarm, false);
  EXPECT_EQ(score.fault_named, false);
}

TEST(TrialScore, KnowsTheNamesOfFaults) {
  PlantedFault fault;
  fault.camera = 1;
  fault.kind = FaultKind::kCameraClock;
  EXPECT_TRUE(IsNameOfFault("clock", fault));
  EXPECT_TRUE(IsNameOfFault("camera 1: clock", fault));
  EXPECT_FALSE(IsNameOfFault("camera 2: clock", fault));
  EXPECT_FALSE(IsNameOfFault("camera 1: pose", fault));
  fault.kind = FaultKind::kCameraScale;
  EXPECT_TRUE(IsNameOfFault("camera cam1: scale", fault));
  EXPECT_FALSE(IsNameOfFault("camera 11: scale", fault));
  fault.kind = FaultKind::kMarkerSwap;
  EXPECT_TRUE(IsNameOfFault("marker offsets", fault));
  EXPECT_FALSE(IsNameOfFault("clock", fault));
}

TEST(TrialScore, OfAnUnlistedEffectIsWhetherItIsFlagged) {
  const Trial trial = FirstOf("unlisted");
  const TrialTruth truth = PlantedTruth(trial);
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::kNoneOfTheAbove;
  EXPECT_EQ(ScoreDiagnosis(trial, truth, diagnosis, {}).flagged, true);
  diagnosis.verdict = Verdict::kNamed;
  diagnosis.effects = {"wind"};
  EXPECT_EQ(ScoreDiagnosis(trial, truth, diagnosis, {}).flagged, false);
}

TEST(TrialScore, OfAPairIsWhetherBothAreNamed) {
  const Trial trial = FirstOf("pairs");
  const TrialTruth truth = PlantedTruth(trial);
  ASSERT_EQ(truth.effects.size(), 2U);
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::kNamed;
  diagnosis.effects = {truth.effects[1], truth.effects[0]};
  EXPECT_EQ(ScoreDiagnosis(trial, truth, diagnosis, {}).both_named, true);
  EXPECT_EQ(ScoreDiagnosis(trial, truth, diagnosis, {}).named_first, true);
  diagnosis.effects = {truth.effects[1], "crease"};
  EXPECT_EQ(ScoreDiagnosis(trial, truth, diagnosis, {}).both_named, false);
}

TEST(BoxOverlap, IsIntersectionOverUnion) {
  EXPECT_DOUBLE_EQ(BoxOverlap({0, 0}, {1, 1}, {0, 0}, {1, 1}), 1.0);
  EXPECT_DOUBLE_EQ(BoxOverlap({0, 0}, {1, 1}, {0.5, 0}, {1.5, 1}), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(BoxOverlap({0, 0}, {1, 1}, {2, 2}, {3, 3}), 0.0);
  EXPECT_DOUBLE_EQ(BoxOverlap({0, 0}, {0, 0}, {0, 0}, {0, 0}), 0.0);
}

// Newcombe 1998, Two-sided confidence intervals for the single proportion, table I, method 3.
TEST(WilsonInterval, IsThatOfTheTable) {
  struct Known {
    int covered, total;
    double lower, upper;
  };
  for (const Known& known : {Known{81, 263, 0.2553, 0.3662}, Known{15, 148, 0.0624, 0.1605},
                             Known{0, 20, 0.0, 0.1611}, Known{1, 29, 0.0061, 0.1718}}) {
    Coverage coverage;
    coverage.covered = known.covered;
    coverage.total = known.total;
    EXPECT_NEAR(coverage.lower(), known.lower, 5e-5);
    EXPECT_NEAR(coverage.upper(), known.upper, 5e-5);
  }
}

TEST(TrialSummary, CountsSharesAndLeavesWeakEffectsApart) {
  Case fair, weak;
  weak.diagnosis.ranking[0].detection_limit = 1.0;  // twice the limit
  weak.diagnosis.effects = {"hem"};
  std::vector<TrialScore> scores = {fair.Score(), fair.Score(), weak.Score()};
  EXPECT_TRUE(IsFair(scores[0]));
  EXPECT_FALSE(IsFair(scores[2]));
  const Coverage all = CountYes(scores, &TrialScore::named_first);
  EXPECT_EQ(all.covered, 2);
  EXPECT_EQ(all.total, 3);
  EXPECT_EQ(CountYes(scores, &TrialScore::named_first, IsFair).total, 2);
  EXPECT_EQ(CountYes(scores, &TrialScore::false_alarm).total, 0);
  const std::string text = ScoresAsMarkdown(scores);
  EXPECT_THAT(text, HasSubstr("| listed, fair: named first | 2/2 = 100 % (34 to 100 %) |"));
  EXPECT_THAT(text, HasSubstr("| listed, below three limits: named first | 0/1 = 0 %"));
  EXPECT_THAT(text, HasSubstr("| markers (mm) | 8 | 4 | 3 |"));
}

TEST(TrialSummary, FindsTheMedian) {
  EXPECT_DOUBLE_EQ(Median({3.0, 1.0, 2.0}), 2.0);
  EXPECT_DOUBLE_EQ(Median({4.0, 1.0, 2.0, 3.0}), 2.5);
  EXPECT_TRUE(std::isnan(Median({})));
}

TEST(TrialScores, ReadBackAsTheyWereWritten) {
  TrialScore failed;
  failed.name = "listed-hem";
  failed.kind = "listed";
  failed.problem = "the simulation diverges, in frame 3\nindeed";
  TrialScore done = Case().Score();
  done.seconds = 12.5;
  done.onset_error = -3;
  const std::vector<TrialScore> read = ReadScores("scores", ScoresAsCsv({done, failed}));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].status, TrialStatus::kDone);
  EXPECT_EQ(read[1].status, TrialStatus::kFailed);
  EXPECT_EQ(read[0].onset_error, -3);
  EXPECT_EQ(read[0].gap_closed, done.gap_closed);
  EXPECT_FALSE(read[1].gap_closed);
  EXPECT_EQ(read[1].problem, "the simulation diverges; in frame 3;indeed");
  EXPECT_EQ(ScoresAsCsv(read), ScoresAsCsv({done, failed}));
  EXPECT_THAT(InputErrorOf([&] { ReadScores("other.csv", "a,b\n1,2\n"); }), HasSubstr("line 1"));
  EXPECT_THAT(InputErrorOf([&] {
                std::string text = ScoresAsCsv({done});
                text.replace(text.find("12.5"), 4, "soon");
                ReadScores("other.csv", text);
              }),
              HasSubstr("line 2: seconds: 'soon'"));
}

// Says what is planted by looking at the recording's name, which no diagnosis can.
Diagnosis Oracle(const Recording& recording, const FitConfig&, const DiagnosisOptions&) {
  Diagnosis diagnosis;
  for (const char* term : {"wind", "heavy_patch", "obstacle_sphere", "shear_friction"}) {
    if (recording.name.find(term) != std::string::npos) diagnosis.effects.emplace_back(term);
  }
  if (!diagnosis.effects.empty()) diagnosis.verdict = Verdict::kNamed;
  if (recording.name.find("vortex") != std::string::npos) throw std::runtime_error("no idea");
  return diagnosis;
}

std::vector<Trial> QuickTrials() {
  TrialPlanOptions options;
  options.frame_count = 12;
  options.resolution = 4;
  options.same_generator = true;
  return MakeTrialPlan("PLAN", "quick", options);
}

TrialRunOptions WithoutTruth() {
  TrialRunOptions options;
  options.refit_truth = false;
  return options;
}

// Seconds are the only thing that may differ.
std::string Text(std::vector<TrialScore> scores) {
  for (TrialScore& score : scores) score.seconds = 0.0;
  return ScoresAsCsv(scores);
}

std::vector<TrialScore> RunInto(const TestFolder& folder, const DiagnoseFunction& diagnose,
                                JobRunOptions jobs = {}) {
  const std::vector<Trial> trials = QuickTrials();
  jobs.folder = folder.path() / "jobs";
  return ScoresOf(
      RunJobs(TrialJobs(trials), TrialWork(trials, diagnose, WithoutTruth()), jobs).results);
}

TEST(RunTrials, ScoresAStandInAndGoesOnAfterAFailure) {
  const TestFolder folder;
  const std::vector<TrialScore> scores = RunInto(folder, Oracle);
  ASSERT_EQ(scores.size(), QuickTrials().size());
  int failed = 0, right = 0, both = 0, clean = 0;
  for (const TrialScore& score : scores) {
    EXPECT_FALSE(score.digest.empty());
    EXPECT_FALSE(score.kind.empty());
    if (score.status == TrialStatus::kFailed) {
      ++failed;
      EXPECT_EQ(score.truth, "vortex");
      EXPECT_EQ(score.problem, "no idea");
    }
    right += score.named_first.value_or(false) ? 1 : 0;
    both += score.both_named.value_or(false) ? 1 : 0;
    clean += score.kind == "clean" && !*score.false_alarm ? 1 : 0;
  }
  EXPECT_EQ(failed, 1);
  EXPECT_EQ(right, 5);
  EXPECT_EQ(both, 1);
  EXPECT_EQ(clean, 2);
}

TEST(RunTrials, GivesTheSameForAnyNumberOfThreadsAndWhenItGoesOn) {
  const TestFolder one_folder, three_folder;
  const std::vector<TrialScore> one = RunInto(one_folder, Oracle);
  JobRunOptions three;
  three.num_threads = 3;
  EXPECT_EQ(Text(RunInto(three_folder, Oracle, three)), Text(one));
  std::filesystem::remove(three_folder.path() / "jobs" / (one[4].name + ".json"));
  int calls = 0;
  const DiagnoseFunction counting = [&](const Recording& recording, const FitConfig& config,
                                        const DiagnosisOptions& diagnosis) {
    ++calls;
    return Oracle(recording, config, diagnosis);
  };
  EXPECT_EQ(Text(RunInto(three_folder, counting)), Text(one));
  EXPECT_EQ(calls, 1);
}

TEST(RunTrials, KeepsNothingOfTheTrialThatWasStopped) {
  const TestFolder folder;
  std::atomic<bool> stop = false;
  JobRunOptions jobs;
  jobs.stop = &stop;
  int calls = 0;
  const DiagnoseFunction stopping = [&](const Recording&, const FitConfig&,
                                        const DiagnosisOptions& of) {
    EXPECT_EQ(of.stop, &stop);
    if (++calls == 3) stop = true;
    return Diagnosis();
  };
  EXPECT_EQ(RunInto(folder, stopping, jobs).size(), 2U);
  EXPECT_EQ(calls, 3);
}

TEST(RunTrials, PassesTheAblationsOn) {
  TrialRunOptions options = WithoutTruth();
  options.diagnosis.project = options.diagnosis.simulate_null = false;
  int calls = 0;
  const DiagnoseFunction checking = [&](const Recording&, const FitConfig&,
                                        const DiagnosisOptions& of) {
    EXPECT_FALSE(of.project || of.simulate_null);
    ++calls;
    return Diagnosis();
  };
  RunTrial(QuickTrials().front(), checking, options, {});
  EXPECT_EQ(calls, 1);
}

TEST(TrueModelError, IsTheNoiseWhereTheFitCanBeRight) {
  TrialPlanOptions options;
  options.frame_count = 25;
  options.resolution = 5;
  options.same_generator = true;
  options.only = {"vortex"};
  const Trial trial = MakeTrialPlan("PLAN", "unlisted", options).front();
  ASSERT_EQ(trial.observation, TrialObservation::kMarkers);
  const TrialRecording made = MakeTrialRecording(trial);
  const std::optional<double> error = TrueModelError(trial, made, DefaultConfig(made.recording));
  ASSERT_TRUE(error);
  // Three coordinates of sigma 1.5 mm; 8 frames of 49 markers, five standard errors of a chi.
  const double sigma = 0.0015 * std::sqrt(3.0), count = 8 * 49 * 3;
  EXPECT_NEAR(*error, sigma, 5.0 * sigma / std::sqrt(2.0 * count));
}

}  // namespace
}  // namespace clothfit
