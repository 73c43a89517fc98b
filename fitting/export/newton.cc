// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Reference: Newton, ModelBuilder.add_cloth_mesh, SolverVBD.
#include "fitting/export/newton.h"

#include <map>
#include <string>

#include <fmt/format.h>

#include "fitting/export/script_text.h"

namespace clothfit {
namespace {

constexpr const char* kNewtonScript =
    R"py(# The cloth of @NAME@, fitted by clothfit @VERSION@, for Newton and Warp:
#   python THIS_FILE OUT.npy              # OUT.npy: frames x particles x 3, m
#   python THIS_FILE OUT.npy --springs    # clothfit's springs in the place of Newton's triangles
# docs/material-elsewhere.md of clothfit derives each number and says what it is worth.
#
# Not kept by the triangles, which are of one isotropic material:
# - shearing is @SHEAR@ N/m in the fit, and half the stretching, @HALF@ N/m, here. --springs keeps both;
# - damping of shearing (@SHEAR_DAMPING@ N s/m) is that of stretching. --springs keeps both.
# Not kept at all:
# - bending across diagonals is 1.41 times too stiff; across warp and weft it is right;
# - drag along the normal, which is quadratic in the fit (@DRAG_NORMAL@ kg/m^3): here a linear one that takes as
#   much energy over the run's motion, the same in all directions;
# - contact with the ground (friction @FRICTION@ in the fit), which is not in this script.
# tri_kd and edge_kd are those of versions whose damping is absolute. Where SolverVBD multiplies it by
# the stiffness, divide tri_kd by tri_ke / 4 and edge_kd by edge_ke.
# Left out:
@LEFT_OUT@
import sys

import numpy as np

DENSITY = @DENSITY@  # kg/m^2
TRI_KE = @TRI_KE@  # N/m; stretching is @STRETCH@ N/m
TRI_KA = @TRI_KA@
TRI_KD = @TRI_KD@  # N s/m
EDGE_KE = @EDGE_KE@  # N; bending is @PLATE@ N m
EDGE_KD = @EDGE_KD@  # N s
DRAG = @DRAG@  # kg/(m^2 s)
RATE = @RATE@  # Hz
FRAMES = @FRAMES@
SUBSTEPS, ITERATIONS = 20, 20
GRAVITY = np.array([@GRAVITY@])  # m/s^2
REST = np.array([@REST@])  # m, flat
START = np.array([@START@])  # m, at frame 0
TRIANGLES = [@TRIANGLES@]
# Particles that are held, and where they are in each frame, m.
PINS = {
@PINS@}
# Two particles, rest length (m), stiffness (N/m), damping (N s/m).
SPRINGS = [@SPRINGS@]


def areas():
    """A third of the triangles around each particle, m^2."""
    corners = REST[np.reshape(TRIANGLES, (-1, 3))]
    sides = corners[:, 1:] - corners[:, :1]
    thirds = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1) / 6.0
    found = np.zeros(len(REST))
    np.add.at(found, np.reshape(TRIANGLES, (-1, 3)), thirds[:, None])
    return found


def make_model(with_springs):
    import newton
    import warp as wp

    builder = newton.ModelBuilder(gravity=0.0)  # weight is among the forces of each step
    builder.add_cloth_mesh(
        pos=wp.vec3(0.0, 0.0, 0.0),
        rot=wp.quat_identity(),
        scale=1.0,
        vel=wp.vec3(0.0, 0.0, 0.0),
        vertices=[wp.vec3(*place) for place in REST.tolist()],
        indices=TRIANGLES,
        density=DENSITY,
        tri_ke=0.0 if with_springs else TRI_KE,
        tri_ka=0.0 if with_springs else TRI_KA,
        tri_kd=0.0 if with_springs else TRI_KD,
        edge_ke=EDGE_KE,
        edge_kd=EDGE_KD,
    )
    if with_springs:
        for a, b, _, stiffness, damping in SPRINGS:
            builder.add_spring(a, b, stiffness, damping, 0.0)
        for k, spring in enumerate(SPRINGS):
            builder.spring_rest_length[k] = spring[2]
    for particle in PINS:
        builder.particle_mass[particle] = 0.0
        builder.particle_flags[particle] = int(builder.particle_flags[particle]) & ~int(newton.ParticleFlags.ACTIVE)
    builder.color(include_bending=True)
    return builder.finalize()


def places_of_pins(time):
    frame = min(time * RATE, FRAMES - 1.0)
    first = min(int(frame), FRAMES - 2)
    share = frame - first
    return [(1.0 - share) * np.array(path[first]) + share * np.array(path[first + 1]) for path in PINS.values()]


def hold(state, time):
    places = state.particle_q.numpy()
    for particle, place in zip(PINS, places_of_pins(time)):
        places[particle] = place
    state.particle_q.assign(places)


def simulate(with_springs):
    import newton

    model = make_model(with_springs)
    solver = newton.solvers.SolverVBD(model=model, iterations=ITERATIONS)
    now, then, control = model.state(), model.state(), model.control()
    now.particle_q.assign(START.astype(np.float32))
    area = areas()[:, None]
    motion = [START]
    for step in range((FRAMES - 1) * SUBSTEPS):
        hold(now, (step + 1) / (SUBSTEPS * RATE))
        force = area * (DENSITY * GRAVITY - DRAG * now.particle_qd.numpy())
        now.particle_f.assign(force.astype(np.float32))
        solver.step(now, then, control, None, 1.0 / (SUBSTEPS * RATE))
        now, then = then, now
        if (step + 1) % SUBSTEPS == 0:
            motion.append(now.particle_q.numpy().copy())
    return np.array(motion)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit("usage: python " + sys.argv[0] + " OUT.npy [--springs]")
    np.save(sys.argv[1], simulate("--springs" in sys.argv[2:]))
)py";

std::string SpringsInPython(const RunCloth& cloth) {
  std::string text;
  const auto add = [&](const std::vector<Spring>& springs, double stiffness, double damping) {
    for (const Spring& spring : springs) {
      const auto& [a, b] = spring.nodes;
      const double length =
          (cloth.rest[static_cast<std::size_t>(b)] - cloth.rest[static_cast<std::size_t>(a)])
              .norm();
      text += fmt::format("{}({}, {}, {:.7g}, {:.7g}, {:.7g})", text.empty() ? "" : ", ", a, b,
                          length, stiffness * spring.weight, damping * spring.weight);
    }
  };
  add(cloth.topology.structural, cloth.material.stretch, cloth.material.stretch_damping);
  add(cloth.topology.shear, cloth.material.shear, cloth.material.shear_damping);
  return text;
}

std::string TrianglesInPython(const ClothMesh& mesh) {
  std::string text;
  for (const auto& [a, b, c] : mesh.triangles)
    text += fmt::format("{}{}, {}, {}", text.empty() ? "" : ", ", a, b, c);
  return text;
}

}  // namespace

NewtonCloth ClothForNewton(const RunCloth& cloth) {
  const ClothMaterial& material = cloth.material;
  NewtonCloth newton;
  newton.density = material.density;
  newton.tri_ke = 0.5 * material.stretch;  // 4 mu (mu + lambda) / (2 mu + lambda) = K, lambda = 0
  newton.tri_kd = 0.25 * material.stretch_damping;  // acts on the rate of F^T F, twice the strain's
  // A moment per length of the edge and angle, or angular speed, as of the sides of clothfit's
  // cells.
  const double share = cloth.motion.mesh.is_grid() ? 4.0 / 3.0 : 1.0;
  newton.edge_ke = share * material.bending / cloth.spacing;
  newton.edge_kd = share * material.bending_damping / cloth.spacing;
  return newton;
}

std::string ClothAsNewtonScript(const RunCloth& cloth) {
  const NewtonCloth newton = ClothForNewton(cloth);
  const ClothMaterial& material = cloth.material;
  std::map<std::string, std::string> values = ValuesOfCloth(cloth);
  values.insert({{"SHEAR", Digits(material.shear)},
                 {"HALF", Digits(0.5 * material.stretch)},
                 {"SHEAR_DAMPING", Digits(material.shear_damping)},
                 {"DENSITY", Digits(newton.density)},
                 {"TRI_KE", Digits(newton.tri_ke)},
                 {"TRI_KA", Digits(newton.tri_ka)},
                 {"TRI_KD", Digits(newton.tri_kd)},
                 {"EDGE_KE", Digits(newton.edge_ke)},
                 {"EDGE_KD", Digits(newton.edge_kd)},
                 {"DRAG", Digits(material.drag_linear)},
                 {"TRIANGLES", TrianglesInPython(cloth.motion.mesh)},
                 {"SPRINGS", SpringsInPython(cloth)}});
  return FillIn(kNewtonScript, values);
}

}  // namespace clothfit
