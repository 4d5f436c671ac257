"""Writes commands by chance for the recorded runs: lines of words, by the tick in which they count."""

from random import Random

from run_machines import Machine

STYLES = (
    *("calm", "busy", "busy", "held", "held", "burst"),
    *("travel", "edits", "edits", "crowd", "all", "all"),
)
PARAMETERS = {"pace": (0.5, 2.0), "stamina": (0.0, 20.0), "arm": (0.0, 1.0)}


def commands(
    chance: Random, machine: Machine, edits: list[int], actors: int, ticks: int
) -> dict[int, list[str]]:
    """For each tick (from 1) the commands that count in it; `edits`: numbers of the files that may replace
    the machine's.
    """
    style = "crowd" if "X0" in machine.events and chance.random() < 0.6 else chance.choice(STYLES)
    teller = _Teller(chance, machine, edits, actors)
    found = {tick: list(getattr(teller, style)(tick)) for tick in range(1, ticks + 1)}
    return {tick: lines for tick, lines in found.items() if lines}


class _Teller:
    def __init__(self, chance: Random, machine: Machine, edits: list[int], actors: int) -> None:
        self.chance, self.machine, self.actors = chance, machine, actors
        self.favourites = chance.sample(machine.events, min(3, len(machine.events)))
        self.edited = {chance.randint(10, 40): number for number in edits}

    def actor(self) -> int:
        return self.chance.randint(1, self.actors)

    def event(self) -> str:
        return self.chance.choice(self.favourites if self.chance.random() < 0.7 else self.machine.events)

    def often(self, share: float, make, *args):
        """Lines of `make`, as many as chance says: `share` is the chance of each further one."""
        while self.chance.random() < share:
            yield make(*args)

    def press(self) -> str:
        return f"press {self.actor()} {self.event()}"

    def key(self) -> str:
        kind = self.chance.choice(["hold", "hold", "hold", "release", "release", "press"])
        return f"{kind} {self.actor()} {self.chance.choice(self.favourites)}"

    def parameter(self) -> str:
        name = self.chance.choice(list(PARAMETERS))
        return f"set {self.actor()} {name} {round(self.chance.uniform(*PARAMETERS[name]), 2)}"

    def goal(self) -> str:
        return (
            f"travel {self.actor()} {self.chance.choice([*self.machine.states, *self.machine.states, '-'])}"
        )

    def calm(self, _: int):
        yield from self.often(0.08, self.press)
        yield from self.often(0.03, self.parameter)

    def busy(self, _: int):
        yield from self.often(0.3, self.press)
        yield from self.often(0.1, self.parameter)

    def held(self, _: int):
        yield from self.often(0.15, self.key)
        yield from self.often(0.08, self.parameter)
        yield from self.often(0.05, self.press)

    def burst(self, tick: int):
        """So many in one tick that more than 8 may change the state."""
        if self.chance.random() < 0.06:
            actor, events = self.actor(), self.chance.sample(self.favourites, 2)
            yield from (
                f"press {actor} {self.chance.choice(events)}" for _ in range(self.chance.randint(9, 20))
            )
        yield from self.calm(tick)

    def travel(self, tick: int):
        yield from self.often(0.06, self.goal)
        yield from self.calm(tick)

    def edits(self, tick: int):
        yield from self.busy(tick)
        yield from self.often(0.06, self.key)
        if tick in self.edited:
            yield f"edit one {self.edited[tick]}"

    def crowd(self, tick: int):
        """Many events that wait."""
        if self.chance.random() < 0.1:
            actor = self.actor()
            events = self.chance.sample(self.machine.events, min(len(self.machine.events), 9))
            yield from (f"press {actor} {event}" for event in events)
        yield from self.held(tick)

    def all(self, tick: int):
        yield from self.edits(tick)
        yield from self.often(0.03, self.goal)
        if self.chance.random() < 0.01:
            yield self.chance.choice([f"remove {self.actor()}", "add one Cid 0.4 0 0.2 1"])
