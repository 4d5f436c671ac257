"""The grammar of .x texts: objects, names, references, templates; errors with the line."""

import re

import pytest
from statwalk.errors import TextError
from statwalk.files.directx.x_objects import DEEPEST, read_objects
from statwalk.files.directx.x_text import text_after_header

HEADER = b"xof 0303txt 0032\n"


def objects(text: str):
    return read_objects(text_after_header(HEADER + text.encode(), []))


def test_objects_have_kind_name_numbers_strings_and_parts_in_order() -> None:
    (frame,) = objects('Frame Arm {\n 1;2,\n 3; Mesh { 4; } {Hand} "a }"; 5;; }').parts
    assert (frame.kind, frame.name, frame.line) == ("frame", "Arm", 2)
    assert [(part.kind, part.name) for part in frame.parts] == [("mesh", ""), ("", "Hand")]
    assert frame.strings == ["a }"]
    assert [word for _, text in frame.pieces for word in re.findall(r"\d", text)] == ["1", "2", "3", "5"]


@pytest.mark.parametrize(
    "text",
    [
        "Frame A{}",
        "// }\nFrame A { # {\n}",
        "Frame A { <3D82AB46-62DA-11CF-AB39-0020AF71E433> }",
        "template T { <F6F23F41-7686-11CF-8F52-0040333594A3> array FLOAT m[16]; [...] } Frame A { }",
        "template Frame { Frame }\r\nFrame A\r\n{\r\n}\r\n",
        "Header { 1; 0; 1; }\nFrame A { }",
    ],
)
def test_templates_comments_and_guids_are_skipped(text: str) -> None:
    (frame,) = objects(text).of_kind("frame")
    assert (frame.name, frame.pieces, frame.parts) == ("A", [], [])


def test_a_reference_may_follow_a_number_and_have_a_guid() -> None:
    (part,) = objects("MeshMaterialList { 1; 2; 0, 0 {Skin <3D82AB4D-62DA-11CF-AB39-0020AF71E433>} }").parts
    assert [(inner.kind, inner.name) for inner in part.parts] == [("", "Skin")]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Frame A {\n Mesh {\n }\n", "line 2: the file ends before this frame A is closed"),
        ("\n}", "line 3: this } closes no object"),
        ("Frame A { }\n7;", "line 3: '7;' stands outside any object"),
        ("Frame A {\n{ Frame B { } }\n}", "line 3: { cannot stand inside a reference"),
        ("Frame A {\n{ }\n}", "line 3: a reference holds the name of an object"),
        ("Frame A {\n? ! {\n}}", "line 3: before { stand the kind of an object and its name, not '? !'"),
        (f"Frame {'a' * 300} {{ }}", "line 2: before {"),
        ("Frame A {" * 5_000, f"nested deeper than {DEEPEST}"),
        ("Frame A { } " * 300_001, "line 2: the file has more than 300000 objects and texts"),
        ('"a"' * 300_001, "line 2: the file has more than 300000 objects and texts"),
    ],
)
def test_what_does_not_fit_is_refused_with_its_line(text: str, said: str) -> None:
    with pytest.raises(TextError, match=re.escape(said)):
        objects(text)


@pytest.mark.timeout(20)
@pytest.mark.parametrize(
    "text", ["<" + " " * 300_000, "< " * 300_000, "<a" * 300_000], ids=["one", "many", "letters"]
)
def test_guids_without_an_end_take_no_time(text: str) -> None:
    with pytest.raises(TextError, match=r"before \{ stand the kind"):
        objects(f"{text} {{")
