// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/residual_correlation.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "fitting/diagnosis/fitted/faults.h"

namespace clothfit {

double CorrelationTime(const std::vector<std::vector<double>>& series) {
  constexpr double kNoMore = 0.05;
  std::size_t longest = 0;
  for (const std::vector<double>& values : series) longest = std::max(longest, values.size());
  const auto pooled = [&](std::size_t lag) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const std::vector<double>& values : series) {
      for (std::size_t i = 0; i + lag < values.size(); ++i, ++count)
        sum += values[i] * values[i + lag];
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
  };
  const double variance = pooled(0);
  double time = 1.0;
  for (std::size_t lag = 1; variance > 0.0 && 2 * lag < longest; ++lag) {
    const double correlation = pooled(lag) / variance;
    if (correlation < kNoMore) break;
    time += 2.0 * correlation;
  }
  return time;
}

double ResidualCorrelationTime(const FittedScene& fitted) {
  const ObservationResiduals observations(fitted.scene, fitted.config);
  constexpr int kAll = 1 << 30;
  const RowFrames frames(fitted.scene, observations, kAll);
  const std::optional<Rows> rows = EvaluateRows(fitted, {fitted.values, false, false}, frames, {});
  if (!rows) return 1.0;
  // Of a marker or a point in a camera, each of its coordinates.
  using Key = std::tuple<int, int, std::array<int, 3>, std::array<double, 3>, int>;
  std::map<Key, std::vector<double>> series;
  for (const int frame : frames.frames()) {
    const std::vector<ResidualSource> sources = SourcesOfFrame(fitted.scene, frame);
    std::map<Key, int> coordinates;
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const ResidualSource& source = sources[i];
      const bool is_point = source.kind == ResidualSource::Kind::kMarker ||
                            source.kind == ResidualSource::Kind::kTrack;
      if (!is_point) continue;
      Key key{static_cast<int>(source.kind), source.source, source.point.nodes,
              source.point.weights, 0};
      const int coordinate = coordinates[key]++;
      std::get<4>(key) = coordinate;
      series[key].push_back(rows->residuals[frames.FirstRow(frame) + static_cast<int>(i)]);
    }
  }
  std::vector<std::vector<double>> values;
  for (auto& [key, of_one] : series) values.push_back(std::move(of_one));
  return CorrelationTime(values);
}

}  // namespace clothfit
