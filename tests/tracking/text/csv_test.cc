// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/text/csv.h"

#include <gtest/gtest.h>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

struct Row {
  int line;
  int frame;
  double x;
};

std::vector<Row> ReadRows(const std::string& text) {
  const TestFolder folder;
  std::vector<Row> rows;
  ReadCsv(folder.Write("table.csv", text), {"frame", "x"}, [&](const CsvRow& row) {
    rows.push_back({row.line(), row.Integer(0), row.Number(1)});
  });
  return rows;
}

TEST(ReadCsv, ReadsRowsWithTheirLines) {
  const std::vector<Row> rows = ReadRows("frame,x\n3,1.5\n\n4,-2e-3\n");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].frame, 3);
  EXPECT_EQ(rows[0].x, 1.5);
  EXPECT_EQ(rows[1].x, -2e-3);
  EXPECT_EQ(rows[1].line, 4);
}

TEST(ReadCsv, TakesColumnsInAnyOrder) {
  const std::vector<Row> rows = ReadRows("x,frame\n1.5,3\n");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].frame, 3);
  EXPECT_EQ(rows[0].x, 1.5);
}

TEST(ReadCsv, PassesOverByteOrderMarkCarriageReturnsAndAMissingLastNewline) {
  const std::vector<Row> rows = ReadRows(
      "\xEF\xBB\xBF"
      "frame, x\r\n3, 1.5\r\n4,2");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1].x, 2.0);
}

TEST(ReadCsv, ReadsATableWithoutRows) { EXPECT_TRUE(ReadRows("frame,x\n").empty()); }

TEST(ReadCsv, RefusesWrongColumns) {
  EXPECT_THAT(InputErrorOf([] { ReadRows("framme,x\n"); }),
              HasSubstr("table.csv: line 1: unknown column 'framme'; did you mean 'frame'?"));
  EXPECT_THAT(InputErrorOf([] { ReadRows("frame\n"); }),
              HasSubstr("line 1: column 'x' is missing; expected the columns frame, x"));
  EXPECT_THAT(InputErrorOf([] { ReadRows("frame,x,x\n"); }), HasSubstr("appears more than once"));
  EXPECT_THAT(InputErrorOf([] { ReadRows(""); }), HasSubstr("unknown column ''"));
}

TEST(ReadCsv, RefusesWrongFields) {
  EXPECT_THAT(InputErrorOf([] { ReadRows("frame,x\n1,2\n1,nan\n"); }),
              HasSubstr("line 3: x: expected a finite number, found 'nan'"));
  EXPECT_THAT(InputErrorOf([] { ReadRows("frame,x\n1,\n"); }),
              HasSubstr("line 2: x: expected a finite number, found ''"));
  EXPECT_THAT(InputErrorOf([] { ReadRows("frame,x\n1.5,2\n"); }),
              HasSubstr("line 2: frame: expected an integer, found '1.5'"));
  EXPECT_THAT(InputErrorOf([] { ReadRows("frame,x\n1,2,3\n"); }),
              HasSubstr("line 2: expected 2 fields, found 3"));
}

TEST(ReadCsv, RefusesMoreThanThereMayBe) {
  EXPECT_THAT(InputErrorOf([] { ReadRows("frame,x\n1," + std::string(1001, '7') + "\n"); }),
              HasSubstr("line 2: x: expected at most 1000 bytes, found '777"));
  const std::string commas(1'000'000, ',');
  EXPECT_THAT(InputErrorOf([&] { ReadRows("frame,x\n1" + commas); }),
              HasSubstr("line 2: expected 2 fields, found 1000001"));
  EXPECT_THAT(InputErrorOf([&] { ReadRows("frame,x" + commas + "\n"); }),
              HasSubstr("unknown column ''"));
  const TestFolder folder;
  const auto file = folder.Write("table.csv", "x\n1\n\n2\n3\n");
  int rows = 0;
  const auto read = [&](std::size_t most) {
    ReadCsv(
        file, {"x"}, [&](const CsvRow&) { ++rows; }, most);
  };
  read(3);
  EXPECT_EQ(rows, 3);
  EXPECT_THAT(InputErrorOf([&] { read(2); }), HasSubstr("line 5: expected at most 2 rows"));
}

TEST(CsvRow, IsMissingWantsAllOrNone) {
  const TestFolder folder;
  std::vector<bool> missing;
  const auto visit = [&](const CsvRow& row) { missing.push_back(row.IsMissing(0, 2)); };
  ReadCsv(folder.Write("a.csv", "x,y\n1,2\n,\n"), {"x", "y"}, visit);
  EXPECT_EQ(missing, (std::vector<bool>{false, true}));
  const auto file = folder.Write("b.csv", "x,y\n1,\n");
  EXPECT_THAT(InputErrorOf([&] {
                ReadCsv(file, {"x", "y"}, visit);
              }),
              HasSubstr("line 2: y: is empty while its neighbours are not"));
}

}  // namespace
}  // namespace clothfit
