# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""What the tests of the package for Python share."""
import pathlib

import numpy
import pytest

import clothfit

FRAMES = 12
SIDE = 0.4  # m


@pytest.fixture(scope="session")
def demo():
    return pathlib.Path(__file__).parents[2] / "data" / "demo"


def falling(markers=None, marker_uv=None, **options):
    """A cloth that falls from two corners that are held; by default with one marker."""
    if markers is None:
        markers = numpy.full((FRAMES, 1, 3), numpy.nan)
        markers[0, 0] = [0.2, 0.2, 0.0]
        marker_uv = [[0.2, 0.2]]
    still = numpy.zeros((FRAMES, 3))
    return clothfit.Recording.from_arrays(
        markers,
        marker_uv,
        frame_rate=30.0,
        size=[SIDE, SIDE],
        resolution=[5, 5],
        areal_density=0.15,
        handles={"left": ((0.0, 0.0), still), "right": ((SIDE, 0.0), still + [SIDE, 0.0, 0.0])},
        **options,
    )


@pytest.fixture(scope="session")
def windy():
    """A recording of a marker at each particle in wind of 0.8 m/s along y, and 0.2 mm of noise."""
    simulation = clothfit.Simulation(falling(), ["wind.y"])
    positions = simulation.positions([0.8])
    noise = numpy.random.default_rng(1).normal(0.0, 2e-4, positions.shape)
    return falling(positions + noise, simulation.uv, marker_sigma=2e-4)


@pytest.fixture
def config(windy):
    """Of `windy`: everything is held but the wind."""
    config = clothfit.Config(windy)
    for name in config.parameters:
        config.fix(name)
    config.free("wind.y")
    return config
