// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Line charts as SVG, which opens in any browser, prints sharp and is small.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

struct ChartLine {
  std::string name;  // lines of one name share a colour and an entry of the legend
  std::vector<Eigen::Vector2d> points;
  bool steps = false;    // level between points, as the best value so far
  bool markers = false;  // a dot at every point
};

struct Chart {
  std::string title, x_label, y_label;
  bool log_x = false, log_y = false;  // points that have no logarithm are left out
  std::vector<ChartLine> lines;
};

// Charts side by side with one legend below. The colours are those of Okabe and Ito 2008, which
// survive colour blindness; of many names some share one.
std::string ChartsAsSvg(const std::vector<Chart>& charts);

// Places of a linear axis's ticks, round numbers, at most about `most` of them.
std::vector<double> LinearTicks(double low, double high, int most);
// Of a logarithmic one: powers of ten; 2 and 5 times them too where those are few.
std::vector<double> LogTicks(double low, double high);

}  // namespace clothfit
