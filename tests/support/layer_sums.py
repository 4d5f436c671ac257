"""What layers show that change together, each worked out as if it were alone, and summed."""

import numpy as np

TICK = 1 / 60
BLENDS = {"CUT": 0.0, "SHORT": 0.1, "LONG": 0.2}
START_AND_VELOCITY = {
    ("base", "A"): (0.0, 0.3), ("base", "B"): (1.0, -0.2), ("base", "C"): (-0.5, 1.1),
    ("arms", "A"): (0.2, 6.0), ("arms", "B"): (-0.7, -3.0), ("arms", "C"): (0.4, 2.0),
    ("top", "A"): (0.1, -4.0), ("top", "B"): (0.8, 5.0), ("top", "C"): (-0.3, 1.0),
}  # fmt: skip
"""metres and metres per second"""
NEXT = {"A": "B", "B": "C", "C": "A"}


class LayerAlone:
    """What a layer shows that nothing lies over or under."""

    def __init__(self, layer, is_additive):
        self.layer, self.is_additive, self.state, self.seconds = layer, is_additive, "A", 0.0
        self.offset, self.velocity, self.passed, self.duration = 0.0, 0.0, 0.0, 0.0
        self.shown = self.earlier = self.motion()

    def motion(self):
        start, velocity = START_AND_VELOCITY[self.layer, self.state]
        return velocity * self.seconds + (0.0 if self.is_additive else start)

    def tick(self, kind):
        """The number that is shown a tick later, when an event of this kind has come or none."""
        left = self.left()
        self.seconds, self.passed = self.seconds + TICK, self.passed + TICK
        if kind is not None:
            self.state, self.seconds = NEXT[self.state], 0.0
        if kind is not None and BLENDS[kind] > 0:
            velocity = START_AND_VELOCITY[self.layer, self.state][1]
            self.offset = self.shown - (self.motion() - velocity * TICK)
            self.velocity = (self.shown - self.earlier) / TICK - velocity
            self.passed, self.duration = TICK, BLENDS[kind]
        self.earlier, self.shown = self.shown, self.motion() + self.left()
        if kind is not None and BLENDS[kind] == 0:  # the jump of a cut is no velocity
            self.earlier = self.motion() - START_AND_VELOCITY[self.layer, self.state][1] * TICK + left
        return self.shown

    def left(self):
        if not self.passed < self.duration - 1e-9:
            return 0.0
        left = 1 - self.passed / self.duration
        return (self.offset * (3 - 2 * left) + self.velocity * self.passed) * left**2


def expected(layers, joint, script, ticks):
    """What is shown of a joint at ticks 1 …; `script` has {tick: {layer: kind}}."""
    alone = {"base": LayerAlone("base", False)}
    alone |= {name: LayerAlone(name, mode == "additive") for name, _, mode, _ in layers}
    track = []
    for tick in range(1, ticks + 1):
        shown = {name: layer.tick(script.get(tick, {}).get(name)) for name, layer in alone.items()}
        x = shown["base"]
        for name, mask, mode, weight in layers:
            if joint in mask:
                x = (
                    x + weight * shown[name]
                    if mode == "additive"
                    else x * (1 - weight) + weight * shown[name]
                )
        track.append(x)
    return np.array(track)
