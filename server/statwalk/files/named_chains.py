"""Reads the chains that a file names for inverse kinematics (IK14): `{"leg": ["hip", "knee", "ankle"]}`."""

from __future__ import annotations

from statwalk.character.chain_of_names import chain_joints
from statwalk.errors import StatwalkError
from statwalk.files.yaml.yaml_text import Node
from statwalk.rig.skeleton import Skeleton

MOST_CHAINS = 1_024


def named_chains(node: Node | None, skeleton: Skeleton) -> dict[str, tuple[str, ...]]:
    """Returns the joints of each chain, from start to end; without a node there are none.

    :raises ContentError: when there are too many, or joints do not exist or form no chain; with the line.
    """
    entries = node.entries() if node else {}
    if node and len(entries) > MOST_CHAINS:
        raise node.refuse(f"at most {MOST_CHAINS} chains; there are {len(entries)}")
    chains = {name: tuple(joint.text() for joint in joints.items()) for name, joints in entries.items()}
    for name, joints in chains.items():
        try:
            chain_joints(skeleton, joints, "look-at")
        except StatwalkError as error:
            raise entries[name].refuse(str(error)) from None
    return chains
