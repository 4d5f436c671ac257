"""What is handed over is durable when the writer says so: once each, and in order, whatever the disk does."""

import sqlite3
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from statwalk.errors import ContentError, StorageError
from statwalk.services.hosting.store.database import FORMAT
from statwalk.services.hosting.store.writer import Statement, Writer

PATIENCE = 60.0


@pytest.fixture
def writer(tmp_path: Path) -> Iterator[Writer]:
    writer = Writer(tmp_path / "store.db")
    yield writer
    writer.close()


def kept(number: int) -> list[Statement]:
    """A row that can be there once only."""
    return [Statement("INSERT INTO snapshots VALUES ('s', ?, ?, x'')", [(number, b"0" * 40_000)])]


def rows(writer: Writer) -> list[int]:
    reader = sqlite3.connect(writer.path)
    found = [tick for (tick,) in reader.execute("SELECT tick FROM snapshots ORDER BY rowid")]
    reader.close()
    return found


def fill_up(writer: Writer) -> None:
    """Leaves the open database no page more; SQLite then says what it says when a disk is full."""
    connection = writer._committer._connection
    assert connection is not None
    (pages,) = connection.execute("PRAGMA page_count").fetchone()
    connection.execute(f"PRAGMA max_page_count={pages}")


def test_it_is_durable_when_flush_returns(writer: Writer) -> None:
    told: list[int] = []
    for number in range(5):
        writer.put(kept(number), lambda number=number: told.append(number))
    writer.flush(PATIENCE)
    assert rows(writer) == told == [0, 1, 2, 3, 4]


def test_a_full_disk_is_named_and_nothing_counts_as_durable(writer: Writer) -> None:
    fill_up(writer)
    told: list[int] = []
    writer.put(kept(1), lambda: told.append(1))
    with pytest.raises(StorageError, match="the disk is full") as refused:
        writer.flush(PATIENCE)
    assert (refused.value.is_full, told) == (True, [])


def test_what_waits_is_written_once_when_there_is_room_again(writer: Writer) -> None:
    fill_up(writer)
    durable = threading.Event()
    writer.put(kept(1))
    writer.put(kept(2), durable.set)
    assert durable.wait(PATIENCE)  # the database is opened again, and has room
    writer.flush(PATIENCE)
    assert (rows(writer), writer.trouble) == ([1, 2], None)


def test_a_commit_that_failed_after_it_was_written_is_not_written_twice(writer: Writer) -> None:
    """As after an fsync that failed: the rows are there, and nobody was told."""
    writer.flush(PATIENCE)
    number = writer.commits + 1
    other = sqlite3.connect(writer.path)
    with other:
        other.execute("UPDATE commits SET ticket = ?", (number,))
        other.execute(*(kept(7)[0].sql, kept(7)[0].rows[0]))
    other.close()
    writer.put(kept(7))
    writer.flush(PATIENCE)
    assert rows(writer) == [7]


def test_after_its_end_it_takes_nothing(tmp_path: Path) -> None:
    writer = Writer(tmp_path / "store.db")
    writer.close()
    writer.put(kept(1))
    with pytest.raises(StorageError, match="has stopped"):
        writer.flush(PATIENCE)


def test_a_file_that_is_no_database_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "store.db"
    path.write_bytes(b"a note of somebody's" * 100)
    with pytest.raises(ContentError, match=r"store\.db: the file is no database"):
        Writer(path)
    assert path.read_bytes().startswith(b"a note")


def test_a_database_of_another_format_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "store.db"
    Writer(path).close()
    other = sqlite3.connect(path)
    other.execute(f"PRAGMA user_version={FORMAT + 1}")
    other.close()
    with pytest.raises(ContentError, match=f"of format {FORMAT + 1}"):
        Writer(path)


def test_a_folder_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    with pytest.raises(StorageError, match="unable to open"):
        Writer(tmp_path / "nowhere" / "store.db")
