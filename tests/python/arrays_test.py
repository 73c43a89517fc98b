# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""Recordings and configs: made, read, written, refused."""
import numpy
import pytest
from conftest import FRAMES, SIDE, falling

import clothfit


def test_reads_a_folder(demo):
    recording = clothfit.Recording(demo)
    assert recording.frame_count == 90
    assert recording.marker_positions.shape == (len(recording.marker_ids), 3)
    assert recording.marker_uv.shape == (len(recording.marker_frames), 2)
    assert "markers" in str(recording)


def test_arrays_become_a_recording_and_a_folder(tmp_path):
    rng = numpy.random.default_rng(0)
    markers = rng.normal(0.0, 0.1, (FRAMES, 4, 3))
    markers[3, 2] = numpy.nan
    uv = [[0.1, 0.1], [0.3, 0.1], [0.1, 0.3], [0.3, 0.3]]
    recording = falling(markers, uv, held_out_frames=[8, 11])
    recording.write(tmp_path / "r")
    for same in (recording, clothfit.Recording(tmp_path / "r")):
        seen = numpy.full_like(markers, numpy.nan)
        seen[same.marker_frames, same.marker_ids] = same.marker_positions
        numpy.testing.assert_array_equal(seen, markers)
        assert list(same.size) == [SIDE, SIDE]
        assert list(same.handles) == ["left", "right"]
        assert same.handles["right"][0] == (SIDE, 0.0)
        numpy.testing.assert_array_equal(same.handles["right"][1], [[SIDE, 0.0, 0.0]] * FRAMES)
    with pytest.raises(clothfit.InputError, match="already holds a recording$"):
        recording.write(tmp_path / "r")
    recording.write(tmp_path / "r", replace=True)


@pytest.mark.parametrize(
    "markers, uv, message",
    [
        (numpy.zeros((3, 3)), [[0.0, 0.0]], r"markers: expected .* found \(3, 3\)"),
        (numpy.zeros((3, 1, 3)), [[0.0, 0.0, 0.0]], r"marker_uv: expected .*\(points, 2\)"),
        (numpy.zeros((FRAMES, 1, 3)), [[9.0, 0.0]], "outside the cloth"),
    ],
)
def test_wrong_arrays_are_one_line(markers, uv, message):
    with pytest.raises(clothfit.InputError, match=message) as error:
        falling(markers, uv)
    assert "\n" not in str(error.value)
    assert type(error.value).__module__ == "clothfit"
    assert isinstance(error.value, ValueError)


def test_a_missing_folder_is_named(tmp_path):
    with pytest.raises(clothfit.InputError, match="none: no such folder"):
        clothfit.Recording(tmp_path / "none")


def test_config_is_changed_by_names():
    config = clothfit.Config(falling())
    config["bending.stiffness"] = 2e-4
    assert config["bending.stiffness"] == 2e-4
    config.free("wind")
    assert config.parameters["wind.x"].free
    config.fix("wind.x")
    assert not config.parameters["wind.x"].free
    assert config.parameters["wind.x"].unit == "m/s"
    config.set_key("strategy.window", "0.5")
    assert "window: 0.5" in config.yaml
    other = config.copy()
    other.without("wind")
    assert not other.parameters["wind.y"].free and config.parameters["wind.y"].free
    with pytest.raises(clothfit.InputError, match="did you mean 'bending.stiffness'"):
        config["bending.stifness"] = 1.0
    with pytest.raises(clothfit.InputError, match="did you mean 'strategy.window'"):
        config.set_key("strategy.windows", "1")
    with pytest.raises(clothfit.InputError, match="strategy.window"):
        config.set_key("strategy.window", "soon")
