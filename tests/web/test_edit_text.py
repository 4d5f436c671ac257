"""The operations of the API on a text, without a server."""

import pytest
import statwalk
from edit_texts import DOOR

RENAME = {"kind": "rename_state", "state": "OPEN", "to": "AJAR"}


def test_operations_in_their_order() -> None:
    text = statwalk.edit(DOOR, [RENAME, {"kind": "set_cell", "state": "AJAR", "event": "PULL", "text": ""}])
    assert "  AJAR    |         |      |       |      |\n" in text


@pytest.mark.parametrize(
    ("operation", "words"),
    [
        ({"kind": "set_cel"}, "operations.0: Input tag 'set_cel'"),
        (RENAME | {"more": 1}, "operations.0.rename_state.more: Extra inputs"),
        (RENAME | {"state": "OPNE"}, "did you mean OPEN"),
        ({"kind": "delete_entry", "section": "parameters", "name": "wind"}, "wind"),
    ],
)
def test_refused(operation: dict[str, object], words: str) -> None:
    with pytest.raises(statwalk.ContentError, match=words):
        statwalk.edit(DOOR, [operation])
