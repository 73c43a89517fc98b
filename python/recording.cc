// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The Python module: recordings and configs.
#include <cmath>
#include <filesystem>

#include <pybind11/functional.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "python/arrays.h"
#include "python/module.h"
#include "python/watched.h"

namespace clothfit::python {
namespace {

using std::filesystem::path;

// frames x markers x 3, not a number where a marker was not seen; marker i has the id i.
std::vector<Marker> ToMarkers(const Numbers& positions, const std::vector<Vector2>& uv) {
  RequireShape(positions, {-1, static_cast<py::ssize_t>(uv.size()), 3}, "markers",
               "(frames, markers, 3), with as many markers as marker_uv has");
  std::vector<Marker> markers;
  for (py::ssize_t f = 0; f < positions.shape(0); ++f) {
    for (py::ssize_t i = 0; i < positions.shape(1); ++i) {
      const Vector3 p = {positions.at(f, i, 0), positions.at(f, i, 1), positions.at(f, i, 2)};
      if (std::isnan(p[0]) || std::isnan(p[1]) || std::isnan(p[2])) continue;
      markers.push_back(
          {static_cast<int>(f), static_cast<int>(i), uv[static_cast<std::size_t>(i)], p});
    }
  }
  return markers;
}

// {name: (uv, path)}, where the path is frames x 3 or None.
std::vector<Handle> ToHandles(const py::dict& given) {
  std::vector<Handle> handles;
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    const auto pair = value.cast<std::pair<Vector2, py::object>>();
    Handle handle{name, pair.first, {}};
    if (!pair.second.is_none())
      handle.path = ToVector3s(pair.second.cast<Numbers>(), "handles: " + name);
    handles.push_back(std::move(handle));
  }
  return handles;
}

Recording FromArrays(const Numbers& markers, const Numbers& marker_uv, double frame_rate,
                     const Vector2& size, const py::dict& handles, const Vector3& origin,
                     const Vector3& u_axis, const Vector3& v_axis, const py::object& initial,
                     std::array<int, 2> resolution, std::optional<double> areal_density,
                     const Vector3& gravity, std::optional<double> ground_height,
                     std::optional<double> marker_sigma,
                     std::optional<std::array<int, 2>> held_out_frames, const std::string& name) {
  RecordingParts parts;
  parts.markers = ToMarkers(markers, ToVector2s(marker_uv, "marker_uv"));
  parts.frame_count = static_cast<int>(markers.shape(0));
  parts.frame_rate = frame_rate;
  parts.size = size;
  parts.handles = ToHandles(handles);
  parts.origin = origin;
  parts.u_axis = u_axis;
  parts.v_axis = v_axis;
  if (!initial.is_none()) {
    const auto [uv, positions] = initial.cast<std::pair<Numbers, Numbers>>();
    const std::vector<Vector2> on_cloth = ToVector2s(uv, "initial");
    const std::vector<Vector3> in_world = ToVector3s(positions, "initial");
    if (on_cloth.size() != in_world.size())
      throw InputError("initial: expected as many positions as (u, v)");
    for (std::size_t i = 0; i < on_cloth.size(); ++i)
      parts.initial.push_back({0, 0, on_cloth[i], in_world[i]});
  }
  parts.resolution = resolution;
  parts.areal_density = areal_density;
  parts.gravity = gravity;
  parts.ground_height = ground_height;
  parts.marker_sigma = marker_sigma;
  parts.held_out_frames = held_out_frames;
  parts.name = name;
  return Recording(parts);
}

py::dict HandlesOf(const Recording& recording) {
  py::dict handles;
  for (const Handle& handle : recording.handles()) {
    py::object path = py::none();
    if (!handle.path.empty()) {
      Array rows{{handle.path.size(), 3}, {}};
      for (const Vector3& p : handle.path)
        rows.values.insert(rows.values.end(), p.begin(), p.end());
      path = Take(std::move(rows));
    }
    handles[py::str(handle.name)] =
        py::make_tuple(py::make_tuple(handle.uv[0], handle.uv[1]), path);
  }
  return handles;
}

template <class Get>
auto AsArray(const Get& get) {
  return [get](const Recording& recording) { return Take((recording.*get)()); };
}

template <class Get>
auto AsIntegers(const Get& get) {
  return [get](const Recording& recording) {
    auto values = std::make_shared<std::vector<int>>((recording.*get)());
    return View(values->data(), {values->size()}, values);
  };
}

}  // namespace

Existing ToExisting(bool replace, bool resume) {
  return resume ? Existing::kResume : replace ? Existing::kReplace : Existing::kRefuse;
}

void AddRecording(py::module_* module) {
  py::class_<Recording>(*module, "Recording", "What was observed of one cloth; never changed.")
      .def(py::init([](const path& folder) { return Recording::Read(folder.string()); }),
           py::arg("folder"), "Reads a recording's folder. Raises InputError.")
      .def_static(
          "from_arrays", &FromArrays, py::arg("markers"), py::arg("marker_uv"), py::kw_only(),
          py::arg("frame_rate"), py::arg("size"), py::arg("handles") = py::dict(),
          py::arg("origin") = Vector3{0.0, 0.0, 0.0}, py::arg("u_axis") = Vector3{1.0, 0.0, 0.0},
          py::arg("v_axis") = Vector3{0.0, 1.0, 0.0}, py::arg("initial") = py::none(),
          py::arg("resolution") = std::array<int, 2>{31, 31}, py::arg("areal_density") = py::none(),
          py::arg("gravity") = Vector3{0.0, 0.0, -9.81}, py::arg("ground_height") = py::none(),
          py::arg("marker_sigma") = py::none(), py::arg("held_out_frames") = py::none(),
          py::arg("name") = "recording",
          R"(A recording of markers in space.

markers: (frames, markers, 3), m, world; nan where a marker was not seen.
marker_uv: (markers, 2), m, where each is on the cloth.
frame_rate: Hz. size: (2,), m, of the cloth along u (warp) and v (weft).
handles: {name: (uv, path)}: points that are held; path (frames, 3), m, nan where it is
    not known, or None where all of it is to be fitted.
origin, u_axis, v_axis: the cloth lies flat at frame 0, x(u, v) = origin + u u_axis + v v_axis
    (m, unit vectors); or initial: (uv, positions), (n, 2) and (n, 3), m, of some of its points.
resolution: particles along u and v. areal_density: kg/m^2; None: estimated.
gravity: m/s^2. ground_height: m, the plane z = height. marker_sigma: m; None: 0.002.
held_out_frames: (first, last), which no fit sees.)")
      .def_property_readonly("folder", &Recording::folder, "empty where it was made of arrays")
      .def_property_readonly("name", &Recording::name)
      .def_property_readonly("frame_rate", &Recording::frame_rate, "Hz")
      .def_property_readonly("frame_count", &Recording::frame_count)
      .def_property_readonly("size", &Recording::size, "of the cloth along u and v, m")
      .def_property_readonly("resolution", &Recording::resolution, "particles along u and v")
      .def_property_readonly("marker_positions", AsArray(&Recording::marker_positions),
                             "(n, 3), m, world")
      .def_property_readonly("marker_uv", AsArray(&Recording::marker_uv), "(n, 2), m")
      .def_property_readonly("marker_frames", AsIntegers(&Recording::marker_frames), "(n,)")
      .def_property_readonly("marker_ids", AsIntegers(&Recording::marker_ids), "(n,)")
      .def_property_readonly("handles", &HandlesOf, "{name: (uv, path)}, as from_arrays takes them")
      .def_property_readonly("camera_names", &Recording::camera_names)
      .def_property_readonly("track_count", &Recording::track_count)
      .def_property_readonly("warnings", &Recording::Warnings, "what is worth knowing, a line each")
      .def("__str__", &Recording::Describe)
      .def("__repr__",
           [](const Recording& r) {
             return "<clothfit.Recording '" + r.name() + "', " + std::to_string(r.frame_count()) +
                    " frames>";
           })
      .def(
          "write",
          [](const Recording& recording, const path& folder, bool replace) {
            recording.Write(folder.string(), ToExisting(replace, false));
          },
          py::arg("folder"), py::arg("replace") = false, "Writes it as a folder.")
      .def(
          "track",
          [](const Recording& recording, const path& folder, bool replace,
             const py::object& progress) {
            return RunWatched(progress, [&](const Callbacks& callbacks) {
              return recording.Track(folder.string(), ToExisting(replace, false), callbacks);
            });
          },
          py::arg("folder"), py::kw_only(), py::arg("replace") = false,
          py::arg("progress") = py::none(),
          "Finds masks, tracks and markers in its pictures; writes and returns a new recording.");
  py::implicitly_convertible<path, Recording>();
}

void AddConfig(py::module_* module) {
  py::class_<Parameter>(*module, "Parameter", "A physical parameter of a config.")
      .def_readonly("name", &Parameter::name, "term.parameter")
      .def_readonly("unit", &Parameter::unit)
      .def_readonly("doc", &Parameter::doc)
      .def_readonly("value", &Parameter::value, "start of a fit, or what is simulated")
      .def_readonly("free", &Parameter::free, "estimated by a fit")
      .def_readonly("lower", &Parameter::lower)
      .def_readonly("upper", &Parameter::upper)
      .def_readonly("off", &Parameter::off, "at which its term does nothing")
      .def("__repr__", [](const Parameter& p) {
        return "<clothfit.Parameter " + p.name + " = " +
               py::str(py::float_(p.value)).cast<std::string>() + " " + p.unit + ">";
      });
  py::class_<Config>(*module, "Config", "What a fit, a diagnosis or a simulation is told.")
      .def(py::init([](const Recording& recording, const std::optional<path>& file) {
             return file ? Config(recording, file->string()) : Config(recording);
           }),
           py::arg("recording"), py::arg("file") = py::none(),
           "The defaults for a recording, and what a config.yaml says over them.")
      .def("__getitem__", &Config::Value, py::arg("parameter"), "in the parameter's unit")
      .def("__setitem__", &Config::Set, py::arg("parameter"), py::arg("value"))
      .def("free", &Config::Free, py::arg("name"), "Lets a parameter, or a term's, be estimated.")
      .def("fix", &Config::Fix, py::arg("name"), "Holds a parameter, or a term's, at its value.")
      .def("without", &Config::Without, py::arg("term"), "Switches a term off.")
      .def("set_key", &Config::SetKey, py::arg("key"), py::arg("yaml"),
           "Any other key as config.yaml has it: ('strategy.window', '0.5').")
      .def_property_readonly(
          "parameters",
          [](const Config& config) {
            py::dict parameters;
            for (const Parameter& p : config.parameters()) parameters[py::str(p.name)] = p;
            return parameters;
          },
          "all of them, by name")
      .def_property_readonly("yaml", &Config::Yaml, "all of it, as config.yaml")
      .def("copy", [](const Config& config) { return Config(config); });
}

}  // namespace clothfit::python
