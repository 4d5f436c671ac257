"""R-06: an upgrade does not silently change old sessions: recordings of all versions are played again.

`python tests/support/record_golden.py` records those of the present version; tests/support/golden.py says
what a folder holds.
"""

import json
import shutil
from pathlib import Path

import pytest
from golden import DRIFTED, RECORD, Golden, versions
from paths import MACHINES
from planted import planted
from random_sessions import CONTENTS
from record_golden import present_version
from statwalk.errors import StageError
from statwalk.stage.history import engine
from statwalk.stage.history.log_codec import KINDS
from statwalk.stage.replay import replay

VERSIONS = versions()
PRESENT = Golden(VERSIONS[0].folder.with_name(present_version()))
LEAST = 50
MOST_BYTES = 1_500_000


@pytest.mark.parametrize(
    ("golden", "content"),
    [(golden, content) for golden in VERSIONS for content in sorted({s[:-2] for s in golden.sessions})],
    ids=lambda part: part.folder.name if isinstance(part, Golden) else part,
)
def test_r06_a_session_goes_as_it_went_or_is_refused(golden: Golden, content: str) -> None:
    for session in (name for name in golden.sessions if name[:-2] == content):
        if golden.is_of_this_engine(session):
            drift = golden.drift(session)
            assert not drift, drift
        else:
            with pytest.raises(StageError, match=r"line 1: engine .* played the log; this is engine"):
                replay(golden.log(session), golden.role)


def test_r06_the_present_version_has_its_sessions() -> None:
    """If this fails after a new version or ENGINE: record, and commit what the script writes."""
    present = [name for name in PRESENT.sessions if PRESENT.is_of_this_engine(name)]
    assert len(present) >= LEAST, f"record the sessions of {PRESENT.folder.name}: {RECORD}"
    assert {name[:-2] for name in present} == set(CONTENTS), f"a machine has no session: {RECORD}"
    files = [path for path in PRESENT.folder.rglob("*") if path.is_file()]
    assert sum(path.stat().st_size for path in files) < MOST_BYTES


def test_r06_the_sessions_hold_every_command_and_many_ticks() -> None:
    entries = [json.loads(line) for name in PRESENT.sessions for line in PRESENT.lines(name)[1:]]
    assert {entry["kind"] for entry in entries} == set(KINDS)
    assert sum(len(hashes) for hashes in PRESENT.index["sessions"].values()) > 2_000


# --- controls


def test_r06_a_change_of_numbers_is_found_and_the_message_says_what_to_do() -> None:
    session = next(name for name in PRESENT.sessions if name.startswith("elbow"))
    with planted("nudge"):
        drift = PRESENT.drift(session)
    assert drift == DRIFTED.format(session=session, version=PRESENT.folder.name, tick=10, record=RECORD)


def test_r06_a_change_late_in_a_session_is_found() -> None:
    """The head's hash in the log is enough, for a reader who has no other hashes."""
    log = PRESENT.log(next(name for name in PRESENT.sessions if name.startswith("elbow")))
    replay(log, PRESENT.role)
    with planted("nudge", until=1), pytest.raises(StageError, match="leads to another state at tick 3"):
        replay(log, PRESENT.role)


def test_r06_another_model_is_named(tmp_path: Path) -> None:
    """As if the shipped elbow had changed since: here the version keeps one that swings otherwise."""
    shutil.copytree(PRESENT.folder, tmp_path / "0.1")
    kept = tmp_path / "0.1" / "machines" / "elbow" / "elbow.glb"
    kept.write_bytes(with_longer_arm((MACHINES / "elbow" / "elbow.glb").read_bytes()))
    assert Golden(tmp_path / "0.1").drift("elbow-1").startswith("elbow has another model than 0.1 had")


def with_longer_arm(model: bytes) -> bytes:
    """The model with its hand a little further out, in as many bytes."""
    changed = model.replace(b"0.550000011920929,0.0,0.0", b"0.650000011920929,0.0,0.0")
    assert changed != model
    return changed


def test_r06_sessions_of_another_engine_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    present = engine.ENGINE
    monkeypatch.setattr(engine, "ENGINE", present + 1)
    with pytest.raises(StageError) as refused:
        replay(PRESENT.log("elbow-1"), PRESENT.role)
    assert str(refused.value) == (
        f"line 1: engine {present} (statwalk 0.1.0) played the log; this is engine {present + 1} (statwalk "
        "0.1.0), which may move otherwise. Play it with statwalk 0.1.0"
    )
