"""Every error survives the way between two processes: its kind, its sentence and what it carries."""

import pickle

import pytest
from statwalk import errors

SAMPLES = [
    errors.ContentError("no", file="a.glb", place="byte 3"),
    errors.ModelError("no", place="/nodes/3"),
    errors.TextError("no", file="a.txt"),
    errors.MachineError("no", file="machine.yaml", place="line 12"),
    errors.UnknownNameError("state", "WALX", ["WALK", "STAT"]),
    errors.UnknownNameError("stage", "old", ["main"], "old is kept"),
    errors.StageError("no"),
    errors.RefusedEditError("no", field="text", findings=["one"]),
    errors.ConflictError("no", field="actor"),
    errors.LimitError("no", field="actors", limit="actors"),
    errors.VersionConflictError("no", field="version"),
    errors.BusyError("no"),
    errors.CancelledError("no"),
    errors.StorageError("full", is_full=True),
    errors.OverdueError("no"),
]


@pytest.mark.parametrize("error", SAMPLES, ids=lambda error: type(error).__name__)
def test_an_error_survives_pickling(error: errors.StatwalkError) -> None:
    back = pickle.loads(pickle.dumps(error))
    assert (type(back), str(back), vars(back)) == (type(error), str(error), vars(error))


@pytest.mark.parametrize(
    ("file", "shown"),
    [("/home/x/machines/a/machine.yaml", "machine.yaml"), ("robot/a.gltf", "robot/a.gltf"), ("", "")],
)
def test_an_error_without_its_folder(file: str, shown: str) -> None:
    error = errors.MachineError("no", file=file, place="line 3").without_folder()
    assert (type(error), error.file, error.place, error.message) == (
        errors.MachineError,
        shown,
        "line 3",
        "no",
    )


def test_all_errors_are_tried() -> None:
    kinds = {kind for kind in vars(errors).values() if isinstance(kind, type)}
    tried = {type(error) for error in SAMPLES} | {errors.StatwalkError}
    assert {kind for kind in kinds if issubclass(kind, errors.StatwalkError)} == tried


def test_an_unknown_name_lists_forty_names_and_counts_the_others() -> None:
    error = errors.UnknownNameError("cell", "A/B", [f"cell-{number}" for number in range(1_110)])
    assert str(error).endswith("cell-38, cell-39 … and 1,070 more")
    assert len(error.known) == 1_110
