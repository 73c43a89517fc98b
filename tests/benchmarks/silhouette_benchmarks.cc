// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Silhouettes of a crumpled cloth of 900 particles in pictures of 640 x 480 pixels: drawn by the
// raster and, beside it, by Embree's rays through the centres of all pixels; compared; and the
// outline that the soft error needs.
#include <benchmark/benchmark.h>

#include "tests/support/crumpled_cloth.h"
#include "tests/support/flat_scene.h"
#include "tracking/recording/surface/cloth_surface.h"
#include "tracking/silhouette/outline.h"
#include "tracking/silhouette/raster.h"

namespace clothfit {
namespace {

struct View {
  CrumpledCloth cloth = Crumple(3, 0.15, 30);
  Camera camera;

  explicit View(bool bent_lens) {
    constexpr double kFocal = 500.0;  // px: the cloth fills a third of the picture
    camera = LookAt({0.4, -0.6, 0.9}, {0.4, 0.3, 0.0}, kFocal);
    camera.width = 640;
    camera.height = 480;
    camera.cx = 319.5;
    camera.cy = 239.5;
    if (bent_lens) camera.distortion = {-0.2, 0.05, 0.002, -0.001, 0.01};
  }
};

void BM_DrawSilhouette(benchmark::State& state) {
  const View view(state.range(0) != 0);
  const SilhouetteRaster raster(view.camera, view.cloth.mesh.triangles);
  BitMask mask;
  for (auto _ : state) {
    raster.Draw(view.cloth.x, &mask);
    benchmark::DoNotOptimize(mask);
  }
  state.counters["silhouettes/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["covered"] = static_cast<double>(mask.Count());
}
BENCHMARK(BM_DrawSilhouette)->ArgName("bent")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond);

void BM_CompareSilhouettes(benchmark::State& state) {
  const View view(false);
  const SilhouetteRaster raster(view.camera, view.cloth.mesh.triangles);
  BitMask mask, other;
  raster.Draw(view.cloth.x, &mask);
  raster.Draw(1.01 * view.cloth.x, &other);
  for (auto _ : state) benchmark::DoNotOptimize(CountDifferences(mask, other));
}
BENCHMARK(BM_CompareSilhouettes)->Unit(benchmark::kMicrosecond);

void BM_RaysThroughAllPixels(benchmark::State& state) {
  const View view(false);
  ClothSurface surface(view.cloth.mesh);
  for (auto _ : state) {
    surface.MoveTo(view.cloth.x);
    int covered = 0;
    for (int y = 0; y < view.camera.height; ++y) {
      for (int x = 0; x < view.camera.width; ++x)
        covered += surface.SeenAt(view.camera, Eigen::Vector2d(x, y)) ? 1 : 0;
    }
    benchmark::DoNotOptimize(covered);
  }
}
BENCHMARK(BM_RaysThroughAllPixels)->Unit(benchmark::kMicrosecond);

void BM_FindOutline(benchmark::State& state) {
  const View view(false);
  const SilhouetteRaster raster(view.camera, view.cloth.mesh.triangles);
  const std::vector<MeshEdge> edges = FindEdges(view.cloth.mesh.triangles);
  BitMask mask;
  raster.Draw(view.cloth.x, &mask);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        FindOutline(view.camera, edges, view.cloth.mesh.triangles, view.cloth.x, mask));
  }
}
BENCHMARK(BM_FindOutline)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace clothfit
