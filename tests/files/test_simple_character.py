"""The figure of a machine that is made from nothing."""

from statwalk.files.gltf.read import read_model
from statwalk.files.simple_character import simple_character


def test_it_stands_on_the_ground_as_its_file_says() -> None:
    character = read_model(simple_character().model_glb, "simple")
    heights = [part.positions[:, 1] for part in character.vertices(character.bind_pose)]
    assert abs(min(height.min() for height in heights)) < 1e-6
    assert 1.7 < max(height.max() for height in heights) < 1.9
