"""The IKchain objects of a .x file: inverse kinematics chains as the second source proposes them (RTCA 3.2,
Listing 8).

    IKchain MyIK {
        {Object_Root}
        {Object_Child}
    }
"""

from __future__ import annotations

from collections.abc import Mapping

from statwalk.character.chain_of_names import chain_joints
from statwalk.errors import StatwalkError
from statwalk.files.directx.x_objects import REFERENCE, DataObject
from statwalk.files.gltf.names import unique
from statwalk.rig.skeleton import Skeleton

IK_CHAIN = "ikchain"
MOST_CHAINS = 1_000


def read_chains(
    file: DataObject, row_of: Mapping[str, int], skeleton: Skeleton, notes: list[str]
) -> dict[str, tuple[str, ...]]:
    """Returns the joints of each chain, from its start to its end; a chain whose frames are no chain is left
    out, with a note.
    """
    chains: dict[str, tuple[str, ...]] = {}
    parts = list(file.of_kind(IK_CHAIN))[:MOST_CHAINS]
    for name, part in zip(unique([part.name for part in parts], "chain"), parts, strict=True):
        names = [inner.name for inner in part.parts if inner.kind == REFERENCE]
        try:
            joints = tuple(
                skeleton.names[row_of.get(frame, -1)] if frame in row_of else frame for frame in names
            )
            chain_joints(skeleton, joints, "ccd")
        except StatwalkError as error:
            notes.append(f"the IKchain {name[:60]!r} is left out: {error}"[:300])
        else:
            chains[name] = joints
    return chains
