"""Where joints are in a clip, and which way bones point, for tests of captured motion."""

import numpy as np
from statwalk.character.character import Character
from statwalk.motion.clip import Clip
from statwalk.rig.evaluate import world_from_local


def places(character: Character, clip: Clip, times: np.ndarray) -> dict[str, np.ndarray]:
    world = world_from_local(character.skeleton, clip.sample(times))[..., 3].astype(np.float64)
    return {name: world[:, row] for row, name in enumerate(character.skeleton.names)}


def directions(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    way = end - start
    return way / np.linalg.norm(way, axis=-1, keepdims=True)
