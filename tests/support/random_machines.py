"""Machine files by chance, over the tiny character: whatever the reader takes, a stage must be able to live
with.
"""

from playing import role_of
from statwalk.errors import MachineError

STATES = {
    "STAND": "{motion: stand, loop: true}",
    "WALK": "{motion: walk, loop: true, speed: pace, markers: {left-down: 0.5}}",
    "HOP": "{motion: hop}",
    "TURN": "{motion: turn}",
    "SPIN": "{motion: {over: pace, clips: {walk: 0.5, turn: 2}}, loop: true}",
}
EVENTS = ("GO", "HOP", "TURN", "STOP", "X", "Y")
ARMS = """
layers:
  arms:
    mask: [arm]
    initial: REST
    states: {{REST: {{motion: none}}, WAVE: {{motion: hop}}}}
    table: |
      state | {event} | END
      REST  | WAVE    |
      WAVE  | {again} | REST
"""
PARAMETERS = """
parameters:
  pace: {default: 1, min: 0.5, max: 2, smooth: 0.2}
  stamina: {default: 8, min: 0, max: 20}
"""


def machine_text(chance):
    """A machine file that the reader takes; `chance` is a random.Random."""
    while True:
        text = a_text(chance)
        try:
            role_of(text)
        except MachineError:
            continue
        return text


def a_text(chance):
    states, events = (
        chance.sample(list(STATES), chance.randint(2, 5)),
        chance.sample(EVENTS, chance.randint(2, 6)),
    )
    rows = [
        [state, *(a_cell(chance, states) for _ in events), chance.choice(["", chance.choice(states)])]
        for state in states
    ]
    table = "\n".join("  " + " | ".join(row) for row in [["state", *events, "END"], *rows])
    known = "\n".join(f"  {state}: {STATES[state]}" for state in states)
    when = chance.choice(["now", "now", "end"])
    head = (
        f"character: c.glb\ninitial: {states[0]}\nstates:\n{known}\n"
        f"{PARAMETERS}defaults: {{blend: 0.2, buffer: 0.3, when: {when}}}\n"
    )
    return f"{head}table: |\n{table}\n{cells(chance, states, events)}{more(chance, states, events)}"


def a_cell(chance, states):
    to = chance.choice(states)
    return chance.choice(["", "", "-", to, to, f"{to} at end", f"{to}!"])


def cells(chance, states, events):
    found = {
        f"{chance.choice([*states, '*'])}/{chance.choice(events)}": outcome(chance, states, events)
        for _ in range(4)
    }
    return "cells:\n" + "".join(f'  "{place}": {said}\n' for place, said in found.items())


def outcome(chance, states, events):
    one, other = chance.sample(states, 2)
    whom = chance.choice(["all", "other", "Ada"])
    return chance.choice(
        [
            f'[{{if: "stamina > {chance.randint(0, 20)} and pace < 1.5", to: {one}}}]',
            f"{{{one}: 3, {other}: 1}}",
            f"{{to: {one}, when: window 0.2..0.6}}",
            f'{{to: {one}, action: "raise({chance.choice(events)}, {whom})"}}',
            f"{{to: {one}, enter: match, blend: {{seconds: 0.1, curve: quintic}}}}",
            f"{{to: {one}, off: true}}",
            f'[{{if: "time > 0.3", to: {one}}}, {{if: "stamina < 3", to: {other}}}]',
        ]
    )


def more(chance, states, events):
    parts = [
        f"senses: {{{chance.choice(events)}: {{when: stamina < {chance.randint(1, 9)}, release: stamina > "
        f"9}}}}\n",
        ARMS.format(event=chance.choice(events), again=chance.choice(["", "-", "REST at end"])),
        f"fallback: {chance.choice(states)}\n",
        f"idle: {events[0]}\n",
    ]
    return "".join(part for part in parts if chance.random() < 0.5)
