"""Clips, blend spaces and root motion in NumPy, for N actors at once: the slow reference that the compiled
form is held against.
"""

from functools import reduce

import numpy as np
from statwalk.maths import curves, quat
from statwalk.maths.pose import Pose
from statwalk.motion.blend_space import BlendSpace
from statwalk.motion.keys.segment_kinds import (
    ARC,
    CUBIC,
    CUBIC_TURN,
    HOLD,
    LINE,
    RATIONAL,
    RATIONAL_TURN,
    SPLINE_TURN,
)
from statwalk.motion.root import compose, relative

ROUNDS = 32


def cubic(rows, fractions):
    width = rows.shape[-1] // 4
    f = fractions[..., None]
    c0, c1, c2, c3 = (rows[..., i * width : (i + 1) * width] for i in range(4))
    return c0 + (c1 + (c2 + c3 * f) * f) * f


def line(rows, fractions):
    width = rows.shape[-1] // 2
    return rows[..., :width] + rows[..., width:] * fractions[..., None]


def rational(rows, fractions):
    width = rows.shape[-1] // 2
    return cubic(rows[..., :width], fractions) / cubic(rows[..., width:], fractions)


def rational_turn(rows, fractions):
    below, *above = (cubic(rows[..., at : at + 4], fractions) for at in (13, 17, 21, 25))
    turned = rows[..., :4]
    for k, part in enumerate(above):
        vector = rows[..., 4 + 3 * k : 7 + 3 * k] * (part / below)
        turned = quat.mul(turned, quat.from_rotation_vector(vector))
    return quat.normalize(turned)


EVALUATE = {
    HOLD: lambda rows, _: rows,
    LINE: line,
    ARC: lambda rows, f: quat.slerp(rows[..., :4], rows[..., 4:], f),
    CUBIC: cubic,
    CUBIC_TURN: lambda rows, f: quat.normalize(cubic(rows, f)),
    RATIONAL: rational,
    RATIONAL_TURN: rational_turn,
    SPLINE_TURN: lambda rows, f: curves.bspline_turn(
        rows[..., :4], rows[..., 4:].reshape(*rows.shape[:-1], 3, 3), f
    ),
}


def values(track, times):
    """(N, C, n) float32 at `times` (N,) float64 seconds."""
    row = track.edges.searchsorted(times, "right")
    fractions = (times[:, None] - track.start[row]) * track.rate[row]
    return EVALUATE[track.kind](track.rows[track.segment[row]], fractions.astype(np.float32))


def sampled(clip, times):
    """Poses (N, …) of a clip at `times` (N,)."""
    pose = Pose(*(array[None].repeat(len(times), 0) for array in clip.base))
    for track in clip.tracks:
        found = values(track, times)
        if track.path == "weights":
            pose.weights[:, track.target] = found[..., 0]
        else:
            getattr(pose, track.path)[:, track.target] = found
    return pose


def pose(motion, times, parameters):
    """Poses (N, …) of a Single or a BlendSpace."""
    if not isinstance(motion, BlendSpace):
        return sampled(motion.clip, times)
    phases = phase(motion, times)

    def at(k, rows):
        lifted = motion.warps[k].lift(phases[rows])
        return sampled(
            motion.motions[k].clip,
            (lifted - np.floor(lifted) if motion.loop else lifted) * motion.motions[k].clip.duration,
        )

    return mixed(motion, weights(motion, parameters), at)


def first(motion, parameters):
    """The poses (N, …) that a motion begins with."""
    if not isinstance(motion, BlendSpace):
        return sampled(motion.clip, np.zeros(len(parameters)))
    return mixed(
        motion,
        weights(motion, parameters),
        lambda k, rows: sampled(motion.motions[k].clip, np.zeros(len(rows))),
    )


def mixed(space, weights, sample):
    out = Pose(*(np.zeros((len(weights), *array.shape), np.float32) for array in space.rest))
    for k in range(len(space.motions)):
        rows = weights[:, k].nonzero()[0]
        if len(rows):
            part = sample(k, rows)
            part = part._replace(rotation=quat.align(out.rotation[rows], part.rotation))
            for array, one in zip(out, part, strict=True):
                array[rows] += one * weights[rows, k].astype(np.float32).reshape(-1, *(1,) * (one.ndim - 1))
    return out._replace(rotation=quat.normalize(out.rotation))


def weights(space, parameters):
    """(N, K) of each clip."""
    points = parameters[:, space.columns].clip(space.places.min(0), space.places.max(0))
    return (
        along_a_line(points[:, 0], space.places[:, 0])
        if len(space.columns) == 1
        else gradient_band(points, space.places)
    )


def along_a_line(points, places):
    order = np.argsort(places)
    rising = places[order]
    within = points.clip(rising[0], rising[-1])
    row = (rising.searchsorted(within, "right") - 1).clip(0, len(places) - 2)
    part = (within - rising[row]) / (rising[row + 1] - rising[row])
    out, everyone = np.zeros((len(points), len(places))), np.arange(len(points))
    out[everyone, order[row]] = 1 - part
    out[everyone, order[row + 1]] = part
    return out


def gradient_band(points, places):
    say = []
    for here in range(len(places)):
        bands = [
            band(points - places[here], places[other] - places[here])
            for other in range(len(places))
            if other != here
        ]
        say.append(reduce(np.minimum, bands))
    total = reduce(np.add, say)
    return np.stack([one / total for one in say], -1)


def band(offset, across):
    done = (offset[:, 0] * across[0] + offset[:, 1] * across[1]) / (
        across[0] * across[0] + across[1] * across[1]
    )
    return 1 - done.clip(0, 1)


def rate(space, times, seconds, parameters):
    """(N,) factor of time of a blend space."""
    share = weights(space, parameters)
    lap = reduce(np.add, (share[:, k] * motion.clip.duration for k, motion in enumerate(space.motions)))
    factor = np.where(lap > 0, space.duration / np.where(lap > 0, lap, 1), 1.0)
    if all(warp.is_identity for warp in space.warps):
        return factor
    now, wanted = phase(space, times), seconds / np.where(lap > 0, lap, 1)
    begin, step = mean_phase(space, now, share), wanted
    before, gone_before, is_open = np.zeros_like(step), np.zeros_like(step), np.ones(len(step), bool)
    short, far = np.zeros_like(step), np.full(len(step), np.inf)
    for _ in range(ROUNDS):
        gone = mean_phase(space, now + step, share) - begin
        is_open &= (np.abs(gone - wanted) > 0) & (np.abs(gone - gone_before) > 0)
        slope = (step - before) / np.where(is_open, gone - gone_before, 1)
        short = np.where(gone < wanted, np.maximum(short, step), short)
        far = np.where(gone < wanted, far, np.minimum(far, step))
        following = step + (wanted - gone) * slope
        inside = (short <= following) & (following <= far)
        following = np.where(inside, following, np.where(far < np.inf, (short + far) / 2, 2 * step))
        before, gone_before = np.where(is_open, step, before), np.where(is_open, gone, gone_before)
        step = np.where(is_open, following, step)
    return factor * np.where(wanted > 0, step / np.where(wanted > 0, wanted, 1), 1)


def mean_phase(space, now, share):
    return reduce(np.add, (share[:, k] * warp.lift(now) for k, warp in enumerate(space.warps)))


def phase(space, times):
    return times / space.duration if space.duration > 0 else np.zeros_like(times)


def way(motion, start, end, wraps, parameters):
    """x, z, yaw (N, 3) from `start` to `end` (N,) seconds through `wraps` (N,) repeats."""
    if not isinstance(motion, BlendSpace):
        return displacement(motion.root, start, end, wraps)
    share, begin, reached = weights(motion, parameters), phase(motion, start), phase(motion, end) + wraps
    return reduce(
        np.add, (own_way(motion, k, begin, reached) * share[:, k, None] for k in range(len(motion.motions)))
    )


def own_way(space, k, start, end):
    root, duration = space.motions[k].root, space.motions[k].clip.duration
    begin, reached = space.warps[k].lift(start), space.warps[k].lift(end)
    before, last = (
        (np.floor(begin), np.floor(reached)) if space.loop else (np.zeros(len(start)), np.zeros(len(start)))
    )
    return displacement(
        root, (begin - before) * duration, (reached - last) * duration, (last - before).astype(np.int64)
    )


def displacement(root, start, end, wraps):
    """x, z, yaw (N, 3) along a root track."""
    origin, now = root.at(start), root.at(end)
    opening, last = root.places[:1], root.places[-1:]
    gone = relative(origin, np.where(wraps[:, None] > 0, last, now))
    for done in range(1, int(wraps.max(initial=0)) + 1):
        lap = relative(opening, np.where((wraps == done)[:, None], now, last))
        gone = np.where((wraps >= done)[:, None], compose(gone, lap), gone)
    return gone
