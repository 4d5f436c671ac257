"""Operations, undo and redo over the versions of a machine: nothing is lost, and each step is a version."""

import random
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from keeping import keeping
from statwalk.errors import ConflictError, UnknownNameError, VersionConflictError
from statwalk.files.machine_yaml.edit.operations import AddState, EditOperation, RenameState, SetCell, SetView
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.services.cancel import CancelToken
from statwalk.services.hosting.machine_edits import (
    MOST_TRIES,
    EditRequest,
    change,
    redo,
    restore,
    trial,
    undo,
)
from statwalk.services.hosting.machine_versions import MachineVersions
from statwalk.services.library.catalogue import Catalogue

WALKER = "faq-walker"
STATES = ["STAT", "WALK", "CSTP", "-", ""]


@pytest.fixture
def versions() -> MachineVersions:
    return MachineVersions(Catalogue(), list)


def newest(versions: MachineVersions, name: str = WALKER) -> EditRequest:
    return EditRequest(name, versions.current(name).version.number)


def text(versions: MachineVersions, name: str = WALKER) -> str:
    return versions.current(name).version.text


def test_any_number_of_steps_back_and_forth(versions: MachineVersions) -> None:
    """Compared with a list of texts and a place in it."""
    chosen, texts, place = random.Random(3), [text(versions)], 0
    for _ in range(60):
        step = chosen.choice(["edit", "undo", "undo", "redo", "redo"])
        if step == "edit":
            change(versions, newest(versions), [SetCell("WALK", "LEFT", chosen.choice(STATES))])
            if text(versions) != texts[place]:
                texts[place + 1 :] = [text(versions)]
                place += 1
        elif (step == "undo" and place == 0) or (step == "redo" and place == len(texts) - 1):
            with pytest.raises(ConflictError, match=f"nothing to {step}"):
                (undo if step == "undo" else redo)(versions, newest(versions))
        else:
            (undo if step == "undo" else redo)(versions, newest(versions))
            place += 1 if step == "redo" else -1
        assert text(versions) == texts[place]
        version = versions.current(WALKER).version
        assert (version.before > 0, version.after > 0) == (place > 0, place < len(texts) - 1)


def test_back_and_forth_over_a_restart(tmp_path: Path) -> None:
    with keeping(tmp_path, Catalogue()) as held:
        change(held.versions, newest(held.versions, "elbow")._replace(author="Ann"), [AddState("MORE")])
        edited = text(held.versions, "elbow")
        undo(held.versions, newest(held.versions, "elbow"))
    with keeping(tmp_path, Catalogue()) as held:
        redo(held.versions, newest(held.versions, "elbow"))
        assert text(held.versions, "elbow") == edited
        assert [version.author for version in held.versions.of("elbow")] == ["", "Ann", "", ""]


def test_a_version_is_brought_back_as_an_edit(versions: MachineVersions) -> None:
    first = text(versions)
    change(versions, newest(versions), [AddState("MORE")])
    change(versions, newest(versions), [AddState("EVEN_MORE")])
    restore(versions, newest(versions), 1)
    assert (text(versions), versions.current(WALKER).version.what) == (first, "back to version 1")
    undo(versions, newest(versions))
    assert "EVEN_MORE" in text(versions)
    with pytest.raises(UnknownNameError, match="no version is called '99'"):
        restore(versions, newest(versions), 99)


def test_an_edit_that_changes_nothing_makes_no_version(versions: MachineVersions) -> None:
    change(versions, newest(versions), [SetCell("WALK", "LEFT", "TLFT")])
    assert len(versions.of(WALKER)) == 1


def test_a_trial_makes_no_version(versions: MachineVersions) -> None:
    assert trial(versions, newest(versions), [AddState("MORE")]).version.number == 2
    assert len(versions.of(WALKER)) == 1


def test_what_others_did_meanwhile_stays(versions: MachineVersions) -> None:
    seen = newest(versions)
    change(versions, seen._replace(author="Ann"), [RenameState("STUP", "RISE")])
    change(versions, seen, [SetCell("WALK", "LEFT", "STAT")])
    assert "RISE" in text(versions)
    with pytest.raises(
        VersionConflictError, match=r"version 2 by Ann \(STUP is now RISE\) has changed the same"
    ):
        change(versions, seen, [SetCell("STUP", "END", "WALK")])
    with pytest.raises(VersionConflictError, match="version 77 is not kept"):
        change(versions, seen._replace(seen=77), [AddState("MORE")])


def test_a_request_that_comes_twice_counts_once(versions: MachineVersions) -> None:
    """Its answer was lost, and the editor sends it again with the version that it knew."""
    seen, operations = newest(versions), [SetCell("WALK", "LEFT", "STAT")]
    change(versions, seen, operations)
    assert change(versions, seen, operations).version.number == 2


def test_many_at_once_lose_nothing(versions: MachineVersions) -> None:
    seen, together = newest(versions), threading.Barrier(4)
    places = [("STAT", "LEFT"), ("WALK", "LEFT"), ("TLFT", "LEFT"), ("TRGT", "LEFT")]

    def edit(place: tuple[str, str]) -> None:
        together.wait(60)
        change(versions, seen, [SetCell(*place, "STAT at end")])

    with ThreadPoolExecutor(4) as threads:
        list(threads.map(edit, places))
    assert text(versions).count("STAT at end") == 4


@pytest.mark.parametrize("operation", [SetView({"WALK": (1, 2)}), AddState("MORE")])
def test_what_is_kept_says_all(versions: MachineVersions, operation: EditOperation) -> None:
    made = change(versions, newest(versions), [operation])
    assert made.version.text == made.file.text == versions.catalogue.entry(WALKER).file.text
    assert MachineText.of(made.version.text).tables == {}


def test_an_edit_that_is_always_late_is_given_up(versions: MachineVersions) -> None:
    """While it is verified, another editor changes another cell, each time."""

    class OtherEdits(CancelToken):
        def check(self) -> None:
            other = "TLFT" if versions.current(WALKER).version.number % 2 else "STAT"
            change(versions, newest(versions), [SetCell("STAT", "RIGHT", other)])

    late = newest(versions)._replace(token=OtherEdits())
    with pytest.raises(VersionConflictError):
        change(versions, late, [SetCell("WALK", "LEFT", "STAT")])
    assert len(versions.of(WALKER)) > MOST_TRIES
    assert all("WALK" not in version.what for version in versions.of(WALKER))
