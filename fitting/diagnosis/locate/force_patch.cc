// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The search for the rectangle and the stretch of time that explain most of a missing force.
#include <algorithm>
#include <cmath>
#include <functional>

#include <Eigen/LU>

#include "fitting/diagnosis/locate/locate.h"
#include "fitting/optimise/checked_factor.h"

namespace clothfit {
namespace {

// Functions of a place from 0 to 1, as sums of hats at evenly spaced nodes, by least squares.
class HatProjection {
 public:
  explicit HatProjection(int nodes) : nodes_(nodes) {
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(nodes, nodes);
    for (int i = 0; i + 1 < nodes; ++i) {
      products(i, i) += 1.0 / 3.0;
      products(i + 1, i + 1) += 1.0 / 3.0;
      products(i, i + 1) += 1.0 / 6.0;
      products(i + 1, i) += 1.0 / 6.0;
    }
    inverse_ = products.inverse();
  }

  Eigen::VectorXd operator()(const std::function<double(double)>& function) const {
    constexpr int kSamples = 24;  // a cell
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(nodes_);
    for (int s = 0; s < kSamples * (nodes_ - 1); ++s) {
      const double place = (s + 0.5) / kSamples, value = function(place / (nodes_ - 1));
      if (value == 0.0) continue;
      const int cell = s / kSamples;
      sums[cell] += value * (cell + 1 - place) / kSamples;
      sums[cell + 1] += value * (place - cell) / kSamples;
    }
    return inverse_ * sums;
  }

  // Of the function that is 1 from 0 to step / steps, one column a step from 0 to steps; that of a
  // stretch is the difference of two.
  Eigen::MatrixXd Cumulative(const std::vector<double>& ends) const {
    Eigen::MatrixXd columns(nodes_, static_cast<Eigen::Index>(ends.size()));
    for (std::size_t i = 0; i < ends.size(); ++i)
      columns.col(static_cast<Eigen::Index>(i)) = Exact(ends[i] * (nodes_ - 1));
    return columns;
  }

 private:
  // Of the function that is 1 below `end`, in cells.
  Eigen::VectorXd Exact(double end) const {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(nodes_);
    for (int cell = 0; cell + 1 < nodes_; ++cell) {
      const double part = std::clamp(end - cell, 0.0, 1.0);
      sums[cell] += part - 0.5 * part * part;
      sums[cell + 1] += 0.5 * part * part;
    }
    return inverse_ * sums;
  }

  int nodes_;
  Eigen::MatrixXd inverse_;
};

// A stretch between two of a list of ends.
struct Stretch {
  int first = 0, last = 0;
};

class PatchSearch {
 public:
  explicit PatchSearch(const MissingForce& missing)
      : layout_(missing.layout),
        noise_(missing.noise_factor),
        information_(missing.system.information.selfadjointView<Eigen::Lower>()),
        data_(missing.system.data.col(0)),
        last_frame_(missing.last_frame),
        in_time_(layout_.num_knots) {
    std::vector<double> ends;
    for (int i = 0; i <= kLattice; ++i) ends.push_back(static_cast<double>(i) / kLattice);
    for (int axis = 0; axis < 2; ++axis)
      in_place_[axis] = HatProjection(layout_.nodes[axis]).Cumulative(ends);
    std::vector<double> frames;
    for (int f = 0; f <= last_frame_ + 1; ++f) frames.push_back(Share(f - 0.5));
    by_frame_ = in_time_.Cumulative(frames);
  }

  ForcePatch Run() {
    StartCoarse();
    for (int round = 0; round < 6; ++round) {
      const double before = best_.score;
      ImproveTime();
      ImprovePlace(1);
      if (best_.score <= before * (1.0 + 1e-9)) break;
    }
    return Finish();
  }

 private:
  static constexpr int kLattice = 16;
  using Course = ForcePatch::Course;

  struct Candidate {
    std::array<Stretch, 2> place = {};  // along u and v, on the lattice
    Stretch time;                       // frames, `last` being the one after
    Course course = Course::kConstant;
    double score = -1.0;
    Eigen::Vector3d amplitude = Eigen::Vector3d::Zero();
  };

  // Of the frames from half a frame before the first on, as a share of the knots' range.
  double Share(double frame) const {
    return std::clamp(frame / (layout_.frames_per_knot * (layout_.num_knots - 1)), 0.0, 1.0);
  }

  Eigen::VectorXd TimeWeights(const Stretch& time, Course course) const {
    if (course == Course::kConstant) return by_frame_.col(time.last) - by_frame_.col(time.first);
    const double begin = Share(time.first - 0.5), end = Share(time.last - 0.5);
    return in_time_([=](double place) {
      if (place <= begin || place >= end) return 0.0;
      const double half = std::sin(M_PI * (place - begin) / (end - begin));
      return half * half;
    });
  }

  Eigen::VectorXd PlaceWeights(const std::array<Stretch, 2>& place) const {
    std::array<Eigen::VectorXd, 2> along;
    for (int axis = 0; axis < 2; ++axis)
      along[axis] = in_place_[axis].col(place[axis].last) - in_place_[axis].col(place[axis].first);
    Eigen::VectorXd weights(layout_.num_nodes());
    for (int node = 0; node < layout_.num_nodes(); ++node)
      weights[node] = along[0][node % layout_.nodes[0]] * along[1][node / layout_.nodes[0]];
    return weights;
  }

  // The candidate with the force that its equations (3 components) make best.
  static Candidate Score(const Eigen::Matrix3d& information, const Eigen::Vector3d& data,
                         Candidate candidate) {
    const double ridge = 1e-9 * information.trace() + 1e-30;
    const Eigen::Matrix3d regular = information + ridge * Eigen::Matrix3d::Identity();
    const auto factor = TryCholesky(regular);
    if (!factor) return candidate;  // with the score of none
    candidate.amplitude = factor->solve(data);
    candidate.score = data.dot(candidate.amplitude);
    return candidate;
  }

  void Keep(const Candidate& candidate) {
    if (candidate.score > best_.score) best_ = candidate;
  }

  // Sums over the knots, which leaves the nodes' equations.
  void ReduceTime(const Eigen::VectorXd& weights, Eigen::MatrixXd* information,
                  Eigen::VectorXd* data) const {
    const int size = layout_.per_knot();
    information->setZero(size, size);
    data->setZero(size);
    for (int k = 0; k < layout_.num_knots; ++k) {
      *data += weights[k] * data_.segment(k * size, size);
      for (int l = 0; l < layout_.num_knots; ++l)
        *information +=
            weights[k] * weights[l] * information_.block(k * size, l * size, size, size);
    }
  }

  // Sums over the nodes, which leaves the knots' equations.
  void ReducePlace(const Eigen::VectorXd& weights, Eigen::MatrixXd* information,
                   Eigen::VectorXd* data) const {
    Eigen::MatrixXd pattern = Eigen::MatrixXd::Zero(layout_.size(), 3 * layout_.num_knots);
    for (int k = 0; k < layout_.num_knots; ++k) {
      for (int node = 0; node < layout_.num_nodes(); ++node) {
        for (int c = 0; c < 3; ++c) pattern(layout_.Index(k, node, c), 3 * k + c) = weights[node];
      }
    }
    *information = pattern.transpose() * (information_ * pattern);
    *data = pattern.transpose() * data_;
  }

  static void ReduceLast(const Eigen::VectorXd& weights, const Eigen::MatrixXd& information,
                         const Eigen::VectorXd& data, Eigen::Matrix3d* last_information,
                         Eigen::Vector3d* last_data) {
    last_information->setZero();
    last_data->setZero();
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      *last_data += weights[i] * data.segment<3>(3 * i);
      for (Eigen::Index j = 0; j < weights.size(); ++j)
        *last_information += weights[i] * weights[j] * information.block<3, 3>(3 * i, 3 * j);
    }
  }

  // All rectangles on every `coarseness`th line of the lattice, for the candidate's time.
  void TryPlaces(Candidate candidate, int coarseness) {
    Eigen::MatrixXd information;
    Eigen::VectorXd data;
    ReduceTime(TimeWeights(candidate.time, candidate.course), &information, &data);
    const int least = std::max(coarseness, kLattice / 8);  // a rectangle's sides
    for (int u0 = 0; u0 < kLattice; u0 += coarseness) {
      for (int u1 = u0 + least; u1 <= kLattice; u1 += coarseness) {
        for (int v0 = 0; v0 < kLattice; v0 += coarseness) {
          for (int v1 = v0 + least; v1 <= kLattice; v1 += coarseness) {
            candidate.place = {Stretch{u0, u1}, Stretch{v0, v1}};
            TryReduced(PlaceWeights(candidate.place), information, data, candidate);
          }
        }
      }
    }
  }

  void TryReduced(const Eigen::VectorXd& weights, const Eigen::MatrixXd& information,
                  const Eigen::VectorXd& data, const Candidate& candidate) {
    Eigen::Matrix3d last_information;
    Eigen::Vector3d last_data;
    ReduceLast(weights, information, data, &last_information, &last_data);
    Keep(Score(last_information, last_data, candidate));
  }

  void StartCoarse() {
    const int frames = last_frame_ + 1, pieces = std::min(10, frames);
    for (int i = 0; i < pieces; ++i) {
      for (int j = i + 1; j <= pieces; ++j) {
        Candidate candidate;
        candidate.time = {i * frames / pieces, j * frames / pieces};
        TryPlaces(candidate, 4);
      }
    }
  }

  void ImproveTime() {
    Eigen::MatrixXd information;
    Eigen::VectorXd data;
    ReducePlace(PlaceWeights(best_.place), &information, &data);
    Candidate candidate = best_;
    const int least = std::max(2, layout_.frames_per_knot / 2);
    for (int first = 0; first <= last_frame_; ++first) {
      for (int last = first + least; last <= last_frame_ + 1; ++last) {
        candidate.time = {first, last};
        for (const Course course : {Course::kConstant, Course::kSwell}) {
          candidate.course = course;
          TryReduced(TimeWeights(candidate.time, course), information, data, candidate);
        }
      }
    }
  }

  void ImprovePlace(int coarseness) { TryPlaces(best_, coarseness); }

  ForcePatch Finish() const {
    ForcePatch patch;
    const Eigen::Vector2d size = layout_.high - layout_.low;
    for (int axis = 0; axis < 2; ++axis) {
      patch.low_uv[axis] = layout_.low[axis] + size[axis] * best_.place[axis].first / kLattice;
      patch.high_uv[axis] = layout_.low[axis] + size[axis] * best_.place[axis].last / kLattice;
    }
    patch.first_frame = best_.time.first;
    patch.last_frame = best_.time.last - 1;
    patch.course = best_.course;
    patch.amplitude = best_.amplitude;
    patch.score = best_.score / (noise_ * noise_);
    const Eigen::VectorXd in_place = PlaceWeights(best_.place);
    const Eigen::VectorXd in_time = TimeWeights(best_.time, best_.course);
    patch.weights.resize(in_place.size() * in_time.size());
    for (Eigen::Index k = 0; k < in_time.size(); ++k)
      patch.weights.segment(k * in_place.size(), in_place.size()) = in_time[k] * in_place;
    return patch;
  }

  const ForceLayout& layout_;
  double noise_;
  Eigen::MatrixXd information_;
  Eigen::VectorXd data_;
  int last_frame_;
  HatProjection in_time_;
  std::array<Eigen::MatrixXd, 2> in_place_;
  Eigen::MatrixXd by_frame_;
  Candidate best_;
};

}  // namespace

ForcePatch FindPatch(const MissingForce& missing) { return PatchSearch(missing).Run(); }

}  // namespace clothfit
