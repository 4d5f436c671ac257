"""Captured motions: GET /api/characters/{name}/bones, POST /api/characters/{name}/clips."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

from fastapi import APIRouter, Depends, Response

from statwalk.character.body_bones import BODY_BONES, NEEDED, body_bones
from statwalk.character.capture import CaptureWish, with_capture
from statwalk.character.character import Character
from statwalk.character.retarget import Retargeted, Wish
from statwalk.errors import ContentError, UnknownNameError
from statwalk.files.character_archive import write_character
from statwalk.files.gltf.add_clip import model_with_clip
from statwalk.motion.filter_clip import Filter
from statwalk.services.library.catalogue import Catalogue
from statwalk.services.library.disk import room_on_disk
from statwalk.services.library.model_store import ModelStore
from statwalk.services.library.upload_sandbox import LARGEST_MODEL_BYTES, checked_beside
from statwalk.web.bounded_json import BoundedRoute
from statwalk.web.dependencies import catalogue_of
from statwalk.web.errors import Problem
from statwalk.web.routes.uploads import check_free, check_result_name, model_store_of
from statwalk.web.schemas.capture import BonesView, JointPair, NewClip, NewClipView

router = APIRouter(prefix="/api/characters", tags=["characters"], route_class=BoundedRoute)
CatalogueDep = Annotated[Catalogue, Depends(catalogue_of)]


@router.get("/{name}/bones")
def get_bones(name: str, catalogue: CatalogueDep) -> BonesView:
    """Returns which joint is which bone of a body, as far as the joints' names tell."""
    skeleton = catalogue.character(name).skeleton
    bones = {bone: skeleton.names[joint] for bone, joint in body_bones(skeleton).items()}
    return BonesView(character=name, bones=bones, needed=list(NEEDED), known=list(BODY_BONES))


@router.post("/{name}/clips", status_code=201)
def add_clip(name: str, new: NewClip, catalogue: CatalogueDep, response: Response) -> NewClipView:
    """Carries a clip of another character over to this one, and keeps the result as an uploaded character:
    this one with a clip more, or a new one called `character`.
    """
    store = model_store_of(catalogue)
    result = _result_name(name, new, catalogue, store)
    target, source = catalogue.character(name), catalogue.character(new.source)
    try:
        character, clip, report = with_capture(target, source, _wish(new))
    except ContentError as error:
        raise Problem(422, error.message, field=error.place or "source") from None
    except UnknownNameError as error:
        raise Problem(422, str(error), field="clip") from None
    with room_on_disk():
        _keep(result, replace(character, model_glb=model_with_clip(character, character.clips[clip])), store)
    response.headers["Location"] = f"/api/characters/{result}"
    return _view(result, character, clip, report)


def _result_name(name: str, new: NewClip, catalogue: Catalogue, store: ModelStore) -> str:
    """Returns the name under which the character with the clip is kept.

    :raises Problem: 409, when the name is taken, or the character belongs to the server.
    """
    result = check_result_name(name, new.character, catalogue)
    check_free(result, catalogue, store)
    return result


def _wish(new: NewClip) -> CaptureWish:
    carried = Wish(new.bones, new.target_bones, new.start, new.end)
    return CaptureWish(new.clip, new.name, carried, Filter(new.low_pass, new.spikes), new.loop)


def _keep(name: str, character: Character, store: ModelStore) -> None:
    """Keeps the character in the data folder, checked, so that no child process reads it again.

    :raises Problem: 413, when the model has become too large.
    """
    if len(character.model_glb) > LARGEST_MODEL_BYTES:
        raise Problem(413, f"the model with the clip is larger than {LARGEST_MODEL_BYTES >> 20} MiB")
    with store.working() as folder:
        model = folder / "model.glb"
        model.write_bytes(character.model_glb)
        write_character(character, checked_beside(model))
        store.keep(name, model)


def _view(name: str, character: Character, clip: str, report: Retargeted) -> NewClipView:
    return NewClipView(
        character=name,
        clip=clip,
        duration=float(character.clips[clip].duration),
        root=report.root,
        bones={bone: JointPair(source=ours, target=theirs) for bone, (ours, theirs) in report.bones.items()},
        missing=list(report.missing),
        unmapped_source=list(report.unmapped_source),
        unmapped_target=list(report.unmapped_target),
        scale=float(report.scale),
        notes=list(report.notes),
    )
