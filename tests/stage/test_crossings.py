"""A cast's tick crosses from Python into compiled code at most twice, whatever its machines measure, begin
and look at: every kernel is counted as it is called.
"""

import sys
import threading
from collections import Counter

import pytest
import statwalk
from builders import character
from statwalk.character.role import Role
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.maths import compiling
from statwalk.maths.prepare import prepare
from statwalk.stage.stage import Stage

OF_THE_STAGE = ("statwalk.world.", "statwalk.character.colliders.")
"""kernels of step 10, after the ticks of all casts: where colliders are, who touches whom, how flocks see"""
MACHINE = """
character: c.glb
initial: IDLE
root: hips
states:
  IDLE: {motion: walk, loop: true}
table: |
  state | HIT  | FAST
  IDLE  | -    | IDLE
colliders: {tip: {sphere: 0.5, joint: arm}}
senses: {HIT: {touch: [tip, tip]}, FAST: {when: speed > 1}}
"""


@pytest.fixture
def crossings(monkeypatch):
    """How often each kernel is called from here on in this thread, by its module and name."""
    prepare()
    here = threading.get_ident()
    counts: Counter[str] = Counter()

    def counted(kernel):
        name = f"{kernel.py_func.__module__}.{kernel.py_func.__name__}"

        def call(*arguments):
            counts[name] += threading.get_ident() == here
            return kernel(*arguments)

        return call

    counting = {id(kernel): counted(kernel) for kernel in compiling.KERNELS}
    modules = [module for name, module in sys.modules.items() if name.startswith("statwalk")]
    for module in modules:
        for name, value in list(vars(module).items()):
            if id(value) in counting:
                monkeypatch.setattr(module, name, counting[id(value)])
    return counts


def most_in_a_tick(stage, counts, ticks=120):
    """The most calls in a tick, without those of step 10; events come every tenth tick."""
    most: Counter[str] = Counter()
    for tick in range(ticks):
        for actor in stage.actors[: 5 if tick % 10 == 0 else 0]:
            events = actor.role.machine.events[:-1]
            if events:  # a machine may run by itself
                stage.send(actor, events[tick // 10 % len(events)])
        counts.clear()
        stage.step()
        own = Counter({name: count for name, count in counts.items() if not name.startswith(OF_THE_STAGE)})
        most = max(most, own, key=Counter.total)
    return most


@pytest.mark.parametrize("machine", statwalk.shipped_machines())
@pytest.mark.parametrize("actors", [1, 20])
def test_of_the_machines_that_are_shipped(machine, actors, crossings):
    stage, role = Stage(), statwalk.load(machine)
    stage.add_many(role, [((0.5 * number, 0, 0), 0.0) for number in range(actors)])
    most_in_a_tick(stage, crossings, 1)  # makes room for the effects of many events and layers, once
    most = most_in_a_tick(stage, crossings)
    assert most.total() == 2, most


@pytest.mark.parametrize("scene", statwalk.shipped_scenes())
def test_of_each_cast_of_a_scene(scene, crossings):
    stage = statwalk.load_scene(scene).open()
    most = most_in_a_tick(stage, crossings)
    assert most.total() == 2 * len(stage.casts), most


def test_of_a_cast_that_measures_and_is_touched(crossings):
    role, stage = Role.build("toucher", character(), read_machine(MACHINE, "toucher"), "hips"), Stage()
    for number in range(3):
        stage.add(role, (0.1 * number, 0, 0))
    most = most_in_a_tick(stage, crossings)
    assert len(stage.state.contacts.touching) == 6  # each its two neighbours
    assert most.total() == 2, most
