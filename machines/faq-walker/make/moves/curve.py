"""Walking round a curve: one cycle of the walk on an arc of 60 degrees, in step with the walk.

The feet are planted along the arc, each turned as the path is there; the body leans inwards, the head looks
where the path goes.
"""

import numpy as np
from curves import Array
from moves.feet import Plant, Track, walk_track
from moves.motion import Body, Feet, Motion, TrackOf, sides
from moves.turn import ANGLE
from moves.walk import CYCLE, STRIDE, arcs_of, pitch_of, walk_body, walk_plant

WAY = 1.20  # metres a cycle, a little shorter than straight ahead
INWARDS = 0.012  # metres that the pelvis is nearer to the centre
RADIUS = WAY / np.radians(ANGLE)


def _on_arc(x: Array, z: Array, way: float) -> tuple[Array, Array, Array]:
    """Place and heading (radians) on the arc of what is `x` beside the straight path (left positive) and `z`
    along it.
    """
    heading = way * z / STRIDE * np.radians(ANGLE)
    radius = RADIUS - way * x
    return way * (RADIUS - radius * np.cos(heading)), radius * np.sin(way * heading), heading


def _planted(plant: Plant, way: float) -> Plant:
    x, z, heading = _on_arc(np.array(plant.x), np.array(plant.z), way)
    return plant._replace(x=float(x), z=float(z), yaw=plant.yaw + float(heading))


def curve_feet(way: float) -> Feet:
    """Feet on the arc; `way` is +1 to the left."""

    def make(_: str, sign: float) -> TrackOf:
        plants = [_planted(walk_plant(sign, step), way) for step in range(-2, 4)]

        def track(t: Array) -> Track:
            return walk_track(t, plants, [arcs_of(sign)] * 5, pitch_of(sign))

        return track

    return sides(make)


def curve_body(way: float) -> Body:
    """The walk's handles on the arc."""

    def body(t: Array) -> dict[str, Array]:
        straight = walk_body(t)
        x, z, heading = _on_arc(straight["x"] + way * INWARDS, straight["z"], way)
        turned = {
            "yaw": np.degrees(heading),
            "list": straight["list"] - way * 3.5,
            "low_yaw": straight["low_yaw"] + way * 2.0,
            "up_yaw": straight["up_yaw"] + way * 4.0,
            "up_roll": straight["up_roll"] + way * 0.8,
            "head_yaw": straight["head_yaw"] + way * 14.0,
            "head_roll": straight["head_roll"] - way * 2.0,
        }
        return {**straight, "x": x, "z": z, **turned, **_arms(straight, way)}

    return body


def _arms(straight: dict[str, Array], way: float) -> dict[str, Array]:
    """The arm on the outside swings wider, the one on the inside hangs further from the body."""
    inside, outside = ("Left", "Right") if way > 0 else ("Right", "Left")
    return {
        f"{outside}.swing": straight[f"{outside}.swing"] * 1.12,
        f"{outside}.abduct": straight[f"{outside}.abduct"] + 2.0,
        f"{inside}.abduct": straight[f"{inside}.abduct"] + 3.5,
    }


CURVE_LEFT = Motion("walk-turn-left", CYCLE, curve_body(1.0), curve_feet(1.0))
CURVE_RIGHT = Motion("walk-turn-right", CYCLE, curve_body(-1.0), curve_feet(-1.0))
