"""Writes machine files by chance for the recorded runs: small, nested, layered and crowded ones.

The recording stores every text, so it does not depend on this file once it is made.
"""

import re
from random import Random
from typing import NamedTuple

INPUTS = ("GO", "HOP", "TURN", "BUMP", "TIRED", "LATE")
MARKERS = ("left", "right")
CROWD = tuple(f"X{number}" for number in range(19))
OUTER, INNER, DEEP = ("A", "b", "C", "d"), ("P", "q"), ("X", "y")
CLIPS = ("stand", "walk", "hop", "turn", "nod")
MOMENTS = ("now", "now", "end", "marker left", "marker right", "window 0.2..0.5", "window 0.7..0.1")
BLENDS = ("0", "0.15", "{seconds: 0.2, curve: quintic}")
ACTIONS = ("nod", "'drop(coins, 3)'", "'raise(BUMP, other)'", "'raise(HOP, all)'", "'raise(GO, Bob)'")
CONDITIONS = (
    "pace > 1",
    "stamina % 3 < 1 and phase > 0.4",
    "time > 0.2 or pace < 0.8",
    "not (phase > 0.5)",
    "stamina < 6",
    "false",
)
POSE_CONDITIONS = (
    "speed > 0.5",
    "turning > 0.3 or speed > 1",
    "height > 1.02",
    "speed > 0.8 and pace > 1",
    "not (turning > 0.1)",
)
SENSES = (
    "stamina < 3, release: stamina > 5",
    "time > 0.3, release: time < 0.1",
    "phase > 0.6, release: phase < 0.2",
    "pace > 1.2",
)
POSE_SENSES = (
    "speed > 1, release: speed < 0.4",
    "turning > 0.5",
    "height > 1.05, release: height < 1.01",
    "speed > 0.6 and time > 0.2",
)
CHANGES = (
    ("when: now, blend", "when: end, blend"),
    ("buffer: 0.3", "buffer: 0"),
    ("speed: 1,", "speed: 0.7,"),
    ("HOP", "LEAP"),
    (r"\bb\b", "e"),
)
"""what an edit replaces, everywhere in the file"""
KINDS = ("small", "small", "small", "nested", "layered", "whole", "crowded")


class Machine(NamedTuple):
    """A machine file, and the names that commands speak of."""

    text: str
    states: tuple[str, ...]
    events: tuple[str, ...]


def machine(chance: Random, poses: bool) -> Machine:
    """A machine file; `poses`: its conditions, senses and touches look at poses."""
    return _Writer(chance, poses).machine()


def near(chance: Random, one: Machine) -> Machine:
    """Nearly the same file, as an edit makes it: without some cells, with another default."""
    lines = [line for line in one.text.splitlines() if "': {" not in line or chance.random() > 0.25]
    text = "\n".join(lines) + "\n"
    old, new = chance.choice(CHANGES)
    return one._replace(text=re.sub(old, new, text))


class _Writer:
    def __init__(self, chance: Random, poses: bool) -> None:
        self.chance, self.kind = chance, chance.choice(KINDS)
        self.conditions = CONDITIONS + POSE_CONDITIONS * 2 * poses
        self.senses = POSE_SENSES if poses else SENSES
        self.poses = poses
        self.events = CROWD if self.kind == "crowded" else INPUTS[: chance.randint(3, 6)]
        self.speeds = chance.choice([("1", "0.5", "pace"), ("1", "pace", "3", "8", "40", "0.37")])
        self.moments = chance.choice([MOMENTS, MOMENTS, ("now",), ("end", "end", "now")])

    def machine(self) -> Machine:
        nested = self.kind in ("nested", "whole")
        outer = OUTER[: self.chance.randint(2, 4)]
        states = (*outer, *("FIGHT",) * nested)
        base = f"states:\n{self.states(outer)}{self.fight() if nested else ''}{self.level(states)}"
        layers = self.layers() if self.kind in ("layered", "whole") else ""
        goals = (*outer, *(("FIGHT", "FIGHT.q", "FIGHT.DEEP.y") if nested else ()))
        inputs = tuple(dict.fromkeys([*self.events, "TIRED", "LATE", "BUMP"]))
        events = self.events if self.kind == "crowded" else inputs
        return Machine(self.head() + base + layers, goals, events)

    def head(self) -> str:
        chance = self.chance
        buffer = "2" if self.kind == "crowded" else chance.choice(["0", "0.1", "0.3"])
        when = chance.choice(["now", "now", "end"])
        idle = f"idle: {self.events[0]}\n" if chance.random() < 0.4 else ""
        fallback = chance.choice(["", "fallback: b\n"])
        senses = (
            f"  TIRED: {{when: {chance.choice(self.senses)}}}\n"
            f"  LATE: {{when: {chance.choice(self.senses)}}}\n"
        )
        touch = (
            f"touch: [body, {chance.choice(['body', 'wall'])}], on: "
            f"{chance.choice(['enter', 'stay', 'leave'])}"
        )
        bump = f"  BUMP: {{{touch}}}\n" if self.poses else ""
        colliders = (
            "colliders: {body: {sphere: 0.4, joint: hips}, wall: {plane: [0, 0, 1]}}\n" if self.poses else ""
        )
        own = "" if self.kind == "crowded" else "events: {GO: {buffer: 0.2}, BUMP: {buffer: 0.5}, HOP}\n"
        return (
            f"character: c.glb\ninitial: A\n{idle}{fallback}"
            f"defaults: {{when: {when}, blend: {chance.choice(BLENDS)}, buffer: {buffer}}}\n"
            "parameters:\n"
            f"  pace: {{default: 1, min: 0.5, max: 2{chance.choice(['', ', smooth: 0.1'])}}}\n"
            f"  stamina: {{default: 8, min: 0, max: 20{chance.choice(['', ', smooth: 0.2'])}}}\n"
            f"  arm: {{default: 1, min: 0, max: 1}}\n{own}{colliders}senses:\n{senses}{bump}"
        )

    def states(self, names: tuple[str, ...], final: str = "") -> str:
        ends = {name: ", final: true" if name == final else "" for name in names}
        return "".join(f"  {self.state(name, more)}\n" for name, more in ends.items())

    def state(self, name: str, more: str) -> str:
        """States in lower case loop."""
        markers = f"markers: {{left: {self.chance.choice(['0', '0.25', '0.5', '1'])}, right: 0.75}}"
        loop, speed = str(name.islower()).lower(), self.chance.choice(self.speeds)
        return f"{name}: {{motion: {self.motion()}, loop: {loop}, speed: {speed}, {markers}{more}}}"

    def motion(self) -> str:
        if self.poses and self.chance.random() < 0.5:
            return self.chance.choice(["walk", "turn"])
        if self.chance.random() < 0.1:
            return "{over: pace, clips: {stand: 0.5, walk: 1.2, hop: 1.9}}"
        return self.chance.choice(CLIPS)

    def fight(self) -> str:
        """A sub-machine that holds a sub-machine."""
        deep = f"initial: X\nstates:\n{self.states(DEEP, 'X')}{self.level(DEEP)}"
        inside = (
            f"  DEEP:\n    resume: {self.yes()}\n    final: {self.yes()}\n    machine:\n{_indented(deep, 6)}"
        )
        names = (*INNER, "DEEP")
        inner = (
            f"initial: {self.chance.choice(names)}\nstates:\n"
            f"{self.states(INNER, 'P')}{inside}{self.level(names)}"
        )
        return f"  FIGHT:\n    resume: {self.yes()}\n    machine:\n{_indented(inner, 6)}"

    def layers(self) -> str:
        return "layers:\n" + "".join(
            self.layer(name) for name in ("arms", "head")[: self.chance.randint(1, 2)]
        )

    def layer(self, name: str) -> str:
        chance, names = self.chance, ("REST", "E", "f")
        mode, weight = chance.choice(["override", "additive"]), chance.choice(["arm", "0.5"])
        text = f"mask: [{chance.choice(['chest', 'arm'])}]\nmode: {mode}\nweight: {weight}\ninitial: REST\n"
        states = f"states:\n  REST: {{motion: none}}\n{self.states(names[1:])}"
        return f"  {name}:\n" + _indented(f"{text}{states}{self.level(names)}", 4)

    def yes(self) -> str:
        return self.chance.choice(["true", "false"])

    def level(self, states: tuple[str, ...]) -> str:
        """A table in short forms, and what its cells do beyond them."""
        columns, chance = (*self.events, *MARKERS, "END"), self.chance
        short = {(row, event): self.short(states, row, event) for row in states for event in columns}
        rows = "".join(f"  {row} | {' | '.join(short[row, event] for event in columns)}\n" for row in states)
        full = 0.1 if self.kind == "crowded" else 0.55
        places = [(row, event) for row in states for event in columns if chance.random() < full]
        places += [(row, "*") for row in states if chance.random() < 0.1]
        places += [("*", event) for event in self.events if chance.random() < 0.15]
        free = [place for place in places if not short.get(place)]
        cells = "".join(f"  '{row}/{event}': {self.cell(states, row, event)}\n" for row, event in free)
        return f"table: |\n  state | {' | '.join(columns)}\n{rows}" + (f"cells:\n{cells}" if cells else "")

    def short(self, states: tuple[str, ...], row: str, event: str) -> str:
        to = self.chance.choice(states)
        if self.kind == "crowded" and event in CROWD:
            return self.chance.choice(["", f"{to} at end", f"{to} at end", f"{row} at end"])
        moments = [""] if event == "END" or row == "REST" else ["", "", " at end", " at left"]
        written = to + self.chance.choice(["", "", "!"]) + self.chance.choice(moments)
        return self.chance.choices(["", written, "-"], [6, 3, 1])[0]

    def cell(self, states: tuple[str, ...], row: str, event: str) -> str:
        chance = self.chance
        when = (
            ""
            if event == "END" or row == "REST" or chance.random() < 0.4
            else f", when: {chance.choice(self.moments)}"
        )
        first, second = (self.outcome(states) for _ in range(2))
        match chance.randrange(10):
            case 0 | 1:
                return f"{{to: [{{if: '{chance.choice(self.conditions)}', {first}}}, {{{second}}}]{when}}}"
            case 2 | 3:
                return f"{{to: [{{if: '{chance.choice(self.conditions)}', {first}}}]{when}}}"
            case 4:
                one, another = chance.sample(states, 2)
                return f"{{to: {{{one}: 3, {another}!: 1}}{when}}}"
            case 5 if event != "END":
                return "{off: true}"
        return f"{{{first}{when}}}"

    def outcome(self, states: tuple[str, ...]) -> str:
        chance = self.chance
        target = "NOWHERE" if chance.random() < 0.03 else chance.choice(states)
        said = [f"to: {target}{chance.choice(['', '', '!'])}"]
        said += [f"blend: {chance.choice(BLENDS)}"] * (chance.random() < 0.3)
        said += [f"enter: {chance.choice(['match', '0.3', '1'])}"] * (chance.random() < 0.3)
        said += [f"action: {chance.choice(ACTIONS)}"] * (chance.random() < 0.4)
        return ", ".join(said)


def _indented(text: str, by: int) -> str:
    return "".join(f"{' ' * by}{line}\n" for line in text.splitlines())
