// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/text/text.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

TEST(ParseNumber, ReadsDecimalsAndExponents) {
  EXPECT_EQ(ParseNumber("1.5"), 1.5);
  EXPECT_EQ(ParseNumber(" -2e-3 "), -2e-3);
  EXPECT_EQ(ParseNumber("+4"), 4.0);
  EXPECT_EQ(ParseNumber(".5"), 0.5);
}

TEST(ParseNumber, RefusesEverythingElse) {
  for (const char* text :
       {"", " ", "abc", "1.5x", "1,5", "nan", "inf", "-inf", "1e400", "0x10", "1 2", "+-1", "+"}) {
    EXPECT_FALSE(ParseNumber(text)) << text;
  }
}

TEST(ParseInteger, RefusesFractionsAndOverflow) {
  EXPECT_EQ(ParseInteger("-7"), -7);
  for (const char* text : {"1.0", "1e3", "", "99999999999", "a"}) {
    EXPECT_FALSE(ParseInteger(text)) << text;
  }
}

TEST(FormatNumber, ReadsBackAsTheSameDouble) {
  std::mt19937_64 random(1);
  int checked = 0;
  for (int i = 0; i < 2000; ++i) {
    const double value =
        std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 200) - 150);
    ASSERT_EQ(ParseNumber(FormatNumber(value)), value);
    ++checked;
  }
  EXPECT_EQ(checked, 2000);
  EXPECT_EQ(FormatNumber(0.1), "0.1");
  EXPECT_TRUE(std::signbit(*ParseNumber(FormatNumber(-0.0))));
}

TEST(TextFile, ReportsWhatCannotBeRead) {
  const TestFolder folder;
  EXPECT_THAT(InputErrorOf([&] { ReadTextFile(folder.path() / "none.txt"); }),
              testing::HasSubstr("none.txt: no such file"));
  folder.Write("a/b.txt", "text\n");
  EXPECT_EQ(ReadTextFile(folder.path() / "a" / "b.txt"), "text\n");
}

TEST(Quantity, HasTwoDigitsOrSo) {
  EXPECT_EQ(QuantityInWords(0.00284, "m"), "2.8 mm");
  EXPECT_EQ(QuantityInWords(0.0113, "m"), "11 mm");
  EXPECT_EQ(QuantityInWords(0.3306, "px"), "0.33 px");
}

TEST(Sentence, BeginsWithACapitalAndEndsWithAFullStop) {
  EXPECT_EQ(AsSentence("the fit ends"), "The fit ends.");
  EXPECT_EQ(AsSentence("It is said."), "It is said.");
  EXPECT_EQ(AsSentence(""), "");
}

}  // namespace
}  // namespace clothfit
