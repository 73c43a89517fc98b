// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

#include <gmock/gmock.h>

#include "autodiff_sim/base/error.h"
#include "fitting/jobs/results.h"
#include "fitting/studies/study.h"
#include "fitting/studies/study_plan.h"
#include "tests/support/test_folder.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

// What a fit would have given, had its error been this.
JobResult Result(const Job& job, double error) {
  const nlohmann::json output = {{"error", error},
                                 {"all_pixels", 100.0},
                                 {"attractor", nullptr},
                                 {"truth_rms", 4.0},
                                 {"roughness", 0.3},
                                 {"true_roughness", 0.2},
                                 {"simulations", 200.0},
                                 {"seconds", 3.0},
                                 {"unknowns", 5},
                                 {"converged", true},
                                 {"reason", "told to"},
                                 {"history", nlohmann::json::array({{1.0, 0.1, 2.0 * error}})},
                                 {"surface", nlohmann::json::array()},
                                 {"true_surface", nlohmann::json::array()},
                                 {"fabric", nlohmann::json::array()}};
  return {job.name, output, "", 3.0};
}

std::string ReportOf(const Study& study, const StudyOptions& options, const TestFolder& folder,
                     const std::function<double(const StudyFit&)>& error) {
  const std::vector<Job> jobs = study.jobs(options);
  std::vector<JobResult> results;
  for (const Job& job : jobs) results.push_back(Result(job, error(StudyFitOf(job))));
  return study.report(options, jobs, results, {folder.path(), folder.path()});
}

StudyOptions OneExperiment() {
  StudyOptions options;
  options.experiments = {"experiment-1"};
  return options;
}

TEST(Studies, HaveJobsOfDifferentNamesAtEachSize) {
  int count = 0;
  for (const Study& study : Studies()) {
    for (const StudyOptions& options : {StudyOptions(), FullSize()}) {
      std::set<std::string> names;
      for (const Job& job : study.jobs(options)) {
        EXPECT_TRUE(names.insert(job.name).second) << study.name << ": " << job.name;
        EXPECT_EQ(job.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_."),
                  std::string::npos)
            << job.name;
        ++count;
      }
      EXPECT_FALSE(names.empty()) << study.name;
    }
  }
  EXPECT_GT(count, 100);
}

// One job of the study of contact in earnest, the cheapest, and the report that is made of it.
TEST(Studies, ContactReportsEveryFrame) {
  const TestFolder folder;
  const Study study = ContactStudy();
  const StudyOptions options;
  const std::vector<Job> jobs = study.jobs(options);
  const auto job =
      std::find_if(jobs.begin(), jobs.end(), [](const Job& one) { return one.name == "ball-120"; });
  ASSERT_NE(job, jobs.end());
  const JobResult result = {job->name, study.work(options, *job, {}), "", 1.0};
  const std::string table = study.report(options, jobs, {result}, {folder.path(), folder.path()});
  EXPECT_THAT(table, HasSubstr("| ball | BDF2 | 120 | 30 | yes | 0 |"));
  const std::string frames = ReadTextFile(folder.path() / "contact-ball.csv");
  EXPECT_EQ(std::count(frames.begin(), frames.end(), '\n'), 32);  // a header, the start, 30 frames
  EXPECT_THAT(frames, HasSubstr("integrator,steps_per_second,time,kinetic,gravity,stretch"));
  for (const char* file : {"contact.csv", "contact.svg", "contact.png"})
    EXPECT_TRUE(std::filesystem::exists(folder.path() / file)) << file;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "contact-bar.csv"));
}

TEST(Studies, ContactTablesHaveACellForEachColumn) {
  const TestFolder folder;
  const Study study = ContactStudy();
  const StudyOptions options;
  const std::vector<Job> jobs = study.jobs(options);
  std::vector<JobResult> results;  // of both integrators
  for (const Job& job : jobs) {
    if (job.name == "ball-120" || (job.input.at("scene") == "ball" && job.input.at("strict")))
      results.push_back({job.name, study.work(options, job, {}), "", 1.0});
  }
  ASSERT_EQ(results.size(), 2u);
  study.report(options, jobs, results, {folder.path(), folder.path()});
  for (const char* file : {"contact.csv", "contact-ball.csv"}) {
    std::istringstream lines(ReadTextFile(folder.path() / file));
    std::string header;
    std::getline(lines, header);
    int rows = 0;
    for (std::string row; std::getline(lines, row); ++rows) {
      EXPECT_EQ(std::count(row.begin(), row.end(), ','),
                std::count(header.begin(), header.end(), ','))
          << row;
    }
    EXPECT_GE(rows, 2) << file;
  }
}

TEST(Studies, AFitIsWhatItsJobSays) {
  StudyFit fit;
  fit.experiment = "experiment-2";
  fit.search = "lm/two-loop";
  fit.points = "tracks";
  fit.linear = 3.0;
  fit.reciprocal = 2e-5;
  fit.alpha = 0.1;
  fit.beta = 0.7;
  fit.cameras = 3;
  fit.start = 2;
  fit.keep_surface = true;
  const Job job = FitJob("x", fit, StudyOptions());
  EXPECT_EQ(FitJob("x", StudyFitOf(job), StudyOptions()).input, job.input);
}

TEST(AttractionStudy, IsNormalisedByTheFitWithout) {
  const TestFolder folder;
  StudyOptions options = OneExperiment();
  options.values = {50.0};
  const std::string table = ReportOf(AttractionStudy(), options, folder, [](const StudyFit& fit) {
    return fit.points == "none" ? 1000.0 : fit.linear > 0.0 ? 250.0 : 500.0;
  });
  EXPECT_THAT(table, HasSubstr("| experiment-1 | - | none | 0 | 1000 | 1.000 |"));
  EXPECT_THAT(table, HasSubstr("| experiment-1 | 3D | linear | 50 | 250 | 0.250 |"));
  EXPECT_THAT(table, HasSubstr("| experiment-1 | 2D | reciprocal | 50 | 500 | 0.500 |"));
  EXPECT_THAT(ReadTextFile(folder.path() / "attraction.svg"), HasSubstr("</svg>"));
}

TEST(AugmentedStudy, IsNormalisedByEachAlone) {
  const TestFolder folder;
  StudyOptions options = OneExperiment();
  options.values = {0.5};
  const std::string table = ReportOf(AugmentedStudy(), options, folder, [](const StudyFit& fit) {
    return fit.beta == 0.0 ? 100.0 : fit.alpha == 0.0 ? 30.0 : 96.0;
  });
  EXPECT_THAT(table, HasSubstr("| experiment-1 | 0.5 | 1 | 96 | 1.200 |"));  // 96 / (50 + 30)
  EXPECT_THAT(table, HasSubstr("| experiment-1 | 1 | 0 | 100 | 1.000 |"));
}

TEST(CameraStudy, IsNormalisedBySeven) {
  const TestFolder folder;
  const std::string table = ReportOf(CameraStudy(), OneExperiment(), folder,
                                     [](const StudyFit& fit) { return 100.0 * fit.cameras; });
  EXPECT_THAT(table, HasSubstr("| experiment-1 | 1 | 100 | 0.143 |"));
  EXPECT_THAT(table, HasSubstr("| experiment-1 | 7 | 700 | 1.000 |"));
}

TEST(LocalParameterStudy, PutsOneLoopOverTwo) {
  const TestFolder folder;
  const std::string table = ReportOf(
      LocalParameterStudy(), OneExperiment(), folder,
      [](const StudyFit& fit) { return fit.search == "pattern/one-loop" ? 190.0 : 100.0; });
  EXPECT_THAT(table, HasSubstr("| experiment-1 | pattern | 1.90 | 1.00 | 1.00 | 1.00 |"));
  EXPECT_THAT(table, HasSubstr("| experiment-1 | lm | 1.00 |"));
}

TEST(StudyOptions, NamesWhatIsWrong) {
  const auto problem = [](const std::function<void(StudyOptions*)>& change) {
    StudyOptions options;
    change(&options);
    return InputErrorOf([&] { options.Check(); });
  };
  EXPECT_THAT(problem([](auto* o) { o->experiments = {"experiment-4"}; }),
              HasSubstr("--experiments"));
  EXPECT_THAT(problem([](auto* o) { o->generator = 30; }), HasSubstr("--generator: 30"));
  EXPECT_THAT(problem([](auto* o) { o->fabric = {"bending.stifness"}; }),
              HasSubstr("'bending.stiffness'"));
  EXPECT_THAT(problem([](auto* o) { o->simulations = 0.0; }), HasSubstr("--simulations: 0"));
  EXPECT_THAT(problem([](auto* o) { o->values = {-1.0}; }), HasSubstr("--values"));
  EXPECT_THAT(problem([](auto* o) { o->search = "newton"; }), HasSubstr("--search"));
}

// A study without recordings whose jobs are nothing but numbers.
Study Squares() {
  Study study;
  study.name = "squares";
  study.uses_recordings = false;
  study.jobs = [](const StudyOptions&) { return std::vector<Job>{{"two", 2}, {"three", 3}}; };
  study.work = [](const StudyOptions&, const Job& job, const JobContext&) -> nlohmann::json {
    const int value = job.input;
    if (value == 3) throw std::runtime_error("three is too much");
    return value * value;
  };
  study.report = [](const StudyOptions&, const std::vector<Job>&,
                    const std::vector<JobResult>& results, const StudyPlace&) {
    return std::string("results: ") + std::to_string(results.size());
  };
  return study;
}

TEST(StudyPlan, ReportsWhatIsDoneAndWhatFailed) {
  const TestFolder folder;
  const std::filesystem::path place = folder.path() / "study";
  const auto prepare = [&](const StudyOptions& options, Existing existing) {
    PrepareStudy(Squares(), options, place, {}, existing);
    return StudyPlan(Squares(), ReadJobList(place), place);
  };
  const PlanResult done = RunPlan(prepare({}, Existing::kRefuse), place, {});
  EXPECT_TRUE(done.jobs.complete);
  EXPECT_EQ(done.table, "results: 1");
  EXPECT_EQ(done.jobs.CountProblems(), 1);
  EXPECT_EQ(done.jobs.FirstProblem(), "three: three is too much");
  EXPECT_EQ(ReadTextFile(place / "squares.md"), done.table);
  EXPECT_THAT(InputErrorOf([&] { prepare({}, Existing::kRefuse); }), HasSubstr("--force"));
  const JobPlan plan = prepare({}, Existing::kResume);
  EXPECT_EQ(RunPlan(plan, place, {}).table, "results: 1");
  EXPECT_THAT(InputErrorOf([&] { prepare(FullSize(), Existing::kResume); }), HasSubstr("--resume"));
  std::filesystem::remove(place / "jobs" / "two.json");
  EXPECT_EQ(GatherResults(plan, place).table, "");
  EXPECT_FALSE(GatherResults(plan, place).jobs.complete);
}

// The list of every study is all that another process needs to do it.
TEST(StudyPlan, IsReadBackFromItsFolder) {
  for (const Study& study : Studies()) {
    const TestFolder folder;
    StudyOptions options = OneExperiment();
    options.under_way = 3;
    options.seed = 7;
    const std::filesystem::path place = folder.path() / "study";
    PrepareStudy(study, options, place, folder.path() / "shared", Existing::kRefuse);
    const JobList list = ReadJobList(place);
    ASSERT_TRUE(StudyOf(list)) << study.name;
    EXPECT_EQ(StudyOf(list)->name, study.name);
    EXPECT_EQ(list.options.at("options"), nlohmann::json(options));
    EXPECT_EQ(nlohmann::json(list.options.at("options").get<StudyOptions>()),
              nlohmann::json(options));
    const std::vector<Job> own = study.jobs(options);
    ASSERT_GE(list.jobs.size(), own.size());
    const std::size_t num_recordings = list.jobs.size() - own.size();
    EXPECT_EQ(num_recordings, study.uses_recordings ? 1U : 0U);
    for (std::size_t i = 0; i < own.size(); ++i) {
      EXPECT_EQ(list.jobs[num_recordings + i].name, own[i].name);
      EXPECT_EQ(list.jobs[num_recordings + i].input, own[i].input);
    }
    EXPECT_EQ(StudyPlan(study, list, place).threads_a_job, 3);
  }
}

}  // namespace
}  // namespace clothfit
