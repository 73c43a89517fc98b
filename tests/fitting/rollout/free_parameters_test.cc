// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/rollout/free_parameters.h"

#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/config/config.h"
#include "fitting/scene/scene.h"
#include "tests/support/small_recording.h"

namespace clothfit {
namespace {

// exp(log(100)) is above 100, which no fit could be given as a start: what ends at a bound is
// there.
TEST(FreeParameters, EndAtTheirBoundsToTheBit) {
  const Recording recording = MakeSmallRecording();
  FitConfig config = DefaultConfig(recording);
  const FreeParameters free(config, MakeScene(recording, config), MakeParameterTable());
  for (const int i : free.Fabric()) {
    const FreeEntry& entry = free.entries()[static_cast<std::size_t>(i)];
    const ParameterSetting& setting = config.parameters.at(entry.name);
    EXPECT_EQ(free.UnitValue(i, entry.lower), setting.lower) << entry.name;
    EXPECT_EQ(free.UnitValue(i, entry.upper), setting.upper) << entry.name;
  }
  EXPECT_EQ(free.Values(free.upper())[FindParameter(MakeParameterTable(), "stretch.damping")],
            config.parameters.at("stretch.damping").upper);
}

}  // namespace
}  // namespace clothfit
