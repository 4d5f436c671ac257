"""The joints of rigs whose names are known (some fingers and twists are left out): a joint a line, below its
parent by one space; `>` leads on to the only child.
"""

from collections.abc import Iterator

from statwalk.rig.skeleton import Skeleton

RIGS = {
    "Mixamo": """\
mixamorig:Hips
 mixamorig:Spine > mixamorig:Spine1 > mixamorig:Spine2
  mixamorig:Neck > mixamorig:Head > mixamorig:HeadTop_End
  mixamorig:LeftShoulder > mixamorig:LeftArm > mixamorig:LeftForeArm > mixamorig:LeftHand
   mixamorig:LeftHandThumb1 > mixamorig:LeftHandThumb2 > mixamorig:LeftHandThumb3 > mixamorig:LeftHandThumb4
   mixamorig:LeftHandIndex1 > mixamorig:LeftHandIndex2 > mixamorig:LeftHandIndex3
  mixamorig:RightShoulder > mixamorig:RightArm > mixamorig:RightForeArm > mixamorig:RightHand
 mixamorig:LeftUpLeg > mixamorig:LeftLeg > mixamorig:LeftFoot > mixamorig:LeftToeBase
 mixamorig:RightUpLeg > mixamorig:RightLeg > mixamorig:RightFoot > mixamorig:RightToeBase
""",
    "VRM, VRoid": """\
Root
 J_Bip_C_Hips
  J_Bip_C_Spine > J_Bip_C_Chest > J_Bip_C_UpperChest
   J_Bip_C_Neck > J_Bip_C_Head
   J_Bip_L_Shoulder > J_Bip_L_UpperArm > J_Bip_L_LowerArm > J_Bip_L_Hand
    J_Bip_L_Index1 > J_Bip_L_Index2 > J_Bip_L_Index3
    J_Bip_L_Thumb1 > J_Bip_L_Thumb2 > J_Bip_L_Thumb3
   J_Bip_R_Shoulder > J_Bip_R_UpperArm > J_Bip_R_LowerArm > J_Bip_R_Hand
   J_Sec_L_Bust1 > J_Sec_L_Bust2
  J_Bip_L_UpperLeg > J_Bip_L_LowerLeg > J_Bip_L_Foot > J_Bip_L_ToeBase
  J_Bip_R_UpperLeg > J_Bip_R_LowerLeg > J_Bip_R_Foot > J_Bip_R_ToeBase
""",
    "VRM 1": """\
hips
 spine > chest > upperChest
  neck > head
  leftShoulder > leftUpperArm > leftLowerArm > leftHand
   leftThumbMetacarpal > leftThumbProximal > leftThumbDistal
   leftIndexProximal > leftIndexIntermediate > leftIndexDistal
  rightShoulder > rightUpperArm > rightLowerArm > rightHand
 leftUpperLeg > leftLowerLeg > leftFoot > leftToes
 rightUpperLeg > rightLowerLeg > rightFoot > rightToes
""",
    "Unreal 4": """\
root
 pelvis
  spine_01 > spine_02 > spine_03
   clavicle_l > upperarm_l > lowerarm_l
    hand_l > index_01_l > index_02_l > index_03_l
    lowerarm_twist_01_l
   clavicle_r > upperarm_r > lowerarm_r > hand_r
   neck_01 > head
  thigh_l
   calf_l
    calf_twist_01_l
    foot_l > ball_l
   thigh_twist_01_l
  thigh_r > calf_r > foot_r > ball_r
 ik_foot_root > ik_foot_l
 ik_hand_root > ik_hand_gun > ik_hand_l
""",
    "Unreal 5": """\
root
 pelvis
  spine_01 > spine_02 > spine_03 > spine_04 > spine_05
   neck_01 > neck_02 > head
   clavicle_l > upperarm_l
    upperarm_twist_01_l
    upperarm_correctiveRoot_l
    lowerarm_l
     lowerarm_twist_02_l
     hand_l
      index_metacarpal_l > index_01_l > index_02_l > index_03_l
   clavicle_r > upperarm_r > lowerarm_r > hand_r
  thigh_l
   thigh_twist_01_l
   calf_l > foot_l > ball_l
  thigh_r > calf_r > foot_r > ball_r
 ik_foot_root > ik_foot_r
""",
    "Rigify metarig": """\
spine
 spine.001 > spine.002 > spine.003
  spine.004 > spine.005 > spine.006 > face
  shoulder.L > upper_arm.L > forearm.L > hand.L
   palm.01.L > f_index.01.L > f_index.02.L > f_index.03.L
   thumb.01.L > thumb.02.L > thumb.03.L
  shoulder.R > upper_arm.R > forearm.R > hand.R
  breast.L
 pelvis.L
 pelvis.R
 thigh.L > shin.L > foot.L
  toe.L
  heel.02.L
 thigh.R > shin.R > foot.R > toe.R
""",
    "Rigify": """\
DEF-spine
 DEF-spine.001 > DEF-spine.002 > DEF-spine.003
  DEF-spine.004 > DEF-spine.005 > DEF-spine.006
  DEF-shoulder.L > DEF-upper_arm.L > DEF-upper_arm.L.001 > DEF-forearm.L > DEF-forearm.L.001 > DEF-hand.L
   DEF-f_index.01.L > DEF-f_index.02.L > DEF-f_index.03.L
  DEF-shoulder.R > DEF-upper_arm.R > DEF-upper_arm.R.001 > DEF-forearm.R > DEF-forearm.R.001 > DEF-hand.R
 DEF-pelvis.L
 DEF-thigh.L > DEF-thigh.L.001 > DEF-shin.L > DEF-shin.L.001 > DEF-foot.L > DEF-toe.L
 DEF-thigh.R > DEF-thigh.R.001 > DEF-shin.R > DEF-shin.R.001 > DEF-foot.R > DEF-toe.R
""",
    "Quaternius": """\
Armature
 Root
  Foot.L
  Foot.R
  Body > Hips
   Abdomen > Torso
    Neck > Head
    Shoulder.L > UpperArm.L > LowerArm.L > Palm.L > Fist.L
    Shoulder.R > UpperArm.R > LowerArm.R > Palm.R
   UpperLeg.L > LowerLeg.L
   UpperLeg.R > LowerLeg.R
""",
    "CMU, BVH": """\
Hips
 LHipJoint > LeftUpLeg > LeftLeg > LeftFoot > LeftToeBase
 RHipJoint > RightUpLeg > RightLeg > RightFoot > RightToeBase
 LowerBack > Spine > Spine1
  Neck > Neck1 > Head
  LeftShoulder > LeftArm > LeftForeArm > LeftHand
   LeftFingerBase > LeftHandIndex1
   LThumb
  RightShoulder > RightArm > RightForeArm > RightHand
""",
    "CMU, ASF": """\
root
 lhipjoint > lfemur > ltibia > lfoot > ltoes
 rhipjoint > rfemur > rtibia > rfoot > rtoes
 lowerback > upperback > thorax
  lowerneck > upperneck > head
  lclavicle > lhumerus > lradius > lwrist > lhand > lfingers
  rclavicle > rhumerus > rradius > rwrist > rhand > rfingers
""",
    "KayKit": """\
Rig
 root
  hips
   spine > chest
    upperarm.l > lowerarm.l > wrist.l > hand.l > handslot.l
    upperarm.r > lowerarm.r > wrist.r > hand.r > handslot.r
    head
   upperleg.l > lowerleg.l > foot.l > toes.l
   upperleg.r > lowerleg.r > foot.r > toes.r
  kneeIK.l
  control-toe-roll.l > control-heel-roll.l > control-foot-roll.l > heelIK.l
  IK-foot.l > IK-toe.l
""",
}


def skeleton_of(rig: str) -> Skeleton:
    """The skeleton of one of the RIGS."""
    rows = list(_rows(RIGS[rig]))
    return Skeleton.sorted([name for name, _ in rows], [parent for _, parent in rows])[0]


def _rows(text: str) -> Iterator[tuple[str, str | None]]:
    path: list[tuple[int, str]] = []
    for line in text.rstrip().split("\n"):
        depth = len(line) - len(line.lstrip())
        path = [above for above in path if above[0] < depth]
        for name in line.strip().split(" > "):
            yield name, path[-1][1] if path else None
            path.append((depth, name))
