"""Assignments: what a line may be, the order of dependencies, circles, and what is refused."""

import pytest
from statwalk.maths.formula.assignments import MOST_ASSIGNMENTS, AssignmentError, read_assignments


def read(*lines, known=("x", "joint.rotate_z")):
    def check(name, names_set):
        return "" if name in known or name in names_set else f"unknown {name}"

    return read_assignments(list(enumerate(lines, 1)), check)


def targets(*lines):
    return [line.target for line in read(*lines)]


def test_lines_follow_the_lines_that_they_read():
    assert targets("c = b + a", "b = 2 * a", "a = x") == ["a", "b", "c"]


def test_lines_that_need_nothing_keep_their_order():
    assert targets("b = 1", "a = 2", "c = 3") == ["b", "a", "c"]


def test_comments_and_empty_lines_count_for_nothing_but_their_numbers():
    (line,) = read("# first", "", "  a = x   # why")
    assert (line.target, line.formula.text, line.line, line.text) == ("a", "x", 3, "a = x")


def test_names_have_parts_and_quotes():
    (line,) = read("'Left arm'.scale_x = joint.rotate_z")
    assert line.target == "Left arm.scale_x"
    assert line.formula.scope == ("joint.rotate_z",)


def test_a_comparison_is_no_second_assignment():
    (line,) = read("a = if(x == 1, 2, 3)")
    assert line.formula.evaluate([[1.0, 0.0]]).tolist() == [2, 3]


@pytest.mark.parametrize(
    ("lines", "line", "what"),
    [
        (["a = 1", "b = c", "c = d", "d = b"], 2, "b -> c -> d -> b"),
        (["a = a"], 1, "a -> a"),
        (["a = 1", "a = 2"], 2, "already set in line 1"),
        (["a = y"], 1, "unknown y"),
        (["x"], 1, "write NAME = FORMULA"),
        (["= 3"], 1, "one name"),
        (["3 = x"], 1, "one name"),
        (["a b = x"], 1, "one name"),
        (["max = x"], 1, "built in"),
        (["a = "], 1, "the end"),
        (["a == 3"], 1, "compares"),
        (["a = 'x"], 1, "no meaning"),
        (["a = x;b = x"], 1, "no meaning"),
        (["a = lambda: 3"], 1, "no meaning"),
    ],
)
def test_what_is_no_assignment_is_refused_with_its_line(lines, line, what):
    with pytest.raises(AssignmentError, match=what) as refused:
        read(*lines)
    assert refused.value.line == line


def test_a_circle_names_its_members_only():
    with pytest.raises(AssignmentError) as refused:
        read("a = b", "b = a", "z = a")
    assert "z" not in refused.value.message.split("next:")[1]


def test_too_many_lines_are_refused():
    with pytest.raises(AssignmentError, match="at most 1,024"):
        read(*(f"a{row} = 1" for row in range(MOST_ASSIGNMENTS + 1)))


def test_a_line_is_written_as_it_is_read_names_in_quotes_included():
    lines = [(1, "'Left arm'.rotate_z = 2 * 'Big smile'.weight"), (2, "a.b.weight = 1")]
    read = read_assignments(lines, lambda _name, _names_set: "")
    assert sorted(line.text for line in read) == sorted(text for _, text in lines)
