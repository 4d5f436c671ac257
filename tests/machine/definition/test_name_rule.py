import pytest
from statwalk.machine.definition.name_rule import NAME, refused_name


@pytest.mark.parametrize("name", ["WALK", "é", "Жй", "1", "_", "a.b-c", "x" * 100])
def test_letters_digits_and_signs_within_make_a_name(name: str) -> None:
    assert NAME.fullmatch(name)


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("", "it is empty"),
        ("-x", "it begins with -"),
        (".", "it begins with ."),
        ("WALK FAST", "it has a space"),
        ("A|B", "it has |"),
        ("e\u0301t", "it has U+0301, combining acute accent"),
        ("a\u00a0b", "it has U+00A0, no-break space"),
        ("a\x07", "it has U+0007, a control character"),
        ("x" * 101, "it has more than 100 letters"),
    ],
)
def test_a_refusal_says_what_is_wrong(text: str, fault: str) -> None:
    assert not NAME.fullmatch(text)
    said = refused_name(text, "state")
    assert f"is no name for the state: {fault}; use letters, digits" in said
