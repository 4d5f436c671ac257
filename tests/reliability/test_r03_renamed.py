"""R-03 for machines: wherever a server is killed while it renames a machine, the machine has one name, and
all its versions.
"""

import shutil
from pathlib import Path

from keeping import keeping
from killed import start_forks
from killed_renames import NEW, OLD, catalogue_of, edited, found, is_killed


def test_r03_a_machine_keeps_its_versions_wherever_its_renaming_is_killed(tmp_path: Path) -> None:
    start_forks()
    versions, names = edited(tmp_path / "before"), []
    for nth in range(20):
        folder = shutil.copytree(tmp_path / "before", tmp_path / str(nth))
        killed = is_killed(folder, nth)
        with keeping(folder, catalogue_of(folder)) as held:
            kept = found(held)
        assert list(kept.values()) == [versions], f"killed before change {nth}"
        names += kept
        if not killed:
            break
    assert {OLD, NEW} == set(names)
    assert len(names) > 4
