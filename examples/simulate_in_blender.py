# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""python3 simulate_in_blender.py RUN: the cloth of a run, simulated again by Blender.

Exports RUN's cloth with `clothfit export`, has Blender simulate it without a window, and tells how
far it is from the run's own motion. Leaves blender.py and blender.npy (frames x particles x 3, m) where you
are. Needs clothfit and blender in PATH, and NumPy.
"""

import pathlib
import subprocess
import sys

import numpy as np


def simulate(run):
    """What Blender makes of the run's cloth: frames x particles x 3, m."""
    pathlib.Path("blender.npy").unlink(missing_ok=True)
    export = ["clothfit", "export", run, "--format", "blender", "-o", "blender.py", "--force"]
    subprocess.run(export, check=True, stdout=subprocess.DEVNULL)
    # Its messages are many, and it ends with 0 where the script fails.
    blender = ["blender", "-b", "--factory-startup", "--python", "blender.py", "--", "blender.npy"]
    done = subprocess.run(blender, check=True, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if not pathlib.Path("blender.npy").exists():
        sys.exit(f"Blender wrote no blender.npy:\n{done.stdout}")
    return np.load("blender.npy")


def root_mean_square(offsets):
    """Of the lengths of offsets (... x 3), frame by frame."""
    return np.sqrt((offsets**2).sum(axis=-1).mean(axis=-1))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.splitlines()[0])
    ours = np.load(pathlib.Path(sys.argv[1]) / "trajectory.npy")
    apart = 1e3 * root_mean_square(simulate(sys.argv[1]) - ours)
    moved = 1e3 * root_mean_square(ours - ours[0])
    over_all = [np.sqrt((frames**2).mean()) for frames in (apart, moved)]
    print("frame  apart, mm  moved, mm")
    for frame in range(0, len(ours), max(1, len(ours) // 8)):
        print(f"{frame:5}  {apart[frame]:9.1f}  {moved[frame]:9.1f}")
    print("root mean square of all frames: {:.1f} mm apart, where the cloth moves by {:.1f} mm".format(*over_all))


main()
