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
        ({"kind": "set_cel"}, "operations.0: 'set_cel' is no kind; did you mean set_cell"),
        (
            RENAME | {"more": 1},
            "rename_state.more: there is no such member; there are: state, layer, kind, to",
        ),
        (RENAME | {"state": "OPNE"}, "did you mean OPEN"),
        ({"kind": "delete_entry", "section": "parameters", "name": "wind"}, "wind"),
    ],
)
def test_refused(operation: dict[str, object], words: str) -> None:
    with pytest.raises(statwalk.ContentError, match=words):
        statwalk.edit(DOOR, [operation])
