// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What Slurm is told, by programs in its place that write down their words. tests/cluster has it
// run.
#include "fitting/jobs/slurm.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "autodiff_sim/base/error.h"
#include "fitting/jobs/results.h"
#include "fitting/jobs/status.h"
#include "tests/support/test_folder.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::Not;

// Three recordings and seven fits of them.
JobList TenJobs() {
  JobList list;
  list.command = "study cameras";
  for (int i = 0; i < 10; ++i) list.jobs.push_back({"job" + std::to_string(i), i, i < 3 ? 0 : 1});
  return list;
}

class Slurm : public testing::Test {
 protected:
  Slurm() : path_(std::getenv("PATH")) {
    fs::create_directories(place());
    setenv("PATH", ((test_.path() / "bin").string() + ":" + path_).c_str(), 1);
    // Numbers from 11 on; the words of each call on a line.
    Program("sbatch",
            "printf '%s|' \"$@\" >> calls; echo >> calls\n"
            "echo 'sbatch: warning: be patient' >&2\n"
            "echo $((10 + $(wc -l < calls))) && test ! -e refuse\n");
    Program("squeue", "cat queue 2> /dev/null; true\n");
    Program("scancel", "echo \"$1\" >> cancelled\n");
  }
  ~Slurm() override { setenv("PATH", path_.c_str(), 1); }

  fs::path place() const { return test_.path() / "study"; }
  std::string Read(const std::string& file) const { return ReadTextFile(test_.path() / file); }
  void Program(const std::string& name, const std::string& text) const {
    const fs::path file =
        test_.Write("bin/" + name, "#!/bin/sh\ncd '" + test_.path().string() + "'\n" + text);
    fs::permissions(file, fs::perms::owner_all);
  }
  void Finish(int job, const std::string& problem = "") const {
    fs::create_directories(place() / kResultFolder);
    WriteJobResult(place() / kResultFolder, {"job" + std::to_string(job), 0, problem, 0.0});
  }
  std::string Submit(int array_size = 1000) const {
    return SubmitToSlurm(place(), TenJobs(), {"/opt/cloth fit", array_size, "--time=5 --mem=2G"});
  }

  TestFolder test_;
  std::string path_;
};

TEST_F(Slurm, GetsAnArrayAStageAndThenTheTables) {
  EXPECT_THAT(Submit(), HasSubstr("array 11: 3 tasks, 1 job each\narray 12: 7 tasks"));
  const std::string calls = Read("calls");
  EXPECT_THAT(calls, HasSubstr("|--array=0-2|"));
  EXPECT_THAT(calls, HasSubstr("|--dependency=afterok:11|--kill-on-invalid-dep=yes|--array=0-6|"));
  EXPECT_THAT(calls, HasSubstr("|--dependency=afterany:12|"));
  const std::string script = Read("study/slurm/stage-1.sh");
  EXPECT_THAT(script, HasSubstr("#SBATCH --time=5 --mem=2G\n"));
  EXPECT_THAT(script, HasSubstr("first=$((3 + SLURM_ARRAY_TASK_ID * 1))"));
  EXPECT_THAT(script, HasSubstr("'/opt/cloth fit' job " + fs::canonical(place()).string()));
  EXPECT_THAT(Read("study/slurm/gather.sh"), HasSubstr("--gather"));
}

// The words that the script of a stage hands to clothfit as task `task`.
std::string JobsOfTask(const fs::path& script, int task, const TestFolder& folder) {
  const fs::path out = folder.path() / "jobs.txt";
  const std::string text = ReadTextFile(script);
  const fs::path plain = folder.Write(
      "plain.sh", text.substr(0, text.find("'/opt")) + "echo" + text.substr(text.find("job ") + 3));
  const std::string line = "SLURM_ARRAY_TASK_ID=" + std::to_string(task) + " bash '" +
                           plain.string() + "' > '" + out.string() + "'";
  EXPECT_EQ(std::system(line.c_str()), 0);
  return ReadTextFile(out);
}

TEST_F(Slurm, GetsGroupsWhereJobsAreMoreThanTasks) {
  EXPECT_THAT(Submit(3), HasSubstr("array 12: 3 tasks, 3 jobs each"));
  EXPECT_THAT(Read("calls"), HasSubstr("|--array=0-2|"));
  const fs::path script = place() / "slurm" / "stage-1.sh";
  EXPECT_THAT(JobsOfTask(script, 0, test_), HasSubstr(" 3-5 --threads 1"));
  EXPECT_THAT(JobsOfTask(script, 1, test_), HasSubstr(" 6-8 --threads 1"));
  EXPECT_THAT(JobsOfTask(script, 2, test_), HasSubstr(" 9-9 --threads 1"));
}

TEST_F(Slurm, GetsOnlyWhatHasNoResult) {
  for (const int job : {0, 1, 2, 4, 6}) Finish(job);
  Submit();
  EXPECT_THAT(Read("calls"), HasSubstr("|--array=0,2,4-6|"));
  EXPECT_THAT(Read("calls"), Not(HasSubstr("afterok")));
}

TEST_F(Slurm, KeepsNothingOfAListThatItRefuses) {
  Program(
      "sbatch",
      "echo x >> calls\n[ $(wc -l < calls) = 1 ] && echo 11 || { echo 'no such account'; exit 1; "
      "}\n");
  EXPECT_THAT(InputErrorOf([&] { Submit(); }), HasSubstr("sbatch refuses: no such account"));
  EXPECT_EQ(Read("cancelled"), "11\n");
}

TEST_F(Slurm, IsNotGivenAJobTwice) {
  Submit();
  test_.Write("queue", "12_3 RUNNING\n12_4 PENDING\n");
  EXPECT_THAT(InputErrorOf([&] { Submit(); }), HasSubstr("2 jobs of the folder are still in the"));
  fs::remove(test_.path() / "queue");
  EXPECT_THAT(Submit(), HasSubstr("array 14"));
}

TEST_F(Slurm, TellsTheStatus) {
  EXPECT_THAT(StatusOfJobs(place(), TenJobs()).words,
              HasSubstr("10 jobs: 0 done, 0 running, 0 in the "
                        "queue, 10 not begun, 0 failed"));
  Submit();
  for (const int job : {0, 1, 2, 3}) Finish(job);
  Finish(4, "it diverges");
  test_.Write("queue", "12_2 RUNNING\n12_3 PENDING\n");
  test_.Write("study/slurm/12_4.log", "one\ntwo\nthree\nslurmstepd: error: DUE TO TIME LIMIT\n");
  const JobStatus under_way = StatusOfJobs(place(), TenJobs());
  EXPECT_TRUE(under_way.is_under_way);
  EXPECT_FALSE(under_way.is_complete);
  const std::string status = under_way.words;
  EXPECT_THAT(status, HasSubstr("4 done, 1 running, 1 in the queue, 0 not begun, 4 failed"));
  EXPECT_THAT(status, HasSubstr("job4 (job 4): it diverges\n"));
  EXPECT_THAT(status, HasSubstr("job7 (job 7) was lost: "));
  EXPECT_THAT(status, HasSubstr("12_4.log ends\n      two\n      three\n      slurmstepd"));
  EXPECT_THAT(status, HasSubstr("12_6.log says nothing\n"));
  ASSERT_EQ(mkfifo((place() / "slurm" / "12_5.log").c_str(), 0600), 0);
  EXPECT_THAT(StatusOfJobs(place(), TenJobs()).words,
              HasSubstr("12_5.log: is a pipe; expected a file\n"));
  Program("squeue", "echo 'slurm_load_jobs error: Unable to contact slurm controller'; exit 1\n");
  EXPECT_THAT(StatusOfJobs(place(), TenJobs()).words,
              HasSubstr("not known what runs: squeue: slurm_load_jobs error: Unable to contact"));
}

TEST_F(Slurm, HasDoneAllWhereEachJobHasAResult) {
  for (int job = 0; job < 9; ++job) Finish(job);
  EXPECT_FALSE(StatusOfJobs(place(), TenJobs()).is_complete);
  Finish(9, "it diverges");
  const JobStatus status = StatusOfJobs(place(), TenJobs());
  EXPECT_TRUE(status.is_complete);
  EXPECT_FALSE(status.is_under_way);
}

TEST_F(Slurm, IsNotAskedForArraysThatCannotBe) {
  const auto refuses = [&](const std::string& array) {
    test_.Write("study/slurm/submitted.json", "[" + array + "]");
    EXPECT_THAT(InputErrorOf([&] { StatusOfJobs(place(), TenJobs()).words; }),
                HasSubstr("submitted.json: array '"))
        << array;
  };
  const std::string jobs = R"("first": 0, "last": 9, "jobs_a_task": 1, )";
  refuses(R"({"id": "../../a", )" + jobs + R"("tasks": [0]})");
  refuses(R"({"id": "11", )" + jobs + R"("tasks": [-1]})");
  refuses(R"({"id": "11", )" + jobs + R"("tasks": [10]})");
  refuses(R"({"id": "11", )" + jobs + R"("tasks": [0, 0]})");
  refuses(
      R"({"id": "11", "first": 0, "last": 2000000000, "jobs_a_task": 2000000000, "tasks": [0]})");
  refuses(R"({"id": "11", "first": 0, "last": 9, "jobs_a_task": 0, "tasks": [0]})");
}

}  // namespace
}  // namespace clothfit
