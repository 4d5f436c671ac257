"""Builds: what makes one figure differ from another. The bones are the same."""

from dataclasses import dataclass

Rows = tuple[tuple[float, float, float, float, float], ...]
"""height, half width, front, back, axis to the front (metres)"""


@dataclass(frozen=True)
class Build:
    """A body and its clothes; lengths in metres."""

    name: str
    chest: Rows
    """the shirt, from its hem to the neck"""
    hips: Rows
    """the trousers, from the crotch to the waist"""
    slope: float
    """height of the shoulders' slope beside the neck"""
    arm: float
    """thickness of the arms, 1 for the walker's"""
    leg: float
    hand: float
    neck: float
    """radius"""
    seat: tuple[float, float, float]
    """radii of a buttock"""
    hem: float
    """height of the shirt's hem"""
    tucked: bool
    """whether a belt holds the shirt"""
    neckline: float
    """how deep the collar is in front"""
    sleeve: float
    """where the sleeves end, from the shoulder"""
    sleeve_loose: float
    ankle: float
    """height of the trousers' hem over the ground"""
    trouser_loose: float
    jaw: float
    """width of the jaw, 1 for the walker's"""
    nose: float
    lips: float
    eye: float
    brow: float
    hair: str
    boots: bool
    colours: dict[str, str]


WALKER = Build(
    name="walker",
    chest=(
        (0.880, 0.172, 0.106, 0.122, -0.005),
        (0.930, 0.169, 0.106, 0.120, -0.006),
        (0.980, 0.164, 0.105, 0.114, -0.002),
        (1.040, 0.159, 0.104, 0.104, 0.003),
        (1.110, 0.156, 0.104, 0.098, 0.005),
        (1.190, 0.157, 0.107, 0.098, 0.004),
        (1.270, 0.163, 0.111, 0.102, 0.001),
        (1.340, 0.168, 0.110, 0.108, -0.005),
        (1.395, 0.160, 0.094, 0.102, -0.010),
        (1.435, 0.124, 0.068, 0.082, -0.016),
        (1.470, 0.070, 0.050, 0.060, -0.018),
    ),
    hips=(
        (0.822, 0.095, 0.068, 0.080, -0.006),
        (0.885, 0.128, 0.082, 0.094, -0.006),
        (0.930, 0.146, 0.090, 0.106, -0.008),
        (0.980, 0.146, 0.093, 0.102, -0.004),
        (1.040, 0.139, 0.092, 0.090, 0.003),
    ),
    slope=1.470,
    arm=1.0,
    leg=1.0,
    hand=1.0,
    neck=0.050,
    seat=(0.076, 0.082, 0.062),
    hem=0.935,
    tucked=False,
    neckline=0.050,
    sleeve=0.205,
    sleeve_loose=0.010,
    ankle=0.098,
    trouser_loose=0.010,
    jaw=1.0,
    nose=1.0,
    lips=1.0,
    eye=1.0,
    brow=1.0,
    hair="quiff",
    boots=False,
    colours={
        "skin": "#e0a880",
        "lips": "#c27a66",
        "lids": "#c98f6c",
        "lash": "#3a2620",
        "brow": "#4a2f20",
        "hair": "#5a3824",
        "white": "#f2efe9",
        "iris": "#3f7fae",
        "rim": "#24506f",
        "pupil": "#15161a",
        "glint": "#ffffff",
        "mouth": "#5c2422",
        "shirt": "#ee6a35",
        "stripe": "#fbeada",
        "band": "#c94f20",
        "trousers": "#41618f",
        "seam": "#334e78",
        "belt": "#6e4a30",
        "buckle": "#c9b27a",
        "shoes": "#dcd8d0",
        "laces": "#f4f1ea",
        "trim": "#d9572a",
        "sock": "#f4f1ea",
        "soles": "#a39b8e",
    },
)
STROLLER = Build(
    name="stroller",
    chest=(
        (0.880, 0.138, 0.085, 0.100, -0.004),
        (0.940, 0.138, 0.090, 0.104, -0.004),
        (1.000, 0.129, 0.090, 0.094, 0.000),
        (1.060, 0.120, 0.089, 0.085, 0.004),
        (1.120, 0.118, 0.090, 0.080, 0.006),
        (1.190, 0.125, 0.098, 0.083, 0.006),
        (1.270, 0.138, 0.119, 0.090, 0.004),
        (1.320, 0.144, 0.119, 0.095, 0.000),
        (1.370, 0.145, 0.099, 0.095, -0.006),
        (1.400, 0.140, 0.083, 0.091, -0.010),
        (1.435, 0.110, 0.060, 0.075, -0.016),
        (1.470, 0.062, 0.046, 0.055, -0.018),
    ),
    hips=(
        (0.822, 0.098, 0.066, 0.083, -0.006),
        (0.885, 0.138, 0.080, 0.102, -0.006),
        (0.930, 0.152, 0.087, 0.112, -0.008),
        (0.980, 0.143, 0.088, 0.101, -0.004),
        (1.040, 0.126, 0.087, 0.086, 0.003),
    ),
    slope=1.462,
    arm=0.84,
    leg=0.98,
    hand=0.90,
    neck=0.043,
    seat=(0.082, 0.084, 0.068),
    hem=0.965,
    tucked=True,
    neckline=0.030,
    sleeve=0.525,
    sleeve_loose=0.009,
    ankle=0.165,
    trouser_loose=0.004,
    jaw=0.86,
    nose=0.84,
    lips=1.3,
    eye=1.0,
    brow=0.8,
    hair="bun",
    boots=True,
    colours={
        "skin": "#a8734e",
        "lips": "#9c4a44",
        "lids": "#8d5c3f",
        "lash": "#241612",
        "brow": "#33221c",
        "hair": "#43302c",
        "white": "#f2efe9",
        "iris": "#7a4f2a",
        "rim": "#44290f",
        "pupil": "#131214",
        "glint": "#ffffff",
        "mouth": "#4f1f1f",
        "shirt": "#2f9d92",
        "band": "#237a72",
        "trousers": "#d8a64a",
        "seam": "#b88936",
        "belt": "#70432b",
        "buckle": "#d8c48a",
        "shoes": "#8b5136",
        "trim": "#6f3f2a",
        "laces": "#f4f1ea",
        "sock": "#d8a64a",
        "soles": "#5f544b",
    },
)
BUILDS = {build.name: build for build in (WALKER, STROLLER)}
