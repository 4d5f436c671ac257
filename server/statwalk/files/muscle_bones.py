"""Reads `muscle_bones` of a character file (DS6): the joints that only deform the skin.

muscle_bones: [biceps, triceps]
"""

from __future__ import annotations

from statwalk.errors import ContentError, StatwalkError
from statwalk.files.yaml.yaml_text import Node
from statwalk.rig.skeleton import Skeleton


def muscle_bones(node: Node | None, skeleton: Skeleton) -> Skeleton:
    """Returns the skeleton with the muscle bones that `node` lists; without a node it stays as it is.

    :raises ContentError: when a joint does not exist, or another joint hangs on a muscle bone; with the line.
    """
    if node is None:
        return skeleton
    names = [item.text() for item in node.items()]
    try:
        return skeleton.with_muscle_bones(names)
    except StatwalkError as error:
        raise node.refuse(error.message if isinstance(error, ContentError) else str(error)) from None
