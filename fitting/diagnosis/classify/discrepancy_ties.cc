// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/classify/discrepancy_ties.h"

#include <algorithm>
#include <functional>

#include "fitting/optimise/checked_factor.h"

namespace clothfit {
namespace {

// By how much a system's best force lowers the sum of squares.
double Gain(const LinearSystem& system, const PosteriorForce& posterior) {
  const Eigen::VectorXd force = posterior.Mean(system.data.leftCols(1));
  return 2.0 * force.dot(system.data.col(0)) -
         force.dot(system.information.selfadjointView<Eigen::Lower>() * force);
}

class Families {
 public:
  Families(const Scene& scene, const MissingForce& missing, const ForcePatch& patch)
      : scene_(scene), missing_(missing), patch_(patch), poses_(KnotPoses(scene, missing)) {}

  std::vector<TriedTie> Run() {
    ties_.push_back(
        {"", "any force", missing_.log_evidence, Gain(missing_.system, missing_.posterior), false});
    AddWorld();
    AddMaterial();
    AddContact();
    AddClock();
    const double whole = ties_.front().explained;
    for (TriedTie& tie : ties_) tie.explained = whole > 0.0 ? tie.explained / whole : 0.0;
    std::stable_sort(ties_.begin(), ties_.end(), [](const TriedTie& a, const TriedTie& b) {
      return a.log_evidence > b.log_evidence;
    });
    return ties_;
  }

 private:
  void AddSystem(const std::string& to, const std::string& family, const LinearSystem& system,
                 const Eigen::MatrixXd& factor) {
    const Evidence evidence = MaximiseEvidence(system, factor);
    const PosteriorForce posterior(system, factor, evidence.strength, evidence.noise);
    ties_.push_back({to, family, evidence.log_evidence, Gain(system, posterior), false});
  }

  // Forces that are sums of these columns, each with an amount (N/m^2) of its own.
  void AddSpan(const std::string& to, const std::string& family, const Eigen::MatrixXd& columns) {
    const Eigen::MatrixXd moved =
        missing_.system.information.selfadjointView<Eigen::Lower>() * columns;
    LinearSystem system;
    system.sum = missing_.system.sum;
    system.rows = missing_.system.rows;
    system.information = columns.transpose() * moved;
    system.data = columns.transpose() * missing_.system.data.leftCols(1);
    AddSystem(to, family, system, Eigen::MatrixXd::Identity(columns.cols(), columns.cols()));
  }

  // Forces at some of the map's (knot, node)s only. None where these are all or none.
  void AddMasked(const std::string& to, const std::string& family,
                 const std::function<bool(int knot, int node)>& is_in) {
    const ForceLayout& layout = missing_.layout;
    std::vector<int> in;
    for (int k = 0; k < layout.num_knots; ++k) {
      for (int node = 0; node < layout.num_nodes(); ++node) {
        for (int c = 0; c < 3 && is_in(k, node); ++c) in.push_back(layout.Index(k, node, c));
      }
    }
    constexpr double kMost = 0.75;  // of the whole: more of it is hardly a part
    if (in.empty() || static_cast<double>(in.size()) > kMost * layout.size()) return;
    const Eigen::MatrixXd rows = missing_.correlation_factor(in, Eigen::all);
    const Eigen::MatrixXd correlation = rows * rows.transpose();
    LinearSystem system;
    system.information = missing_.system.information(in, in);
    system.data = missing_.system.data(in, std::vector<int>{0});
    system.sum = missing_.system.sum;
    system.rows = missing_.system.rows;
    AddSystem(to, family, system, Cholesky(correlation, "the correlations of a tie").matrixL());
    ties_.back().is_of_patch = to != "contact";
  }

  // Columns of `count` world vectors, weighted at each (knot, node).
  Eigen::MatrixXd WorldVectors(int count,
                               const std::function<double(int knot, int node, int which)>& weight) {
    const ForceLayout& layout = missing_.layout;
    Eigen::MatrixXd columns(layout.size(), 3 * count);
    for (int k = 0; k < layout.num_knots; ++k) {
      for (int node = 0; node < layout.num_nodes(); ++node) {
        for (int which = 0; which < count; ++which) {
          columns.block<3, 3>(layout.Index(k, node, 0), 3 * which) =
              weight(k, node, which) * poses_[k].frames[node].transpose();
        }
      }
    }
    return columns;
  }

  void AddWorld() {
    const Eigen::MatrixXd one = WorldVectors(1, [](int, int, int) { return 1.0; });
    AddSpan("world", "one vector", one);
    Eigen::MatrixXd along_normal = one;  // what an even stream does to a surface across it
    for (Eigen::Index row = 0; row < one.rows(); ++row) {
      if (row % 3 != 0) along_normal.row(row).setZero();
    }
    AddSpan("world", "one vector, along the surface's normal", along_normal);
    Eigen::Vector3d low = poses_[0].places[0], high = low;
    for (const KnotPose& pose : poses_) {
      for (const Eigen::Vector3d& place : pose.places) {
        low = low.cwiseMin(place);
        high = high.cwiseMax(place);
      }
    }
    const Eigen::Vector3d size = (high - low).cwiseMax(1e-6);
    AddSpan("world", "a field in the world, trilinear",
            WorldVectors(8, [&](int k, int node, int c) {
              const Eigen::Vector3d s = (poses_[k].places[node] - low).cwiseQuotient(size);
              double weight = 1.0;
              for (int axis = 0; axis < 3; ++axis)
                weight *= ((c >> axis) & 1) != 0 ? s[axis] : 1.0 - s[axis];
              return weight;
            }));
  }

  void AddMaterial() {
    const ForceLayout& layout = missing_.layout;
    const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(layout.per_knot(), layout.per_knot());
    AddSpan("material", "a pattern fixed in the cloth's frame", one.replicate(layout.num_knots, 1));
    AddSpan("material", "a vector at each place of the cloth",
            WorldVectors(layout.num_nodes(),
                         [](int, int node, int which) { return node == which ? 1.0 : 0.0; }));
    const Eigen::Vector2d cell =
        (layout.high - layout.low)
            .cwiseQuotient(Eigen::Vector2d(layout.nodes[0] - 1, layout.nodes[1] - 1));
    AddMasked("material", "any force on a part of the cloth", [&](int, int node) {
      const Eigen::Vector2d uv = layout.NodePlace(node);
      return (uv - patch_.low_uv + 0.5 * cell).minCoeff() >= 0.0 &&
             (patch_.high_uv + 0.5 * cell - uv).minCoeff() >= 0.0;
    });
  }

  void AddContact() {
    if (!scene_.world.ground_height) return;
    constexpr double kNear = 0.02;  // m
    AddMasked("contact", "any force near the ground", [&](int knot, int node) {
      return poses_[knot].places[node].z() < *scene_.world.ground_height + kNear;
    });
  }

  void AddClock() {
    const double before = patch_.first_frame, after = patch_.last_frame;
    const int step = missing_.layout.frames_per_knot;
    AddMasked("clock", "any force for a time", [&](int knot, int) {
      return knot * step > before - step && knot * step < after + step;
    });
  }

  const Scene& scene_;
  const MissingForce& missing_;
  const ForcePatch& patch_;
  std::vector<KnotPose> poses_;
  std::vector<TriedTie> ties_;
};

}  // namespace

int FrameOfKnot(const MissingForce& missing, int knot) {
  return std::min(knot * missing.layout.frames_per_knot, missing.last_frame);
}

std::vector<KnotPose> KnotPoses(const Scene& scene, const MissingForce& missing) {
  const ForceLayout& layout = missing.layout;
  std::vector<Eigen::Vector2d> uv;
  for (int node = 0; node < layout.num_nodes(); ++node) uv.push_back(layout.NodePlace(node));
  const std::vector<SurfacePoint> points = LocateOnCloth(scene.mesh, uv);
  std::vector<KnotPose> poses;
  for (int k = 0; k < layout.num_knots; ++k) {
    const Eigen::VectorXd& x = missing.x[FrameOfKnot(missing, k)];
    KnotPose pose;
    for (const SurfacePoint& point : points) {
      pose.frames.push_back(TriangleFrame(scene.mesh, point.nodes, x));
      pose.places.push_back(point.At(x));
    }
    poses.push_back(std::move(pose));
  }
  return poses;
}

std::vector<TriedTie> FindTies(const Scene& scene, const MissingForce& missing,
                               const ForcePatch& patch) {
  return Families(scene, missing, patch).Run();
}

}  // namespace clothfit
