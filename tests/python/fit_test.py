# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""Fits, runs and diagnoses."""
import pathlib
import signal
import threading

import numpy
import pytest

import clothfit


def test_a_fit_finds_the_wind(windy, config, tmp_path):
    told = []
    run = clothfit.fit(windy, config, progress=lambda stage, share: told.append((stage, share)))
    assert run.status == "converged"
    estimate = run.estimates["wind.y"]
    assert estimate.free and estimate.determined and estimate.unit == "m/s"
    assert estimate.lower < 0.8 < estimate.upper and run["wind.y"] == estimate.value
    assert run.fitted.markers < 3 * 2e-4 * 3**0.5 and run.held_out.markers is None
    assert told and all(0.0 <= share <= 1.0 for _, share in told)
    run.report(tmp_path / "r.html")
    run.export("npy", tmp_path / "x.npy")
    numpy.testing.assert_allclose(numpy.load(tmp_path / "x.npy"), run.trajectory, atol=1e-12)
    with pytest.raises(clothfit.InputError, match="gltf"):
        run.export("gltff", tmp_path / "x")


def test_arrays_of_a_run_are_views(windy, config):
    run = clothfit.fit(windy, config)
    folder = pathlib.Path(run.folder)
    trajectory, uv, triangles = run.trajectory, run.uv, run.triangles
    assert trajectory.shape == (12, 25, 3) and uv.shape == (25, 2)
    assert triangles.shape == (32, 3) and triangles.max() == 24
    assert trajectory.ctypes.data == run.trajectory.ctypes.data
    with pytest.raises(ValueError):
        trajectory[0] = 0.0
    assert folder.exists()
    del run
    assert numpy.isfinite(trajectory).all() and folder.exists()
    del trajectory, uv
    assert not folder.exists()  # it was for the time being


def test_a_run_predicts_and_is_read_again(windy, config, tmp_path):
    run = clothfit.fit(windy, config, folder=tmp_path / "run")
    again = clothfit.Run(tmp_path / "run")
    assert again["wind.y"] == run["wind.y"]
    frames = numpy.full(len(run.uv), 7)
    for one in (run, again):
        numpy.testing.assert_allclose(one.predict(frames, run.uv), run.trajectory[7], atol=1e-12)
    with pytest.raises(clothfit.InputError, match="point 1: .*outside the cloth"):
        run.predict([0, 0], [[0.1, 0.1], [5.0, 0.1]])
    with pytest.raises(clothfit.InputError, match="already holds"):
        clothfit.fit(windy, config, folder=tmp_path / "run")


def test_interrupt_ends_a_fit(demo, tmp_path):
    timer = threading.Timer(1.0, lambda: signal.raise_signal(signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        clothfit.fit(str(demo), folder=tmp_path / "run")
    timer.join()
    run = clothfit.Run(tmp_path / "run")
    assert run.status == "interrupted" and numpy.isfinite(run.trajectory).all()
    other = clothfit.Config(clothfit.Recording(str(demo)))
    other["air_drag.normal"] = 2.0
    with pytest.raises(clothfit.InputError, match="air_drag.normal"):
        clothfit.fit(str(demo), other, folder=tmp_path / "run", resume=True)


def test_an_exception_of_progress_ends_a_fit(demo):
    def give_up(stage, share):
        raise LookupError(stage)

    with pytest.raises(LookupError):
        clothfit.fit(str(demo), progress=give_up)


def test_a_diagnosis_names_what_is_missing(windy):
    config = clothfit.Config(windy)
    for name in config.parameters:
        config.fix(name)
    config.free("air_drag.normal")
    terms = {name.split(".")[0] for name in config.parameters} - {"cloth", "wind"}
    diagnosis = clothfit.diagnose(windy, config, exclude=sorted(terms), max_effects=1, finest_side=5)
    assert diagnosis.verdict == "named" and diagnosis.effects == ["wind"]
    amounts = {amount.name: amount for amount in diagnosis.models[0].amounts}
    assert abs(amounts["wind.y"].value - 0.8) < 0.05
    assert diagnosis.config["wind.y"] == pytest.approx(amounts["wind.y"].value)
    assert diagnosis.candidates[0].name == "wind"
    assert diagnosis.headline and diagnosis.words.startswith(diagnosis.headline)
