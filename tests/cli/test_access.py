"""`statwalk access`: gives, lists and takes away."""

from pathlib import Path

import pytest
import typer
from statwalk.cli.access import access
from statwalk.services.access.access_file import AccessFile
from statwalk.services.access.roles import digest_of


def test_a_token_is_shown_once(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    access("add", "ada", "drive", tmp_path)
    token = capsys.readouterr().out.splitlines()[1]
    assert [person.digest for person in AccessFile(tmp_path).people()] == [digest_of(token)]
    access("list", data=tmp_path)
    listed = capsys.readouterr().out
    assert "ada" in listed
    assert "drive" in listed
    assert token not in listed
    access("revoke", "ada", data=tmp_path)
    assert AccessFile(tmp_path).people() == ()


@pytest.mark.parametrize(("action", "name"), [("add", ""), ("revoke", ""), ("list", "ada")])
def test_what_takes_a_name_says_so(tmp_path: Path, action: str, name: str) -> None:
    with pytest.raises(typer.BadParameter, match="name"):
        access(action, name, data=tmp_path)
