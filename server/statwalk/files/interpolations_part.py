"""The `interpolation` of a clip in a character file: one for all, or by property and by bone.

interpolation: slerp
interpolation: {rotation: nurbs, translation: linear}
interpolation: {rotation: squad, bones: {Tail: nurbs, Hand: {rotation: b-spline, translation: hold}}}
"""

from __future__ import annotations

from collections.abc import Sequence

from statwalk.files.faq.key_frame_clip import ByPath, Interpolations
from statwalk.files.yaml.yaml_node import Node
from statwalk.motion.keys.channel_table import PATHS
from statwalk.motion.keys.interpolations import INTERPOLATIONS

DEFAULT = "slerp"


def read_interpolations(node: Node | None, bones: Sequence[str]) -> Interpolations:
    """Reads how the keys of each property of each of the skeleton's `bones` are interpolated.

    :raises ContentError: when an interpolation, a property or a bone does not exist.
    """
    everywhere = dict.fromkeys(PATHS, DEFAULT)
    if node is None:
        return Interpolations(everywhere)
    if not node.is_mapping:
        return Interpolations(_by_path(node))
    entries = node.entries(*PATHS, "bones")
    found = {path: _name(entries[path]) for path in PATHS if path in entries}
    own = entries["bones"].entries() if "bones" in entries else {}
    for bone in own:
        if bone not in bones:
            raise entries["bones"].unknown("bone", bone, bones, entries["bones"].key_lines[bone])
    return Interpolations(everywhere | found, {bone: _by_path(value) for bone, value in own.items()})


def _by_path(node: Node) -> ByPath:
    """One name for all properties, or a name for some of them."""
    if not node.is_mapping:
        return dict.fromkeys(PATHS, _name(node))
    return {path: _name(value) for path in PATHS if (value := node.entries(*PATHS).get(path)) is not None}


def _name(node: Node) -> str:
    if node.text() not in INTERPOLATIONS:
        raise node.unknown("interpolation", node.text(), INTERPOLATIONS)
    return node.text()
