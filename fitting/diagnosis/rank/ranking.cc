// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/rank/ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "fitting/diagnosis/rank/fault_score.h"
#include "fitting/diagnosis/rank/short_list.h"

namespace clothfit {
namespace {

constexpr int kRefined = 5;             // candidates whose places and shapes are looked at again
constexpr double kByItsPattern = 1e-3;  // p-value

// One candidate at one probe, and where its columns are.
struct Trial {
  int candidate;
  Probe probe;
  std::vector<int> columns;
};

// Everything that is put into the Gram matrix.
class Ranker {
 public:
  Ranker(const FittedScene& fitted, const DiagnosisOptions& options, const RankingStart& start)
      : fitted_(fitted),
        options_(options),
        errors_(start.errors),
        set_(start.set),
        draws_(start.draws),
        most_probes_(start.probes),
        refinements_(start.refinements),
        observations_(fitted.scene, fitted.config),
        frames_(fitted.scene, observations_, kMostRows),
        faults_(ListFaults(fitted.scene, fitted.config)) {}

  Ranking Run();

 private:
  void RunBaseline();
  void PassGate(Ranking* ranking);
  void AddDiscretisationErrors();
  // Simulates with one probe of each of these candidates set free.
  void AddTrials(const std::vector<std::pair<int, Probe>>& probes);
  void AddFirstTrials();
  void Refine();
  void Scale();
  double DiscretisationRms(const Projection& projection) const;
  std::vector<Nuisance> Nuisances(const std::string& fault_group) const;
  ScoredGroup GroupOf(const Trial& trial) const;
  RankedCandidate Physics(int candidate, const Projection& projection, const Projection& raw) const;
  // Of one amount of either sign that acts at a place: the best probe with the other sign, where it
  // scores half as much. What draws to one side may be what pushes from the other.
  void AddOtherSign(const Projection& projection, RankedCandidate* ranked) const;
  double ExplainedTogether(const Projection& projection,
                           const std::vector<Eigen::VectorXd>& nulls) const;
  void DrawTheNulls();
  double AtScale(int column) const { return 1.0 / scale_[column]; }

  const FittedScene& fitted_;
  const DiagnosisOptions& options_;
  std::shared_ptr<const DiscretisationErrors> errors_;
  CandidateSet set_;
  int draws_, most_probes_, refinements_;
  ObservationResiduals observations_;
  RowFrames frames_;
  std::vector<Fault> faults_;
  std::vector<CandidateTerm> candidates_;
  std::vector<Trial> trials_;
  std::optional<Rows> baseline_;
  Extent extent_;
  std::optional<ColumnSet> columns_;
  int residual_ = 0, first_baseline_ = 0, first_fault_ = 0;
  std::vector<int> drawn_errors_;
  Eigen::MatrixXd gram_;
  Eigen::VectorXd scale_;  // a column of the Gram matrix is its values times this
  std::vector<NullResidual> nulls_;
  double null_mean_ = 0.0;
};

void Ranker::RunBaseline() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  extent_.low.setConstant(kInfinity);
  extent_.high.setConstant(-kInfinity);
  extent_.gravity = fitted_.scene.world.gravity;
  extent_.size = fitted_.scene.recording.cloth.size;
  extent_.duration = fitted_.scene.FrameTime(fitted_.scene.last_fitted_frame);
  baseline_ =
      EvaluateRows(fitted_, BaselinePass(fitted_), frames_, faults_, [&](int, const State& state) {
        for (Eigen::Index i = 0; i < state.x.size(); i += 3) {
          extent_.low = extent_.low.cwiseMin(state.x.segment<3>(i));
          extent_.high = extent_.high.cwiseMax(state.x.segment<3>(i));
        }
      });
  if (!baseline_) throw std::runtime_error("the fitted baseline cannot be simulated");
  columns_.emplace(frames_.num_rows());
  residual_ = columns_->Add(baseline_->residuals);
  first_baseline_ = columns_->Add(baseline_->jacobian);
  first_fault_ = columns_->Add(baseline_->faults);
}

void Ranker::AddDiscretisationErrors() {
  if (fitted_.forecasts) {
    DiscretisationErrors none;
    none.num_rows = frames_.num_rows();
    errors_ = std::make_shared<DiscretisationErrors>(std::move(none));
  }
  if (!errors_ || errors_->num_rows != frames_.num_rows()) {
    errors_ = std::make_shared<DiscretisationErrors>(MeasureDiscretisationErrors(
        fitted_, frames_, *baseline_, options_.simulate_null ? draws_ : 0, options_.seed,
        options_.stop));
  }
  for (const Eigen::VectorXd& error : errors_->at_draws)
    drawn_errors_.push_back(columns_->Add(error));
}

void Ranker::AddTrials(const std::vector<std::pair<int, Probe>>& probes) {
  if (options_.stop != nullptr && *options_.stop) return;
  std::vector<std::pair<const CandidateTerm*, Probe>> on;
  for (const auto& [candidate, probe] : probes) on.push_back({&candidates_[candidate], probe});
  const std::optional<Rows> rows =
      EvaluateRows(fitted_, {WithProbes(fitted_.values, on)}, frames_, {});
  if (!rows) return;
  const int first = columns_->Add(rows->jacobian);
  for (const auto& [candidate, probe] : probes) {
    Trial trial{candidate, probe, {}};
    for (const std::string& name : candidates_[candidate].switches) {
      for (std::size_t e = 0; e < rows->entries.size(); ++e) {
        if (rows->entries[e].name == name) trial.columns.push_back(first + static_cast<int>(e));
      }
    }
    trials_.push_back(std::move(trial));
  }
}

void Ranker::AddFirstTrials() {
  candidates_ =
      ListCandidates(fitted_.values, fitted_.scene, extent_, options_.excluded, most_probes_, set_);
  std::size_t most = 0;
  for (const CandidateTerm& candidate : candidates_) most = std::max(most, candidate.probes.size());
  for (std::size_t round = 0; round < most; ++round) {
    std::vector<std::pair<int, Probe>> probes;
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      if (round < candidates_[c].probes.size())
        probes.push_back({static_cast<int>(c), candidates_[c].probes[round]});
    }
    if (!probes.empty()) AddTrials(probes);
  }
}

void Ranker::Scale() {
  gram_ = columns_->values().transpose() * columns_->values();
  scale_ = gram_.diagonal().cwiseSqrt();
  for (double& s : scale_) s = s > 0.0 ? 1.0 / s : 1.0;
  gram_ = scale_.asDiagonal() * gram_ * scale_.asDiagonal();
}

// D_0: the discretisation error when baseline and faults have taken their part, in sigmas.
double Ranker::DiscretisationRms(const Projection& projection) const {
  const auto sum_of = [&](int column) {
    return projection.gram()(column, column) / (scale_[column] * scale_[column]);
  };
  double sum = 0.0;
  for (const int column : drawn_errors_)
    sum += sum_of(column) / static_cast<double>(drawn_errors_.size());
  return std::sqrt(std::max(0.0, sum) / std::max(1, frames_.num_rows()));
}

// Of physics, and of a fault where its group is given: it is scored as the only one where there are
// points (outlines are no such sharp test), all others as well-made recordings have them.
std::vector<Nuisance> Ranker::Nuisances(const std::string& fault_group) const {
  const bool is_only = !fault_group.empty() && HasPoints(fitted_.scene);
  std::vector<Nuisance> nuisances;
  if (!options_.project) return nuisances;
  for (std::size_t i = 0; i < baseline_->entries.size(); ++i) {
    const int column = first_baseline_ + static_cast<int>(i);
    const double sigma = baseline_->entries[i].prior_sigma;
    nuisances.push_back({column, std::pow(scale_[column] / sigma, 2)});
  }
  const std::vector<Nuisance> others =
      OtherFaults(faults_, fault_group, first_fault_, scale_, is_only);
  nuisances.insert(nuisances.end(), others.begin(), others.end());
  return nuisances;
}

ScoredGroup Ranker::GroupOf(const Trial& trial) const {
  return {trial.columns, candidates_[trial.candidate].is_one_sided, {}};
}

// Places and shapes beside the best ones of the candidates that look best, finer each time.
void Ranker::Refine() {
  if (trials_.empty()) return;  // it was stopped before
  double step = 0.5;
  for (int round = 0; round < refinements_; ++round, step *= 0.5) {
    Scale();
    const Projection projection(gram_, Nuisances(""));
    std::vector<std::pair<double, std::size_t>> best(candidates_.size(), {-1.0, 0});
    for (std::size_t t = 0; t < trials_.size(); ++t) {
      const Score score =
          ScoreOf(projection, GroupOf(trials_[t]), projection.gram().col(residual_));
      auto& own = best[static_cast<std::size_t>(trials_[t].candidate)];
      own = std::max(own, {score.decrease, t});
    }
    std::sort(best.rbegin(), best.rend());
    best.resize(std::min<std::size_t>(best.size(), kRefined));
    std::vector<std::vector<Probe>> near;
    std::size_t most = 0;
    for (const auto& [decrease, t] : best) {
      const CandidateTerm& candidate = candidates_[trials_[t].candidate];
      near.push_back(ProbesNear(candidate, trials_[t].probe, extent_, step));
      most = std::max(most, near.back().size());
    }
    std::vector<int> which;
    for (const auto& [decrease, t] : best) which.push_back(trials_[t].candidate);
    for (std::size_t k = 0; k < most; ++k) {
      std::vector<std::pair<int, Probe>> probes;
      for (std::size_t b = 0; b < near.size(); ++b) {
        if (k < near[b].size()) probes.push_back({which[b], near[b][k]});
      }
      AddTrials(probes);
    }
  }
}

RankedCandidate Ranker::Physics(int candidate, const Projection& projection,
                                const Projection& raw) const {
  RankedCandidate ranked;
  ranked.term = candidates_[candidate];
  ranked.summary.name = ranked.term.name;
  ranked.summary.kind = CandidateKind::kPhysics;
  ranked.names = ranked.term.switches;
  double best = -1.0;
  for (const Trial& trial : trials_) {
    if (trial.candidate != candidate) continue;
    const Score score = ScoreOf(projection, GroupOf(trial), projection.gram().col(residual_));
    if (score.decrease <= best) continue;
    best = score.decrease;
    ranked.summary.score = score.decrease / (scale_[residual_] * scale_[residual_]);
    ranked.summary.raw_score = ScoreOf(raw, GroupOf(trial), raw.gram().col(residual_)).decrease /
                               (scale_[residual_] * scale_[residual_]);
    ranked.amounts = score.amounts.cwiseProduct(scale_(trial.columns)) / scale_[residual_];
    ranked.sigma = score.sigma.cwiseProduct(scale_(trial.columns));
    ranked.columns = trial.columns;
    ranked.probe = trial.probe;
  }
  if (ranked.names.size() == 1 && !ranked.probe.empty()) AddOtherSign(projection, &ranked);
  return ranked;
}

void Ranker::AddOtherSign(const Projection& projection, RankedCandidate* ranked) const {
  constexpr double kAsLikely = 0.5;  // of the best score
  double best = kAsLikely * ranked->summary.score * scale_[residual_] * scale_[residual_];
  std::optional<RankedCandidate::Start> other;
  for (const Trial& trial : trials_) {
    if (candidates_[trial.candidate].name != ranked->summary.name) continue;
    const Score score = ScoreOf(projection, GroupOf(trial), projection.gram().col(residual_));
    if (score.decrease < best || score.amounts[0] * ranked->amounts[0] >= 0.0) continue;
    best = score.decrease;
    const Eigen::VectorXd amounts = score.amounts.cwiseProduct(scale_(trial.columns));
    other = RankedCandidate::Start{trial.probe, amounts / scale_[residual_]};
  }
  if (other) ranked->other_starts.push_back(*other);
}

// By how much all absent physics together would lower the sum of squares, above what they do to the
// null: small effects show here long before they show in the whole sum.
double Ranker::ExplainedTogether(const Projection& projection,
                                 const std::vector<Eigen::VectorXd>& nulls) const {
  // What the baseline and faults can do as well has no length of its own left.
  constexpr double kItsOwn = 1e-10;
  std::vector<int> columns;
  for (const Trial& trial : trials_)
    for (const int column : trial.columns)
      if (projection.gram()(column, column) > kItsOwn) columns.push_back(column);
  if (columns.empty()) return 0.0;
  constexpr std::size_t kEnough = 20;
  const std::size_t count = std::min(kEnough, nulls.size());
  Eigen::MatrixXd products(columns.size(), 1 + count);
  products.col(0) = projection.gram().col(residual_)(columns);
  for (std::size_t k = 0; k < count; ++k)
    products.col(1 + static_cast<Eigen::Index>(k)) = nulls[k](columns);
  const Eigen::VectorXd decreases = DecreasesOfAll(projection, columns, products);
  const double of_null = count > 0 ? decreases.tail(count).mean() : 0.0;
  return std::max(0.0, decreases[0] / (scale_[residual_] * scale_[residual_]) - of_null);
}

void Ranker::DrawTheNulls() {
  std::vector<DrawnColumn> numerical, faults;
  if (options_.simulate_null) {
    for (const int column : drawn_errors_) numerical.push_back({column, AtScale(column)});
    for (std::size_t i = 0; i < faults_.size(); ++i) {
      const int column = first_fault_ + static_cast<int>(i);
      faults.push_back({column, faults_[i].typical * AtScale(column)});
    }
  }
  nulls_ =
      DrawNulls(gram_, frames_.num_rows(), numerical, faults, options_.num_nulls, options_.seed);
}

// Is more left than the null leaves?
void Ranker::PassGate(Ranking* ranking) {
  Scale();
  DrawTheNulls();
  const Projection projection(gram_, Nuisances(""));
  const std::vector<double> left = LeftByNulls(projection, nulls_);
  null_mean_ = Mean(left);
  const double residual2 = scale_[residual_] * scale_[residual_];
  const double own = projection.gram()(residual_, residual_) / residual2;
  ranking->num_rows = frames_.num_rows();
  ranking->null_mean = null_mean_;
  ranking->gate_p_value = TailProbability(left, own);
  const auto rms = [&](double sum) { return std::sqrt(std::max(0.0, sum) / frames_.num_rows()); };
  ranking->left_rms = rms(own);
  for (const double sum : left) ranking->null_left_rms.push_back(rms(sum));
  ranking->unexplained = std::max(0.0, own - null_mean_);
  ranking->residual_rms = std::sqrt(1.0 / residual2 / frames_.num_rows());
  ranking->discretisation_rms = DiscretisationRms(projection);
  ranking->errors = errors_;
  std::vector<Nuisance> own_fit = Nuisances("");
  own_fit.resize(std::min<std::size_t>(own_fit.size(), baseline_->entries.size()));
  ranking->promised = 1.0 - Projection(gram_, own_fit).gram()(residual_, residual_);
}

Ranking Ranker::Run() {
  Ranking ranking;
  RunBaseline();
  AddDiscretisationErrors();
  AddFirstTrials();
  if (set_ == CandidateSet::kCatalogue) Refine();
  PassGate(&ranking);
  const Projection projection(gram_, Nuisances("")), raw(gram_, {});
  ranking.faults = faults_;
  ranking.extent = extent_;
  std::vector<Eigen::VectorXd> projected;
  for (const NullResidual& null : nulls_) projected.push_back(projection.Products(null.products));
  ranking.explainable = std::max(ranking.unexplained, ExplainedTogether(projection, projected));
  for (std::size_t c = 0; c < candidates_.size(); ++c) {
    RankedCandidate candidate = Physics(static_cast<int>(c), projection, raw);
    if (candidate.columns.empty()) continue;
    std::vector<double> null_scores(nulls_.size(), 0.0);
    for (const Trial& trial : trials_) {
      if (trial.candidate != static_cast<int>(c)) continue;
      const Scorer scorer(projection, GroupOf(trial));
      for (std::size_t k = 0; k < nulls_.size(); ++k)
        null_scores[k] = std::max(null_scores[k], scorer.Of(projected[k]).decrease);
    }
    JudgeAgainstNull(projection, scale_, null_scores, &candidate);
    // A candidate that stands out by its pattern is there to be explained, however large the
    // discretisation error: where it can be held to simulated recordings of the baseline.
    if (HasPoints(fitted_.scene) && candidate.summary.p_value < kByItsPattern)
      ranking.explainable = std::max(ranking.explainable, candidate.summary.score);
    ranking.candidates.push_back(std::move(candidate));
  }
  for (RankedCandidate& candidate : ranking.candidates)
    candidate.summary.share = ShareOf(candidate.summary.score, ranking.explainable);
  std::set<std::string> groups;
  for (const Fault& fault : faults_) groups.insert(fault.group);
  const FaultProducts products = {faults_,      gram_,  scale_,    residual_,
                                  first_fault_, nulls_, null_mean_};
  for (const std::string& group : groups)
    ranking.candidates.push_back(ScoreFaults(products, group, Nuisances(group)));
  std::stable_sort(ranking.candidates.begin(), ranking.candidates.end(),
                   [](const auto& a, const auto& b) { return a.summary.score > b.summary.score; });
  ShortList(HasPoints(fitted_.scene), options_, &ranking);
  ranking.projection = projection;
  return ranking;
}

}  // namespace

double Ranking::Cosine(const RankedCandidate& a, const RankedCandidate& b) const {
  const bool are_physics = a.faults.empty() && b.faults.empty() && projection.has_value();
  return are_physics ? LargestCosine(*projection, a.columns, b.columns) : 0.0;
}

Ranking RankCandidates(const FittedScene& fitted, const DiagnosisOptions& options,
                       const RankingStart& start) {
  return Ranker(fitted, options, start).Run();
}

}  // namespace clothfit
