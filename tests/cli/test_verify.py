"""`statwalk verify`: what it prints, and its exit status."""

import orjson
import pytest
from command_line import statwalk
from paths import MACHINES


def run(*arguments):
    return statwalk("verify", *arguments)


def test_errors_are_printed_and_make_status_1():
    done = run("faq-printed")
    assert done.returncode == 1
    assert "TLFG is no state; did you mean TLFT?" in done.stdout
    assert "2 errors, 5 warnings" in done.stdout


@pytest.mark.parametrize("machine", ["faq-walker", "walker-layers"])
def test_what_ships_keeps_its_promises(machine):
    assert run(machine).stdout.endswith(f"{machine}: 0 errors, 0 warnings\n")


def test_json_is_for_programs():
    done = run("faq-walker", "--json")
    assert done.returncode == 0
    findings = orjson.loads(done.stdout)["findings"]
    assert [one["severity"] for one in findings] == ["info"] * 6
    assert findings[0]["message"] == "JUMP only after WALK: proved"
    assert findings[4]["message"] == "JUMP leads to CRCH within 1.2 s: proved (at most 1.167 s)"


def test_a_file_that_cannot_be_read_makes_status_2_and_one_line(tmp_path):
    text = (MACHINES / "faq-walker" / "machine.yaml").read_text()
    (tmp_path / "machine.yaml").write_text(text.replace("initial: STAT", "initial: STAAT"))
    line = 1 + text.splitlines().index("initial: STAT")
    done = run(tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith(
        f"statwalk: {tmp_path}/machine.yaml, line {line}: no state is called 'STAAT'; did you mean STAT?"
    )
    assert len(done.stderr.splitlines()) == 1


def test_a_machine_that_does_not_exist_lists_those_that_do():
    done = run("faq-waker")
    assert done.returncode == 2
    assert "did you mean faq-walker?" in done.stderr


def test_help_shows_examples():
    assert "statwalk verify faq-printed" in run("--help").stdout


def test_a_root_that_is_no_joint_is_named_with_its_line(tmp_path):
    text = (MACHINES / "faq-walker" / "machine.yaml").read_text().replace("root: Root", "root: Rot")
    (tmp_path / "machine.yaml").write_text(text)
    (tmp_path / "walker.glb").write_bytes((MACHINES / "faq-walker" / "walker.glb").read_bytes())
    done = run(tmp_path)
    assert done.returncode == 2
    assert "machine.yaml, line 7: root: the character has no joint 'Rot'; did you mean Root?" in done.stderr


def test_what_the_character_does_not_have_makes_status_2(tmp_path):
    """The table has no error, and yet the machine could not be played."""
    text = (MACHINES / "faq-walker" / "machine.yaml").read_text()
    (tmp_path / "machine.yaml").write_text(text + 'expressions: ["Tail.rotate_z = 10"]\n')
    (tmp_path / "walker.glb").write_bytes((MACHINES / "faq-walker" / "walker.glb").read_bytes())
    done = run(tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert f"line {len(text.splitlines()) + 1}" in done.stderr
    assert "Tail" in done.stderr
