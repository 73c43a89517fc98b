// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/effect_table.h"

#include <exception>
#include <map>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "fitting/trials/recording.h"

namespace clothfit {
namespace {

struct Piece {
  Trial trial;
  std::size_t row, size;
};

// The same motion and effect of a cloth of the typical fabric.
Trial WithTypicalFabric(Trial trial) {
  for (const auto& [name, value] : TypicalParameters(trial.fabric))
    trial.recording.parameters[name] = value;
  return trial;
}

std::size_t RowOf(const Trial& trial, std::vector<MeasuredEffect>* rows) {
  for (std::size_t i = 0; i < rows->size(); ++i) {
    if ((*rows)[i].term == trial.effects[0].term && (*rows)[i].motion == trial.recording.scenario)
      return i;
  }
  MeasuredEffect row;
  row.term = trial.effects[0].term;
  row.motion = trial.recording.scenario;
  row.fabric = trial.fabric;
  rows->push_back(row);
  return rows->size() - 1;
}

// The first trial of every effect, motion and size.
std::vector<Piece> PiecesOf(const std::vector<Trial>& trials, std::vector<MeasuredEffect>* rows) {
  std::vector<Piece> pieces;
  std::vector<std::array<bool, 3>> has;
  for (const Trial& trial : trials) {
    if (trial.effects.size() != 1) continue;
    const std::size_t row = RowOf(trial, rows);
    has.resize(rows->size(), {false, false, false});
    const auto size = static_cast<std::size_t>(trial.effects[0].size);
    if (has[row][size]) continue;
    has[row][size] = true;
    pieces.push_back({WithTypicalFabric(trial), row, size});
  }
  return pieces;
}

// The motions without effects, each motion and fabric once.
class StillMotions {
 public:
  const std::vector<TruthPoint>& Of(const Trial& trial) {
    const auto key = std::make_pair(trial.recording.scenario, trial.fabric);
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<TruthPoint>& points = points_[key];
    if (points.empty()) points = TruePoints(WithoutEffects(trial));
    return points;
  }

 private:
  std::mutex mutex_;
  std::map<std::pair<SyntheticScenario, Fabric>, std::vector<TruthPoint>> points_;
};

}  // namespace

std::vector<MeasuredEffect> MeasureEffects(const std::vector<Trial>& trials, int num_threads,
                                           const std::function<void(double share)>& done,
                                           const std::atomic<bool>* stop) {
  std::vector<MeasuredEffect> rows;
  const std::vector<Piece> pieces = PiecesOf(trials, &rows);
  StillMotions still;
  std::mutex mutex;
  std::size_t num_done = 0;
  ParallelFor(static_cast<int>(pieces.size()), num_threads, [&](int i, int) {
    if (stop != nullptr && *stop) return;
    const Piece& piece = pieces[static_cast<std::size_t>(i)];
    std::optional<double> moved;
    std::string problem;
    try {
      moved = DistanceBetween(TruePoints(piece.trial), still.Of(piece.trial));
    } catch (const std::exception& error) {
      problem = ToString(kEffectSizes[piece.size]) + ": " + error.what();
    }
    const std::lock_guard<std::mutex> lock(mutex);
    rows[piece.row].moved[piece.size] = moved;
    if (!problem.empty()) rows[piece.row].problem = problem;
    if (done) done(static_cast<double>(++num_done) / static_cast<double>(pieces.size()));
  });
  return rows;
}

std::string EffectsAsMarkdown(const std::vector<MeasuredEffect>& effects) {
  std::string text =
      "| effect | motion | fabric | small (mm) | middle (mm) | large (mm) |\n"
      "|---|---|---|---:|---:|---:|\n";
  for (const MeasuredEffect& effect : effects) {
    text += fmt::format("| {} | {} | {} |", effect.term, ToString(effect.motion),
                        ToString(effect.fabric));
    for (const std::optional<double>& moved : effect.moved)
      text += moved ? fmt::format(" {:.1f} |", 1e3 * *moved) : std::string(" - |");
    text += effect.problem.empty() ? "\n" : " " + effect.problem + "\n";
  }
  return text;
}

}  // namespace clothfit
