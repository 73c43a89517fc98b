// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The shape of a sparse Cholesky factor: an elimination order, and columns of (nearly) the same
// pattern gathered in dense panels, its supernodes (Ng and Peyton 1993). In particles, of which
// each stands for three rows and columns.
#pragma once

#include <vector>

#include "autodiff_sim/linear/block_sparse_matrix.h"

namespace clothfit {

// A dense block column of the factor. Its rows are its own particles first, then those below.
struct Panel {
  int first, width;    // particles in elimination order: its columns are [first, first + width)
  int height;          // particles in its rows, the own ones included
  int rows;            // where its rows begin in Supernodes::rows
  int stride;          // numbers between two columns, 3 * height rounded up to whole registers
  std::size_t values;  // where its numbers begin, column after column
  int targets_begin, targets_end;  // of Supernodes::targets
};

// What a panel's outer product adds to one of the panels after it.
struct PanelTarget {
  int panel;
  int row_begin, row_end;  // the rows of the source that are columns of the target
  int positions;           // where in Supernodes::positions the rows from row_begin on begin
};

// Where a block of the lower triangle goes.
struct BlockPlace {
  int block, mirror;   // of the matrix: a (row, column) and its mirror image (column, row)
  std::size_t values;  // its first number in the factor
  int stride;
  bool diagonal;
};

struct Supernodes {
  std::vector<int> order;  // the particle that is eliminated as the i-th
  std::vector<Panel> panels;
  std::vector<int> rows;  // particles, in elimination order, ascending within a panel
  std::vector<PanelTarget> targets;
  std::vector<int> positions;  // row of the target, in particles
  std::vector<BlockPlace> places;
  std::size_t num_values = 0;
  int largest_stride = 0;
};

// Numbers are padded to multiples of this many, and columns begin at one.
constexpr int kRegister = 16;

// How the elimination order is found.
enum class Ordering {
  kNestedDissection,  // by METIS: the least fill
  kMinimumDegree,     // AMD: about as little on a cloth, found in a quarter of the time
};

// Orders and finds the supernodes, both by CHOLMOD.
Supernodes FindSupernodes(const BlockPattern& pattern,
                          Ordering ordering = Ordering::kNestedDissection);

}  // namespace clothfit
