// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "clothfit/term.h"

#include <algorithm>

#include "autodiff_sim/terms/added_terms.h"
#include "clothfit/detail/boundary.h"
#include "clothfit/detail/data.h"

namespace clothfit::v0::detail {
namespace {

Cloth ToCloth(const TermContext& context) {
  Cloth cloth;
  for (const Eigen::Vector2d& uv : context.mesh.uv) cloth.uv.push_back(ToArray(uv));
  cloth.areas = context.topology.areas;
  cloth.triangles = context.mesh.triangles;
  cloth.gravity = ToArray(context.world.gravity);
  cloth.ground_height = context.world.ground_height;
  return cloth;
}

TermInfo InfoOf(const PlainTerm& term) {
  TermInfo info;
  info.name = term.name;
  info.doc = term.doc;
  info.reference = "added by the program";
  info.nodes = term.particles;
  info.ties = {Tie::kWorld};
  for (const TermParameter& p : term.parameters)
    info.parameters.push_back(
        {p.name, p.unit, p.doc, p.initial, p.off, p.lower, p.upper,
         p.scale == Scale::kLog ? clothfit::Scale::kLog : clothfit::Scale::kLinear, p.prior});
  const bool is_off = std::all_of(term.parameters.begin(), term.parameters.end(),
                                  [](const TermParameter& p) { return p.initial == p.off; });
  info.role = is_off ? Role::kMayBeMissing : Role::kOrdinary;
  return info;
}

}  // namespace

void AddPlainTerm(const PlainTerm& term) {
  AtBoundary([&] {
    const auto elements = [make = term.make, evaluate = term.evaluate](const TermContext& context) {
      AddedElements added;
      const std::shared_ptr<const void> made = make(ToCloth(context), &added.particles);
      added.evaluate = [made, evaluate](std::size_t element, const ElementPoint& point,
                                        double* force, double* jacobian) {
        evaluate(made.get(), element, point.time, point.step, point.x, point.v, point.parameter,
                 force, jacobian);
      };
      return added;
    };
    clothfit::AddTerm({InfoOf(term), elements});
  });
}

}  // namespace clothfit::v0::detail
