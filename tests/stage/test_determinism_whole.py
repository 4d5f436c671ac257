"""The same log, the same bits: with chance, senses, layers, raised events, journeys and edits in it, however
it was cut.
"""

import pytest
from playing import role_of, text_of
from statwalk.stage.replay import replay
from statwalk.stage.stage import Stage

TABLE = """
state | GO   | HOP  | TURN | TIRED | WAVE | STOP  | END
STAND | WALK | HOP  | TURN | TURN  |      | -     |
WALK  | WALK | HOP  |      | STAND |      | STAND |
HOP   |      | HOP! |      |       |      |       | STAND
TURN  |      |      |      |       |      | STAND | STAND
"""
PARTS = """
senses: {TIRED: {when: stamina < 3, release: stamina > 5}}
layers:
  arms:
    mask: [arm]
    initial: REST
    states: {REST: {motion: none}, WAVE: {motion: hop}}
    table: |
      state | WAVE | END
      REST  | WAVE |
      WAVE  |      | REST
cells:
  STAND/GO: {WALK: 3, TURN: 1}
  WALK/HOP: {when: marker left-down, action: "raise(TURN, all)"}
  "*/END": {to: %s}
"""
STATES = """
states:
  STAND: {motion: stand, loop: true}
  WALK: {motion: {over: pace, clips: {stand: 0.5, walk: 1.5}}, loop: true, markers: {left-down: 0.5}}
  HOP: {motion: hop}
  TURN: {motion: turn}
parameters:
  pace: {default: 1, min: 0.5, max: 2, smooth: 0.3}
  stamina: {default: 8, min: 0, max: 20}
defaults: {blend: 0.2, buffer: 0.3}
"""
TEXTS = {key: text_of(TABLE, PARTS % to, STATES) for key, to in (("a", "STAND"), ("b", "WALK"))}
EVENTS = ("GO", "HOP", "WAVE", "TURN", "STOP")


def lived(cuts):
    """Thirty actors, 300 ticks: everybody is sent something every now and then, two edits come in between."""
    stage = Stage(seed=11)
    stage.add_many(role_of(TEXTS["a"]), [((number, 0, 0), number) for number in range(30)])
    cut = iter(cuts)
    for tick in range(0, 300, 20):
        for actor in range(1, 31):
            stage.send(actor, EVENTS[(actor + tick // 20) % 5])
        stage.set(1 + tick // 20, "stamina", tick % 7)
        stage.set(1 + tick // 20, "pace", 0.5 + tick % 3 / 2)
        if tick in (100, 200):
            stage.travel(3, "HOP")
            stage.edit(role_of(TEXTS["b" if tick == 100 else "a"]), TEXTS["b" if tick == 100 else "a"])
        left = 20
        while left:
            part = min(left, next(cut))
            stage.step(part)
            left -= part
    return stage


def forever(*cuts):
    while True:
        yield from cuts


@pytest.fixture(scope="module")
def whole():
    return lived(forever(20))


@pytest.fixture(scope="module")
def hashes(whole):
    """The hash of some ticks, gone through in order."""
    copy, found = whole.copy(), {}
    copy.seek(0)
    for tick in range(0, 301, 25):
        copy.seek(tick)
        found[tick] = copy.hash
    return found


def test_everything_has_happened(whole):
    said = {(one.event, one.verdict) for one in whole.verdicts}
    assert {("GO", "taken"), ("WAVE", "taken"), ("TIRED", "taken"), ("HOP", "waits")} <= said
    assert any(one.other > 0 for one in whole.verdicts)
    assert any("drawn" in one.reason for one in whole.verdicts)


def test_however_it_is_cut(whole):
    assert lived(forever(1, 3, 7, 2)).hash == whole.hash


def test_a_replay_is_the_same(whole, hashes):
    again = replay(whole.dump(), lambda name, text=TEXTS["a"]: role_of(text, name.partition("@")[0]), until=0)
    for tick in sorted(hashes):
        again.step(tick - again.tick)
        assert again.hash == hashes[tick]


def test_seeking_anywhere_shows_what_was_shown(whole, hashes):
    for tick in (300, 25, 225, 100, 125, 0, 275):
        whole.seek(tick)
        assert whole.hash == hashes[tick]
    whole.seek(300)


def test_a_fork_that_is_told_the_same_goes_the_same_way(whole, hashes):
    fork = whole.fork_at(90)
    for tick in range(91, 151):
        for command in whole.commands(tick):
            fork.keep(tick, command)
        fork.step()
    assert fork.hash == hashes[150]


def test_slices_come_to_the_same_state(whole, hashes):
    copy = whole.copy()
    copy.seek(0)
    slices = list(copy.seeking(275, most=17))
    assert (copy.hash, slices) == (hashes[275], [257, 274, 275])  # from the snapshot of tick 240


def test_an_actor_is_the_same_alone():
    """Without raised events nobody hears of the others: chance, blends and layers are the actor's own."""
    alone, crowd = Stage(seed=5), Stage(seed=5)
    role = role_of(TEXTS["a"])
    crowd.add_many(role, [((0, 0, 0), 0.5)] * 40)
    one = alone.add(role, heading=0.5)
    for stage in (alone, crowd):
        for event in ("GO", "WAVE", "STOP", "GO"):
            stage.send(1, event)
            stage.set(1, "pace", 1.7)
            stage.step(25)
    assert one.hash == crowd.actor(1).hash
