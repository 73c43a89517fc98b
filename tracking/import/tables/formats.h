// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Tables of markers as programs of motion capture export them. Each format has a header of its own;
// the rows after it are read alike.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tracking/import/markers/take_in_file.h"
#include "tracking/import/tables/lines.h"

namespace clothfit {

// Where a marker's coordinates stand in a row.
struct MarkerColumns {
  std::string name, id;
  bool is_expected = false;  // where a rigid body that was found has it; not measured
  std::array<std::optional<size_t>, 3> axes;  // X, Y, Z; all there once the header was read
};

// What a header says.
struct MarkerTable {
  TakeFacts facts;
  size_t num_columns = 0;
  std::optional<size_t> frame_column, time_column;  // without either, rows are frames
  std::vector<MarkerColumns> markers;               // at least one that is measured
  std::set<std::string> bodies;
  std::optional<int> num_frames;  // as the header has it
  bool ends_at_empty_line = false;
  bool zeros_are_lost = false;  // a marker at 0, 0, 0 was not seen
};

// Each of these reads up to the first row of data, and sets the separator.

// OptiTrack, "Data Export: CSV"; format versions 1.2 and later. Columns of type Marker and Rigid
// Body Marker; bones are left alone. Motive's y points up.
MarkerTable ReadMotiveHeader(TableLines* lines);

// Track Row Column of Motion Analysis, which OpenSim writes too.
MarkerTable ReadTrcHeader(TableLines* lines);

// Qualisys Track Manager, "TSV export"; lengths in millimetres. A marker at zero is lost.
MarkerTable ReadQualisysHeader(TableLines* lines);

// The section "Trajectories" of the ASCII export of Vicon Nexus.
MarkerTable ReadViconHeader(TableLines* lines);
bool IsVicon(std::string_view text);

// One line of names: "frame" or "time" (s) or both, and NAME_x, NAME_y, NAME_z of each marker, with
// '_', '.', ':' or a blank before the axis. Fields end at a comma, a semicolon or a tab. Without a
// time, rows say no rate. `notes` gets a sentence on columns that are left out.
MarkerTable ReadPlainHeader(TableLines* lines, std::vector<std::string>* notes);

// What a field says, in Hz and in metres; `label` is its name in messages.
double RateOf(const std::string& label, const std::string& text, const TableLines& lines);
double UnitOf(const std::string& label, const std::string& text, const TableLines& lines);

// Throws at the line last read, unless there are markers that were measured, of distinct names and
// with all three axes. `found` is what the header has instead.
void CheckMarkers(const std::vector<MarkerColumns>& markers, const std::string& found,
                  const TableLines& lines);

// Reads the rows after the header. A marker is lost where its fields are empty or not a number
// ("nan"). Frames count from the first row's; a number or a time that is left out is a frame in
// which all markers are lost.
TakeInFile ReadRows(const MarkerTable& table, const TakeFileOptions& options, TableLines* lines,
                    std::vector<std::string>* notes);

}  // namespace clothfit
