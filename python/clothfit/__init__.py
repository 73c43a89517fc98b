# SPDX-FileCopyrightText: 2026 The clothfit authors
# SPDX-License-Identifier: Apache-2.0
"""Recovers the motion and the physics of real cloth from recordings.

Units are metres, seconds, kilograms, newtons and pixels; arrays are NumPy's, float64.
"""

from ._clothfit import (
    Amount,
    Candidate,
    Config,
    Diagnosis,
    Errors,
    Estimate,
    InputError,
    Model,
    Parameter,
    Recording,
    Run,
    Simulation,
    __version__,
    diagnose,
    fit,
)

__all__ = [
    "Amount",
    "Candidate",
    "Config",
    "Diagnosis",
    "Errors",
    "Estimate",
    "InputError",
    "Model",
    "Parameter",
    "Recording",
    "Run",
    "Simulation",
    "diagnose",
    "fit",
]

for _name in __all__:
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = __name__
del _name
