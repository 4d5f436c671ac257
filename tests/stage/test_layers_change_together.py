"""Layers that change in the same tick: what is shown is the sum of the layers, each as if it were alone.

Joints move along x at steady velocities, so each layer is a number, and what it shows can be worked out by
itself: a cut shows the new motion, a blend goes on from what was shown along a cubic.
"""

from itertools import combinations

import numpy as np
import pytest
from layer_sums import BLENDS, NEXT, START_AND_VELOCITY, TICK, expected
from scipy.spatial.transform import Rotation
from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton
from statwalk.stage.stage import Stage

REST = rest(3, weights=1)
ARM, HAND = 1, 2


def steady(name, start, velocity, seconds=60.0):
    """A clip in which arm, hand and the morph weight go from `start` on at a velocity."""
    times = np.array([0, seconds], np.float32)
    x = np.array([start, start + velocity * seconds], np.float32)
    move = np.stack([x, 0 * x, 0 * x], -1)
    channels = [Channel(joint, "translation", times, move) for joint in (ARM, HAND)]
    return Clip(name, (*channels, Channel(0, "weights", times, x[:, None])), seconds, REST)


def turning(name, axis, degrees, seconds=1.0):
    """A clip in which the arm turns through angles, evenly spaced in time."""
    turns = Rotation.from_euler(axis, np.array(degrees)[:, None], degrees=True).as_quat().astype(np.float32)
    times = np.linspace(0, seconds, len(degrees)).astype(np.float32)
    return Clip(name, (Channel(ARM, "rotation", times, turns),), seconds, REST)


def character():
    skeleton, _ = Skeleton.sorted(["hips", "arm", "hand"], [None, "hips", "hips"])
    clips = [steady(f"{layer}-{state}", *line) for (layer, state), line in START_AND_VELOCITY.items()]
    clips += [turning("front", "y", [0, 0.0]), turning("side", "y", [90, 90.0])]
    clips += [turning("lift", "z", [0, 100, 200, 300.0])]
    return Character(
        "line", skeleton, np.arange(3, dtype=np.int32), REST, {clip.name: clip for clip in clips}
    )


CHARACTER = character()


def table_of(layer, indent):
    """The states A, B and C of a layer in a ring, and events that lead on by each kind of blend."""
    events = [f"{kind}-{layer}" for kind in BLENDS]
    lines = ["states:"]
    lines += [f"  {state}: {{motion: {layer}-{state}, loop: true}}" for state in NEXT]
    lines += ["table: |", f"  state | {' | '.join(events)}"]
    lines += [f"  {state} | {' | '.join([to] * len(events))}" for state, to in NEXT.items()]
    lines += ["cells:"]
    for state, to in NEXT.items():
        lines += [f"  {state}/{kind}-{layer}: {{to: {to}, blend: {BLENDS[kind]}}}" for kind in BLENDS]
    return "\n".join(indent + line for line in lines)


def layer_text(name, mask, mode, weight):
    head = [f"  {name}:", f"    mask: [{', '.join(mask)}]", f"    mode: {mode}", f"    weight: {weight}"]
    return "\n".join([*head, "    initial: A", table_of(name, "    ")])


HEAD = "character: c.glb\ninitial: A\ndefaults: {when: now, blend: 0, buffer: 0}\n"


def role(*layers):
    """A machine of a base and layers (name, mask, mode, weight)."""
    text = HEAD + table_of("base", "") + ("\nlayers:\n" if layers else "")
    text += "\n".join(layer_text(*layer) for layer in layers)
    return Role.build("line", CHARACTER, read_machine(text, "line"), "hips")


def play(stage, actors, scripts, ticks):
    """Tracks (actors, ticks, 2) of arm and hand."""
    tracks = np.empty((len(actors), ticks, 2))
    for tick in range(1, ticks + 1):
        for actor, script in zip(actors, scripts, strict=True):
            for layer, kind in script.get(tick, {}).items():
                stage.send(actor, f"{kind}-{layer}")
        stage.step()
        tracks[:, tick - 1] = stage.frame.casts[0].pose.translation[:, [ARM, HAND], 0]
    return tracks


def compare(layers, scripts, ticks):
    stage, line = Stage(seed=1, rate=60), role(*layers)
    tracks = play(stage, [stage.add(line) for _ in scripts], scripts, ticks)
    for script, track in zip(scripts, tracks, strict=True):
        for joint, shown in zip(("arm", "hand"), track.T, strict=True):
            assert shown == pytest.approx(expected(layers, joint, script, ticks), abs=2e-4), (joint, script)


ARMS = [("additive", 1), ("additive", 0.5), ("override", 0.5), ("override", 1)]


@pytest.mark.parametrize(("mode", "weight"), ARMS)
@pytest.mark.parametrize(
    "kinds", [("CUT", "LONG"), ("LONG", "CUT"), ("SHORT", "LONG"), ("LONG", "SHORT"), ("CUT", "CUT")]
)
def test_each_layer_is_shown_as_if_it_were_alone(mode, weight, kinds):
    """Base and layer change in tick 7."""
    script = {7: dict(zip(("base", "arms"), kinds, strict=True))}
    compare([("arms", ["arm"], mode, weight)], [script], 22)


def test_a_layer_that_fades_takes_in_nothing_of_the_base_that_cuts():
    """By hand: the arm was at 6 m/s x 0.1 s = 0.6 m and turns to -3 m/s from 0, so one tick before it would
    have been at 0.05: an offset of 0.55 m that goes at 9 m/s. A twelfth into the blend 0.98032 of the one
    and 1/60 s x 0.84028 of the other are left: 0.66522 m. The base stands at 1 m.
    """
    stage, line = Stage(seed=1, rate=60), role(("arms", ["arm"], "additive", 1))
    track = play(stage, [stage.add(line)], [{7: {"base": "CUT", "arms": "LONG"}}], 7)
    assert track[0, 6] == pytest.approx([1.66522, 1.0], abs=1e-4)


def test_a_blend_a_tick_after_a_cut_takes_over_the_new_velocity_and_not_the_jump():
    """By hand: the cut in tick 7 puts the hand at 1 m, going at -0.2 m/s; the blend in tick 8 leads to -0.5 m
    at 1.1 m/s, one tick before at -0.51833: an offset of 1.51833 m at -1.3 m/s. A twelfth into the blend
    0.98032 of the one and 1/60 s x 0.84028 of the other are left.
    """
    stage, line = Stage(seed=1, rate=60), role()
    track = play(stage, [stage.add(line)], [{7: {"base": "CUT"}, 8: {"base": "LONG"}}], 8)
    assert track[0, 6:, 1] == pytest.approx([1.0, -0.5 + 1.51833 * 0.98032 - 1.3 / 60 * 0.84028], abs=1e-4)


def test_the_base_fades_where_a_layer_cuts():
    """By hand: the base was at 0.03 m at 0.3 m/s and turns to 1 m at -0.2 m/s, one tick before at 1.00333:
    an offset of -0.97333 m at 0.5 m/s, of which -0.94718 m is left. The arm stands at 0.
    """
    stage, line = Stage(seed=1, rate=60), role(("arms", ["arm"], "additive", 1))
    track = play(stage, [stage.add(line)], [{7: {"base": "LONG", "arms": "CUT"}}], 7)
    assert track[0, 6] == pytest.approx([0.05282, 0.05282], abs=1e-4)


@pytest.mark.parametrize("top", [["hand"], ["arm", "hand"]])
@pytest.mark.parametrize(("mode", "weight"), ARMS)
def test_random_lives_are_the_sum_of_their_layers(mode, weight, top):
    """Twenty actors whose three layers change together, and interrupt each other's blends."""
    layers = [("arms", ["arm"], mode, weight), ("top", top, "additive", 0.5)]
    chance = np.random.default_rng(4)
    compare(layers, [random_life(chance) for _ in range(20)], 90)


@pytest.mark.parametrize(("mode", "weight"), ARMS)
def test_a_blend_a_tick_after_cuts_is_the_sum_of_its_layers(mode, weight):
    """Some of three layers blend, some cut while the blends are under way, and a tick later one blends."""
    layers, names = (
        [("arms", ["arm"], mode, weight), ("top", ["hand"], "additive", 0.5)],
        ("base", "arms", "top"),
    )
    scripts = [
        {3: dict.fromkeys(names, "LONG"), 8: dict.fromkeys(cuts, "CUT"), 9: {blends: "SHORT"}}
        for count in (1, 2, 3)
        for cuts in combinations(names, count)
        for blends in names
    ]
    compare(layers, scripts, 24)


def random_life(chance):
    """Six ticks in which some of three layers change, none of them a tick after a blend has ended: what is
    left of the velocity of a blend that has just ended is not taken over where layers change together.
    """
    script, ends, tick = {}, {}, 3
    for _ in range(6):
        tick += int(chance.integers(2, 16))
        while tick in ends.values():
            tick += 1
        script[tick] = {
            name: str(chance.choice(list(BLENDS)))
            for name in ("base", "arms", "top")
            if chance.random() < 0.7
        }
        ends |= {name: tick + round(BLENDS[kind] / TICK) for name, kind in script[tick].items()}
    return script


def test_one_layer_that_changes_does_not_see_its_neighbours():
    """The same bits alone and in a block in which another actor's layers change together."""
    line, script = role(("arms", ["arm"], "override", 0.5)), {5: {"base": "LONG"}, 9: {"arms": "SHORT"}}
    together = {5: {"base": "CUT", "arms": "LONG"}, 9: {"base": "LONG", "arms": "SHORT"}}
    single, crowd = Stage(seed=1, rate=60), Stage(seed=1, rate=60)
    alone = play(single, [single.add(line)], [script], 16)
    among = play(crowd, [crowd.add(line) for _ in range(3)], [script, together, script], 16)
    assert among[0].tobytes() == among[2].tobytes() == alone[0].tobytes()


TURNING = """
states:
  A: {motion: front, loop: true}
  B: {motion: side, loop: true}
table: |
  state | GO
  A | B
  B |
cells:
  A/GO: {to: B, blend: 0}
layers:
  arms:
    mask: [arm]
    mode: additive
    initial: UP
    states:
      UP: {motion: lift}
      NONE: {motion: none}
    table: |
      state | GO
      UP | NONE
      NONE |
    cells:
      UP/GO: {to: NONE, blend: 0.2}
"""


def test_turns_about_other_axes_do_not_mix():
    """The base cuts by 90 degrees about y; the arm, lifted by 30 degrees at 300 a second about its z, comes
    down from there: 30 x 0.98032 + 300 / 60 x 0.84028 = 33.611 degrees a tick later.
    """
    stage = Stage(seed=1, rate=60)
    actor = stage.add(Role.build("turning", CHARACTER, read_machine(HEAD + TURNING, "turning"), "hips"))
    stage.step(6)
    stage.send(actor, "GO")
    stage.step()
    wanted = Rotation.from_euler("YZ", [90, 33.611], degrees=True)
    assert (Rotation.from_quat(actor.pose.rotation[ARM]) * wanted.inv()).magnitude() < 1e-4
