// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/base/printable.h"

#include <gtest/gtest.h>

namespace clothfit {
namespace {

TEST(Printable, LeavesTextAsItIs) {
  for (const char* text : {"", "cotton 1", "Ünïcode, 布, \xf0\x9f\xa7\xb5"})
    EXPECT_EQ(Printable(text), text);
}

TEST(Printable, SteersNoTerminal) {
  EXPECT_EQ(Printable("a\nb\tc\rd"), "a b c d");
  EXPECT_EQ(Printable("\x1b[2J\x7f"), "\\x1b[2J\\x7f");
  EXPECT_EQ(Printable("\xc2\x9b"), "\\u009b");  // one character that begins commands
  EXPECT_EQ(Printable("a\xe2\x80\xae"
                      "b"),
            "a\\u202eb");  // from right to left from here on
  EXPECT_EQ(Printable("\xff"
                      "a\xc3"),
            "\\xffa\\xc3");                                                   // no UTF-8
  EXPECT_EQ(Printable("\xc0\x9b\xe0\x82\x9b"), "\\xc0\\x9b\\xe0\\x82\\x9b");  // spelt too long
  EXPECT_EQ(Printable(std::string("a\0b", 3)), "a\\x00b");
}

TEST(Printable, KeepsTheBeginningAndTheEndOfWhatIsLong) {
  const std::string text = "first" + std::string(1'000'000, 'x') + "last";
  const std::string shown = Printable(text, 60);
  EXPECT_EQ(shown.substr(0, 5), "first");
  EXPECT_EQ(shown.substr(shown.size() - 4), "last");
  EXPECT_LE(shown.size(), 65u);
  // Escapes count as they are shown; no character is cut.
  EXPECT_LE(Printable(std::string(50, '\x1b'), 60).size(), 65u);
  std::string wide;
  for (int i = 0; i < 100; ++i) wide += "布";
  EXPECT_EQ(Printable(wide, 60).find('\\'), std::string::npos);
}

TEST(Quoted, IsShort) { EXPECT_LE(Quoted(std::string(1000, 'x')).size(), 130u); }

}  // namespace
}  // namespace clothfit
