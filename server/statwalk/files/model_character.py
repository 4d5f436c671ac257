"""The model that a character file names in place of a skeleton, and the clips that the file makes of the
model's.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from statwalk.character.character import Character
from statwalk.character.made_clips import Refuse, with_clips
from statwalk.files import clip_changes, model_formats
from statwalk.files.gltf.add_clip import model_with_clip
from statwalk.files.yaml.yaml_text import Node

SUFFIXES = model_formats.MODEL_SUFFIXES
_ONLY_WITH_SKELETON = ("scale",)


def model_of(node: Node, path: Path, entries: Mapping[str, Node]) -> Character:
    """Returns the character of the model at `path`, which `node` names.

    :raises ContentError: when there is no such file, it is too large, or it is refused.
    """
    for key in _ONLY_WITH_SKELETON:
        if key in entries:
            raise entries[key].refuse(f"`{key}` is for characters with a skeleton; a model has its own size")
    if path.suffix.lower() not in SUFFIXES or not path.is_file():
        kinds = ", ".join(SUFFIXES[:-1])
        raise node.refuse(
            f"{node.text()[:80]!r} must name a {kinds} or {SUFFIXES[-1]} file in the folder of this file"
        )
    name = entries["name"].text() if "name" in entries else path.stem
    return replace(model_formats.format_of(path).load_file(path), name=name)


def with_made_clips(character: Character, entries: Mapping[str, Node], refuse: Refuse) -> Character:
    """Returns the character with the clips that the file makes of the model's; the model carries them too.

    :raises ContentError: when a clip is not made of another, or a change is impossible.
    """
    made = clip_changes.clips(_without_faces(entries.get("clips")))
    whole = with_clips(character, made, refuse)
    for name in made:
        whole = replace(whole, model_glb=model_with_clip(whole, whole.clips[name]))
    return replace(whole, made=frozenset())


def _without_faces(node: Node | None) -> Node | None:
    """The clips that key no faces."""
    if node is None or not node.is_mapping:
        return node
    kept = {name: clip for name, clip in node.entries().items() if "faces" not in clip.entries()}
    return replace(node, value=kept)
