"""`statwalk measure`: what it prints, and its exit status."""

import orjson
from command_line import statwalk
from paths import MACHINES


def run(*arguments, columns=240):
    return statwalk("measure", *arguments, columns=columns)


def with_budgets(tmp_path, budgets):
    text = (MACHINES / "faq-walker" / "machine.yaml").read_text().partition("budgets:")[0]
    folder = tmp_path / "walker"
    folder.mkdir()
    (folder / "machine.yaml").write_text(
        text.replace("character: walker.glb", "character: faq-walker") + budgets
    )
    return folder


def test_over_budget_is_status_1_and_says_where(tmp_path):
    done = run(with_budgets(tmp_path, "budgets: {arrived: 0.01}\n"), "--cell", "WALK/STOP")
    assert done.returncode == 1
    assert "WALK/STOP: arrived 0." in done.stdout
    assert "1 figure over budget" in done.stdout


def test_json_is_for_programs(tmp_path):
    done = run(with_budgets(tmp_path, "budgets: {jump: 2}\n"), "--cell", "WALK/STOP", "--json")
    assert done.returncode == 0
    answer = orjson.loads(done.stdout)
    assert (answer["budgets"], answer["findings"], answer["units"]["slide"]) == ({"jump": 2.0}, [], "m")
    (row,) = answer["measured"]
    assert 0 < row["figures"]["jump"]["mean"] <= row["figures"]["jump"]["worst"] < 2


def test_an_unknown_cell_is_status_2():
    done = run("faq-walker", "--cell", "WALK/STAP")
    assert done.returncode == 2
    assert "did you mean WALK/STOP" in done.stderr


def test_a_table_of_80_columns_cuts_nothing_and_has_the_worst_alone():
    done = run("walker-layers", "--cell", "SURPRISE/NEUTRAL", columns=80)
    assert done.returncode == 0
    assert not {"…", "("} & set(done.stdout)
    assert max(map(len, done.stdout.splitlines())) <= 80


def test_a_wide_table_has_the_mean_too():
    assert "(" in run("faq-walker", "--cell", "WALK/STOP").stdout
