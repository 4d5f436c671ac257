"""A character from the FAQ's text, as a user writes it: files in a folder, loaded."""

from pathlib import Path

import numpy as np
from statwalk.character.character import Character
from statwalk.files.character_yaml import load_character
from statwalk.maths.pose import Pose


def from_text(folder: Path, skeleton: str, scale: float = 1.0, **clips: tuple[str, str]) -> Character:
    """The character of a skeleton table (or a shipped skeleton's name) and clips given as name=(key frames,
    what else the file says).
    """
    lines = [f"scale: {scale}", "clips:" if clips else ""]
    for name, (keys, more) in clips.items():
        (folder / f"{name}.txt").write_text(keys)
        lines.append(f"  {name}: {{keys: {name}.txt, {more}}}")
    if "\n" in skeleton:
        (folder / "skeleton.txt").write_text(skeleton)
        skeleton = "skeleton.txt"
    (folder / "character.yaml").write_text("\n".join([f"skeleton: {skeleton}", *lines]))
    return load_character(folder / "character.yaml")


def keyed(times: list[float], command: str, bone: str, values: np.ndarray) -> str:
    """Key-frame text: one key of one bone at each time."""
    return "\n".join(
        f"#time {t}\n{command} {bone} {' '.join(map(repr, map(float, v)))}"
        for t, v in zip(times, values, strict=True)
    )


def place(character: Character, pose: Pose, joint: str) -> np.ndarray:
    """Where a joint is, (3,)."""
    return character.world(pose)[character.skeleton.index(joint), :3, 3]
