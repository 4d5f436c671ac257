"""Machine files drawn at random, with all that a file can say: sub-machines two deep, layers, senses,
touches, moments, blends.
"""

from random import Random

EVENTS = ("GO", "HOP", "TURN", "BUMP", "TIRED", "left", "right")
INPUTS = EVENTS[:5]
OUTER, INNER = ("A", "b", "FIGHT", "C", "d"), ("P", "q", "DEEP")
CLIPS = ("stand", "walk", "hop", "turn")
CONDITIONS = (
    "pace > 1",
    "stamina % 3 < 1 and phase > 0.4",
    "speed > 0.5 or time > 0.2",
    "not (turning > 0.1)",
    "height / 0 == 0",
    "false",
)
MOMENTS = ("now", "now", "now", "end", "marker left", "marker right", "window 0.2..0.5", "window 0.7..0.1")
BLENDS = ("0", "0.15", "{seconds: 0.2, curve: quintic}")
SPEEDS = ("1", "0.5", "pace", "3", "8", "40")
ACTIONS = ("nod", "'drop(coins, 3)'", "'raise(BUMP, other)'", "'raise(HOP, all)'", "'raise(GO, second)'")


def motion(chance):
    """A clip, or a blend over one or two parameters."""
    match chance.randrange(5):
        case 0:
            return "{over: pace, clips: {stand: 0.5, walk: 1.2, hop: 1.9}}"
        case 1:
            return (
                "{over: [pace, stamina], clips: {walk: [0.5, 0], turn: [1.5, 3], stand: [1, 9]}, markers: "
                "{turn: {left: 0.6}}}"
            )
    return chance.choice(CLIPS)


def state(chance, name, speeds, more=""):
    """A state; those in lower case loop."""
    speed = chance.choice(speeds)
    markers = f"markers: {{left: {chance.choice(['0', '0.25', '0.5', '1'])}, right: 0.75}}"
    return (
        f"{name}: {{motion: {motion(chance)}, loop: {str(name.islower()).lower()}, speed: {speed}, "
        f"{markers}{more}}}"
    )


def outcome(chance, states, blends):
    """What an alternative may say."""
    said = [f"to: {chance.choice(states)}{chance.choice(['', '', '!'])}"]
    said += [f"blend: {chance.choice(blends)}"] * (chance.random() < 0.3)
    said += [f"enter: {chance.choice(['match', '0.3', '1'])}"] * (chance.random() < 0.3)
    said += [f"action: {chance.choice(ACTIONS)}"] * (chance.random() < 0.3)
    return ", ".join(said)


def cell(chance, states, blends, row, event):
    """A cell's text."""
    when = "" if event == "END" or row == "REST" else f", when: {chance.choice(MOMENTS)}"
    first, other = (outcome(chance, states, blends) for _ in range(2))
    match chance.randrange(9):
        case 0:
            return f"{{to: [{{if: '{chance.choice(CONDITIONS)}', {first}}}, {{{other}}}]{when}}}"
        case 1:
            return f"{{to: [{{if: '{chance.choice(CONDITIONS)}', {first}}}]{when}}}"
        case 2:
            one, another = chance.sample(states, 2)
            return f"{{to: {{{one}: 3, {another}!: 1}}{when}}}"
        case 3 if event != "END":
            return "{off: true}"
    return f"{{{first}{when}}}"


def level(chance, states, blends):
    """A table without words, and its cells: of states, of rows and of columns."""
    places = [(row, event) for row in states for event in (*EVENTS, "END") if chance.random() < 0.45]
    places += [(row, "*") for row in states if chance.random() < 0.1] + [
        ("*", event) for event in EVENTS if chance.random() < 0.1
    ]
    rows = "".join(f"  {row} |{' |' * len(EVENTS)}\n" for row in states)
    cells = "".join(
        f"  '{row}/{event}': {cell(chance, states, blends, row, event)}\n" for row, event in places
    )
    return f"table: |\n  state | {' | '.join(EVENTS)} | END\n{rows}" + (f"cells:\n{cells}" if cells else "")


def indented(text, by):
    return "".join(f"{' ' * by}{line}\n" for line in text.splitlines())


def machine(seed, calm=False):
    """A machine file; `calm`: nothing is so fast, or cut, that it jumps."""
    chance = Random(seed)
    blends, speeds = BLENDS[calm:], SPEEDS[: 3 if calm else None]

    def states(*names, final=""):
        ends = {name: ", final: true" if name == final else "" for name in names}
        return "".join(f"  {state(chance, name, speeds, more)}\n" for name, more in ends.items())

    def yes():
        return chance.choice(["true", "false"])

    deep = f"initial: X\nstates:\n{states('X', 'y', final='X')}{level(chance, ('X', 'y'), blends)}"
    within = f"  DEEP:\n    resume: {yes()}\n    final: {yes()}\n    machine:\n{indented(deep, 6)}"
    inner = (
        f"initial: {chance.choice(INNER)}\nstates:\n"
        f"{states('P', 'q', final='P')}{within}{level(chance, INNER, blends)}"
    )
    fight = f"  FIGHT:\n    resume: {yes()}\n    machine:\n{indented(inner, 6)}"
    base = f"states:\n{states('A', 'b', 'C', 'd')}{fight}{level(chance, OUTER, blends)}"
    layer = (
        f"mask: [chest]\nmode: {chance.choice(['override', 'additive'])}\n"
        f"weight: {chance.choice(['arm', '0.5'])}\ninitial: REST\n"
    )
    layer += (
        f"states:\n  REST: {{motion: none}}\n{states('E', 'f')}{level(chance, ('REST', 'E', 'f'), blends)}"
    )
    return f"{head(chance, blends)}{base}layers:\n  arms:\n{indented(layer, 4)}"


def head(chance, blends):
    """What a file says beside its tables."""
    when, buffer = chance.choice(["now", "now", "end"]), chance.choice(["0", "0.1", "0.3"])
    tired = chance.choice(["stamina < 3", "speed > 1", "time > 0.3"])
    touch = (
        f"touch: [body, {chance.choice(['body', 'wall'])}], on: {chance.choice(['enter', 'stay', 'leave'])}"
    )
    return f"""
character: c.glb
initial: A
{chance.choice(["", "idle: GO"])}
defaults: {{when: {when}, blend: {chance.choice(blends)}, buffer: {buffer}}}
parameters:
  pace: {{default: 1, min: 0.5, max: 2, smooth: 0.1}}
  stamina: {{default: 8, min: 0, max: 20, smooth: 0.2}}
  arm: {{default: 1, min: 0, max: 1}}
colliders: {{body: {{sphere: 0.4, joint: hips}}, wall: {{plane: [0, 0, 1]}}}}
senses:
  TIRED: {{when: {tired}, release: stamina > 5}}
  BUMP: {{{touch}}}
"""


def inputs(seed, ticks, actors):
    """For each tick (from 0) what actors (from 1) are told: kind, actor, event or parameter or state,
    value.
    """
    chance = Random(seed + 10_000)
    told = {tick: [] for tick in range(ticks)}
    for tick in range(ticks):
        while chance.random() < 0.3:
            kind = chance.choice(["press", "press", "press", "hold", "release", "set", "travel"])
            name = {
                "set": chance.choice(["pace", "stamina"]),
                "travel": chance.choice(["A", "b", "FIGHT.q", "FIGHT.DEEP.y"]),
            }.get(kind)
            told[tick].append(
                (
                    kind,
                    chance.randint(1, actors),
                    name or chance.choice(INPUTS),
                    round(chance.uniform(0.5, 2), 2),
                )
            )
    return told
