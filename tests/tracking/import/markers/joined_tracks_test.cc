// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/markers/joined_tracks.h"

#include <gtest/gtest.h>

#include "tests/support/motive_file.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

std::vector<Eigen::Vector2d> GridPlaces() {
  std::vector<Eigen::Vector2d> uv;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) uv.emplace_back(0.1 * column, 0.08 * row);
  }
  return uv;
}

// The marker is lost after frame `last` and comes back at frame `first` under the name.
void Break(size_t marker, size_t last, size_t first, const std::string& name, MarkerTake* take) {
  MarkerPath later{name, take->markers[marker].positions};
  for (size_t frame = 0; frame < first; ++frame) later.positions[frame].reset();
  HandleDescription::Path& earlier = take->markers[marker].positions;
  for (size_t frame = last + 1; frame < earlier.size(); ++frame) earlier[frame].reset();
  take->markers.push_back(later);
}

TEST(JoinTracks, JoinsEachWithItsOwnPieces) {
  const MarkerTake whole = BentSheetTake(GridPlaces(), 1e-4);
  MarkerTake take = whole;
  Break(2, 28, 34, "n2", &take);
  Break(6, 25, 33, "n6", &take);
  Break(9, 45, 50, "o2", &take);  // a piece of a piece
  std::vector<std::string> notes;
  JoinTracks({}, &take, &notes);
  ASSERT_EQ(NamesOf(take), NamesOf(whole));
  EXPECT_EQ(notes.size(), 3u);
  EXPECT_THAT(notes.back() + notes.front(), HasSubstr("comes back at"));
  for (const size_t marker : {2u, 6u}) {
    for (size_t frame = 0; frame < whole.num_frames(); ++frame) {
      const auto& position = take.markers[marker].positions[frame];
      if (!position) continue;
      EXPECT_EQ(*position, *whole.markers[marker].positions[frame]);
    }
  }
  EXPECT_FALSE(take.markers[2].positions[30]);
  EXPECT_TRUE(take.markers[2].positions[59]);
}

TEST(JoinTracks, GoesByTheNamesThatAreKept) {
  MarkerTake take = BentSheetTake(GridPlaces(), 1e-4);
  Break(2, 28, 34, "n2", &take);
  MarkerTake both = take;
  std::vector<std::string> notes;
  JoinTracks({"n2"}, &take, &notes);
  EXPECT_EQ(take.markers[2].name, "n2");
  JoinTracks({"m2", "n2"}, &both, &notes);
  EXPECT_EQ(both.markers.size(), 10u);
}

TEST(JoinTracks, LeavesApartWhatIsNotOne) {
  MarkerTake take = BentSheetTake(GridPlaces(), 1e-4);
  Break(2, 28, 34, "elsewhere", &take);
  for (auto& position : take.markers.back().positions) {
    if (position) *position += Eigen::Vector3d(0.0, 0.5, 0.5);  // off the cloth, and too fast
  }
  Break(4, 20, 40, "never", &take);
  take.markers.back().positions.assign(60, std::nullopt);
  std::vector<std::string> notes;
  JoinTracks({}, &take, &notes);
  EXPECT_EQ(take.markers.size(), 10u);  // of those that are never seen none is left
  EXPECT_TRUE(notes.empty());
}

}  // namespace
}  // namespace clothfit
