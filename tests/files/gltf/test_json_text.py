"""Whole numbers with a point, and deeply nested extras: both are legal JSON of glTF."""

import json

import orjson
import pytest
import tiny_model
from statwalk.errors import ModelError
from statwalk.files.gltf import container, json_text, read_model
from statwalk.files.gltf.add_clip import model_with_clip
from statwalk.files.gltf.template import FrameTemplate

DEEP = {"list": ("[", "]"), "object": ('{"a":', "}")}


def with_points(value):
    """The JSON value with a point in every integer."""
    if isinstance(value, dict):
        return {key: with_points(member) for key, member in value.items()}
    if isinstance(value, list):
        return [with_points(member) for member in value]
    return float(value) if type(value) is int else value


def nested(kind, depth):
    opening, closing = DEEP[kind]
    return opening * depth + "1" + closing * depth


def with_extras(place, kind, depth=900):
    """The model with deep extras in its root, or in its material."""
    root, binary = tiny_model.document()
    root["materials"] = [{"name": "skin"}]
    entry = root if place == "root" else root[place][0]
    entry["extras"] = "DEEP"
    text = json.dumps(root).replace('"DEEP"', nested(kind, depth)).encode()
    return container.join(text, bytes(binary)), text


def test_integers_may_have_a_point():
    root, binary = tiny_model.document()
    plain, pointed = (
        read_model(tiny_model.glb(document, binary), "tiny") for document in (root, with_points(root))
    )
    assert pointed.skeleton.names == plain.skeleton.names
    assert (pointed.vertices(pointed.bind_pose)[0].positions == plain.parts[0].positions).any()
    assert list(pointed.clips) == list(plain.clips)
    assert orjson.loads(container.split(pointed.model_glb)[0]) == json.loads(json.dumps(root))


def test_fractions_are_no_integers():
    with pytest.raises(ModelError) as caught:
        read_model(tiny_model.changed("/accessors/0/count", 3.5), "tiny")
    assert caught.value.place == "/accessors/0/count"


def test_numbers_of_extras_stay_as_they_are():
    root = {"extras": {"weight": 2.0}, "count": 2.0, "list": [3.0, 1e300, 0.5], "min": [1.0]}
    assert json_text.make_whole(root)
    assert json.dumps(root) == json.dumps(
        {"extras": {"weight": 2.0}, "count": 2, "list": [3, 1e300, 0.5], "min": [1.0]}
    )


@pytest.mark.parametrize("kind", DEEP)
def test_deep_values_are_written_as_they_were_read(kind):
    text = ('{"a":[1,"b",{},[],null,true,' + nested(kind, 900) + ',{"c":-2.5}]}').encode()
    assert json_text.dumps(orjson.loads(text)) == text


@pytest.mark.parametrize("kind", DEEP)
@pytest.mark.parametrize("place", ["root", "nodes", "materials"])
def test_deep_extras_pass(place, kind):
    data, text = with_extras(place, kind)
    character = read_model(data, "deep")
    assert bytes(container.split(character.model_glb)[0]).rstrip() == text
    assert FrameTemplate([(character, 1)], images=True).layout_text
    added = model_with_clip(character, character.clip("Bend"))
    assert nested(kind, 900).encode() in bytes(container.split(added)[0])
