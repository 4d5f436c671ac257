import khronos
from statwalk.files.gltf import read_model
from statwalk.files.gltf.write_files import write_glb, write_gltf, write_zip
from tiny_model import model


def test_a_model_is_written_as_it_came() -> None:
    assert write_glb(read_model(model(), "tiny")) == model()


def test_a_gltf_stands_alone_and_the_validator_finds_no_more_than_in_the_source() -> None:
    source = read_model(model(), "tiny")
    data = write_gltf(source)
    back = read_model(data, "tiny")
    assert back.skeleton.names == source.skeleton.names
    assert list(back.clips) == list(source.clips)
    assert khronos.errors(data) == khronos.errors(model())


def test_the_same_character_is_the_same_zip() -> None:
    source = read_model(model(), "tiny")
    assert write_zip(source) == write_zip(source)
