# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases and runs of interphase: what tools/* are made of, and scripts of one's own.

    import interphase

    case = interphase.Case("cases/sscp1").set(inletVelocity=3.28, method="CGHS", weight=8)
    run = case.run("runs/a", ranks=2, until=5)       # or interphase.Run("runs/a"), also of one that still goes
    print(run.series["pressure_drop"].mean(after=3))  # value, standard error, unit
    run.snapshots[-1].positions, run.fields("voidage").values

Case (case.py), Run (run.py), InputError (input_error.py): what a user gave cannot be used, and why; StepFailed (launch.py): a program on the
way to a run failed. Nothing beyond Python's standard library is loaded before it is needed.
"""

_WHERE = {"Case": "case", "Run": "run", "InputError": "input_error", "StepFailed": "launch"}
__all__ = sorted(_WHERE)


def __getattr__(name):
    if name not in _WHERE:
        raise AttributeError(f"module 'interphase' has no attribute '{name}'; it has {', '.join(__all__)}")
    from interphase.missing import module
    return getattr(module(_WHERE[name]), name)
