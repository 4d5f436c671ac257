"""The 112 cases of `ik_cases.json`, judged by the file's own rules."""

import json
from functools import cache

import numpy as np
import statwalk
from paths import ASSETS, GROUND_TRUTH


@cache
def cases():
    return json.loads((GROUND_TRUTH / "ik_cases.json").read_text())["cases"]


@cache
def character(asset):
    return statwalk.load(ASSETS / asset)


def judged(solver, count=None, **options):
    """Solves all cases whose chain has `count` joints (None: any) and returns the faults, and the most
    iterations by kind.
    """
    faults, most = [], {}
    for number, case in enumerate(cases()):
        if count is not None and len(case["chain_names"]) != count:
            continue
        solved = answer(case, solver, **options)
        faults += [f"case {number} ({case['kind']}): {fault}" for fault in _faults(case, solved)]
        most[case["kind"]] = max(most.get(case["kind"], 0), int(solved.iterations))
    return faults, most


def answer(case, solver, **options):
    """Solves one case."""
    figure = character(case["asset"])
    return figure.solve(_pose(case, figure), case["chain_names"], case["target"], solver, **options)


def _pose(case, figure):
    clip = case["clip"]
    return figure.bind_pose if clip < 0 else list(figure.clips.values())[clip].sample(case["t"])


def _faults(case, answer):
    figure = character(case["asset"])
    pose = _pose(case, figure)
    rows = [figure.skeleton.index(name) for name in case["chain_names"]]
    places = figure.world(answer.pose)[rows, :3, 3].astype(float)
    error = np.linalg.norm(places[-1] - case["target"])
    lengths = np.linalg.norm(np.diff(places, axis=0), axis=1)
    turned = ~np.isclose(np.abs((answer.pose.rotation * pose.rotation).sum(-1)), 1, atol=1e-6)
    tolerance = case["tolerance"]
    if not abs(error - case["expect_end_error"]) <= tolerance:
        yield f"{error} from the target, not {case['expect_end_error']} within {tolerance}"
    if not abs(error - answer.distance) <= tolerance * 0.1:
        yield f"says {answer.distance}, but it is {error}"
    if not np.allclose(lengths, case["bone_lengths"], rtol=1e-4):
        yield f"bones of {lengths}"
    if not all(np.isfinite(part).all() for part in answer.pose):
        yield "numbers that are not finite"
    if set(np.flatnonzero(turned)) - set(rows[:-1]):
        yield f"joints {set(np.flatnonzero(turned)) - set(rows[:-1])} turned"
    if case["kind"] == "current_position" and turned.any():
        yield "moved though it was there"
    if case["kind"].startswith("unreachable"):
        aim = np.array(case["target"]) - places[0]
        if not (places[-1] - places[0]) @ aim >= (1 - 1e-4) * np.linalg.norm(aim) * sum(lengths):
            yield "does not point at the target"
