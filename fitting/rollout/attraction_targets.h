// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What pulls at the cloth while it is simulated towards its observations (Hasler et al. 2007,
// sec. 4).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "autodiff_sim/contact/closest_on_mesh.h"
#include "autodiff_sim/term/step_inputs.h"
#include "fitting/scene/scene.h"

namespace clothfit {

// Adds the fitted markers of a frame and the rays of its fitted tracks; they pull as strongly as
// attraction_point.* and attraction_ray.* say.
void AddAttractionTargets(const Scene& scene, int frame, StepInputs* inputs);

// The same targets at any time, on their courses between the frames: Catmull-Rom splines through
// what was observed, so that the cloth is drawn to where a target is by then, and the motion
// relative to it can be damped. What was not seen at the same point of the cloth in the frame
// before stands still where it is in the coming frame, and damps nothing. Where one frame in so
// many is fitted, the frame before is the fitted one, and courses lead through those between.
class AttractionCourses {
 public:
  // The scene must outlive it.
  explicit AttractionCourses(const Scene& scene);

  // From here on the fitted clouds' points of a coming frame pull at what is closest to them of the
  // cloth at x (3N, m, world), and those of other frames no more (Besl and McKay 1992).
  void Approach(int frame, const Eigen::VectorXd& x);

  // time: s since frame 0.
  void AddTargets(double time, StepInputs* inputs) const;

 private:
  // Coefficients of 1, s, s^2, s^3, where s goes from 0 to 1 between two frames.
  template <class Values>
  struct Course {
    SurfacePoint on_cloth;
    std::array<Values, 4> coefficients;
    bool is_known;  // seen in the frame before, too
  };
  using PointCourse = Course<Eigen::Vector3d>;
  using RayCourse =
      Course<Eigen::Matrix<double, 6, 1>>;  // direction and moment, not of unit length

  const Scene& scene_;
  std::optional<ClosestOnMesh> surface_;  // where there are clouds
  std::vector<PointTarget> of_clouds_;
  double frame_rate_;
  // By the frame at which they end.
  std::vector<std::vector<PointCourse>> points_;
  std::vector<std::vector<RayCourse>> rays_;
};

}  // namespace clothfit
