// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// An elastic thread sewn along the cloth's diagonal from (0, 0), shorter than the cloth by a share:
//   tension = stiffness (e + sqrt(e^2 + s^2)) / 2,  e = l / ((1 - gather) l_0) - 1,  s = 0.01,
// linear where it is taut and next to nothing where it is slack. For recordings of trials only:
// clothfit's own list of terms has no line that pulls together.
#pragma once

#include <cmath>

#include "autodiff_sim/term/term.h"

namespace clothfit {

// Pieces of the thread between neighbouring particles, one for each cell of a grid's longer side;
// none where the mesh is no grid.
struct ThreadPiece {
  std::array<int, 2> nodes;
  double length;  // m, on the flat cloth
};
std::vector<ThreadPiece> DiagonalThreadPieces(const ClothMesh& mesh);

struct DiagonalThread : TermDefaults {
  static constexpr const char* kName = "diagonal_thread";
  static constexpr const char* kDoc = "an elastic thread sewn along the diagonal";
  static constexpr const char* kReference = "spring that does not push";
  static constexpr int kNodes = 2;
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 2> kParameters = {{
      {"stiffness", "N", "tension over strain", 0.0, 0.0, 0.0, 100.0, Scale::kLinear, 1.0},
      Shape({"gather", "1", "share by which it is shorter than the cloth", 0.05, 0.05, 0.0, 0.5,
             Scale::kLinear, 0.05},
            Meaning::kNumber, 0.0, 0.1),
  }};
  using Element = ThreadPiece;
  static std::vector<Element> Elements(const TermContext& context) {
    return DiagonalThreadPieces(context.mesh);
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<DiagonalThread, T>& in,
                       ElementOutput<DiagonalThread, T>* out) {
    using std::sqrt;
    constexpr double kRounding = 0.01;  // s, of the corner between slack and taut
    const Vector3<T> along = in.x[1] - in.x[0];
    const T length = sqrt(along.dot(along));
    const T strain = length / ((1.0 - in.parameter[1]) * element.length) - 1.0;
    const T taut = (strain + sqrt(strain * strain + kRounding * kRounding)) * 0.5;
    const T pull = in.parameter[0] * taut / length;
    for (int k = 0; k < 3; ++k) {
      out->force[0][k] += pull * along[k];
      out->force[1][k] -= pull * along[k];
    }
  }
};

}  // namespace clothfit
