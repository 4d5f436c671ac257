"""The muscles and expressions of machines/face, for the walker: the same head, on his neck."""

from dataclasses import replace
from pathlib import Path

from statwalk.errors import ContentError
from statwalk.files.face_yaml import read_faces, read_muscles
from statwalk.files.gltf.carried import with_carried
from statwalk.files.gltf.read import read_model
from statwalk.files.with_face import with_faces, with_muscles
from statwalk.files.yaml.yaml_text import parse
from statwalk.skin.face_muscles import Muscle

FACE = Path(__file__).resolve().parents[2] / "face" / "face.yaml"
HIGHER = 1.36
"""metres from the place of the head in machines/face to its place on the walker"""


def with_the_face(path: Path) -> None:
    """Gives the model in a file the muscles; its extras say what they are."""
    entries = parse(FACE.read_text(), FACE.name, ContentError).entries()
    muscles = {name: _raised(muscle) for name, muscle in read_muscles(entries["muscles"]).items()}
    walker = with_muscles(read_model(path.read_bytes(), path.stem), muscles)
    whole = with_faces(walker, read_faces(entries["faces"], muscles))
    path.write_bytes(with_carried(whole).model_glb)


def _raised(muscle: Muscle) -> Muscle:
    return replace(muscle, to=tuple((x, y + HIGHER, z) for x, y, z in muscle.to))
