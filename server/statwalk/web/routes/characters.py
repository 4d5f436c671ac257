"""/api/characters: the characters, their joints, clips and models; inverse kinematics of their poses."""

from __future__ import annotations

import math
from typing import Annotated

import numpy as np
from fastapi import APIRouter, Depends, Query, Response

from statwalk.character.chain_of_names import chain_joints
from statwalk.character.character import Character
from statwalk.character.feet import feet_of
from statwalk.character.foot_contacts import contacts_of
from statwalk.character.role import Role
from statwalk.files.film_strip import MOST_PICTURES, film_strip
from statwalk.files.machine_yaml.state_names import MEANINGS, proposed
from statwalk.files.skeleton_svg import Side
from statwalk.maths import quat
from statwalk.maths.clamp_table import JointLimit
from statwalk.maths.pose import Pose
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.model_store import UploadedCharacter
from statwalk.solve.chains import top_of
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import catalogue_of
from statwalk.web.routes.model_views import model_views
from statwalk.web.schemas.base import Coordinate
from statwalk.web.schemas.character import (
    CharacterView,
    ClipView,
    JointView,
    MappingView,
    ShippedCharacterView,
    UploadedCharacterView,
)
from statwalk.web.schemas.measured import FeetView, feet_view
from statwalk.web.schemas.solve import NewSolve, PoseSource, SolvedJointView, SolveView

router = APIRouter(prefix="/api/characters", tags=["characters"], route_class=BoundedRoute)
CatalogueDep = Annotated[Catalogue, Depends(catalogue_of)]


@router.get("")
def list_characters(catalogue: CatalogueDep) -> list[ShippedCharacterView | UploadedCharacterView]:
    """Lists the characters, each with the machine in whose folder it is; an uploaded character has the first
    machine made from it.
    """
    shipped = [ShippedCharacterView(name=name, machine=machine) for name, machine in catalogue.owners.items()]
    return [*shipped, *(_view_upload(upload, catalogue) for upload in catalogue.uploads().values())]


def _view_upload(upload: UploadedCharacter, catalogue: Catalogue) -> UploadedCharacterView:
    made = [entry for entry in catalogue.entries.values() if entry.made]
    machines = [entry.name for entry in made if entry.file.character_path.stem == upload.sha256]
    return UploadedCharacterView(
        name=upload.name,
        machine=machines[0] if machines else None,
        sha256=upload.sha256,
        bytes=upload.bytes,
        machines=machines,
    )


@router.get("/{name}")
def get_character(name: str, catalogue: CatalogueDep) -> CharacterView:
    """Returns the joints (parents first), clips and skins, and what the server repaired in the file."""
    character = catalogue.character(name)
    skeleton = character.skeleton
    return CharacterView(
        name=name,
        joints=[
            JointView(name=joint, parent=int(parent), node=int(node))
            for joint, parent, node in zip(skeleton.names, skeleton.parent, character.node_index, strict=True)
        ],
        clips=[ClipView(name=clip.name, duration=float(clip.duration)) for clip in character.clips.values()],
        skins=len(character.skins),
        **model_views(character)._asdict(),
        notes=list(character.notes),
        targets=list(character.targets),
        expressions=[line.text for line in character.expressions],
        muscle_bones=sorted(character.skeleton.muscle_bones),
        skinning=character.skinning,
        model=f"/api/characters/{name}/model.glb",
    )


@router.get("/{name}/feet")
def get_character_feet(name: str, catalogue: CatalogueDep) -> FeetView:
    """Returns the feet that the names of the joints tell, and the spans of the clips in which they stand."""
    character = catalogue.character(name)
    feet = feet_of(character)
    return feet_view(character.skeleton, feet, contacts_of(character, feet))


@router.get(
    "/{name}/skeleton.svg", response_class=Response, responses={200: {"content": {"image/svg+xml": {}}}}
)
def get_skeleton(
    name: str,
    catalogue: CatalogueDep,
    clip: Annotated[str, Query(max_length=200)] = "",
    time: Annotated[list[Coordinate] | None, Query(max_length=MOST_PICTURES)] = None,
    frames: Annotated[int, Query(ge=0, le=MOST_PICTURES)] = 0,
    side: Side = "right",
) -> Response:
    """Draws the skeleton as stick figures: at rest, or a clip as a film strip, at each `time` (seconds) or at
    so many `frames`.
    """
    drawn = film_strip(catalogue.character(name), clip, time or (), frames, side)
    return Response(drawn, media_type="image/svg+xml", headers={"Cache-Control": "no-cache"})


@router.get(
    "/{name}/model.glb", response_class=Response, responses={200: {"content": {"model/gltf-binary": {}}}}
)
def get_model(name: str, catalogue: CatalogueDep) -> Response:
    """Returns the model as a .glb, which any glTF viewer opens."""
    headers = {"Cache-Control": "no-cache"}
    return Response(catalogue.model_glb(name), media_type="model/gltf-binary", headers=headers)


@router.get("/{name}/mapping")
def get_mapping(name: str, catalogue: CatalogueDep) -> MappingView:
    """Proposes a state for each clip; change the mapping and post it to /api/machines."""
    clips = catalogue.character(name).clips
    return MappingView(character=name, mapping=proposed(clips), meanings=MEANINGS)


@router.post("/{name}/solve")
def solve(name: str, body: NewSolve, catalogue: CatalogueDep) -> SolveView:
    """Returns the joints of a chain after its end was brought to the target; nothing on a stage changes."""
    character = catalogue.character(name)
    limits = {} if body.machine is None else {"limits": _limits(character, catalogue.role(body.machine))}
    answer = character.solve(
        _pose(character, body.pose),
        body.chain,
        body.target,
        body.solver,
        weight=body.weight,
        pole=body.pole,
        pole_point=body.pole_point,
        rotation=body.rotation,
        softening=body.softening,
        tolerance=body.tolerance,
        iterations=body.iterations,
        sensitivity=body.sensitivity,
        forward=body.forward,
        anchor=body.anchor,
        **limits,
    )
    joints, _middle = chain_joints(character.skeleton, body.chain, body.solver)
    places = character.world(answer.pose)
    return SolveView(
        joints=[
            SolvedJointView(
                name=character.skeleton.names[joint],
                rotation=tuple(answer.pose.rotation[joint].tolist()),
                position=tuple(places[joint, :3, 3].tolist()),
            )
            for joint in joints
        ],
        reached=bool(answer.reached),
        distance=float(answer.distance),
        iterations=int(answer.iterations),
        clamped={joint: math.degrees(float(angle)) for joint, angle in answer.clamped.items()},
        root=tuple(answer.pose.translation[top_of(character.skeleton.parent, joints[0])].tolist()),
    )


def _limits(character: Character, role: Role) -> dict[str, JointLimit]:
    """The limits of a machine's joints that the character has too."""
    names = role.character.skeleton.names
    return {names[row]: limit for row, limit in role.limits.items() if names[row] in character.skeleton.names}


def _pose(character: Character, source: PoseSource) -> Pose:
    """The pose of a body.

    :raises UnknownNameError: when the character has no such clip or joint.
    """
    pose = character.bind_pose if source.clip is None else character.clip(source.clip).sample(source.time)
    pose = pose.copy()
    for joint, rotation in source.rotations.items():
        pose.rotation[character.skeleton.index(joint)] = quat.normalize(np.array(rotation))
    for joint, translation in source.translations.items():
        pose.translation[character.skeleton.index(joint)] = translation
    return pose
