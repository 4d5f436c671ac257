"""Which joint is which bone, by the names of the rigs that the issue of KF8 lists; worked out by hand."""

import pytest
from known_rigs import RIGS, skeleton_of
from statwalk.character.body_bones import SIDES, body_bones

ARM = ("UpperArm", "LowerArm", "Hand")
LEG = ("UpperLeg", "LowerLeg", "Foot")
BONES = ("Hips", "Head", *(side + bone for side in SIDES for bone in ARM + LEG))
EXPECTED = {
    "Mixamo": "mixamorig: Hips Head LeftArm LeftForeArm LeftHand LeftUpLeg LeftLeg LeftFoot",
    "VRM, VRoid": "J_Bip_ C_Hips C_Head L_UpperArm L_LowerArm L_Hand L_UpperLeg L_LowerLeg L_Foot",
    "VRM 1": "- hips head leftUpperArm leftLowerArm leftHand leftUpperLeg leftLowerLeg leftFoot",
    "Unreal 4": "- pelvis head upperarm_l lowerarm_l hand_l thigh_l calf_l foot_l",
    "Unreal 5": "- pelvis head upperarm_l lowerarm_l hand_l thigh_l calf_l foot_l",
    "Rigify metarig": "- spine spine.006 upper_arm.L forearm.L hand.L thigh.L shin.L foot.L",
    "Rigify": "DEF- spine spine.006 upper_arm.L forearm.L hand.L thigh.L shin.L foot.L",
    "Quaternius": "- Hips Head UpperArm.L LowerArm.L Palm.L UpperLeg.L LowerLeg.L Foot.L",
    "CMU, BVH": "- Hips Head LeftArm LeftForeArm LeftHand LeftUpLeg LeftLeg LeftFoot",
    "CMU, ASF": "- root head lhumerus lradius lwrist lfemur ltibia lfoot",
    "KayKit": "- hips head upperarm.l lowerarm.l wrist.l upperleg.l lowerleg.l foot.l",
}
RIGHT = {"Left": "Right", "left": "right", "L_": "R_", "_l": "_r", ".L": ".R", ".l": ".r"}


def right(name: str) -> str:
    """The same joint on the right."""
    other = next((name.replace(*pair) for pair in RIGHT.items() if pair[0] in name), "")
    return other or f"r{name[1:]}"


def found(rig: str) -> dict[str, str]:
    skeleton = skeleton_of(rig)
    return {bone: skeleton.names[joint] for bone, joint in body_bones(skeleton).items()}


@pytest.mark.parametrize("rig", RIGS)
def test_names_tell_hips_head_and_limbs(rig: str) -> None:
    prefix, *names = EXPECTED[rig].split()
    joints = [name if prefix == "-" else prefix + name for name in names]
    assert (
        found(rig).items()
        >= dict(zip(BONES, joints + [right(name) for name in joints[2:]], strict=True)).items()
    )


@pytest.mark.parametrize(
    ("rig", "bones"),
    [
        ("Rigify", {"Spine": "DEF-spine.001", "UpperChest": "DEF-spine.003", "Neck": "DEF-spine.004"}),
        ("CMU, ASF", {"Neck": "lowerneck", "LeftToes": "ltoes", "RightShoulder": "rclavicle"}),
        ("VRM 1", {"LeftThumb1": "leftThumbMetacarpal", "LeftThumb2": "leftThumbProximal"}),
        ("Unreal 5", {"LeftToes": "ball_l", "LeftShoulder": "clavicle_l", "LeftIndex1": "index_01_l"}),
        ("Mixamo", {"LeftToes": "mixamorig:LeftToeBase", "LeftThumb3": "mixamorig:LeftHandThumb3"}),
    ],
)
def test_names_tell_necks_toes_and_fingers(rig: str, bones: dict[str, str]) -> None:
    assert found(rig).items() >= bones.items()
