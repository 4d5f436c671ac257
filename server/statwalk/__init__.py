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

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from statwalk.character.character import Character as Character
    from statwalk.character.deduce import Deduction as Deduction
    from statwalk.character.deduce import deduce as deduce
    from statwalk.character.express import Expressed as Expressed
    from statwalk.character.express import express as express
    from statwalk.character.made_clips import sides_of as sides_of
    from statwalk.character.motion_path import motion_path as motion_path
    from statwalk.character.retarget import retarget as retarget
    from statwalk.character.role import Role as Role
    from statwalk.character.staging import staging as staging
    from statwalk.errors import ContentError as ContentError
    from statwalk.errors import MachineError as MachineError
    from statwalk.errors import ModelError as ModelError
    from statwalk.errors import StageError as StageError
    from statwalk.errors import StatwalkError as StatwalkError
    from statwalk.errors import TextError as TextError
    from statwalk.errors import UnknownNameError as UnknownNameError
    from statwalk.files.film_strip import film_strip as film_strip
    from statwalk.files.gltf.detailed_model import lod as lod
    from statwalk.files.gltf.detailed_model import with_detail as with_detail
    from statwalk.files.gltf.rigged import rigged as rigged
    from statwalk.files.principles import follow_through as follow_through
    from statwalk.files.principles import secondary as secondary
    from statwalk.files.principles import straight_ahead as straight_ahead
    from statwalk.maths.pose import Pose as Pose
    from statwalk.motion.filter_clip import filtered as filtered
    from statwalk.motion.principles.anticipate import anticipate as anticipate
    from statwalk.motion.principles.ease import ease as ease
    from statwalk.motion.principles.exaggerate import exaggerate as exaggerate
    from statwalk.motion.principles.retime import retime as retime
    from statwalk.motion.principles.retime import to_frames as to_frames
    from statwalk.motion.principles.retime import to_seconds as to_seconds
    from statwalk.motion.principles.squash import squash as squash
    from statwalk.motion.principles.twinning import twinning as twinning
    from statwalk.motion.switched import switched as switched
    from statwalk.services.library.convert import convert as convert
    from statwalk.services.library.load import load as load
    from statwalk.services.library.load import shipped_machines as shipped_machines
    from statwalk.services.library.load_scene import load_scene as load_scene
    from statwalk.services.library.load_scene import shipped_scenes as shipped_scenes
    from statwalk.stage.replay import replay as replay
    from statwalk.stage.stage import Actor as Actor
    from statwalk.stage.stage import Stage as Stage
    from statwalk.web.edit_text import edit as edit

_NAMES = {  # imported on first use: `statwalk --help` needs none of them
    "statwalk.character.character": ("Character",),
    "statwalk.character.deduce": ("Deduction", "deduce"),
    "statwalk.character.express": ("Expressed", "express"),
    "statwalk.character.made_clips": ("sides_of",),
    "statwalk.character.motion_path": ("motion_path",),
    "statwalk.character.retarget": ("retarget",),
    "statwalk.character.role": ("Role",),
    "statwalk.character.staging": ("staging",),
    "statwalk.errors": (
        "ContentError",
        "MachineError",
        "ModelError",
        "StageError",
        "StatwalkError",
        "TextError",
        "UnknownNameError",
    ),
    "statwalk.files.film_strip": ("film_strip",),
    "statwalk.files.gltf.detailed_model": ("lod", "with_detail"),
    "statwalk.files.gltf.rigged": ("rigged",),
    "statwalk.files.principles": ("follow_through", "secondary", "straight_ahead"),
    "statwalk.maths.pose": ("Pose",),
    "statwalk.motion.filter_clip": ("filtered",),
    "statwalk.motion.principles.anticipate": ("anticipate",),
    "statwalk.motion.principles.ease": ("ease",),
    "statwalk.motion.principles.exaggerate": ("exaggerate",),
    "statwalk.motion.principles.retime": ("retime", "to_frames", "to_seconds"),
    "statwalk.motion.principles.squash": ("squash",),
    "statwalk.motion.principles.twinning": ("twinning",),
    "statwalk.motion.switched": ("switched",),
    "statwalk.services.library.convert": ("convert",),
    "statwalk.services.library.load": ("load", "shipped_machines"),
    "statwalk.services.library.load_scene": ("load_scene", "shipped_scenes"),
    "statwalk.stage.replay": ("replay",),
    "statwalk.stage.stage": ("Actor", "Stage"),
    "statwalk.web.edit_text": ("edit",),
}
_MODULES = {name: module for module, names in _NAMES.items() for name in names}
__all__ = sorted(_MODULES)


def __getattr__(name: str) -> Any:
    if name not in _MODULES:
        raise AttributeError(f"module 'statwalk' has no attribute {name!r}")
    try:
        module = import_module(_MODULES[name])
    except ImportError:
        import_module(
            "statwalk.maths.prepare"
        ).compiler()  # raises a StatwalkError where numba is what is missing
        raise
    globals()[name] = value = getattr(module, name)
    return value


def __dir__() -> list[str]:
    return __all__  # what a notebook completes
