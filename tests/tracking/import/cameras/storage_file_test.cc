// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/cameras/storage_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class StorageFile : public testing::Test {
 protected:
  // What OpenCV writes, and what is of no interest between it.
  std::filesystem::path WriteAll(const std::string& name, int more = 0) const {
    const std::filesystem::path file = folder_.path() / name;
    cv::FileStorage storage(file.string(), cv::FileStorage::WRITE | more);
    storage << "text"
            << "a: \"b\" <c> & [d]";
    storage.writeComment("a comment: {");
    storage << "matrix" << cv::Mat(cv::Matx22d(0.1, -2e-20, 3, 1e6 / 3));
    storage << "bytes" << cv::Mat(cv::Matx<unsigned char, 1, 3>(0, 7, 255));
    storage << "channels" << cv::Mat(cv::Mat_<cv::Vec3i>(1, 2, cv::Vec3i(1, -2, 3)));
    storage << "vector" << cv::Vec3d(1, 2, 0.25) << "number" << 640;
    storage << "matrices" << std::vector<cv::Mat>(2, cv::Mat::eye(2, 2, CV_32F));
    storage << "none" << cv::Mat();
    storage.writeComment("the end");
    return file;
  }

  std::vector<double> Numbers(const std::string& text) const {
    return StorageNumbers(ReadStorageFile(folder_.Write("a.yml", text)).at(0)["K"], "K");
  }
  std::string ErrorOf(const std::string& text) const {
    return InputErrorOf([&] { Numbers(text); });
  }

  TestFolder folder_;
};

TEST_F(StorageFile, HasTheNumbersThatOpencvWrites) {
  int checked = 0;
  for (const int base64 : {0, static_cast<int>(cv::FileStorage::BASE64)}) {
    for (const char* name : {"a.yml", "a.xml", "a.json"}) {
      const std::vector<YAML::Node> documents = ReadStorageFile(WriteAll(name, base64));
      ASSERT_EQ(documents.size(), 1u);
      const auto numbers = [&](const char* key) { return StorageNumbers(documents[0][key], key); };
      EXPECT_THAT(numbers("matrix"), ElementsAre(0.1, -2e-20, 3, 1e6 / 3));
      EXPECT_THAT(numbers("bytes"), ElementsAre(0, 7, 255));
      EXPECT_THAT(numbers("channels"), ElementsAre(1, -2, 3, 1, -2, 3));
      EXPECT_THAT(numbers("vector"), ElementsAre(1, 2, 0.25));
      EXPECT_THAT(numbers("number"), ElementsAre(640));
      EXPECT_THAT(InputErrorOf([&] { numbers("matrices"); }), HasSubstr("expected a matrix or"));
      EXPECT_THAT(InputErrorOf([&] { numbers("none"); }), HasSubstr("found 0 x 0"));
      EXPECT_THAT(InputErrorOf([&] { numbers("text"); }), HasSubstr("text: expected a matrix or"));
      ++checked;
    }
  }
  EXPECT_EQ(checked, 6);
}

TEST_F(StorageFile, MayHaveBeenAppendedTo) {
  const std::filesystem::path file = WriteAll("a.yml");
  cv::FileStorage more(file.string(), cv::FileStorage::APPEND);
  more << "later" << cv::Vec3d(4, 5, 6);
  more.release();
  const std::vector<YAML::Node> documents = ReadStorageFile(file);
  ASSERT_EQ(documents.size(), 2u);
  EXPECT_THAT(StorageNumbers(documents[1]["later"], ""), ElementsAre(4, 5, 6));
  std::string many = "K: 1\n";
  for (int i = 0; i < 100; ++i) many += "...\n---\nK: 1\n";
  EXPECT_THAT(ErrorOf(many), HasSubstr("has more than 100 documents"));
}

TEST_F(StorageFile, MayBeWrittenByOthers) {
  EXPECT_THAT(Numbers("{\n\t\"K\":[[1,2],\n\t[3,4.]],\"s\":\"//\"}"), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(Numbers("\xef\xbb\xbf%YAML:1.0\r\n---\r\nK: [1, 2]\r\n"), ElementsAre(1, 2));
  EXPECT_THAT(Numbers("%YAML:1.0\nK: +1.5e3\n"), ElementsAre(1500));
  EXPECT_THAT(Numbers("<a><K a=\"b\"><_>1 2</_><!-- <_> --><_>3</_></K><empty/></a>"),
              ElementsAre(1, 2, 3));
}

TEST_F(StorageFile, IsRefusedWhereItIsDamaged) {
  EXPECT_THAT(ErrorOf("K: [1, 2\n"), HasSubstr("a.yml: line 2: column 1: end of sequence"));
  EXPECT_THAT(ErrorOf("a: 1\n...\n---\nK: a: b\n"), HasSubstr("a.yml: line 4: column 5: illegal"));
  EXPECT_THAT(ErrorOf("- 1\n"), HasSubstr("a.yml: expected keys and values"));
  EXPECT_THAT(ErrorOf(""), HasSubstr("a.yml: is empty"));
  EXPECT_THAT(ErrorOf("<a>\n <K>1</k></a>"),
              HasSubstr("a.yml: line 2: column 10: expected the end of 'K', found that of 'k'"));
  EXPECT_THAT(ErrorOf("<a><K>1</K>"), HasSubstr("expected another tag, found the end"));
  EXPECT_THAT(ErrorOf("<a><K>1<K</a>"), HasSubstr("has a tag that does not end"));
  EXPECT_THAT(ErrorOf("<a><!-- K</a>"), HasSubstr("has a tag that does not end"));
  EXPECT_THAT(ErrorOf("<a><>"), HasSubstr("has a tag without a name"));
  EXPECT_THAT(ErrorOf("<a><K><_>1</_><b/></K></a>"), HasSubstr("found both in 'K'"));
  EXPECT_THAT(ErrorOf("<a><K><_>1</_>2</K></a>"), HasSubstr("found both in 'K'"));
}

TEST_F(StorageFile, HoldsNoMoreNumbersThanItSays) {
  const std::string matrix = "K: {rows: 1, cols: 2, dt: d, data: ";
  EXPECT_THAT(Numbers(matrix + "[1, 2]}"), ElementsAre(1, 2));
  EXPECT_THAT(ErrorOf(matrix + "[1]}"), HasSubstr("K: expected 2 numbers, found 1"));
  EXPECT_THAT(ErrorOf(matrix + "[1, .Nan]}"), HasSubstr("finite numbers, found '.Nan'"));
  EXPECT_THAT(ErrorOf(matrix + std::string(40, 'A') + "}"), HasSubstr("2 numbers in base 64"));
  EXPECT_THAT(ErrorOf(matrix + "A\xc3\xa9" + std::string(40, 'A') + "}"),
              HasSubstr("2 numbers in base 64"));
  EXPECT_THAT(ErrorOf("K: {rows: 1, cols: 2, data: [1, 2]}"), HasSubstr("rows, cols, dt and data"));
  EXPECT_THAT(ErrorOf("K: {rows: 2000000, cols: 2000000, dt: d, data: [1]}"),
              HasSubstr("found 2000000 x 2000000"));
  EXPECT_THAT(ErrorOf("K: {rows: -1, cols: -1, dt: d, data: [1]}"), HasSubstr("found -1 x -1"));
  std::string many = "[1";
  for (int i = 0; i < 1000; ++i) many += ", 1";
  EXPECT_THAT(ErrorOf("K: " + many + "]"), HasSubstr("at most 1000 finite numbers"));
}

// Lists of lists that a few bytes make: in themselves, of aliases, of nothing.
TEST_F(StorageFile, DoesNotMultiply) {
  EXPECT_THAT(ErrorOf("K: &a [*a]\n"), HasSubstr("K: expected a matrix or a list of numbers"));
  std::string bomb = "a0: &a0 []\n";
  for (int i = 1; i < 60; ++i) bomb += fmt::format("a{0}: &a{0} [*a{1}, *a{1}]\n", i, i - 1);
  EXPECT_THAT(ErrorOf(bomb + "K: *a59\n"), HasSubstr("K: expected a matrix or a list of numbers"));
  EXPECT_THAT(ErrorOf(bomb + "K: *a2\n"), HasSubstr("K: expected a matrix or a list of numbers"));
}

}  // namespace
}  // namespace clothfit
