// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/files/evaluation_journal.h"

#include <cmath>

#include "tests/support/test_folder.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

const Eigen::Vector3d kAt(1.0 / 3.0, -1e-300, std::nextafter(1.0, 2.0));
const Eigen::Vector2d kNumbers(1e300, 0.1);

TEST(EvaluationJournal, HasWhatWasAddedOnceAndInOrder) {
  const TestFolder folder;
  const std::filesystem::path file = folder.path() / "journal";
  {
    EvaluationJournal journal(file);
    EXPECT_FALSE(journal.Recall("a", kAt));
    journal.Add("a", kAt, kNumbers);
    EXPECT_FALSE(journal.Recall("a", kAt)) << "only what was there when it was opened";
    journal.Add("a", kAt, 2.0 * kNumbers);
    journal.Add("b", kAt, Eigen::VectorXd());
  }
  EvaluationJournal again(file);
  EXPECT_FALSE(again.Recall("a", 2.0 * kAt));
  EXPECT_EQ(again.Recall("a", kAt), Eigen::VectorXd(kNumbers));
  EXPECT_EQ(again.Recall("a", kAt), Eigen::VectorXd(2.0 * kNumbers));
  EXPECT_FALSE(again.Recall("a", kAt));
  EXPECT_EQ(again.Recall("b", kAt)->size(), 0);
}

TEST(EvaluationJournal, EndsBeforeWhatIsDamagedAndGoesOnThere) {
  const TestFolder folder;
  const std::filesystem::path file = folder.path() / "journal";
  std::size_t one = 0;
  {
    EvaluationJournal journal(file);
    journal.Add("a", kAt, kNumbers);
    one = ReadTextFile(file).size();
    journal.Add("b", kAt, kNumbers);
  }
  const std::string whole = ReadTextFile(file);
  int checked = 0;
  for (std::size_t size = one; size <= whole.size(); ++size, ++checked) {
    std::string bytes = whole.substr(0, size);
    if (size == whole.size()) bytes.back() ^= 1;
    folder.Write("journal", bytes);
    EvaluationJournal journal(file);
    EXPECT_EQ(ReadTextFile(file), whole.substr(0, one));
    EXPECT_TRUE(journal.Recall("a", kAt));
    EXPECT_FALSE(journal.Recall("b", kAt));
    journal.Add("b", kAt, kNumbers);
    EXPECT_EQ(ReadTextFile(file), whole);
  }
  EXPECT_GT(checked, 20);
}

TEST(EvaluationJournal, TakesNothingOfAnotherVersion) {
  const TestFolder folder;
  const std::filesystem::path file = folder.path() / "journal";
  EvaluationJournal(file).Add("a", kAt, kNumbers);
  std::string bytes = ReadTextFile(file);
  ++bytes[bytes.find('/') + 1];
  folder.Write("journal", bytes);
  EXPECT_FALSE(EvaluationJournal(file).Recall("a", kAt));
}

}  // namespace
}  // namespace clothfit
