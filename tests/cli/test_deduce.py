"""`statwalk deduce`: a table of values and sources, and one line about an error."""

import typer
from statwalk.cli.deduce import deduce
from typer.testing import CliRunner

app = typer.Typer()
app.command()(deduce)
ARM = """\
bones: {upper: {length: 5, direction: [0, -1, 0]}, fore: {parent: upper, length: 5, direction: [0, -1, 0]}}
known: {upper: {SP: [0, 0, 0]}, fore: {EP: [0, -8, 0], bend: [0, 0, 1]}}
"""


def run(tmp_path, text):
    file = tmp_path / "arm.yaml"
    file.write_text(text)
    return CliRunner().invoke(app, [str(file)])


def test_it_prints_values_and_their_sources(tmp_path):
    printed = run(tmp_path, ARM).stdout
    assert "0 -4 3" in printed
    assert "rule 12" in printed
    assert "unknown" not in printed


def test_it_says_what_stayed_unknown(tmp_path):
    printed = run(tmp_path, ARM.replace(", bend: [0, 0, 1]", "")).stdout
    assert "unknown: upper.RA, upper.RM, upper.EP" in printed


def test_a_contradiction_is_an_error(tmp_path):
    refused = run(tmp_path, ARM.replace("-8", "-11"))
    assert "misses the sphere" in str(refused.exception)
