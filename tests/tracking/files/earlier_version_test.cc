// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Folders of version 0.1.0 are known by what their files hold, and not by names alone.
#include "tracking/files/earlier_version.h"

#include <gmock/gmock.h>

#include "tests/support/test_folder.h"
#include "tracking/files/output_folder.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::Contains;
using testing::ElementsAre;
using testing::IsSupersetOf;
using testing::Not;

constexpr const char* kResult =
    "{\n \"output\": null,\n \"problem\": \"\",\n \"seconds\": 0.0\n}\n";
constexpr const char* kConditions = "spread: 0.5\nseed: 1\nmax_simulations: inf\n";
constexpr const char* kConfig = "# What decides a fit: clothfit fit --config FILE\n";
constexpr const char* kPictures = "frame,camera,mask_quality,features,points\n";
constexpr const char* kPage =
    "<!doctype html>\n<html lang=\"en\">\n<meta name=\"generator\" content=\"clothfit 0.1.0\">\n";

// What it began a folder with, and files of the same names by somebody else.
struct EarlierFolder {
  const char* name;
  FolderKind kind;
  TestFiles own, foreign;
};

const std::vector<EarlierFolder>& Folders() {
  static const std::vector<EarlierFolder> folders = {
      {"run",
       FolderKind::kRun,
       {{"log.txt", "clothfit 0.1.0\n"}, {"report.html", kPage}},
       {{"log.txt", "clothfit fit demo -o run\n"}, {"report.html", kPage}}},
      {"diagnosis_log",
       FolderKind::kDiagnosis,
       {{"log.txt", "clothfit diagnose\n"}},
       {{"log.txt", "clothfit diagnose demo -o out\n"}}},
      {"diagnosis",
       FolderKind::kDiagnosis,
       {{"diagnosis.json", "{\n  \"format\": \"clothfit-diagnosis/1\",\n"}},
       {{"diagnosis.json", "{\"patient\": \"a\", \"diagnosis\": \"flu\"}"}}},
      {"comparison",
       FolderKind::kComparison,
       {{"comparison.json", "{\n \"format\": \"clothfit-comparison/1\",\n"}, {"runs.csv", ""}},
       {{"comparison.json", "{\"format\": 1}"}, {"runs.csv", ""}}},
      {"comparison_begun",
       FolderKind::kComparison,
       {{"conditions.yaml", kConditions}, {"config.yaml", kConfig}},
       {{"conditions.yaml", "spread: wide\n"}, {"config.yaml", kConfig}}},
      {"trials",
       FolderKind::kTrials,
       {{"commitments.csv", "trial,sha256\n"}, {"jobs/a.json", kResult}},
       {{"commitments.csv", "who,what\n"}, {"jobs/a.json", kResult}}},
      {"batch",
       FolderKind::kBatch,
       {{"batch.yaml", "fits:\n  - recording: silk\n\n# silk: silk\n"},
        {"jobs/silk.json", kResult}},
       {{"batch.yaml", "fits:\n  - recording: silk\n# wool: later\n"}, {"jobs/silk.json", "{}"}}},
      {"batch_with_config",
       FolderKind::kBatch,
       {{"batch.yaml", "config: a.yaml\nfits:\n- recording: a\n# a: a\n"},
        {"jobs/a.json", kResult}},
       {{"batch.yaml", "kind: Job\n"}, {"jobs/a.json", kResult}}},
      {"study",
       FolderKind::kStudy,
       {{"study.json",
         "{\n \"clothfit\": \"0.1.0\",\n \"options\": {},\n \"study\": \"cameras\"\n}\n"},
        {"jobs/a.json", kResult},
        {"cameras.csv", ""}},
       {{"study.json", "{\n \"study\": \"of wool\"\n}\n"}, {"jobs/a.json", kResult}}},
      {"recovery",
       FolderKind::kStudyTables,
       {{"recovery.csv", "seed,status,parameter,unit,truth,start,estimate,lower95,upper95\n"}},
       {{"recovery.csv", "patient,days\n"}}},
      {"tracking",
       FolderKind::kStudyTables,
       {{"tracking.md", "| recording | silhouette IoU (worst picture) | 2D tracks |\n"}},
       {{"tracking.md", "# Parcels\n"}}},
      {"chaos",
       FolderKind::kStudyTables,
       {{"chaos.csv", "time,rms,largest,sensitivity,predicted,growth\n"}, {"chaos.png", ""}},
       {{"chaos.csv", "time,x,y\n"}, {"chaos.png", ""}}},
      {"study_recordings",
       FolderKind::kStudyRecordings,
       {{"jobs/a.json", kResult}},
       {{"jobs/a.json", kResult}}},
      {"synthesized",
       FolderKind::kRecording,
       {{"truth/synthesize.yaml", "scenario: corner-lift\n"}, {"recording.yaml", ""}},
       {{"truth/synthesize.yaml", "voices: 4\n"}, {"recording.yaml", ""}}},
      {"tracked",
       FolderKind::kRecording,
       {{"origin.txt", "/rec\n"}, {"pictures.csv", kPictures}, {"masks/cam0/000001.png", ""}},
       {{"origin.txt", "/rec\n"}, {"masks/cam0/000001.png", ""}}}};
  return folders;
}

TEST(EarlierVersion, IsKnownByWhatItWrote) {
  const TestFolder test;
  for (const EarlierFolder& one : Folders()) {
    SCOPED_TRACE(one.name);
    const std::string own = one.name, foreign = own + "_of_others";
    for (const auto& [file, text] : one.own) test.Write((fs::path(own) / file).string(), text);
    for (const auto& [file, text] : one.foreign)
      test.Write((fs::path(foreign) / file).string(), text);
    if (one.kind == FolderKind::kStudyRecordings) {  // which are one folder down
      test.Write(own + "/lift/seen/origin.txt", "/pictures\n");
      test.Write(own + "/lift/seen/pictures.csv", kPictures);
      test.Write(foreign + "/lift/seen/origin.txt", "where the lift was seen\n");
    }
    test.Write(own + "/mine.txt", "mine");
    const std::optional<Manifest> manifest = FilesOfEarlierVersion(test.path() / own);
    ASSERT_TRUE(manifest);
    EXPECT_EQ(manifest->kind, one.kind);
    EXPECT_THAT(manifest->All(), IsSupersetOf(NamesOf(one.own)));
    EXPECT_THAT(manifest->All(), Not(Contains("mine.txt")));
    EXPECT_FALSE(FilesOfEarlierVersion(test.path() / foreign));
  }
}

TEST(EarlierVersion, IsNotKnownWhereNothingIsItsOwn) {
  const TestFolder test;
  test.Write("hand/recording.yaml", "");
  test.Write("other/log.txt", "of another program\n");
  test.Write("empty/chaos.csv", "");
  fs::create_directories(test.path() / "folder" / "chaos.csv");
  for (const char* name : {"hand", "other", "empty", "folder"})
    EXPECT_EQ(KindOfFolder(test.path() / name), std::nullopt) << name;
}

TEST(EarlierVersion, LosesNothingOfOthersWhenItIsReplaced) {
  const TestFolder test;
  const fs::path place = test.path() / "out";
  for (const char* file : {"tables/tracking.md", "tables/mine.md", "batch/jobs/mine.json",
                           "run/report.html", "run/mine.txt", "seen/masks/cam0/mine.png"})
    test.Write((fs::path("out") / file).string(), "mine");
  test.Write("out/tables/chaos.csv", "time,rms,largest,sensitivity,predicted,growth\n");
  test.Write("out/tables/recovery.csv", "seed,status,parameter,unit,truth,start,estimate,\n");
  test.Write("out/batch/batch.yaml", "fits:\n- recording: silk\n\n# silk: silk\n");
  test.Write("out/batch/jobs/silk.json", kResult);
  test.Write("out/run/log.txt", "clothfit 0.1.0\n");
  test.Write("out/run/summary.json", "{}");
  test.Write("out/seen/origin.txt", "/rec\n");
  test.Write("out/seen/pictures.csv", kPictures);
  test.Write("out/seen/masks/cam0/000001.png", "");
  const auto files = [&](const char* name) { return ReadManifest(place / name)->All(); };
  EXPECT_THAT(files("tables"), ElementsAre("chaos.csv", "recovery.csv"));
  EXPECT_THAT(files("batch"), ElementsAre("batch.yaml", "jobs/silk.json"));
  EXPECT_THAT(files("run"), ElementsAre("log.txt", "summary.json"));
  EXPECT_THAT(files("seen"), ElementsAre("masks/cam0/000001.png", "origin.txt", "pictures.csv"));
  OutputFolder(place / "run", FolderKind::kRun, "fit", Existing::kReplace).Begin({"a.csv"});
  for (const char* file : {"run/report.html", "run/mine.txt"})
    EXPECT_EQ(ReadTextFile(place / file), "mine") << file;
  EXPECT_FALSE(fs::exists(place / "run" / "summary.json"));
}

}  // namespace
}  // namespace clothfit
