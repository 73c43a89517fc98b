// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/files/whole_file.h"

#include <csignal>
#include <iterator>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "tests/support/test_folder.h"
#include "tracking/files/output_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;

int CountEntries(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

// For its lifetime no file of this process can grow beyond `bytes`, as on a disk that is full.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit before_ = {};
  void (*handler_)(int) = nullptr;
};

TEST(WholeFile, IsThereOrLeavesWhatWasThere) {
  const TestFolder folder;
  const fs::path file = folder.Write("a.txt", "before");
  WriteWholeFile(file, "after");
  EXPECT_EQ(ReadTextFile(file), "after");
  {
    const SmallDisk full(1000);
    EXPECT_THAT(InputErrorOf([&] { WriteWholeFile(file, std::string(2000, 'x')); }),
                HasSubstr("a.txt: cannot be written: File too large"));
  }
  EXPECT_EQ(ReadTextFile(file), "after");
  EXPECT_EQ(CountEntries(folder.path()), 1);
  EXPECT_THAT(InputErrorOf([&] { WriteWholeFile(file / "below", ""); }),
              HasSubstr("Not a directory"));
  fs::create_directories(folder.path() / "b" / "c");
  EXPECT_THAT(InputErrorOf([&] { WriteWholeFile(folder.path() / "b", ""); }),
              HasSubstr("cannot be written"));
}

TEST(WholeFile, TouchesNoOtherFile) {
  const TestFolder folder;
  const fs::path foreign = folder.Write("a.txt.part", "of somebody else");
  WriteWholeFile(folder.path() / "a.txt", "mine");
  EXPECT_EQ(ReadTextFile(foreign), "of somebody else");
  WriteWholeFile(folder.path() / std::string(255, 'n'), "the longest name");
  EXPECT_EQ(CountEntries(folder.path()), 3);
}

TEST(WholeFile, IsWholeWhoeverElseWritesIt) {
  const TestFolder folder;
  const std::string text(100000, 'x');
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int k = 0; k < 5; ++k) WriteWholeFile(folder.path() / "table", text);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(fs::file_size(folder.path() / "table"), text.size());
  EXPECT_EQ(CountEntries(folder.path()), 1);
}

TEST(WholeFile, IsMadeByOneOfMany) {
  const TestFolder folder;
  EXPECT_TRUE(WriteNewFile(folder.path() / "result", "first"));
  EXPECT_FALSE(WriteNewFile(folder.path() / "result", "second"));
  EXPECT_EQ(ReadTextFile(folder.path() / "result"), "first");
  EXPECT_EQ(CountEntries(folder.path()), 1);
}

TEST(WholeFile, KnowsItsPartFiles) {
  const TestFolder folder;
  const PartFile part(folder.path() / "a.csv"), film(folder.path() / "a.mp4", ".mp4");
  EXPECT_EQ(PlaceOfPartFile(part.path().filename().string()), "a.csv");
  EXPECT_EQ(PlaceOfPartFile(film.path().filename().string()), "a.mp4");
  EXPECT_EQ(PlaceOfPartFile("a.csv.part"), "");
}

TEST(WholeFile, AppendsLines) {
  const TestFolder folder;
  const fs::path log = folder.path() / "log.txt";
  AppendLine(log, "one");
  AppendLine(log, "two");
  EXPECT_EQ(ReadTextFile(log), "one\ntwo\n");
  EXPECT_THAT(InputErrorOf([] { AppendLine("/dev/full", "line"); }),
              HasSubstr("/dev/full: cannot be written: is no file"));
  fs::create_symlink(log, folder.path() / "link");
  EXPECT_THAT(InputErrorOf([&] { AppendLine(folder.path() / "link", "line"); }),
              HasSubstr("cannot be written"));
  EXPECT_EQ(ReadTextFile(log), "one\ntwo\n");
}

TEST(OutputFile, ReplacesARegularFileOnly) {
  const TestFolder folder;
  const fs::path file = folder.Write("a.csv", "before");
  EXPECT_THAT(InputErrorOf([&] { CheckMayWrite(file, Overwrite::kRefuse); }),
              HasSubstr("a.csv: exists already; --force replaces it"));
  WriteOutputFile(file, "after", Overwrite::kAllow);
  EXPECT_EQ(ReadTextFile(file), "after");

  const fs::path pipe = folder.path() / "pipe", link = folder.path() / "link",
                 dangling = folder.path() / "dangling", device = folder.path() / "device";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink(file, link);
  fs::create_symlink("nowhere", dangling);
  fs::create_symlink("/dev/null", device);
  for (const fs::path& other : {pipe, link, dangling, device, fs::path("/dev/null")}) {
    for (const Overwrite overwrite : {Overwrite::kRefuse, Overwrite::kAllow}) {
      EXPECT_THAT(InputErrorOf([&] { WriteOutputFile(other, "lost", overwrite); }),
                  HasSubstr("is a link, device or pipe, which is never replaced"));
    }
  }
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(ReadTextFile(file), "after");
  EXPECT_FALSE(fs::exists(folder.path() / "nowhere"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_THAT(InputErrorOf([&] { WriteOutputFile(folder.path(), "", Overwrite::kAllow); }),
              HasSubstr("is a folder; expected a file"));
}

TEST(OutputFile, TellsWhyAFolderCannotBeReached) {
  const TestFolder folder;
  const auto problem = [&](const char* file) {
    return InputErrorOf([&] { CheckMayWrite(folder.path() / file, Overwrite::kRefuse); });
  };
  fs::create_symlink("loop", folder.path() / "loop");
  folder.Write("file", "");
  EXPECT_THAT(problem("loop/a.csv"),
              HasSubstr("loop: cannot be read: Too many levels of symbolic"));
  EXPECT_THAT(problem("file/a.csv"), HasSubstr("file: expected a folder"));
  EXPECT_THAT(problem("none/a.csv"), HasSubstr("none: no such folder"));
}

}  // namespace
}  // namespace clothfit
