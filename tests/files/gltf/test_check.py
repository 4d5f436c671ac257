"""One thing wrong in a model that is right otherwise: refused, at the place where it is wrong."""

import pytest
from statwalk.errors import ModelError
from statwalk.files.gltf import read_model
from tiny_model import changed, document, glb

SAMPLER, CHANNEL, PRIMITIVE = "/animations/0/samplers/0", "/animations/0/channels/0", "/meshes/0/primitives/0"
WRONG = [
    ("/asset/version", "1.0", "/asset/version"),
    ("/asset", None, "/asset"),
    ("/nodes/0", None, "/scenes/0/nodes/1"),
    ("/nodes/0", 7, "/nodes/0"),
    ("/nodes", {}, "/nodes"),
    ("/nodes/0/children/0", 0, "/nodes/0/children"),
    ("/nodes/0/children/0", -1, "/nodes/0/children/0"),
    ("/nodes/0/children/0", True, "/nodes/0/children/0"),
    ("/nodes/2/children", [1], "/nodes/2/children/0"),
    ("/nodes/2/mesh", 9999, "/nodes/2/mesh"),
    ("/nodes/2/skin", 1, "/nodes/2/skin"),
    ("/nodes/1/translation", [0, 1], "/nodes/1/translation"),
    ("/nodes/1/translation", [0, 1e300, 0], "/nodes/1/translation"),
    ("/nodes/1/matrix", [1] * 12, "/nodes/1/matrix"),
    ("/scene", 3, "/scene"),
    ("/scenes/0/nodes", [1], "/scenes/0/nodes/0"),
    ("/skins/0/joints", [], "/skins/0/joints"),
    ("/skins/0/joints", [0, 77], "/skins/0/joints/1"),
    ("/skins/0/joints", [0, 1, 2], "/skins/0/inverseBindMatrices"),
    ("/skins/0/joints", [0], f"{PRIMITIVE}/attributes/JOINTS_0"),
    ("/skins/0/inverseBindMatrices", 0, "/skins/0/inverseBindMatrices"),
    ("/meshes/0/primitives", [], "/meshes/0/primitives"),
    ("/meshes/0/weights", [1, 2], "/meshes/0/weights"),
    (f"{PRIMITIVE}/indices", -1, f"{PRIMITIVE}/indices"),
    (f"{PRIMITIVE}/mode", 9, f"{PRIMITIVE}/mode"),
    (f"{PRIMITIVE}/attributes/WEIGHTS_0", None, f"{PRIMITIVE}/attributes/WEIGHTS_0"),
    (f"{PRIMITIVE}/attributes/WEIGHTS_0", 0, f"{PRIMITIVE}/attributes/WEIGHTS_0"),
    (f"{PRIMITIVE}/targets/0/POSITION", -1, f"{PRIMITIVE}/targets/0/POSITION"),
    ("/accessors/1/count", 2, f"{PRIMITIVE}/attributes/NORMAL"),
    ("/accessors/0/count", 4, "/accessors/0"),
    ("/accessors/0/count", 3.5, "/accessors/0/count"),
    ("/accessors/0/count", "3", "/accessors/0/count"),
    ("/accessors/0/count", -3, "/accessors/0/count"),
    ("/accessors/0/byteOffset", 4, "/accessors/0"),
    ("/accessors/0/componentType", 5124, f"{PRIMITIVE}/attributes/POSITION"),
    ("/accessors/0/type", "VEC5", f"{PRIMITIVE}/attributes/POSITION"),
    ("/accessors/0/type", ["VEC3"], f"{PRIMITIVE}/attributes/POSITION"),
    ("/accessors/0/bufferView", 99, "/accessors/0/bufferView"),
    ("/accessors/8/count", 1, f"{SAMPLER}/output"),
    ("/bufferViews/0/byteStride", 8, "/accessors/0/bufferView"),
    ("/bufferViews/0/byteOffset", -16, "/bufferViews/0/byteOffset"),
    ("/bufferViews/0/byteLength", 1 << 40, "/bufferViews/0/byteLength"),
    ("/bufferViews/0/buffer", 2, "/bufferViews/0/buffer"),
    ("/buffers/0/byteLength", 1 << 53, "/buffers/0/byteLength"),
    (f"{SAMPLER}/input", 8, f"{SAMPLER}/input"),
    (f"{SAMPLER}/output", 0, f"{SAMPLER}/output"),
    (f"{SAMPLER}/interpolation", "CUBICSPLINE", f"{SAMPLER}/output"),
    (f"{SAMPLER}/interpolation", "BEZIER", f"{SAMPLER}/interpolation"),
    (f"{CHANNEL}/sampler", 1, f"{CHANNEL}/sampler"),
    (f"{CHANNEL}/target/node", -1, f"{CHANNEL}/target/node"),
    (f"{CHANNEL}/target", None, f"{CHANNEL}/target"),
    ("/animations/0/channels", [], "/animations/0/channels"),
    ("/animations/0/channels", None, "/animations/0/channels"),
    ("/animations/0/samplers", [], "/animations/0/samplers"),
    ("/extensionsRequired", ["XX_none"], "/extensionsRequired/0"),
]


@pytest.mark.parametrize(("pointer", "value", "place"), WRONG)
def test_what_is_wrong_is_refused_where_it_is(pointer, value, place):
    with pytest.raises(ModelError) as caught:
        read_model(changed(pointer, value), "tiny")
    assert caught.value.place == place


NO_JSON = [
    b"[]",
    b"{",
    b'{"a":NaN}',
    b'{"a":1e999}',
    b'{"a":"\xe9"}',
    b'{"a":' + b"[" * 100_000 + b"]" * 100_000 + b"}",
]


@pytest.mark.parametrize("text", NO_JSON, ids=["list", "cut", "NaN", "infinite", "Latin-1", "deep"])
def test_what_is_no_json_is_refused(text):
    with pytest.raises(ModelError):
        read_model(text, "tiny")


def with_accessor(accessor: dict) -> bytes:
    root, binary = document()
    root["accessors"].append(accessor)
    return glb(root, binary)


@pytest.mark.parametrize("count", [2_000_000_000, 10**18])
def test_zeros_without_a_buffer_count_before_they_take_memory(count):
    with pytest.raises(ModelError, match="bytes"):
        read_model(with_accessor({"componentType": 5126, "count": count, "type": "VEC3"}), "bomb")


def test_many_accessors_together_have_a_limit():
    root, binary = document()
    root["accessors"] += [{"componentType": 5126, "count": 1 << 20, "type": "VEC4"}] * 20
    with pytest.raises(ModelError, match="allowed"):
        read_model(glb(root, binary), "bomb")


SPARSE = {"count": 2, "indices": {"bufferView": 6, "componentType": 5123}, "values": {"bufferView": 0}}


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"count": 1_000_000_000}, "/accessors/9/sparse/count"),
        ({"indices": {"bufferView": 6, "componentType": 5126}}, "/accessors/9/sparse/indices/componentType"),
        (
            {"indices": {"bufferView": 6, "componentType": 5123, "byteOffset": 4}},
            "/accessors/9/sparse/indices",
        ),
        ({"values": {"bufferView": 99}}, "/accessors/9/sparse/values/bufferView"),
    ],
)
def test_sparse_accessors_are_checked(change, place):
    with pytest.raises(ModelError) as caught:
        read_model(
            with_accessor({"componentType": 5126, "count": 3, "type": "VEC3", "sparse": SPARSE | change}),
            "tiny",
        )
    assert caught.value.place == place
