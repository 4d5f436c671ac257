"""R-16: one process has a data folder."""

from pathlib import Path

from races import Racers
from serving import serving
from statwalk.web.app import create_app
from statwalk.web.settings import Settings


def winners(folder: Path, races: int, *, is_honest: bool) -> list[int]:
    """How many got the folder, in each race."""
    with Racers(is_honest=is_honest) as racers:
        return [
            racers.run(folder / str(race // 3), kills_winner=race % 2 == 0).count("") for race in range(races)
        ]


def test_of_two_that_start_at_once_one_wins_and_the_next_race_has_a_winner_too(tmp_path: Path) -> None:
    assert winners(tmp_path, 20, is_honest=True) == [1] * 20


def test_a_file_as_a_lock_is_found_out(tmp_path: Path) -> None:
    assert winners(tmp_path, 6, is_honest=False) != [1] * 6  # after a kill nobody gets the folder


def test_who_has_the_folder_deletes_what_a_killed_server_left(tmp_path: Path) -> None:
    left = tmp_path / "tmp" / "half"
    left.mkdir(parents=True)
    with serving(create_app(Settings(data=tmp_path, main_stage=False))):
        assert left.exists()  # the control: another server may use it
    with serving(create_app(Settings(data=tmp_path, kept=tmp_path, main_stage=False))):
        assert not left.exists()
