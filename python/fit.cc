// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The Python module: fits, diagnoses and simulations.
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

Config ConfigOr(const Recording& recording, const std::optional<Config>& config) {
  return config ? *config : Config(recording);
}

Run FitWatched(const Recording& recording, const std::optional<Config>& config,
               const std::optional<path>& folder, bool replace, bool resume,
               const py::object& progress) {
  return RunWatched(progress, [&](const Callbacks& callbacks) {
    return Fit(recording, ConfigOr(recording, config),
               {folder ? folder->string() : "", ToExisting(replace, resume), callbacks});
  });
}

Diagnosis DiagnoseWatched(const Recording& recording, const std::optional<Config>& config,
                          const std::optional<path>& folder, bool replace, bool resume,
                          const std::vector<std::string>& exclude, int max_effects, int max_models,
                          int finest_side, const py::object& progress) {
  return RunWatched(progress, [&](const Callbacks& callbacks) {
    return Diagnose(recording, ConfigOr(recording, config),
                    {folder ? folder->string() : "", ToExisting(replace, resume), exclude,
                     max_effects, max_models, finest_side, callbacks});
  });
}

py::array TrianglesOf(const std::vector<std::array<int, 3>>& triangles) {
  return py::array_t<int>({triangles.size(), std::size_t{3}},
                          triangles.empty() ? nullptr : triangles.front().data());
}

py::array Predict(const Run& run, const Integers& frames, const Numbers& uv) {
  if (frames.ndim() != 1) throw InputError("frames: expected an array of shape (points,)");
  const std::vector<int> of_points(frames.data(), frames.data() + frames.size());
  return Take(run.Predict(of_points, ToVector2s(uv, "uv")));
}

// All values from an array, or the config's.
Motion Simulate(Simulation* simulation, const std::optional<Numbers>& values, bool with_jacobian) {
  std::vector<double> given = simulation->start();
  if (values) {
    if (values->ndim() != 1) throw InputError("values: expected an array of shape (parameters,)");
    given.assign(values->data(), values->data() + values->size());
  }
  Motion motion = RunWatched(py::none(), [&](const Callbacks& callbacks) {
    return simulation->Run(given, with_jacobian, callbacks.stop);
  });
  if (motion.complete) return motion;
  throw std::runtime_error("the simulation breaks down after frame " +
                           std::to_string(motion.positions.shape[0] - 1));
}

void AddErrors(py::module_* module) {
  py::class_<Errors>(*module, "Errors",
                     "Root mean square distances from what was observed; None where there is none.")
      .def_readonly("markers", &Errors::markers, "m")
      .def_readonly("tracks", &Errors::tracks, "px")
      .def_readonly("clouds", &Errors::clouds, "m, of their points from the surface")
      .def_readonly("silhouettes", &Errors::silhouettes, "px that differ, in a picture");
  py::class_<Estimate>(*module, "Estimate", "What a fit found of one unknown.")
      .def_readonly("name", &Estimate::name)
      .def_readonly("unit", &Estimate::unit)
      .def_readonly("value", &Estimate::value)
      .def_readonly("start", &Estimate::start)
      .def_readonly("free", &Estimate::free)
      .def_readonly("lower", &Estimate::lower, "end of the 95 % interval, where free")
      .def_readonly("upper", &Estimate::upper, "end of the 95 % interval, where free")
      .def_readonly("determined", &Estimate::determined, "by the data rather than by its prior")
      .def_readonly("at_bound", &Estimate::at_bound);
}

}  // namespace

void AddFit(py::module_* module) {
  AddErrors(module);
  py::class_<Run>(*module, "Run", "A finished fit; never changed.")
      .def(py::init([](const path& folder) { return Run::Read(folder.string()); }),
           py::arg("folder"), "Reads the folder of an earlier fit. Raises InputError.")
      .def_property_readonly("folder", &Run::folder)
      .def_property_readonly("status", &Run::status, "'converged', 'not converged', ...")
      .def_property_readonly("verdict", &Run::verdict, "how good the fit is, in a sentence")
      .def_property_readonly("sentences", &Run::sentences, "and why")
      .def_property_readonly("seconds", &Run::seconds)
      .def_property_readonly("fitted", &Run::fitted, "errors of the fitted frames")
      .def_property_readonly("held_out", &Run::held_out, "errors of frames that no fit has seen")
      .def_property_readonly(
          "estimates",
          [](const Run& run) {
            py::dict estimates;
            for (const Estimate& e : run.estimates()) estimates[py::str(e.name)] = e;
            return estimates;
          },
          "by name, physical parameters first")
      .def("__getitem__", &Run::Value, py::arg("parameter"), "its value, in its unit")
      .def_property_readonly(
          "trajectory",
          [](const Run& run) {
            return View(run.trajectory().values.data(), run.trajectory().shape, run);
          },
          "(frames, particles, 3), m, world; read-only, not copied")
      .def_property_readonly(
          "uv", [](const Run& run) { return View(run.uv().values.data(), run.uv().shape, run); },
          "(particles, 2), m, on the cloth; read-only, not copied")
      .def_property_readonly(
          "triangles", [](const Run& run) { return TrianglesOf(run.triangles()); },
          "(triangles, 3), particles, counter-clockwise in (u, v)")
      .def("predict", &Predict, py::arg("frames"), py::arg("uv"),
           "Where points of the cloth are: frames (n,), uv (n, 2) in m. Returns (n, 3), m, world.")
      .def(
          "report",
          [](const Run& run, const path& file, bool replace) {
            run.Report(file.string(), ToExisting(replace, false));
          },
          py::arg("file"), py::arg("replace") = false, "Writes a page to open in a browser.")
      .def(
          "export",
          [](const Run& run, const std::string& format, const path& file, bool replace) {
            run.Export(format, file.string(), ToExisting(replace, false));
          },
          py::arg("format"), py::arg("file"), py::arg("replace") = false,
          R"(Writes the run for other programs; lengths in m, z up. format:

'gltf': binary glTF 2.0 (.glb), a morph target a frame; y is up.
'usda': Universal Scene Description as text, an animated mesh.
'pc2', 'mdd': point caches for the run's mesh.obj, the second LightWave's.
'obj', 'ply': a file a frame, in a folder: Wavefront OBJ, binary PLY.
'csv': table of frame, time (s), particle, u, v, x, y, z.
'npy': NumPy array, frames x particles x 3.
'video': pictures of the first camera with the simulated outline (.mp4).
'mjcf', 'newton', 'blender': the cloth itself, to be simulated by MuJoCo, Newton and Blender.

Raises InputError where format is none of these, the run lacks what it needs or file is there.)");
  module->def(
      "fit", &FitWatched, py::arg("recording"), py::arg("config") = py::none(), py::kw_only(),
      py::arg("folder") = py::none(), py::arg("replace") = false, py::arg("resume") = false,
      py::arg("progress") = py::none(),
      R"(Fits a simulated cloth to a recording (or to the folder of one) and returns the Run.

Where the config has no cloth.resolution the fit begins with the recording's and may choose a finer one,
up to cloth.finest.

folder: where the run is written; None: nowhere that lasts. replace: what an earlier fit wrote
there. resume: go on with an interrupted one. progress: called as progress(stage, share).
Ctrl-C raises KeyboardInterrupt; with a folder, resume=True goes on from there.
Raises InputError where the input cannot be used, RuntimeError where the simulation fails.)");
}

void AddDiagnosis(py::module_* module) {
  py::class_<Amount>(
      *module, "Amount",
      "An amount of an effect with its 90 % interval, nan where the diagnosis was interrupted.")
      .def_readonly("name", &Amount::name)
      .def_readonly("unit", &Amount::unit)
      .def_readonly("value", &Amount::value)
      .def_readonly("lower", &Amount::lower)
      .def_readonly("upper", &Amount::upper);
  py::class_<Candidate>(*module, "Candidate", "An effect that was looked for.")
      .def_readonly("name", &Candidate::name)
      .def_readonly("physics", &Candidate::physics, "else a fault of cameras or markers")
      .def_readonly("share", &Candidate::share, "of the misfit that it explains to first order")
      .def_readonly("p_value", &Candidate::p_value)
      .def_readonly("short_listed", &Candidate::short_listed);
  py::class_<Model>(*module, "Model", "A candidate switched on and everything fitted again.")
      .def_readonly("effects", &Model::effects, "all that are on, the newest last")
      .def_readonly("amounts", &Model::amounts)
      .def_readonly("log_evidence", &Model::log_evidence, "natural logarithm of the odds for it")
      .def_readonly("explained", &Model::explained, "share of the misfit that is gone")
      .def_readonly("kept", &Model::kept);
  py::class_<Diagnosis>(*module, "Diagnosis", "What physics a recording shows that a fit lacks.")
      .def_readonly("verdict", &Diagnosis::verdict, "'named', 'nothing missing', ...")
      .def_readonly("headline", &Diagnosis::headline,
                    "the answer, with all that the recording cannot tell apart")
      .def_readonly("words", &Diagnosis::words,
                    "the same as a paragraph, which begins with the headline")
      .def_readonly("effects", &Diagnosis::effects, "that were named")
      .def_readonly("cannot_tell", &Diagnosis::cannot_tell,
                    "effects that the recording cannot tell from the first, itself among them")
      .def_readonly("cannot_tell_beside", &Diagnosis::cannot_tell_beside,
                    "the same of each later effect that does not stand alone, beside those before "
                    "it")
      .def_readonly("residual_rms", &Diagnosis::residual_rms, "of the baseline's fit, in sigmas")
      .def_readonly("discretisation_rms", &Diagnosis::discretisation_rms,
                    "the discretisation error, of mesh and step, in sigmas")
      .def_readonly("candidates", &Diagnosis::candidates, "best first")
      .def_readonly("models", &Diagnosis::models, "that were fitted")
      .def_readonly("config", &Diagnosis::config, "of the answer; fit and Simulation take it");
  module->def("diagnose", &DiagnoseWatched, py::arg("recording"), py::arg("config") = py::none(),
              py::kw_only(), py::arg("folder") = py::none(), py::arg("replace") = false,
              py::arg("resume") = false, py::arg("exclude") = std::vector<std::string>(),
              py::arg("max_effects") = 3, py::arg("max_models") = 5, py::arg("finest_side") = 31,
              py::arg("progress") = py::none(),
              R"(Finds out what physics a recording shows that the simulation lacks.

exclude: terms that are not looked for. max_effects: that are added, one after the other.
max_models: candidates that are fitted, each time. finest_side: particles a side of the mesh
that decides, at most. The others are those of fit.)");
}

void AddSimulation(py::module_* module) {
  py::class_<Simulation>(*module, "Simulation",
                         "A cloth to be simulated again and again with other values.")
      .def(py::init([](const Recording& recording, const std::vector<std::string>& parameters,
                       const std::optional<Config>& config, int frame_count) {
             return Simulation(recording, ConfigOr(recording, config), parameters, frame_count);
           }),
           py::arg("recording"), py::arg("parameters"), py::arg("config") = py::none(),
           py::arg("frame_count") = 0,
           "parameters: names of the values that are given; others have the config's.")
      .def_property_readonly("parameters", &Simulation::parameters)
      .def_property_readonly(
          "start",
          [](const Simulation& s) {
            return Take({{s.start().size()}, s.start()});
          },
          "(parameters,), the config's values")
      .def_property_readonly("frame_count", &Simulation::frame_count)
      .def_property_readonly(
          "uv", [](const Simulation& s) { return Take(s.uv()); }, "(particles, 2), m")
      .def_property_readonly(
          "triangles", [](const Simulation& s) { return TrianglesOf(s.triangles()); },
          "(triangles, 3), particles")
      .def(
          "positions",
          [](Simulation* s, const std::optional<Numbers>& values) {
            return Take(Simulate(s, values, false).positions);
          },
          py::arg("values") = py::none(),
          R"(The motion from frame 0 on, driven by the handles: (frames, particles, 3), m, world.

values: (parameters,), in their units; None: the config's.
Raises InputError for values out of range, RuntimeError where the simulation breaks down.)")
      .def(
          "jacobian",
          [](Simulation* s, const std::optional<Numbers>& values) {
            Motion motion = Simulate(s, values, true);
            return std::pair(Take(std::move(motion.positions)), Take(std::move(motion.jacobian)));
          },
          py::arg("values") = py::none(),
          R"((positions, jacobian): the motion and its exact derivatives.

positions: (frames, particles, 3), m. jacobian: (frames, particles, 3, parameters), m per unit of
the parameter.)");
}

}  // namespace clothfit::python
