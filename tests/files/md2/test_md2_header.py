"""The head of an MD2 file: what it names lies in the file, or the file is refused before memory is taken."""

import tracemalloc

import pytest
from md2_models import HOSTILE_MD2, md2, with_field
from statwalk.errors import ModelError
from statwalk.files.md2 import read_md2
from statwalk.files.md2.md2_header import read_header


@pytest.mark.parametrize("what", HOSTILE_MD2)
def test_a_broken_file_is_refused_with_the_byte(what: str) -> None:
    data, said = HOSTILE_MD2[what]
    with pytest.raises(ModelError, match=f"^{said}" if said.startswith("byte") else said):
        read_md2(data, "broken")


@pytest.mark.parametrize("what", HOSTILE_MD2)
def test_a_refusal_takes_no_memory(what: str) -> None:
    tracemalloc.start()
    with pytest.raises(ModelError):
        read_md2(HOSTILE_MD2[what][0], "broken")
    assert tracemalloc.get_traced_memory()[1] < 500_000
    tracemalloc.stop()


@pytest.mark.parametrize("cut", range(0, len(md2()), 7))
def test_a_file_that_is_cut_short_is_refused(cut: int) -> None:
    with pytest.raises(ModelError, match=r"^byte"):
        read_md2(md2()[:cut], "cut")


@pytest.mark.parametrize("field", ["commands", "commands_at"])
@pytest.mark.parametrize("value", [-1, 0, 1 << 30])
def test_gl_commands_may_lie_anywhere(field: str, value: int) -> None:
    assert getattr(read_header(with_field(field, value)), field) == value


def test_what_follows_the_end_is_ignored() -> None:
    assert read_header(md2() + b"more").end == len(md2())
