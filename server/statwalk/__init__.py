"""statwalk animates characters from state tables: proved, streamed to a browser, tested without one.

From Python:

    import statwalk

    fox = statwalk.load("fox.glb")                  # a Character
    pose = fox.clips["Walk"].sample(0.3)            # a Pose: numbers
    walker = statwalk.load("faq-walker")            # a Role: character and machine
    stage = statwalk.Stage(seed=1)
    actor = stage.add(walker)
    stage.send(actor, "FORWARD")
    stage.step(30)
    actor.state, actor.pose, stage.hash
"""

from statwalk.character import Character
from statwalk.errors import ContentError, MachineError, ModelError, StageError, StatwalkError, TextError, UnknownNameError
from statwalk.loading import load, load_scene, shipped_machines, shipped_scenes
from statwalk.maths.pose import Pose
from statwalk.stage.past.replay import replay
from statwalk.stage.role import Role
from statwalk.stage.stage import Actor, Stage

__all__ = [
    "Actor",
    "Character",
    "ContentError",
    "MachineError",
    "ModelError",
    "Pose",
    "Role",
    "Stage",
    "StageError",
    "StatwalkError",
    "TextError",
    "UnknownNameError",
    "load",
    "load_scene",
    "replay",
    "shipped_machines",
    "shipped_scenes",
]
