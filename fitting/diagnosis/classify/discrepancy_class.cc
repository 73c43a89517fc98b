// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/classify/discrepancy_class.h"

#include <algorithm>
#include <cmath>

#include <Eigen/SVD>

#include "fitting/diagnosis/classify/class_text.h"
#include "fitting/diagnosis/classify/discrepancy_ties.h"
#include "fitting/diagnosis/evidence/rao_score.h"
#include "fitting/optimise/checked_factor.h"

namespace clothfit {
namespace {

// Functions of the force that sum it up over the cloth at a knot.
class KnotSums {
 public:
  KnotSums(const Scene& scene, const MissingForce& missing)
      : scene_(scene), missing_(missing), shares_(NodeShares(scene.mesh, missing.layout)) {}

  // Adds factor(triangle's middle, its mean velocity) * force (N) to rows: each row of `rows`
  // (count x controls) gets one component.
  template <class Factor>
  void Add(int knot, const Factor& factor, Eigen::MatrixXd* rows) const {
    const Eigen::VectorXd& x = missing_.x[FrameOfKnot(missing_, knot)];
    const Eigen::VectorXd& v = missing_.v[FrameOfKnot(missing_, knot)];
    for (const NodeShare& share : shares_) {
      const Eigen::Matrix3d frame = TriangleFrame(scene_.mesh, share.triangle, x);
      rows->middleCols<3>(missing_.layout.Index(knot, share.node, 0)) +=
          factor(Middle(share.triangle, x), Middle(share.triangle, v)) * (share.area * frame);
    }
  }

  static Eigen::Vector3d Middle(const std::array<int, 3>& t, const Eigen::VectorXd& x) {
    return (x.segment<3>(3 * t[0]) + x.segment<3>(3 * t[1]) + x.segment<3>(3 * t[2])) / 3.0;
  }

 private:
  const Scene& scene_;
  const MissingForce& missing_;
  std::vector<NodeShare> shares_;
};

Eigen::Matrix3d CrossMatrix(const Eigen::Vector3d& p) {
  Eigen::Matrix3d m;
  m << 0.0, -p.z(), p.y(), p.z(), 0.0, -p.x(), -p.y(), p.x(), 0.0;
  return m;
}

// Places (m) that are held at a time, with the cloth at x.
std::vector<Eigen::Vector3d> HeldPlaces(const Scene& scene, double time, const Eigen::VectorXd& x) {
  std::vector<Eigen::Vector3d> places;
  for (const SceneHandle& handle : scene.handles) {
    if (time <= handle.released_after + 1e-9) places.push_back(handle.on_cloth.At(x));
  }
  return places;
}

// Unit combinations (rows) of net force and of net moment (about the origin, over `length`) that no
// forces at these places can add to: the orthogonal complement of what they can.
Eigen::MatrixXd FreeWrenches(const std::vector<Eigen::Vector3d>& held, double length) {
  Eigen::MatrixXd exerted(6, 3 * static_cast<Eigen::Index>(held.size()));
  for (std::size_t h = 0; h < held.size(); ++h) {
    exerted.block<3, 3>(0, 3 * static_cast<Eigen::Index>(h)).setIdentity();
    exerted.block<3, 3>(3, 3 * static_cast<Eigen::Index>(h)) = CrossMatrix(held[h]) / length;
  }
  if (held.empty()) return Eigen::MatrixXd::Identity(6, 6);
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(exerted, Eigen::ComputeFullU);
  svd.setThreshold(1e-6);
  return svd.matrixU().rightCols(6 - svd.rank()).transpose();
}

double SigmasOfRows(const MissingForce& missing, const Eigen::MatrixXd& rows) {
  if (rows.rows() == 0) return 0.0;
  Eigen::MatrixXd covariance = missing.posterior.Covariance(rows);
  covariance.diagonal().array() += 1e-9 * covariance.diagonal().maxCoeff();
  const auto factor = TryCholesky(covariance);
  if (!factor) return 0.0;  // nothing is known of these sums
  const Eigen::VectorXd sums = rows * missing.force;
  return NormalDeviate(sums.dot(factor->solve(sums)), static_cast<double>(rows.rows()));
}

Eigen::VectorXd Deviations(const MissingForce& missing, const Eigen::MatrixXd& rows) {
  return missing.posterior.Covariance(rows).diagonal().cwiseMax(0.0).cwiseSqrt();
}

// Everything that is summed up over the cloth.
class Balance {
 public:
  Balance(const Scene& scene, const MissingForce& missing)
      : scene_(scene), missing_(missing), sums_(scene, missing) {
    for (int k = 0; k < missing.layout.num_knots; ++k) {
      if (k * missing.layout.frames_per_knot <= missing.last_frame) ++num_knots_;
    }
    length_ = 0.5 * (missing.layout.high - missing.layout.low).norm();
    FindRows();
  }

  DiscrepancyBalance Fill() const {
    DiscrepancyBalance balance;
    for (int k = 0; k < num_knots_; ++k) balance.times.push_back(missing_.layout.KnotTime(k));
    const Eigen::VectorXd net = force_rows_ * missing_.force;
    const Eigen::VectorXd net_sigma = Deviations(missing_, force_rows_);
    balance.force = Eigen::Map<const Eigen::MatrixXd>(net.data(), 3, num_knots_);
    balance.force_sigma = Eigen::Map<const Eigen::MatrixXd>(net_sigma.data(), 3, num_knots_);
    balance.power = power_rows_ * missing_.force;
    balance.power_sigma = Deviations(missing_, power_rows_);
    balance.is_testable = free_rows_.rows() > 0;
    if (!balance.is_testable) return balance;
    const Eigen::VectorXd free = length_ * (free_rows_ * missing_.force);
    const Eigen::VectorXd free_sigma = length_ * Deviations(missing_, free_rows_);
    balance.moment.assign(free.data(), free.data() + free.size());
    balance.moment_sigma.assign(free_sigma.data(), free_sigma.data() + free.size());
    const double unsigned_sum = std::max(length_ * UnsignedSum(), 1e-300);
    balance.coherence = free.cwiseAbs().sum() / unsigned_sum;
    return balance;
  }

  double ForceSigmas() const { return SigmasOfRows(missing_, force_rows_); }
  double FreeSigmas() const { return SigmasOfRows(missing_, free_rows_); }
  const Eigen::MatrixXd& power_rows() const { return power_rows_; }

  // W: of a force of the same size everywhere that goes with the motion, at each knot.
  Eigen::VectorXd LargestPower() const {
    Eigen::VectorXd largest = Eigen::VectorXd::Zero(num_knots_);
    for (int k = 0; k < num_knots_; ++k) {
      const int frame = FrameOfKnot(missing_, k);
      const Eigen::Matrix3Xd forces =
          TriangleForces(scene_.mesh, missing_.layout, missing_.force, missing_.layout.KnotTime(k),
                         missing_.x[frame]);
      for (std::size_t t = 0; t < scene_.mesh.triangles.size(); ++t) {
        largest[k] += forces.col(static_cast<Eigen::Index>(t)).norm() *
                      KnotSums::Middle(scene_.mesh.triangles[t], missing_.v[frame]).norm();
      }
    }
    return largest;
  }

 private:
  // About the middle of what is held, or of the cloth.
  Eigen::Vector3d Origin(const std::vector<Eigen::Vector3d>& held, const Eigen::VectorXd& x) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& place : held) sum += place;
    if (!held.empty()) return sum / static_cast<double>(held.size());
    for (Eigen::Index i = 0; i < x.size(); i += 3) sum += x.segment<3>(i);
    return sum / (static_cast<double>(x.size()) / 3.0);
  }

  Eigen::MatrixXd FreeOfKnot(int knot, Eigen::Vector3d* origin) const {
    const Eigen::VectorXd& x = missing_.x[FrameOfKnot(missing_, knot)];
    std::vector<Eigen::Vector3d> held = HeldPlaces(scene_, missing_.layout.KnotTime(knot), x);
    *origin = Origin(held, x);
    for (Eigen::Vector3d& place : held) place -= *origin;
    return FreeWrenches(held, length_);
  }

  void FindRows() {
    const Eigen::Index controls = missing_.layout.size();
    force_rows_.setZero(3 * num_knots_, controls);
    power_rows_.setZero(num_knots_, controls);
    std::vector<Eigen::MatrixXd> free;
    Eigen::Index count = 0;
    for (int k = 0; k < num_knots_; ++k) {
      Eigen::Vector3d origin;
      const Eigen::MatrixXd combinations = FreeOfKnot(k, &origin);
      Eigen::MatrixXd wrench = Eigen::MatrixXd::Zero(6, controls);
      Eigen::MatrixXd power = Eigen::MatrixXd::Zero(1, controls);
      sums_.Add(
          k,
          [&](const Eigen::Vector3d& place, const Eigen::Vector3d&) {
            Eigen::Matrix<double, 6, 3> both;
            both << Eigen::Matrix3d::Identity(), CrossMatrix(place - origin) / length_;
            return both;
          },
          &wrench);
      sums_.Add(
          k,
          [](const Eigen::Vector3d&, const Eigen::Vector3d& velocity) {
            return Eigen::RowVector3d(velocity.transpose());
          },
          &power);
      force_rows_.middleRows<3>(3 * k) = wrench.topRows<3>();
      power_rows_.row(k) = power;
      free.push_back(combinations * wrench);
      count += free.back().rows();
    }
    free_rows_.resize(count, controls);
    Eigen::Index row = 0;
    for (const Eigen::MatrixXd& rows : free) {
      free_rows_.middleRows(row, rows.rows()) = rows;
      row += rows.rows();
    }
  }

  // As the free rows' sums, every triangle's part counted without its sign (N).
  double UnsignedSum() const {
    double sum = 0.0;
    for (int k = 0; k < num_knots_; ++k) {
      Eigen::Vector3d origin;
      const Eigen::MatrixXd combinations = FreeOfKnot(k, &origin);
      const Eigen::VectorXd& x = missing_.x[FrameOfKnot(missing_, k)];
      const Eigen::Matrix3Xd forces = TriangleForces(scene_.mesh, missing_.layout, missing_.force,
                                                     missing_.layout.KnotTime(k), x);
      for (std::size_t t = 0; t < scene_.mesh.triangles.size(); ++t) {
        const Eigen::Vector3d f = forces.col(static_cast<Eigen::Index>(t));
        Eigen::Matrix<double, 6, 1> wrench;
        wrench << f, (KnotSums::Middle(scene_.mesh.triangles[t], x) - origin).cross(f) / length_;
        sum += (combinations * wrench).cwiseAbs().sum();
      }
    }
    return sum;
  }

  const Scene& scene_;
  const MissingForce& missing_;
  KnotSums sums_;
  int num_knots_ = 0;
  double length_ = 1.0;  // m, that moments are compared with forces by
  Eigen::MatrixXd force_rows_, power_rows_, free_rows_;
};

// Mean power over the patch's time, and whether work is nearly all of one sign.
void FillPower(const MissingForce& missing, const ForcePatch& patch, const Balance& balance,
               DiscrepancyClass* result) {
  const Eigen::MatrixXd& rows = balance.power_rows();
  const Eigen::VectorXd power = rows * missing.force, largest = balance.LargestPower();
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(rows.rows());
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    const auto frame = static_cast<double>(k * missing.layout.frames_per_knot);
    if (frame >= patch.first_frame - 0.5 * missing.layout.frames_per_knot &&
        frame <= patch.last_frame + 0.5 * missing.layout.frames_per_knot)
      weights[k] = 1.0;
  }
  if (weights.sum() == 0.0) return;
  weights /= weights.sum();
  result->power = weights.dot(power);
  result->power_sigma =
      std::sqrt(std::max(0.0, missing.posterior.Covariance(weights.transpose() * rows)(0, 0)));
  constexpr double kSure = 3.0;     // sigmas
  constexpr double kOneSign = 0.8;  // of the work done either way
  constexpr double kEnough = 0.2;   // of what a force along the motion would do
  const double either_way = weights.dot(power.cwiseAbs());
  const bool is_clear = std::abs(result->power) > kSure * result->power_sigma &&
                        std::abs(result->power) > kEnough * weights.dot(largest);
  const double one_sign = 0.5 * (1.0 + std::abs(result->power) / std::max(either_way, 1e-300));
  result->is_dissipative = is_clear && result->power < 0.0 && one_sign > kOneSign;
  result->is_driving = is_clear && result->power > 0.0 && one_sign > kOneSign;
}

// What the best family is tied to, where it is clearly better than any force at all and than the
// families of other ties. Empty where none is.
std::string ClearTie(const std::vector<TriedTie>& ties) {
  constexpr double kClearly = 10.0;  // log evidence: what is correlated and what is not are models
  const auto best =
      std::find_if(ties.begin(), ties.end(), [](const TriedTie& tie) { return !tie.is_of_patch; });
  for (const TriedTie& other : ties) {
    if (other.is_of_patch || other.to == best->to) continue;
    if (other.log_evidence > best->log_evidence - kClearly) return "";
  }
  return best->log_evidence > kClearly ? best->to : "";
}

}  // namespace

DiscrepancyReport ClassifyDiscrepancy(const Scene& scene, const MissingForce& missing,
                                      const Location& location) {
  DiscrepancyReport report;
  const Balance balance(scene, missing);
  report.balance = balance.Fill();
  DiscrepancyClass& c = report.discrepancy_class;
  c.net_force_sigmas = balance.ForceSigmas();
  c.net_moment_sigmas = balance.FreeSigmas();
  // Forces that cancel are not said to be the cloth's own: the prior's smoothness alone can make an
  // internal force look as if it did not, and one from outside as if it did.
  constexpr double kCancels = 0.3;  // of the sum without signs
  constexpr double kSure = 10.0;    // sigmas of the net sums
  c.is_from_outside = report.balance.is_testable && location.discrepancy.is_significant &&
                      report.balance.coherence > kCancels && c.net_moment_sigmas > kSure;
  FillPower(missing, location.patch, balance, &c);
  report.ties = FindTies(scene, missing, location.patch);
  c.tied_to = ClearTie(report.ties);
  c.words = ClassText(c);
  return report;
}

}  // namespace clothfit
