// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Reference: Blender, Python API, ClothSettings and ClothCollisionSettings.
#include "fitting/export/blender.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>

#include "fitting/export/script_text.h"

namespace clothfit {
namespace {

constexpr const char* kBlenderScript =
    R"py(# The cloth of @NAME@, fitted by clothfit @VERSION@, for Blender:
#   blender --python THIS_FILE                  to look at it
#   blender -b --python THIS_FILE -- OUT.npy    to simulate it; OUT.npy: frames x vertices x 3, m
# docs/material-elsewhere.md of clothfit derives each number and says what it is worth.
#
# Not kept, for Blender's cloth has no counterpart:
# - drag along the normal, which is quadratic in the fit (@DRAG_NORMAL@ kg/m^3): air_damping is linear, the
#   same in all directions, and takes as much energy over the run's motion;
# - lighter particles at the edges: each vertex has the same mass, and all together that of the cloth;
# - the velocity at frame 0: the cloth begins at rest.
# Left out:
@LEFT_OUT@
import array
import struct
import sys

import bpy

NAME = @NAME@
RATE = @RATE@  # Hz
FRAMES = @FRAMES@
GRAVITY = (@GRAVITY@)  # m/s^2
GROUND = @GROUND@  # m, or None
DISTANCE = @DISTANCE@  # m, at which the ground begins to push
FRICTION = @GROUND_FRICTION@  # @FRICTION@ in the fit, times 100
START = [@START@]  # m, at frame 0
REST = [@REST@]  # m, flat
FACES = [@FACES@]
# Vertices that are held, and where they are in each frame, m.
PINS = {
@PINS@}
# Blender's unit of time is 1/sqrt(1000) s: a stiffness in N/m is a thousandth here.
SETTINGS = {
    "mass": @MASS@,  # kg, each vertex
    "tension_stiffness": @TENSION@,  # @STRETCH@ N/m
    "compression_stiffness": @TENSION@,
    "tension_damping": @TENSION_DAMPING@,  # @STRETCH_DAMPING@ N s/m
    "compression_damping": @TENSION_DAMPING@,
    "shear_stiffness": @SHEAR@,  # @SHEAR_MODULUS@ N/m; twice, for what is compressed does not resist
    "shear_damping": @SHEAR_DAMPING@,
    "bending_model": "ANGULAR",
    "bending_stiffness": @BENDING@,  # @PLATE@ N m
    "bending_damping": @BENDING_DAMPING@,
    "air_damping": @AIR_DAMPING@,
    "time_scale": @TIME_SCALE@,  # a frame lasts 1 / RATE
    "quality": 30,  # steps a frame
}


def add_ground(height):
    bpy.ops.mesh.primitive_plane_add(size=20.0, location=(0.0, 0.0, height))
    ground = bpy.context.object
    ground.name = "ground"
    ground.modifiers.new("Collision", "COLLISION")
    ground.collision.thickness_outer = 0.001
    ground.collision.cloth_friction = FRICTION


def add_mesh():
    mesh = bpy.data.meshes.new(NAME)
    mesh.from_pydata(START, [], FACES)
    mesh.update()
    cloth = bpy.data.objects.new(NAME, mesh)
    bpy.context.collection.objects.link(cloth)
    cloth.shape_key_add(name="start", from_mix=False)
    rest = cloth.shape_key_add(name="rest", from_mix=False)
    for point, place in zip(rest.data, REST):
        point.co = place
    return cloth


# An empty a vertex, which a hook before the cloth modifier follows.
def add_pins(cloth):
    group = cloth.vertex_groups.new(name="pin")
    group.add(list(PINS), 1.0, "REPLACE")
    for vertex, places in PINS.items():
        empty = bpy.data.objects.new("handle %d" % vertex, None)
        empty.empty_display_size = 0.02
        bpy.context.collection.objects.link(empty)
        for frame, place in enumerate(places):
            empty.location = place
            empty.keyframe_insert("location", frame=frame + 1)
        for curve in empty.animation_data.action.fcurves:
            for key in curve.keyframe_points:
                key.interpolation = "LINEAR"
        empty.location = places[0]
        bpy.context.view_layer.update()
        hook = cloth.modifiers.new("hook %d" % vertex, "HOOK")
        hook.object = empty
        hook.vertex_indices_set([vertex])
        hook.matrix_inverse = empty.matrix_world.inverted() @ cloth.matrix_world


def add_cloth(cloth):
    modifier = cloth.modifiers.new("Cloth", "CLOTH")
    for name, value in SETTINGS.items():
        setattr(modifier.settings, name, value)
    modifier.settings.rest_shape_key = cloth.data.shape_keys.key_blocks["rest"]
    if PINS:
        modifier.settings.vertex_group_mass = "pin"
    modifier.collision_settings.use_self_collision = False
    modifier.collision_settings.use_collision = GROUND is not None
    modifier.collision_settings.distance_min = max(0.001, DISTANCE - 0.001)
    modifier.point_cache.frame_start = 1
    modifier.point_cache.frame_end = FRAMES


# Without NumPy, which not every Blender has.
def write_npy(file, numbers, shape):
    head = "{'descr': '<f8', 'fortran_order': False, 'shape': %r, }" % (shape,)
    head += " " * (-(len(head) + 11) % 64) + "\n"
    numbers = array.array("d", numbers)
    if sys.byteorder == "big":
        numbers.byteswap()
    with open(file, "wb") as out:
        out.write(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode())
        numbers.tofile(out)


def simulate(cloth, file):
    scene = bpy.context.scene
    numbers = []
    for frame in range(FRAMES):
        scene.frame_set(frame + 1)
        evaluated = cloth.evaluated_get(bpy.context.evaluated_depsgraph_get())
        for vertex in evaluated.to_mesh().vertices:
            numbers.extend(vertex.co)
        evaluated.to_mesh_clear()
    write_npy(file, numbers, (FRAMES, len(START), 3))
    print("%d frames: %s" % (FRAMES, file))


def main():
    for other in list(bpy.data.objects):
        bpy.data.objects.remove(other)
    scene = bpy.context.scene
    scene.render.fps = max(1, round(RATE))
    scene.render.fps_base = scene.render.fps / RATE
    scene.frame_start, scene.frame_end = 1, FRAMES
    scene.gravity = GRAVITY
    scene.frame_set(1)
    if GROUND is not None:
        add_ground(GROUND)
    cloth = add_mesh()
    add_pins(cloth)
    add_cloth(cloth)
    after = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    if after:
        simulate(cloth, after[0])


main()
)py";

// Of a grid its cells, between whose corners Blender's shear springs go; else the triangles, which
// have none.
std::string FacesInPython(const ClothMesh& mesh) {
  std::string text;
  const auto add = [&text](const std::string& face) {
    text += (text.empty() ? "(" : ", (") + face + ")";
  };
  if (!mesh.is_grid()) {
    for (const auto& [a, b, c] : mesh.triangles) add(fmt::format("{}, {}, {}", a, b, c));
    return text;
  }
  const int nu = mesh.grid[0];
  for (int j = 0; j + 1 < mesh.grid[1]; ++j) {
    for (int i = 0; i + 1 < nu; ++i) {
      const int corner = i + j * nu;
      add(fmt::format("{}, {}, {}, {}", corner, corner + 1, corner + nu + 1, corner + nu));
    }
  }
  return text;
}

}  // namespace

BlenderCloth ClothForBlender(const RunCloth& cloth) {
  const double kForce = 1000.0, kTime = std::sqrt(1000.0);  // of Blender's units in N/kg and 1/s
  const ClothMaterial& material = cloth.material;
  double area = 0.0;
  for (const double part : cloth.topology.areas) area += part;
  const double h = cloth.spacing, of_vertex = area / static_cast<double>(cloth.rest.size());
  BlenderCloth blender;
  blender.mass = material.density * of_vertex;
  // A spring is stiffness / mean length of all; one of a square cell stands for its own length.
  blender.tension = material.stretch * h / kForce;
  blender.tension_damping = material.stretch_damping / kTime;
  blender.shear = 2.0 * material.shear * h / kForce;
  blender.shear_damping = 2.0 * material.shear_damping / kTime;
  // A force F = stiffness length angle / 10 on either side, shared by the corners of a cell and so
  // at h / 2 from the fold: F h / 2 = B angle for a fold of length h. Its damping is that force by
  // the speed of both sides there, h / 2 times that of the angle.
  blender.bending = 20.0 * material.bending / (h * h) / kForce;
  blender.bending_damping = 4.0 * material.bending_damping / (h * h) / kTime;
  blender.air_damping = material.drag_linear * of_vertex / kTime / 0.01;
  blender.friction = std::min(80.0, 100.0 * cloth.ground_friction);  // 80 is Blender's most
  blender.time_scale = kTime / cloth.motion.frame_rate;
  return blender;
}

std::string ClothAsBlenderScript(const RunCloth& cloth) {
  const BlenderCloth blender = ClothForBlender(cloth);
  const ClothMaterial& material = cloth.material;
  std::map<std::string, std::string> values = ValuesOfCloth(cloth);
  values.insert({{"GROUND_FRICTION", Digits(blender.friction)},
                 {"GROUND", cloth.ground_height ? Digits(*cloth.ground_height) : "None"},
                 {"DISTANCE", Digits(cloth.ground_distance)},
                 {"FACES", FacesInPython(cloth.motion.mesh)},
                 {"MASS", Digits(blender.mass)},
                 {"TENSION", Digits(blender.tension)},
                 {"TENSION_DAMPING", Digits(blender.tension_damping)},
                 {"STRETCH_DAMPING", Digits(material.stretch_damping)},
                 {"SHEAR", Digits(blender.shear)},
                 {"SHEAR_MODULUS", Digits(material.shear)},
                 {"SHEAR_DAMPING", Digits(blender.shear_damping)},
                 {"BENDING", Digits(blender.bending)},
                 {"BENDING_DAMPING", Digits(blender.bending_damping)},
                 {"AIR_DAMPING", Digits(blender.air_damping)},
                 {"TIME_SCALE", Digits(blender.time_scale)}});
  return FillIn(kBlenderScript, values);
}

}  // namespace clothfit
