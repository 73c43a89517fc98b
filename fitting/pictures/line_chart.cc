// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/pictures/line_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace clothfit {
namespace {

// px
constexpr double kWidth = 460.0, kHeight = 330.0;  // of a chart
constexpr double kLeft = 72.0, kRight = 16.0, kTop = 34.0, kBottom = 48.0;
constexpr double kLegendRow = 22.0, kLegendLeft = 24.0;

constexpr std::array<const char*, 7> kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                 "#e69f00", "#56b4e9", "#000000"};

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else
      escaped += c;
  }
  return escaped;
}

struct Axis {
  bool log = false;
  double low = 0.0, high = 1.0;   // of what is drawn: numbers, or their logarithms
  double begin = 0.0, end = 1.0;  // px

  double Scaled(double value) const { return log ? std::log10(value) : value; }
  double At(double value) const {
    return begin + (Scaled(value) - low) / (high - low) * (end - begin);
  }
  std::vector<double> Ticks() const {
    return log ? LogTicks(std::pow(10.0, low), std::pow(10.0, high)) : LinearTicks(low, high, 6);
  }
};

bool IsDrawable(const Chart& chart, const Eigen::Vector2d& point) {
  return point.allFinite() && (!chart.log_x || point.x() > 0.0) &&
         (!chart.log_y || point.y() > 0.0);
}

Axis MakeAxis(const Chart& chart, int coordinate, double begin, double end) {
  Axis axis;
  axis.log = coordinate == 0 ? chart.log_x : chart.log_y;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ChartLine& line : chart.lines) {
    for (const Eigen::Vector2d& point : line.points) {
      if (!IsDrawable(chart, point)) continue;
      low = std::min(low, axis.Scaled(point[coordinate]));
      high = std::max(high, axis.Scaled(point[coordinate]));
    }
  }
  if (!(low <= high)) low = 0.0, high = 1.0;  // nothing to draw
  const double margin = high > low ? 0.04 * (high - low) : 0.5 * std::max(1.0, std::abs(low));
  axis.low = low - margin;
  axis.high = high + margin;
  axis.begin = begin;
  axis.end = end;
  return axis;
}

std::string TickText(double value) {
  const double size = std::abs(value);
  if (size >= 1e5 || (size > 0.0 && size < 1e-3)) return fmt::format("{:.0e}", value);
  return fmt::format("{:g}", value);
}

std::string Frame(const Chart& chart, const Axis& x, const Axis& y) {
  std::string svg;
  for (const double tick : x.Ticks()) {
    svg += fmt::format(
        "<line class='grid' x1='{0:.1f}' y1='{1:.1f}' x2='{0:.1f}' y2='{2:.1f}'/>"
        "<text x='{0:.1f}' y='{3:.1f}' text-anchor='middle'>{4}</text>\n",
        x.At(tick), y.begin, y.end, y.begin + 16.0, TickText(tick));
  }
  for (const double tick : y.Ticks()) {
    svg += fmt::format(
        "<line class='grid' x1='{0:.1f}' y1='{2:.1f}' x2='{1:.1f}' y2='{2:.1f}'/>"
        "<text x='{3:.1f}' y='{4:.1f}' text-anchor='end'>{5}</text>\n",
        x.begin, x.end, y.At(tick), x.begin - 6.0, y.At(tick) + 4.0, TickText(tick));
  }
  const double middle = 0.5 * (x.begin + x.end), height = 0.5 * (y.begin + y.end);
  svg += fmt::format("<rect class='frame' x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}'/>\n",
                     x.begin, y.end, x.end - x.begin, y.begin - y.end);
  svg += fmt::format("<text class='title' x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>\n",
                     middle, y.end - 12.0, Escaped(chart.title));
  svg += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>\n", middle,
                     y.begin + 36.0, Escaped(chart.x_label));
  svg += fmt::format(
      "<text transform='translate({:.1f} {:.1f}) rotate(-90)' text-anchor='middle'>{}</text>\n",
      x.begin - 54.0, height, Escaped(chart.y_label));
  return svg;
}

std::string Line(const Chart& chart, const ChartLine& line, const Axis& x, const Axis& y,
                 const char* colour) {
  std::string path, dots;
  double last = 0.0;
  for (const Eigen::Vector2d& point : line.points) {
    if (!IsDrawable(chart, point)) continue;
    const double px = x.At(point.x()), py = y.At(point.y());
    if (line.steps && !path.empty()) path += fmt::format("L{:.1f} {:.1f}", px, last);
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", px, py);
    last = py;
    if (line.markers) {
      dots += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='3' fill='{}'/>", px, py, colour);
    }
  }
  return fmt::format("<path class='line' stroke='{}' d='{}'/>{}\n", colour, path, dots);
}

std::vector<std::string> NamesOf(const std::vector<Chart>& charts) {
  std::vector<std::string> names;
  for (const Chart& chart : charts) {
    for (const ChartLine& line : chart.lines) {
      if (std::find(names.begin(), names.end(), line.name) == names.end())
        names.push_back(line.name);
    }
  }
  return names;
}

const char* ColourOf(const std::vector<std::string>& names, const std::string& name) {
  const auto place = std::find(names.begin(), names.end(), name) - names.begin();
  return kColours[static_cast<std::size_t>(place) % kColours.size()];
}

// px; most fonts are narrower. A letter is one byte, or several of which the later ones are marked.
double WidthOf(const std::string& text) {
  constexpr double kLetter = 7.5;
  return kLetter * static_cast<double>(std::count_if(text.begin(), text.end(), [](char byte) {
           return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
         }));
}

// Rows of entries, each a line and a name; columns are as wide as the longest name.
struct Legend {
  explicit Legend(std::vector<std::string> of_lines, double width) : names(std::move(of_lines)) {
    for (const std::string& name : names)
      column = std::max(column, kSample + kGap + WidthOf(name) + 2.0 * kGap);
    columns = std::max<std::size_t>(1, static_cast<std::size_t>((width - kLegendLeft) / column));
  }
  double Height() const {
    return kLegendRow * static_cast<double>((names.size() + columns - 1) / columns);
  }
  double Width() const {
    return kLegendLeft + column * static_cast<double>(std::min(columns, names.size()));
  }
  std::string Svg(double top) const {
    std::string svg;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const double x = kLegendLeft + column * static_cast<double>(i % columns);
      const double y = top + kLegendRow * static_cast<double>(i / columns) + 12.0;
      svg += fmt::format(
          "<path class='line' stroke='{}' d='M{:.1f} {:.1f}h{:.0f}'/><text class='name' x='{:.1f}' "
          "y='{:.1f}'>{}</text>\n",
          ColourOf(names, names[i]), x, y, kSample, x + kSample + kGap, y + 4.0, Escaped(names[i]));
    }
    return svg;
  }

  static constexpr double kSample = 24.0, kGap = 6.0;  // px
  std::vector<std::string> names;
  double column = 1.0;  // px
  std::size_t columns = 1;
};

}  // namespace

std::vector<double> LinearTicks(double low, double high, int most) {
  std::vector<double> ticks;
  const double raw = (high - low) / std::max(1, most);
  if (!(raw > 0.0) || !std::isfinite(raw)) return {low};
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= raw) step = factor * power;
  }
  for (double k = std::ceil(low / step); k * step <= high; k += 1.0)
    ticks.push_back(k * step + 0.0);  // no "-0"
  return ticks;
}

std::vector<double> LogTicks(double low, double high) {
  const auto between = [&](std::initializer_list<double> factors) {
    std::vector<double> ticks;
    for (double power = std::floor(std::log10(low)); power <= std::log10(high); power += 1.0) {
      for (const double factor : factors) {
        const double tick = factor * std::pow(10.0, power);
        if (tick >= low && tick <= high) ticks.push_back(tick);
      }
    }
    return ticks;
  };
  constexpr std::size_t kFew = 3;
  const std::vector<double> powers = between({1.0});
  return powers.size() >= kFew ? powers : between({1.0, 2.0, 5.0});
}

std::string ChartsAsSvg(const std::vector<Chart>& charts) {
  const std::vector<std::string> names = NamesOf(charts);
  const double of_charts = kWidth * static_cast<double>(std::max<std::size_t>(1, charts.size()));
  const Legend legend(names, of_charts);
  const double width = std::max(of_charts, legend.Width());
  const double height = kHeight + legend.Height() + 8.0;
  std::string svg = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' width='{0:.0f}' height='{1:.0f}' "
      "viewBox='0 0 {0:.0f} {1:.0f}' font-family='sans-serif' font-size='12'>\n"
      "<style>.grid{{stroke:#ddd}}.frame{{fill:none;stroke:#666}}.line{{fill:none;"
      "stroke-width:1.8;stroke-linejoin:round;stroke-opacity:.85}}.title{{font-weight:bold}}"
      "</style>\n<rect width='100%' height='100%' fill='#fff'/>\n",
      width, height);
  double left = 0.0;
  for (const Chart& chart : charts) {
    const Axis x = MakeAxis(chart, 0, left + kLeft, left + kWidth - kRight);
    const Axis y = MakeAxis(chart, 1, kHeight - kBottom, kTop);
    svg += Frame(chart, x, y);
    for (const ChartLine& line : chart.lines)
      svg += Line(chart, line, x, y, ColourOf(names, line.name));
    left += kWidth;
  }
  return svg + legend.Svg(kHeight) + "</svg>\n";
}

}  // namespace clothfit
