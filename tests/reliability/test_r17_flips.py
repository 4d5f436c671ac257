"""R-17: a bit of the database flips, or its end is gone: no stage is silently another one."""

import sqlite3
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
from flips_folder import EDITED, REPORTED, WHOLE, kept, outcome, outcomes
from statwalk.services.hosting import reopen
from statwalk.services.hosting.store import read_records
from statwalk.services.hosting.store.database import FILE_NAME
from statwalk.services.library.catalogue import Catalogue

DAMAGES = range(24)


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue()


def test_r17_each_stage_is_what_it_was_or_reported(tmp_path: Path, catalogue: Catalogue) -> None:
    found = list(outcomes(tmp_path, DAMAGES, catalogue))
    assert [(seed, wrong) for seed, _, wrong in found if wrong] == []
    assert {what for _, what, _ in found} == {REPORTED, WHOLE}


def test_r17_a_table_that_is_no_table_any_more_is_reported(tmp_path: Path, catalogue: Catalogue) -> None:
    """SQLite's message has the damaged letters, which are no text."""
    before = kept(tmp_path, catalogue)
    path = tmp_path / FILE_NAME
    path.write_bytes(path.read_bytes().replace(b"CREATE TABLE stages", b"CREATE TABL\xce stages"))
    assert outcome(tmp_path, before, catalogue) == (REPORTED, [])


class Believed(bytes):
    """A hash that is every hash."""

    __hash__ = bytes.__hash__

    def __eq__(self, other: object) -> bool:
        return True

    def __ne__(self, other: object) -> bool:
        return False


OTHER_ANSWERS = "UPDATE keys SET seq = seq + 1"
ANOTHER_VERSION = "UPDATE versions SET text = text || '#' WHERE number = 2"


def changed(folder: Path, catalogue: Catalogue, change: str) -> dict[str, Any]:
    """Makes a folder whose database was changed; returns what it held before."""
    before = kept(folder, catalogue)
    with closing(sqlite3.connect(folder / FILE_NAME)) as database, database:
        database.execute(change)
    return before


def test_r17_another_answer_is_reported(tmp_path: Path, catalogue: Catalogue) -> None:
    assert outcome(tmp_path, changed(tmp_path, catalogue, OTHER_ANSWERS), catalogue) == (REPORTED, [])


def test_r17_an_answer_of_another_stage_is_reported(tmp_path: Path, catalogue: Catalogue) -> None:
    """A flip in the column that says whose answer it is."""
    of_another = "UPDATE keys SET stage = substr(stage, 1, 7) || '%' WHERE key = 'TWIST 1'"
    assert outcome(tmp_path, changed(tmp_path, catalogue, of_another), catalogue) == (REPORTED, [])


def with_hidden_answers(folder: Path, catalogue: Catalogue) -> dict[str, Any]:
    """Makes a folder whose database says that a page of answers has a row less than it has."""
    before, path = kept(folder, catalogue), folder / FILE_NAME
    data = bytearray(path.read_bytes())
    size = int.from_bytes(data[16:18])
    rows = data.index(b"TWIST 1") // size * size + 3
    data[rows : rows + 2] = (int.from_bytes(data[rows : rows + 2]) - 1).to_bytes(2)
    path.write_bytes(data)
    return before


def test_r17_a_page_that_hides_answers_is_reported(tmp_path: Path, catalogue: Catalogue) -> None:
    """A bit can do that."""
    assert outcome(tmp_path, with_hidden_answers(tmp_path, catalogue), catalogue) == (REPORTED, [])


def test_r17_a_row_that_hides_answers_is_reported(tmp_path: Path, catalogue: Catalogue) -> None:
    """Rows are sought by halves: a row in the middle that belongs before all others leads past them. A bit
    can do that too.
    """
    before, path = kept(tmp_path, catalogue), tmp_path / FILE_NAME
    data = path.read_bytes()
    at = data.index(f"{sorted(set(before) - {EDITED})[1]}STRETCH".encode())
    path.write_bytes(data[:at] + b"!" + data[at + 1 :])
    assert outcome(tmp_path, before, catalogue) == (REPORTED, [])


def test_r17_a_server_that_does_not_look_at_pages_is_found_out(
    tmp_path: Path, catalogue: Catalogue, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The control."""
    before = with_hidden_answers(tmp_path, catalogue)
    monkeypatch.setattr(reopen, "_check_answers", lambda *_: None)
    what, wrong = outcome(tmp_path, before, catalogue)
    assert (what, len(wrong)) == (WHOLE, 1)


def test_r17_a_server_that_compares_no_hashes_is_found_out(
    tmp_path: Path, catalogue: Catalogue, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The control."""
    before = changed(tmp_path, catalogue, OTHER_ANSWERS)
    monkeypatch.setattr(read_records, "row_digest", lambda *_: Believed())
    what, wrong = outcome(tmp_path, before, catalogue)
    assert (what, sorted(wrong)) == (WHOLE, sorted(set(before) - {EDITED}))


def test_r17_another_version_of_a_machine_is_reported(tmp_path: Path, catalogue: Catalogue) -> None:
    assert outcome(tmp_path, changed(tmp_path, catalogue, ANOTHER_VERSION), catalogue) == (REPORTED, [])


def test_r17_a_server_that_leaves_damaged_versions_out_is_found_out(
    tmp_path: Path, catalogue: Catalogue, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The control."""
    before = changed(tmp_path, catalogue, ANOTHER_VERSION)
    monkeypatch.setattr(read_records.KeptRecords, "damaged_versions", lambda _: {})
    assert outcome(tmp_path, before, catalogue) == (WHOLE, [EDITED])
