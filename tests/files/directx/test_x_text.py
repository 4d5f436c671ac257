"""The header of .x files, and their comments."""

import pytest
from statwalk.errors import TextError
from statwalk.files.directx.x_text import text_after_header


@pytest.mark.parametrize(
    ("header", "said"),
    [
        (
            b"xof 0303bin 0032",
            "line 1: this .x file is binary; statwalk reads .x files in text form: save it",
        ),
        (b"xof 0302tzip0032", "compressed"),
        (b"xof 0303bzip0064", "compressed binary"),
        (b"xof 0304txt 0032", "not 'xof 0304txt 0032'"),
        (b"xof 0303txt 0016", "should read xof 0303txt 0032"),
        (b"xof", "begins with a header"),
        (b"solid cube facet normal", "begins with a header"),
    ],
)
def test_other_headers_are_refused_with_what_to_do(header: bytes, said: str) -> None:
    with pytest.raises(TextError) as refused:
        text_after_header(header + b"\n", [])
    assert said in str(refused.value)


def test_comments_go_and_lines_stay() -> None:
    text = text_after_header(b'\xef\xbb\xbfxof 0302txt 0064\r\n// a\r\n"//b" # c\rBone#1', [])
    assert text.split("\n") == ["", "", '"//b" ', "Bone#1"]


def test_failed_numbers_count_as_zero_with_a_note() -> None:
    notes: list[str] = []
    assert text_after_header(b"xof 0303txt 0032\n-1.#IND00; 1.#QNAN;", notes).split() == ["0;", "0;"]
    assert len(notes) == 1
