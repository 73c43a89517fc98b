// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the fuzzers begin from, and what has broken a reader once, without libFuzzer. Broken inputs
// are kept beside the seeds, as seeds/READER/broken-*.
#include <algorithm>
#include <ostream>

#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "tests/fuzz/readers.h"

namespace clothfit {

void PrintTo(const FuzzedReader& reader, std::ostream* stream) { *stream << reader.name; }

namespace {

namespace fs = std::filesystem;

const fs::path kSeeds = fs::path(CLOTHFIT_SOURCE_DIR) / "tests/fuzz/seeds";

class Seeds : public testing::TestWithParam<FuzzedReader> {
 protected:
  ~Seeds() override { fs::remove_all(FuzzFolder()); }
};

TEST_P(Seeds, AreTaken) {
  int taken = 0;
  for (const fs::path& seed : ListInputFolder(kSeeds / GetParam().name)) {
    const bool is_broken = seed.filename().string().rfind("broken-", 0) == 0;
    const std::string bytes = ReadInputFile(seed);
    try {
      GetParam().read(bytes);
      ++taken;
    } catch (const InputError& error) {
      EXPECT_TRUE(is_broken) << seed << ": " << error.what();
    }
    // Cut off anywhere it is no crash either.
    for (const std::size_t share : {1, 2, 3}) {
      try {
        GetParam().read(bytes.substr(0, bytes.size() * share / 4));
      } catch (const InputError&) {  // as it should be
      }
    }
  }
  EXPECT_GT(taken, 0);
}

INSTANTIATE_TEST_SUITE_P(Readers, Seeds, testing::ValuesIn(FuzzedReaders()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(SeedFolders, AreThoseOfReaders) {
  int checked = 0;
  for (const fs::path& folder : ListInputFolder(kSeeds)) {
    const auto has_its_name = [&](const FuzzedReader& reader) {
      return folder.filename() == reader.name;
    };
    EXPECT_TRUE(std::any_of(FuzzedReaders().begin(), FuzzedReaders().end(), has_its_name))
        << folder;
    ++checked;
  }
  EXPECT_GT(checked, 0);
}

}  // namespace
}  // namespace clothfit
