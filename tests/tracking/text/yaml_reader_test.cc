// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/text/yaml_reader.h"

#include <gtest/gtest.h>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

YamlValue Load(const std::string& text) {
  const TestFolder folder;
  return YamlValue::Load(folder.Write("file.yaml", text));
}

TEST(YamlValue, ReadsEveryType) {
  const YamlValue top =
      Load("number: 1e-3\ninteger: 7\ntext: abc\npair: [1, 2]\nlist: [1, 2.5, 3]\n");
  EXPECT_EQ(top.Require("number").Number(), 1e-3);
  EXPECT_EQ(top.Require("integer").Integer(), 7);
  EXPECT_EQ(top.Require("text").Text(), "abc");
  EXPECT_EQ(top.Require("pair").IntegerPair(), Eigen::Vector2i(1, 2));
  EXPECT_EQ(top.Require("pair").Vector2(), Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(top.Require("list").Vector3(), Eigen::Vector3d(1.0, 2.5, 3.0));
  EXPECT_EQ(top.Require("list").Items().size(), 3u);
  EXPECT_EQ(top.Entries().size(), 5u);
  EXPECT_FALSE(top.Find("none"));
}

TEST(YamlValue, NamesTheWholeKeyOfWhatIsWrong) {
  const YamlValue top = Load("a: {b: [{c: x}]}\n");
  const YamlValue c = top.Require("a").Require("b").Items()[0].Require("c");
  EXPECT_THAT(InputErrorOf([&] { c.Number(); }),
              EndsWith("file.yaml: a.b[0].c: expected a finite number, found 'x'"));
}

TEST(YamlValue, RefusesWrongTypes) {
  const YamlValue top =
      Load("text: abc\nlist: [1, 2]\nmap: {a: 1}\nnan: .nan\nempty:\nreal: 1.5\n");
  const auto error = [&](const std::string& key, void (*read)(const YamlValue&)) {
    return InputErrorOf([&] { read(top.Require(key)); });
  };
  EXPECT_THAT(error("list", [](const YamlValue& v) { v.Number(); }),
              HasSubstr("found a list of 2"));
  EXPECT_THAT(error("map", [](const YamlValue& v) { v.Text(); }), HasSubstr("found a map"));
  EXPECT_THAT(error("nan", [](const YamlValue& v) { v.Number(); }), HasSubstr("found '.nan'"));
  EXPECT_THAT(error("empty", [](const YamlValue& v) { v.Text(); }), HasSubstr("found nothing"));
  EXPECT_THAT(error("real", [](const YamlValue& v) { v.Integer(); }), HasSubstr("found '1.5'"));
  EXPECT_THAT(error("list", [](const YamlValue& v) { v.Vector3(); }),
              HasSubstr("expected a list of 3 numbers, found a list of 2"));
  EXPECT_THAT(error("text", [](const YamlValue& v) { v.Items(); }), HasSubstr("expected a list"));
  EXPECT_THAT(error("text", [](const YamlValue& v) { v.Find("a"); }), HasSubstr("expected a map"));
}

TEST(YamlValue, RefusesUnknownRepeatedAndMissingKeys) {
  EXPECT_THAT(InputErrorOf([] {
                Load("sizze: 1\n").AllowKeys({"size", "name"});
              }),
              EndsWith("file.yaml: sizze: unknown key; did you mean 'size'?"));
  EXPECT_THAT(InputErrorOf([] { Load("size: 1\nsize: 2\n").AllowKeys({"size"}); }),
              EndsWith("size: appears twice"));
  EXPECT_THAT(InputErrorOf([] { Load("a: 1\n").Require("size"); }),
              EndsWith("file.yaml: size: required key is missing"));
}

TEST(YamlValue, RefusesWhatIsNoYaml) {
  EXPECT_THAT(InputErrorOf([] { Load("a: 1\nb: [1, 2\n"); }), HasSubstr("file.yaml: line "));
  EXPECT_THAT(InputErrorOf([] { Load("- 1\n"); }), HasSubstr("expected a map"));
  EXPECT_THAT(InputErrorOf([] { Load(""); }), HasSubstr("expected a map"));
}

TEST(YamlText, ReadsBackAsTheSameText) {
  int checked = 0;
  for (const char* text : {"plain-name_1", "1.5", "a: b", "true", "null", " x ", "say \"hi\"", "#a",
                           "back\\slash", "[a", "caf\xC3\xA9", "~"}) {
    EXPECT_EQ(Load("key: " + YamlText(text) + "\n").Require("key").Text(), text);
    ++checked;
  }
  EXPECT_EQ(checked, 12);
  EXPECT_EQ(YamlText("handles/corner_a.csv"), "handles/corner_a.csv");
}

}  // namespace
}  // namespace clothfit
