// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/runs/recording_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/names.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

TEST(RecordingList, TellsFoldersOfOneNameApart) {
  EXPECT_THAT(NamesOf(ListRecordings({"a/silk", "b/silk", "c/silk-2", "d/silk/"}, {})),
              testing::ElementsAre("silk", "silk-2", "silk-2-2", "silk-3"));
}

TEST(RecordingList, HoldsOutThoseThatAreNamedOrOthers) {
  const auto listed = ListRecordings({"a", "b", "c"}, {"b", "d"});
  EXPECT_THAT(NamesOf(listed), testing::ElementsAre("a", "b", "c", "d"));
  std::vector<bool> held_out;
  for (const ListedRecording& one : listed) held_out.push_back(one.is_held_out);
  EXPECT_THAT(held_out, testing::ElementsAre(false, true, false, true));
}

TEST(RecordingList, RefusesWhatIsNamedTwiceAndNothingToFit) {
  EXPECT_THAT(InputErrorOf([] { ListRecordings({"a", "x/../a"}, {}); }), HasSubstr("named twice"));
  EXPECT_THAT(InputErrorOf([] { ListRecordings({"a"}, {"b", "b"}); }), HasSubstr("named twice"));
  EXPECT_THAT(InputErrorOf([] { ListRecordings({"a"}, {"a"}); }), HasSubstr("all recordings"));
}

TEST(RecordingList, IsReadBackAndRefusedWhereItIsDamaged) {
  const TestFolder folder;
  EXPECT_THAT(InputErrorOf([&] { ReadRecordingList(folder.path()); }),
              HasSubstr("is not the folder"));
  folder.Write(".clothfit.json",
               R"({"format": "clothfit-folder/1", "kind": "joint run", "files": {}})");
  const auto listed = ListRecordings({"a: b", "x/silk"}, {"silk"});
  WriteRecordingList(listed, folder.path());
  const auto again = ReadRecordingList(folder.path());
  ASSERT_EQ(again.size(), 3u);
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_EQ(again[i].name, listed[i].name);
    EXPECT_EQ(again[i].path, listed[i].path);
    EXPECT_EQ(again[i].is_held_out, i == 2);
  }
  const auto error_of = [&](const std::string& entry) {
    folder.Write("recordings.yaml", "format: clothfit-recordings/1\nrecordings: [" + entry + "]\n");
    return InputErrorOf([&] { ReadRecordingList(folder.path()); });
  };
  EXPECT_THAT(error_of("{name: ../a, path: a, hold_out: false}"), HasSubstr("name of one folder"));
  EXPECT_THAT(error_of("{name: a, path: a, hold_out: maybe}"), HasSubstr("true or false"));
  EXPECT_THAT(error_of("{name: a, path: a}"), HasSubstr("hold_out"));
}

}  // namespace
}  // namespace clothfit
