// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/parameter_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/gravity.h"
#include "autodiff_sim/terms/shear.h"

namespace clothfit {
namespace {

std::string ProblemOf(const std::string& name, const std::string& place) {
  try {
    RequireParameter(MakeParameterTable(), name, place);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RequireParameter, FindsWhatIsThere) {
  const std::vector<NamedParameter> table = MakeParameterTable();
  EXPECT_EQ(RequireParameter(table, "cloth.shrink_weft"), kShrinkWeft);
  for (const NamedParameter& named : table)
    EXPECT_EQ(RequireParameter(table, named.name), FindParameter(table, named.name));
}

// An index of -1 would be read, or written, before the first parameter.
TEST(RequireParameter, NamesTheNearestOfWhatIsNot) {
  EXPECT_EQ(FindParameter(MakeParameterTable(), "air_drag.norml"), -1);
  EXPECT_EQ(ProblemOf("air_drag.norml", "--set"),
            "--set: 'air_drag.norml' is no parameter; did you mean 'air_drag.normal'?");
  EXPECT_THAT(ProblemOf("%", "parameters"), testing::StartsWith("parameters: '%' is no parameter"));
}

TEST(ValuesOf, NamesThemInTheTermsOrder) {
  const std::map<std::string, double> values = ValuesOf<Gravity, Shear>({1.0}, {20.0, 0.1});
  EXPECT_THAT(values, testing::ElementsAre(testing::Pair("gravity.scale", 1.0),
                                           testing::Pair("shear.damping", 0.1),
                                           testing::Pair("shear.stiffness", 20.0)));
}

}  // namespace
}  // namespace clothfit
