"""Which points of the body the markers of the usual sets show."""

import pytest
from statwalk.character.marker_names import points_of

SETS = {
    "Plug-in Gait": {
        "Head": "LFHD RFHD LBHD RBHD",
        "Neck": "C7 CLAV STRN",
        "LeftUpperArm": "LSHO",
        "LeftLowerArm": "LELB",
        "LeftHand": "LWRA LWRB",
        "LeftHandEnd": "LFIN",
        "Pelvis": "LASI RASI LPSI RPSI",
        "LeftLowerLeg": "LKNE",
        "LeftFoot": "LANK",
        "RightToes": "RTOE",
        "": "T10 RBAK LUPA LFRM LTHI LTIB LHEE",
    },
    "Helen Hayes": {
        "Head": "Top.Head Front.Head Rear.Head",
        "RightUpperArm": "R.Shoulder",
        "RightLowerArm": "R.Elbow",
        "RightHand": "R.Wrist",
        "Pelvis": "R.ASIS L.ASIS V.Sacral",
        "RightLowerLeg": "R.Knee.Lat R.Knee.Med",
        "RightFoot": "R.Ankle.Lat R.Ankle.Med",
        "RightToes": "R.Toe",
        "": "R.Thigh R.Shank R.Heel",
    },
    "OpenSim": {
        "Neck": "Sternum",
        "RightUpperArm": "R.Acromium",
        "RightLowerLeg": "R.Knee.Lat",
        "RightToes": "R.Toe.Tip R.Toe.Lat",
        "RightLowerArm": "R.Elbow",
        "": "R.Forearm R.Bicep R.Thigh.Upper R.Thigh.Front R.Shank.Rear R.Midfoot.Sup",
    },
    "OpenSim, Rajagopal": {
        "LeftUpperArm": "LACR",
        "LeftLowerArm": "LLEL LMEL",
        "LeftHand": "LFAradius LFAulna",
        "LeftLowerLeg": "LLFC LMFC",
        "LeftFoot": "LLMAL LMMAL",
        "LeftToes": "LTOE LMT5",
        "": "LTH1 LTB2 LCAL",
    },
    "OpenCap": {
        "LeftUpperArm": "L_Shoulder",
        "RightLowerLeg": "r_knee r_mknee",
        "RightFoot": "r_ankle r_mankle",
        "RightToes": "r_toe r_5meta",
        "LeftHand": "L_lwrist L_mwrist",
        "Pelvis": "r.ASIS L.PSIS",
        "": "r_thigh1 r_sh1 r_calc",
    },
    "Human Body Model": {
        "LeftLowerLeg": "LLEK LMEK",
        "LeftFoot": "LLM LMM",
        "LeftLowerArm": "LLEE LMEE",
        "LeftHand": "LLW LMW",
        "Head": "THEAD LHEAD",
        "": "LGTRO XYPH",
    },
    "CMU": {"Pelvis": "LFWT RFWT LBWT RBWT", "Head": "ARIEL", "LeftFoot": "LANK", "": "LSHN RBAC"},
    "CAST": {
        "Pelvis": "L_IAS R_IAS L_IPS",
        "LeftLowerLeg": "L_FLE L_FME",
        "LeftFoot": "L_FAL L_TAM",
        "LeftToes": "L_FM1 L_FM5",
        "LeftUpperArm": "L_SAE",
        "LeftLowerArm": "L_HLE L_HME",
        "LeftHand": "L_RSP L_USP",
        "Neck": "CV7 SJN",
        "": "L_FTC L_FCC TV10",
    },
    "Qualisys, OptiTrack": {
        "Head": "HeadL HeadTop Q_HeadR HeadFront",
        "Neck": "SpineTop",
        "LeftUpperArm": "LShoulderTop LShoulderBack",
        "LeftLowerArm": "LElbowOut LElbowIn",
        "LeftHand": "LWristOut LWristIn LHandOut",
        "Pelvis": "WaistLFront WaistRFront WaistL WaistLBack WaistBack Q_WaistRBack",
        "LeftLowerLeg": "LKneeOut LKneeIn",
        "LeftFoot": "LAnkleOut",
        "LeftToes": "LForefootOut LForefoot2 LToeTip",
        "": "LArm LThigh LThighFrontLow LShin LHeelBack SpineThoracic2",
    },
    "joint centres": {
        "Pelvis": "CHip",
        "RightUpperLeg": "RHip",
        "RightLowerLeg": "RKnee",
        "RightToes": "RBigToe RSmallToe",
        "Head": "Nose Head",
        "LeftLowerArm": "left_elbow",
        "LeftFoot": "left_ankle",
        "": "RHeel left_eye",
    },
    "a skeleton": {
        "Pelvis": "Hips",
        "LeftUpperLeg": "LeftThigh",
        "LeftLowerLeg": "LeftLeg",
        "LeftFoot": "LeftFoot",
        "LeftUpperArm": "LeftArm",
        "LeftLowerArm": "LeftForeArm",
        "": "LeftShoulder Spine",
    },
}


@pytest.mark.parametrize("name", SETS)
def test_the_points_of_a_marker_set(name: str) -> None:
    wanted = {marker: point or None for point, markers in SETS[name].items() for marker in markers.split()}
    assert dict(zip(wanted, points_of(list(wanted)), strict=True)) == wanted


def test_a_prefix_of_the_subject_is_left_out() -> None:
    assert points_of(["Anna:LKNE", "Anna:C7"]) == ["LeftLowerLeg", "Neck"]
