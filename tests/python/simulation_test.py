# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""Simulations: their motion, their derivatives, and what they refuse."""
import numpy
import pytest
from conftest import FRAMES, falling

import clothfit

NAMES = ["wind.y", "air_drag.normal", "bending.stiffness"]


@pytest.fixture
def simulation():
    config = clothfit.Config(falling())
    config.set_key("simulation.tolerance", "1e-11")
    return clothfit.Simulation(falling(), NAMES, config)


def test_jacobian_is_that_of_differences(simulation):
    values = simulation.start + [0.5, 0.0, 1e-3]
    positions, jacobian = simulation.jacobian(values)
    assert positions.shape == (FRAMES, 25, 3) and jacobian.shape == (FRAMES, 25, 3, 3)
    numpy.testing.assert_allclose(positions, simulation.positions(values), atol=1e-10)
    for k, value in enumerate(values):
        step = numpy.zeros(3)
        step[k] = 1e-4 * max(value, 1e-3)
        quotient = simulation.positions(values + step) - simulation.positions(values - step)
        quotient /= 2.0 * step[k]
        scale = numpy.abs(quotient).max()
        assert scale > 0.0
        # What differences of motions that are exact to 1e-12 m can tell.
        numpy.testing.assert_allclose(
            jacobian[..., k], quotient, rtol=0.0, atol=1e-5 * scale + 1e-11 / step[k]
        )


def test_gradient_descent_finds_the_wind(simulation):
    """What a wrapper for PyTorch or JAX does: a vector times the Jacobian."""
    target = simulation.positions(simulation.start + [0.7, 0.0, 0.0])
    values = simulation.start
    for _ in range(5):  # Gauss and Newton's
        positions, jacobian = simulation.jacobian(values)
        slope = jacobian[..., 0].ravel()
        values[0] -= slope @ (positions - target).ravel() / (slope @ slope)
    assert abs(values[0] - 0.7) < 1e-6


def test_arrays_outlive_what_made_them():
    uv = clothfit.Simulation(falling(), []).uv
    positions = clothfit.Simulation(falling(), []).positions()
    assert uv.shape == (25, 2) and uv.max() == pytest.approx(0.4)
    assert numpy.isfinite(positions).all()


def test_frames_beyond_the_recording_are_simulated():
    assert clothfit.Simulation(falling(), [], frame_count=20).positions().shape[0] == 20


@pytest.mark.parametrize(
    "values, message",
    [([1.0], "expected 3"), ([1e9, 0.0, 0.0], "wind.y = 1000000000 m/s: expected -10"), ([[0.0] * 3], "shape")],
)
def test_wrong_values_are_refused(simulation, values, message):
    with pytest.raises(clothfit.InputError, match=message):
        simulation.positions(values)


def test_unknown_parameters_are_refused():
    with pytest.raises(clothfit.InputError, match="did you mean 'wind.x'"):
        clothfit.Simulation(falling(), ["wind.xx"])
    with pytest.raises(clothfit.InputError, match="twice"):
        clothfit.Simulation(falling(), ["wind.x", "wind.x"])
