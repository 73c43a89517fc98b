// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/text/json_text.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

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

TEST(JsonText, IsReadAsWhatIsMadeOfIt) {
  const TestFolder folder;
  const auto size = [](const nlohmann::json& json) { return json.at("size").get<int>(); };
  EXPECT_EQ(ReadJson(folder.Write("a.json", R"({"size": 3})"), "is no sheet", size), 3);
  for (const char* wrong : {"{", "[]", "{}", R"({"size": "3"})"}) {
    const auto file = folder.Write("wrong.json", wrong);
    EXPECT_THAT(InputErrorOf([&] { ReadJson(file, "is no sheet", size); }),
                testing::HasSubstr("wrong.json: is no sheet: [json.exception."))
        << wrong;
  }
}

TEST(JsonText, HasNullForWhatIsNoNumber) {
  EXPECT_EQ(OrNull(0.5), 0.5);
  EXPECT_TRUE(OrNull(std::nullopt).is_null());
  EXPECT_TRUE(OrNull(std::numeric_limits<double>::infinity()).is_null());
  EXPECT_TRUE(OrNull(std::nan("")).is_null());
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
  EXPECT_FALSE(IsShallowCbor(std::string(10'000'000, '\xbf')));
}

// The parser calls itself for every piece of a string.
TEST(JsonText, IsRefusedAsCborWhereStringsHaveNoLength) {
  for (const char kind : {'\x7f', '\x5f'}) {
    EXPECT_FALSE(IsShallowCbor(std::string(10'000'000, kind)));
    EXPECT_FALSE(IsShallowCbor(std::string("\x82\x61\x41") + kind + "\x61\x41\xff"));
  }
}

TEST(JsonText, IsTakenAsCborWhateverItsStringsAndNumbersAre) {
  nlohmann::json json = {{"text", std::string(300, '\x7f')}, {"empty", nlohmann::json::array()}};
  for (const std::size_t size : {0, 23, 24, 255, 256, 65536}) {
    json["sizes"].push_back({std::string(size, '_'), std::vector<double>(size / 8, 1e300), size,
                             -static_cast<std::int64_t>(size), nlohmann::json::binary({1, 0x5f})});
  }
  json["deep"] = nlohmann::json::parse(Nested(kMostJsonLevels - 1));
  std::string bytes;
  nlohmann::json::to_cbor(json, bytes);
  EXPECT_TRUE(IsShallowCbor(bytes));
  json["deep"] = nlohmann::json::parse(Nested(kMostJsonLevels));  // its map is another level
  bytes.clear();
  nlohmann::json::to_cbor(json, bytes);
  EXPECT_FALSE(IsShallowCbor(bytes));
}

TEST(JsonText, IsNotReadBeyondItsEndAsCbor) {
  for (const char* cut : {"", "\x9b", "\x9b\x01", "\x7b\xff\xff\xff\xff\xff\xff\xff\xff", "\xff",
                          "\xfb\x01", "\xc1\x01", "\x5c", "\xbb\xff\xff\xff\xff\xff\xff\xff\xff"})
    EXPECT_TRUE(IsShallowCbor(cut)) << cut;
}

}  // namespace
}  // namespace clothfit
