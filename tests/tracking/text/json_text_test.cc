// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/text/json_text.h"

#include <gmock/gmock.h>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

std::string Nested(int levels) {
  const auto count = static_cast<std::size_t>(levels);
  return std::string(count, '[') + std::string(count, ']');
}

TEST(JsonText, IsRefusedWhereItIsNestedTooDeep) {
  const TestFolder folder;
  const std::string allowed = Nested(kMostJsonLevels);
  EXPECT_EQ(ReadJsonText(folder.Write("a.json", allowed)), allowed);
  for (const std::string& deep : {Nested(kMostJsonLevels + 1), Nested(1'000'000)}) {
    const auto file = folder.Write("deep.json", deep);
    EXPECT_THAT(InputErrorOf([&] { ReadJsonText(file); }),
                testing::HasSubstr("deep.json: is nested too deep; expected at most 100 levels"));
  }
}

TEST(JsonText, MayHaveManyListsAndBracketsInStrings) {
  const TestFolder folder;
  std::string many = "[\"" + std::string(1000, '[') + "\"";
  for (int i = 0; i < 1000; ++i) many += ",[]";
  many += "]";
  EXPECT_EQ(ReadJsonText(folder.Write("many.json", many)), many);
  EXPECT_EQ(ReadJsonText(folder.Write("none.json", "no JSON")), "no JSON");
}

TEST(JsonText, IsRefusedAsCborWhereItIsNestedTooDeep) {
  const auto nested = [](std::size_t levels) { return std::string(levels, '\x81') + '\0'; };
  EXPECT_TRUE(IsShallowCbor(nested(kMostJsonLevels)));
  EXPECT_FALSE(IsShallowCbor(nested(kMostJsonLevels + 1)));
  EXPECT_FALSE(IsShallowCbor(nested(10'000'000)));
  EXPECT_FALSE(IsShallowCbor(std::string(10'000'000, '\x9f')));  // lists of no stated length
}

}  // namespace
}  // namespace clothfit
