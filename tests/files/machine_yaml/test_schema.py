"""The JSON Schema says what the reader says: shipped files are valid, wrong ones are refused by both, the
keys are the same.
"""

import json
import re

import jsonschema
import pytest
from paths import GLTF, MACHINES, needs_assets
from statwalk.errors import MachineError
from statwalk.files.character_file import load_character_file
from statwalk.files.machine_yaml import (
    capture_lines,
    cells,
    flock_part,
    layers,
    levels,
    solvers_part,
    states,
)
from statwalk.files.machine_yaml.machine_file import KEYS, SCHEMA_PATH, read_machine
from statwalk.files.machine_yaml.new_machine import write_machine
from statwalk.files.yaml.yaml_text import parse
from statwalk.machine.definition.budgets_definition import FIGURES

SCHEMA = json.loads(SCHEMA_PATH.read_text())
SHIPPED = sorted(MACHINES.rglob("machine.yaml"))

WHOLE = """semantics: 1
title: all of it
view: {base: {MOVE: [10, -20.5]}, arms: }
character: faq-walker
root: Hips
initial: FIGHT
idle: STOP
fallback: MOVE
defaults: {when: end, blend: {seconds: 0.2, curve: quintic}, buffer: 0.5}
states:
  MOVE:
    motion: {over: [pace, side], clips: {walk: [1, 0], run: [3, 0]}, markers: {walk: {left: 0.1}}}
    loop: true
    markers: {left: 0.1}
  LEAP: {motion: leap, speed: pace}
  1: {motion: 2, framing: upper body, ground_speed: [0, 1.4]}
  FIGHT:
    machine:
      initial: GUARD
      states: {GUARD: {motion: guard}, HIT: {motion: hit, final: true}}
      table: |
        state | PUNCH
        GUARD | HIT at left
    resume: true
captures:
  cmu: {file: walk.bvh, position: add, scale: 0.1, end: 2.5, loop: true, filter: {low_pass: 6, spikes: true}}
  wave: {file: wave.trc, bones: {Hips: pelvis}, target_bones: {Head: top}}
events: {LATE: {buffer: 1}, MORE: }
table: |
  state | GO   | STOP | END
  MOVE  | LEAP | -    |
cells:
  MOVE/GO: {when: window 0.2..0.6, blend: 0.1, enter: match, action: "drop(coins, 3)", off: true}
  MOVE/LATE:
    - {if: side > 0 and pace < 2, to: LEAP!, blend: {curve: cubic}, enter: 0.5, action: hop}
    - {to: FIGHT}
  LEAP/GO: {to: {MOVE: 4, LEAP: 1}, when: marker left-down}
  LEAP/STOP: {MOVE: 4, 1: 0.5}
  LEAP/END: {to: MOVE at end}
  "*/MORE": {to: "-"}
layers:
  arms:
    mask: [Spine]
    mode: additive
    weight: amount
    initial: REST
    states: {REST: {motion: none}}
    cells: {REST/GO: {to: REST!}}
keys:
  ArrowUp: {hold: GO, release: STOP}
  a: {press: GO}
  PageUp: {change: {MOVE: {pace: 0.5}, "*": {side: -1}}}
parameters:
  pace: {default: 1, min: 0, max: 4, smooth: 0.25}
  side: {default: 0, min: -1, max: 1}
  amount: {default: 1, min: 0, max: 1}
  bend: {default: 0, min: -90, max: 90, handle: {joint: Knee, freedom: angle, event: GO}}
chains:
  rope: {joints: [A, B], anchor: [A, B], gravity: 9.81, half_life: 0.5, mass: 2}
  tail: {joints: {from: A, to: B}, anchor: B}
senses:
  RUN: {when: speed > 2.0, release: speed < 1.6}
  HIT: {touch: [body, coin], on: stay}
colliders:
  body: {sphere: 0.4, joint: Hips, at: [0, 0, 0]}
  door: {plane: [0, 0, 1], at: [0, 1, 0], radius: 1}
flock: {distance: 2, nearest: 6, goal: {at: [0, 8, 0], radius: 25, seconds: 40}, speed_parameter: pace}
properties:
  - LEAP only after MOVE
feet: {left: {hip: thigh, knee: shin, ankle: foot, toe: toes}}
contacts: {walk: {left: [[0, 0.6]], right: [[0.5, 1.1]]}}
budgets:
  {jump: 1.2, joint: 2.4, slide: 0.015, sink: 0.005, hover: 0.006, knee: 0, hand: 60, visible: 0.1, half: 1,
   arrived: 2}
"""

WRONG = {
    "unknown key": ("title:", "titel:"),
    "unknown key of a state": ("speed: pace", "sped: pace"),
    "ground speed": ("ground_speed: [0, 1.4]", "ground_speed: fast"),
    "unknown framing": ("framing: upper body", "framing: feet"),
    "unknown key of a cell": ("off: true}", "of: true}"),
    "no initial state": ("initial: FIGHT\n", ""),
    "no table": ("table: |\n  state | GO  ", "description: |\n  state | GO  "),
    "another semantics": ("semantics: 1", "semantics: 2"),
    "a character of an unknown kind": ("character: faq-walker", "character: walker.exe"),
    "buffer": ("buffer: 0.5", "buffer: -1"),
    "curve": ("curve: quintic", "curve: linear"),
    "moment": ("when: end", "when: soon"),
    "marker without a name": ("when: marker left-down", "when: marker"),
    "window": ("window 0.2..0.6", "window 0.2-0.6"),
    "enter": ("enter: 0.5", "enter: 1.5"),
    "action": ('"drop(coins, 3)"', '"drop(coins"'),
    "off": ("off: true", "off: maybe"),
    "alternatives without an end": ("to: LEAP!, blend", "blend"),
    "no alternatives": (
        "\n    - {if: side > 0 and pace < 2, to: LEAP!, blend: {curve: cubic}, enter: 0.5, action: hop}\n"
        "    - {to: FIGHT}",
        " []",
    ),
    "moment of an alternative": ("{to: FIGHT}", "{to: FIGHT at end}"),
    "weight": ("MOVE: 4, 1: 0.5", "MOVE: -4"),
    "cell without an event": ("LEAP/GO:", "LEAP:"),
    "loop": ("loop: true", "loop: twice"),
    "speed": ("speed: pace", "speed: -1"),
    "state without a motion": ("{motion: leap, speed: pace}", "{speed: pace}"),
    "blend of one clip": ("{walk: [1, 0], run: [3, 0]}", "{walk: [1, 0]}"),
    "blend over three": ("over: [pace, side]", "over: [pace, side, amount]"),
    "marker beyond": ("    markers: {left: 0.1}\n", "    markers: {left: 1.1}\n"),
    "machine without states": ("states: {GUARD: {motion: guard}, HIT: {motion: hit, final: true}}\n", "\n"),
    "resume": ("resume: true", "resume: always"),
    "base as a layer": ("  arms:", "  base:"),
    "mode": ("mode: additive", "mode: add"),
    "place in the graph": ("[10, -20.5]", "[10]"),
    "mask": ("mask: [Spine]", "mask: Spine"),
    "key without down": ("{press: GO}", "{release: GO}"),
    "key with both": ("{press: GO}", "{press: GO, hold: GO}"),
    "key that changes and presses": ("{press: GO}", "{press: GO, change: {MOVE: {pace: 1}}}"),
    "key that changes nothing": ("{press: GO}", "{change: {}}"),
    "handle without a joint": ("handle: {joint: Knee, ", "handle: {"),
    "handle with more": ("event: GO}}", "event: GO, key: g}}"),
    "chain without joints": ("{joints: [A, B], anchor: [A, B], ", "{anchor: [A, B], "),
    "chain with three anchors": ("anchor: [A, B]", "anchor: [A, B, C]"),
    "chain without mass": ("mass: 2", "mass: 0"),
    "parameter without bounds": ("amount: {default: 1, min: 0, max: 1}", "amount: {default: 1}"),
    "parameter called as a word": ("  side: {default", "  not: {default"),
    "sense without a condition": ("{when: speed > 2.0, release: speed < 1.6}", "{release: speed < 1.6}"),
    "sense of END": ("  RUN:", "  END:"),
    "touch of one": ("[body, coin]", "[body]"),
    "kind of touch": ("on: stay", "on: always"),
    "collider without shape": ("{sphere: 0.4, joint", "{joint"),
    "sphere with a radius": ("{sphere: 0.4", "{radius: 1, sphere: 0.4"),
    "point": ("at: [0, 1, 0]", "at: [0, 1]"),
    "flock": ("flock: {distance", "flock: {distanse"),
    "properties": ("properties:\n  - ", "properties: "),
    "foot without ankle": ("ankle: foot, ", ""),
    "contact of one phase": ("[[0, 0.6]]", "[[0.6]]"),
    "contact beyond two laps": ("[[0.5, 1.1]]", "[[0.5, 2.1]]"),
    "unknown figure": ("slide: 0.015", "slip: 0.015"),
    "budget below nothing": ("sink: 0.005", "sink: -1"),
}


def typed(node):
    """What an editor sees: the scalars of YAML 1.2 (quoted ones are text)."""
    if isinstance(node.value, dict):
        return {key: typed(one) for key, one in node.value.items()}
    if isinstance(node.value, list):
        return [typed(one) for one in node.value]
    text = node.value
    if node.style is not None:
        return text
    if text in ("", "true", "false", "null", "~"):
        return {"true": True, "false": False}.get(text)
    return float(text) if re.fullmatch(r"[-+]?(\.\d+|\d+(\.\d*)?)([eE][-+]?\d+)?", text) else text


def validate(text):
    jsonschema.Draft7Validator(SCHEMA).validate(typed(parse(text, "machine.yaml", MachineError)))


def test_the_schema_is_one():
    jsonschema.Draft7Validator.check_schema(SCHEMA)


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.parent.name)
def test_shipped_files_are_valid(path):
    validate(path.read_text())


def test_all_that_can_be_said_is_valid():
    read_machine(WHOLE)
    validate(WHOLE)


@needs_assets
@pytest.mark.parametrize("name", ["KayKit_Knight", "Khronos_Fox"])
def test_new_machines_are_valid(name, tmp_path):
    source = GLTF / f"{name}.glb"
    validate(
        (write_machine(load_character_file(source), source, tmp_path / "made") / "machine.yaml").read_text()
    )


@pytest.mark.parametrize(("old", "new"), WRONG.values(), ids=WRONG)
def test_wrong_files_fail_in_both(old, new):
    assert old in WHOLE
    text = WHOLE.replace(old, new, 1)
    with pytest.raises(jsonschema.ValidationError):
        validate(text)
    if old.startswith("character"):
        return  # the character is looked at when a folder is loaded; test_machinefile says so
    with pytest.raises(MachineError):
        read_machine(text)


@pytest.mark.parametrize(
    ("place", "keys"),
    [
        (("properties",), KEYS),
        (("definitions", "state", "properties"), states.STATE_KEYS),
        (("definitions", "composite", "properties"), levels.COMPOSITE_KEYS),
        (("definitions", "cell", "properties"), cells.CELL_KEYS),
        (("definitions", "choices", "items", "properties"), cells.CHOICE_KEYS),
        (("properties", "layers", "additionalProperties", "properties"), layers.LAYER_KEYS),
        (("properties", "solvers", "additionalProperties", "properties"), solvers_part.KEYS),
        (("properties", "budgets", "properties"), FIGURES),
        (("properties", "captures", "additionalProperties", "properties"), capture_lines.KEYS),
        (("properties", "flock", "properties"), (*flock_part.NUMBERS, *flock_part.OTHERS)),
    ],
    ids=[
        *("machine", "state", "composite", "cell", "alternative", "layer"),
        *("solvers", "budgets", "captures", "flock"),
    ],
)
def test_reader_and_schema_know_the_same_keys(place, keys):
    part = SCHEMA
    for key in place:
        part = part[key]
    assert set(part) == set(keys)
