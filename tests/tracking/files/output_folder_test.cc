// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What in a folder is clothfit's, and that nothing else is touched.
#include "tracking/files/output_folder.h"

#include <csignal>
#include <iterator>

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/test_folder.h"
#include "tracking/files/part_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::ElementsAre;
using testing::HasSubstr;
using Files = std::map<std::string, std::string>;

// As a command does.
void WriteFolder(const fs::path& folder, FolderKind kind, Existing existing, const Files& files,
                 const std::string& command = "fit") {
  OutputFolder output(folder, kind, command, existing);
  output.Begin(NamesOf(files));
  output.WriteAll(files);
}

std::string ErrorOf(const fs::path& folder, FolderKind kind, Existing existing,
                    const Files& files = {{"a.csv", "new"}}, const std::string& command = "fit") {
  return InputErrorOf([&] { WriteFolder(folder, kind, existing, files, command); });
}

class OutputFolderTest : public testing::Test {
 protected:
  OutputFolderTest() { WriteFolder(place(), FolderKind::kRun, Existing::kRefuse, kFiles); }

  fs::path place() const { return test_.path() / "run"; }
  std::string Read(const std::string& file) const { return ReadTextFile(place() / file); }
  bool Has(const std::string& file) const { return fs::exists(fs::symlink_status(place() / file)); }

  const Files kFiles = {{"a.csv", "a"}, {"deep/er/b.csv", "b"}};
  TestFolder test_;
};

TEST_F(OutputFolderTest, ListsWhatItHolds) {
  EXPECT_EQ(KindOfFolder(place()), FolderKind::kRun);
  EXPECT_THAT(ReadManifest(place())->All(), ElementsAre("a.csv", "deep/er/b.csv"));
  EXPECT_THAT(Read(kManifestFile), HasSubstr("clothfit-folder/1"));
  EXPECT_EQ(KindOfFolder(test_.path()), std::nullopt);
  EXPECT_EQ(KindOfFolder(test_.path() / "none"), std::nullopt);
  EXPECT_FALSE(Has(kLockFile));
}

TEST_F(OutputFolderTest, IsNotReplacedUnasked) {
  EXPECT_THAT(ErrorOf(place(), FolderKind::kRun, Existing::kRefuse),
              HasSubstr("run: already holds a run; --force replaces it"));
  EXPECT_EQ(Read("a.csv"), "a");
}

TEST_F(OutputFolderTest, IsReplacedByItsOwnKindOnly) {
  for (const Existing existing : {Existing::kReplace, Existing::kResume}) {
    EXPECT_THAT(ErrorOf(place(), FolderKind::kDiagnosis, existing),
                HasSubstr("run: is not the folder of a diagnosis: it holds a run"));
  }
  EXPECT_THAT(ErrorOf(place(), FolderKind::kDiagnosis, Existing::kRefuse),
              HasSubstr("is not empty: it holds a run; expected a new or empty folder"));
  EXPECT_EQ(Read("a.csv"), "a");
}

TEST_F(OutputFolderTest, KeepsWhatItDidNotWrite) {
  test_.Write("run/notes.txt", "mine");
  test_.Write("run/deep/er/mine.csv", "mine");
  WriteFolder(place(), FolderKind::kRun, Existing::kReplace, {{"c.csv", "c"}});
  EXPECT_EQ(Read("notes.txt"), "mine");
  EXPECT_EQ(Read("deep/er/mine.csv"), "mine");
  EXPECT_FALSE(Has("a.csv"));
  EXPECT_FALSE(Has("deep/er/b.csv"));
  EXPECT_THAT(ReadManifest(place())->All(), ElementsAre("c.csv"));
}

TEST_F(OutputFolderTest, RemovesNothingWhereSomebodyElsesFileIsInTheWay) {
  test_.Write("run/c.csv", "mine");
  EXPECT_THAT(ErrorOf(place(), FolderKind::kRun, Existing::kReplace, {{"c.csv", "c"}}),
              HasSubstr("c.csv: exists already and is not replaced"));
  EXPECT_EQ(Read("c.csv"), "mine");
  EXPECT_EQ(Read("a.csv"), "a");
}

TEST_F(OutputFolderTest, RefusesWhatIsNotClothfits) {
  const fs::path file = test_.Write("other/a.csv", "mine");
  const fs::path other = file.parent_path();
  EXPECT_THAT(ErrorOf(other, FolderKind::kRun, Existing::kRefuse), HasSubstr("is not empty"));
  for (const Existing existing : {Existing::kReplace, Existing::kResume, Existing::kJoin}) {
    EXPECT_THAT(ErrorOf(other, FolderKind::kRun, existing),
                HasSubstr("is not the folder of a run that clothfit wrote"));
  }
  EXPECT_THAT(ErrorOf(file, FolderKind::kRun, Existing::kReplace),
              HasSubstr("is a file; expected a folder"));
  EXPECT_THAT(ErrorOf(file / "below", FolderKind::kRun, Existing::kRefuse),
              HasSubstr("cannot be made: Not a directory"));
  fs::create_symlink("loop", test_.path() / "loop");
  EXPECT_THAT(ErrorOf(test_.path() / "loop", FolderKind::kRun, Existing::kRefuse),
              HasSubstr("cannot be looked at: Too many levels of symbolic links"));
  EXPECT_EQ(ReadTextFile(file), "mine");
  EXPECT_EQ(std::distance(fs::directory_iterator(other), fs::directory_iterator()), 1);
}

TEST_F(OutputFolderTest, WritesAndRemovesNothingBehindALink) {
  const fs::path precious = test_.Write("elsewhere/b.csv", "precious");
  fs::remove_all(place() / "deep" / "er");
  fs::create_symlink(precious.parent_path(), place() / "deep" / "er");
  fs::remove(place() / "a.csv");
  fs::create_symlink(precious, place() / "a.csv");
  EXPECT_THAT(ErrorOf(place(), FolderKind::kRun, Existing::kReplace, kFiles),
              HasSubstr("a.csv: is no regular file any more"));
  EXPECT_THAT(ErrorOf(place(), FolderKind::kRun, Existing::kReplace, {{"deep/er/b.csv", ""}}),
              HasSubstr("deep/er: is in the way; expected a folder, and no link to one"));
  WriteFolder(place(), FolderKind::kRun, Existing::kReplace, {{"c.csv", "c"}});
  EXPECT_EQ(ReadTextFile(precious), "precious");
  EXPECT_TRUE(fs::is_symlink(place() / "a.csv"));
}

TEST_F(OutputFolderTest, TrustsNoManifestThatLeadsOutside) {
  test_.Write("mine.txt", "mine");
  for (const char* file : {"../mine.txt", "/etc/hosts", "deep/../../mine.txt", ""}) {
    test_.Write(std::string("run/") + kManifestFile,
                std::string(R"({"format":"clothfit-folder/1","kind":"run","files":{"fit":[")") +
                    file + "\"]}}");
    EXPECT_THAT(ErrorOf(place(), FolderKind::kRun, Existing::kReplace),
                HasSubstr(".clothfit.json: is damaged, or of a newer clothfit"));
  }
  EXPECT_EQ(ReadTextFile(test_.path() / "mine.txt"), "mine");
  for (const char* text :
       {"", "[]", R"({"format":1})", R"({"format":"clothfit-folder/2","kind":"run","files":{}})",
        R"({"format":"clothfit-folder/1","kind":"novel","files":{}})",
        R"({"format":"clothfit-folder/1","kind":"run","files":["a"]})"}) {
    test_.Write(std::string("run/") + kManifestFile, text);
    EXPECT_THAT(InputErrorOf([&] { ReadManifest(place()); }), HasSubstr("is damaged")) << text;
  }
}

TEST_F(OutputFolderTest, RefusesToWriteOutside) {
  EXPECT_THAT(ErrorOf(test_.path() / "new", FolderKind::kRun, Existing::kRefuse, {{"../x", ""}}),
              HasSubstr("lies outside of"));
  EXPECT_FALSE(fs::exists(test_.path() / "x"));
  EXPECT_FALSE(fs::exists(test_.path() / "new"));  // nothing was begun
}

TEST_F(OutputFolderTest, ReplacesFoldersInItByTheirOwnManifests) {
  WriteFolder(place() / "in", FolderKind::kRecording, Existing::kRefuse, {{"x.csv", "x"}});
  {
    OutputFolder output(place(), FolderKind::kRun, "fit", Existing::kResume);
    output.Begin({"in/"});
  }
  test_.Write("run/in/mine.txt", "mine");
  WriteFolder(place(), FolderKind::kRun, Existing::kReplace, {});
  EXPECT_EQ(Read("in/mine.txt"), "mine");
  EXPECT_FALSE(Has("in/x.csv"));
}

TEST_F(OutputFolderTest, ResumesWithWhatIsThere) {
  OutputFolder output(place(), FolderKind::kRun, "fit", Existing::kResume);
  EXPECT_TRUE(output.was_there());
  output.Begin({"a.csv", "c.csv"});
  EXPECT_EQ(Read("a.csv"), "a");
  EXPECT_THAT(ReadManifest(place())->All(), ElementsAre("a.csv", "c.csv", "deep/er/b.csv"));
}

TEST_F(OutputFolderTest, TidiesUpAfterAKilledWriter) {
  test_.Write("run/.a.csv.abc123.part", "half");
  test_.Write("run/.mine.csv.abc123.part", "mine");
  WriteFolder(place(), FolderKind::kRun, Existing::kReplace, kFiles);
  EXPECT_FALSE(Has(".a.csv.abc123.part"));
  EXPECT_EQ(Read(".mine.csv.abc123.part"), "mine");
}

// Recordings are put together by several imports.
TEST_F(OutputFolderTest, BeginsWhereAWriterWasKilledBeforeItsFirstManifest) {
  const fs::path begun = test_.path() / "begun";
  const std::string part = std::string(".") + kManifestFile + ".a1b2c3.part";
  for (const Existing existing : {Existing::kRefuse, Existing::kReplace, Existing::kResume}) {
    fs::remove_all(begun);
    test_.Write("begun/" + part, "half of it");
    WriteFolder(begun, FolderKind::kRun, existing, {{"a.csv", "new"}});
    EXPECT_FALSE(fs::exists(begun / part));
    EXPECT_EQ(ReadTextFile(begun / "a.csv"), "new");
  }
  fs::remove_all(begun);
  test_.Write("begun/.mine.csv.a1b2c3.part", "mine");
  EXPECT_THAT(ErrorOf(begun, FolderKind::kRun, Existing::kRefuse), HasSubstr("is not empty"));
}

TEST_F(OutputFolderTest, ResumesWithoutWhatAKilledWriterLeft) {
  test_.Write("run/.a.csv.a1b2c3.part", "half of it");
  test_.Write("run/deep/er/.b.csv.a1b2c3.part", "half of it");
  test_.Write("run/.mine.csv.a1b2c3.part", "mine");
  const OutputFolder resumed(place(), FolderKind::kRun, "fit", Existing::kResume);
  EXPECT_FALSE(Has(".a.csv.a1b2c3.part"));
  EXPECT_FALSE(Has("deep/er/.b.csv.a1b2c3.part"));
  EXPECT_EQ(Read(".mine.csv.a1b2c3.part"), "mine");
  EXPECT_EQ(Read("a.csv"), "a");
}

TEST(RecordingFolder, TakesMoreFilesAndReplacesImportedOnesOnly) {
  const TestFolder test;
  const fs::path place = test.path() / "rec";
  constexpr FolderKind kKind = FolderKind::kRecording;
  WriteFolder(place, kKind, Existing::kAdd, {{"cameras.yaml", "1"}}, "import cameras");
  test.Write("rec/images/cam0/000000.png", "mine");
  const Files markers = {{"markers.csv", "1"}, {"handles/a.csv", "1"}};
  WriteFolder(place, kKind, Existing::kAdd, markers, "import markers");
  EXPECT_EQ(ReadTextFile(place / "cameras.yaml"), "1");
  EXPECT_THAT(ErrorOf(place, kKind, Existing::kAdd, markers, "import markers"),
              HasSubstr("exists already; --force replaces it"));

  WriteFolder(place, kKind, Existing::kAddAndReplace, {{"markers.csv", "2"}}, "import markers");
  EXPECT_EQ(ReadTextFile(place / "markers.csv"), "2");
  EXPECT_FALSE(fs::exists(place / "handles"));  // of the markers before
  EXPECT_EQ(ReadTextFile(place / "cameras.yaml"), "1");
  EXPECT_EQ(ReadTextFile(place / "images/cam0/000000.png"), "mine");

  test.Write("rec/tracks.csv", "mine");
  EXPECT_THAT(ErrorOf(place, kKind, Existing::kAddAndReplace, {{"tracks.csv", "2"}}, "import x"),
              HasSubstr("tracks.csv: exists already and is not replaced"));
  EXPECT_EQ(ReadTextFile(place / "tracks.csv"), "mine");
}

TEST(RecordingFolder, MayBeMadeByHand) {
  const TestFolder test;
  test.Write("rec/recording.yaml", "mine");
  const fs::path place = test.path() / "rec";
  constexpr FolderKind kKind = FolderKind::kRecording;
  EXPECT_THAT(ErrorOf(place, kKind, Existing::kReplace), HasSubstr("is not the folder of a"));
  WriteFolder(place, kKind, Existing::kAdd, {{"cameras.yaml", "1"}}, "import cameras");
  // Now there is a manifest, but what was there before is not in it.
  EXPECT_THAT(ErrorOf(place, kKind, Existing::kReplace, {{"recording.yaml", "2"}}),
              HasSubstr("recording.yaml: exists already and is not replaced"));
  EXPECT_EQ(ReadTextFile(place / "recording.yaml"), "mine");
  test.Write("notes/thesis.txt", "mine");
  EXPECT_THAT(ErrorOf(test.path() / "notes", kKind, Existing::kAdd),
              HasSubstr("is not the folder of a recording"));
}

TEST(FolderLock, KeepsTheSecondOutAsLongAsTheFirstLives) {
  const TestFolder test;
  const fs::path place = test.path() / "run";
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t first = fork();
  ASSERT_GE(first, 0);
  if (first == 0) {
    OutputFolder output(place, FolderKind::kRun, "fit", Existing::kRefuse);
    output.Begin({"a.csv"});
    if (write(ready[1], "x", 1) != 1) _exit(1);
    while (true) pause();
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  for (const Existing existing : {Existing::kReplace, Existing::kResume}) {
    EXPECT_THAT(ErrorOf(place, FolderKind::kRun, existing),
                HasSubstr("run: another clothfit is writing it"));
  }
  kill(first, SIGKILL);
  waitpid(first, nullptr, 0);
  EXPECT_NO_THROW(WriteFolder(place, FolderKind::kRun, Existing::kReplace, {{"b.csv", "b"}}));
  EXPECT_FALSE(fs::exists(place / kLockFile));
  close(ready[0]);
  close(ready[1]);
}

TEST(FolderLock, IsSharedByThoseWhoDoItsJobs) {
  const TestFolder test;
  using Kind = FolderLock::Kind;
  {
    const FolderLock alone(test.path(), Kind::kAlone);
    EXPECT_THAT(InputErrorOf([&] { FolderLock(test.path(), Kind::kShared); }),
                HasSubstr("another clothfit"));
  }
  {
    FolderLock first(test.path(), Kind::kShared);
    const FolderLock second(test.path(), Kind::kShared);
    const FolderLock third(std::move(first));  // NOLINT(performance-move-const-arg)
    EXPECT_THAT(InputErrorOf([&] { FolderLock(test.path(), Kind::kAlone); }),
                HasSubstr("another clothfit"));
  }
  EXPECT_NO_THROW(FolderLock(test.path(), Kind::kAlone));
  EXPECT_TRUE(fs::is_empty(test.path()));
}

TEST(PartFolder, ReplacesWhatClothfitWroteAndKeepsTheRest) {
  const TestFolder test;
  const fs::path place = test.path() / "runs" / "silk";
  WriteFolder(place, FolderKind::kRun, Existing::kRefuse, {{"a.csv", "1"}, {"old.csv", "1"}});
  test.Write("runs/silk/mine.txt", "mine");
  {
    PartFolder part(place);
    WriteFolder(part.path(), FolderKind::kRun, Existing::kRefuse, {{"a.csv", "2"}, {"d/b", "2"}});
    part.MoveToPlace();
  }
  EXPECT_EQ(ReadTextFile(place / "a.csv"), "2");
  EXPECT_EQ(ReadTextFile(place / "d" / "b"), "2");
  EXPECT_EQ(ReadTextFile(place / "mine.txt"), "mine");
  EXPECT_FALSE(fs::exists(place / "old.csv"));
  EXPECT_THAT(ReadManifest(place)->All(), ElementsAre("a.csv", "d/b"));
  {
    PartFolder part(place);
    EXPECT_FALSE(part.MoveToFreePlace());
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(place.parent_path()), fs::directory_iterator()),
            1);
}

TEST(FolderName, LeadsNowhereElse) {
  EXPECT_EQ(AsFolderName(".."), "__");
  EXPECT_EQ(AsFolderName("."), "_");
  EXPECT_EQ(AsFolderName("a/../b"), "a_.._b");
  EXPECT_EQ(AsFolderName(""), "_");
  EXPECT_EQ(AsFolderName("silk.2"), "silk.2");
}

}  // namespace
}  // namespace clothfit
