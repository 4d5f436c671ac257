"""The parts of a machine file: states, events, cells, keys, parameters, properties; each from its value in the YAML."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from statwalk.files.yamltext import Node
from statwalk.machine.build import LARGEST_SPEED
from statwalk.machine.celldefinition import AT_END, NOW, ActionDefinition, CellDefinition, Defaults, Moment
from statwalk.machine.definition import (
    ANY,
    END,
    EventDefinition,
    KeyDefinition,
    ParameterDefinition,
    PropertyDefinition,
    StateDefinition,
)
from statwalk.machine.table import NAME, read_cell

LONGEST_SECONDS = 60.0
CELL_KEYS = ("to", "when", "blend", "action")
CELL_NOT_YET = ("enter", "if", "off", "window", "marker", "curve")
STATE_NOT_YET = ("blend", "machine", "final", "pose", "mask")


def mapping(node: Node | None) -> list[tuple[str, Node]]:
    """Key and value of each entry; none where the key is missing or empty."""
    return [] if node is None or node.value == "" else list(node.entries().items())


def known_keys(node: Node, known: tuple[str, ...], not_yet: tuple[str, ...]) -> dict[str, Node]:
    """The entries; raises MachineError for keys that are unknown, and for those that are not supported yet."""
    for key in node.entries():
        if key in not_yet:
            raise node.refuse(f"`{key}` is not supported yet", node.key_lines[key])
    return node.entries(*known)


def refuse_bad_names(node: Node, kind: str) -> None:
    """Raises MachineError for a key that cannot be a name."""
    for name, line in node.key_lines.items():
        if not NAME.fullmatch(name):
            raise node.refuse(f"{name[:40]!r} is no name for the {kind}: letters, digits and _, then also . -", line)


def state(node: Node) -> StateDefinition:
    """`{motion: walk, loop: true, speed: 1.5}`; the speed may be a parameter."""
    entries = known_keys(node, ("motion", "loop", "speed"), STATE_NOT_YET)
    if "motion" not in entries:
        raise node.refuse("a state needs a motion: `{motion: NAME}`")
    if not entries["motion"].is_text:
        raise entries["motion"].refuse("blends and sub-machines as motions are not supported yet; name one motion")
    return StateDefinition(
        motion=entries["motion"].text(),
        line=node.line,
        loop=entries["loop"].truth() if "loop" in entries else None,
        speed=speed(entries["speed"]) if "speed" in entries else 1.0,
    )


def speed(node: Node) -> float | str:
    """A factor from 0 to 100, or a parameter's name."""
    return node.text() if node.text().isidentifier() else node.number(0, LARGEST_SPEED)


def events(node: Node | None) -> dict[str, EventDefinition]:
    """`{JUMP: {buffer: 0.5}}`: inputs beside the columns of the table, or more about them."""
    if node is not None and node.value != "":
        refuse_bad_names(node, "event")
    found = {}
    for name, one in mapping(node):
        if name == END:
            raise one.refuse("END is no input: motions raise it")
        entries = known_keys(one, ("buffer",), ()) if one.value != "" else {}
        found[name] = EventDefinition(one.line, entries["buffer"].number(0, LONGEST_SECONDS) if "buffer" in entries else None)
    return found


def defaults(node: Node | None) -> Defaults:
    """`{when: now, blend: 0.2, buffer: 0.3}`."""
    if node is None:
        return Defaults()
    entries = known_keys(node, ("when", "blend", "buffer"), ())
    standard = Defaults()
    return Defaults(
        when=when(entries["when"]) if "when" in entries else standard.when,
        blend=entries["blend"].number(0, LONGEST_SECONDS) if "blend" in entries else standard.blend,
        buffer=entries["buffer"].number(0, LONGEST_SECONDS) if "buffer" in entries else standard.buffer,
    )


def when(node: Node) -> Moment:
    """`now` or `end`."""
    match node.text():
        case "now":
            return NOW
        case "end":
            return AT_END
        case other:
            if other.split(" ")[0] in ("marker", "window"):
                raise node.refuse(f"`{other[:40]}`: markers and windows are not supported yet, only now and end")
            raise node.unknown("moment", other, ("now", "end"))


def refine(
    cells: Mapping[tuple[str, str], CellDefinition], node: Node, states: Iterable[str], inputs: Iterable[str]
) -> dict[tuple[str, str], CellDefinition]:
    """The cells of the table with what stands under `cells`: `WALK/JUMP: {when: end, blend: 0.1, action: scream}`."""
    found = dict(cells)
    for name, one in mapping(node):
        place = cell_place(node, name, states, inputs)
        found[place] = cell(one, found.get(place), name)
    return found


def cell_place(node: Node, name: str, states: Iterable[str], inputs: Iterable[str]) -> tuple[str, str]:
    """State and event of `STATE/EVENT`, either perhaps `*`; raises MachineError for names that do not exist."""
    row, slash, column = name.partition("/")
    line = node.key_lines[name]
    if not slash:
        raise node.refuse(f"{name[:40]!r} is no cell; it is written STATE/EVENT, with * for any", line)
    if row != ANY and row not in states:
        raise node.unknown("state", row, states, line)
    if column not in (ANY, END) and column not in inputs:
        raise node.unknown("event", column, (*inputs, END), line)
    return row, column


def cell(node: Node, written: CellDefinition | None, name: str) -> CellDefinition:
    """A cell of the table with more said about it, or one that the table has not."""
    if isinstance(node.value, list):
        raise node.refuse("alternatives are not supported yet")
    entries = known_keys(node, CELL_KEYS, CELL_NOT_YET)
    base = read_cell(cell_text(entries["to"]), node.file, entries["to"].line) if "to" in entries else written
    if base is None:
        raise node.refuse(f"the cell {name[:80]} has no next state, neither in the table nor here (`to: STATE`)")
    more = base
    if "when" in entries:
        more = replace(more, when=when(entries["when"]))
    if "blend" in entries:
        more = replace(more, blend=entries["blend"].number(0, LONGEST_SECONDS))
    if "action" in entries:
        more = replace(more, action=action(entries["action"]))
    return more


def cell_text(node: Node) -> str:
    """What `to` says; raises MachineError where it is not one cell."""
    if not node.is_text:
        raise node.refuse("alternatives and weights are not supported yet; `to` names one state")
    return node.text()


def action(node: Node) -> ActionDefinition:
    """The name of an action, of at most 100 characters."""
    text = node.text()
    if not text or len(text) > 100 or not text.isprintable():
        raise node.refuse("an action is a name of 1 to 100 characters")
    return ActionDefinition(text)


def key(node: Node, inputs: Iterable[str]) -> KeyDefinition:
    """`{press: EVENT}` or `{hold: EVENT}` when it goes down, `release: EVENT` when it comes up."""
    entries = known_keys(node, ("press", "hold", "release"), ())
    for one in entries.values():
        if one.text() not in inputs:
            raise one.unknown("event", one.text(), inputs)
    if ("press" in entries) == ("hold" in entries):
        raise node.refuse("a key needs either `press: EVENT` (once) or `hold: EVENT` (as long as it is down)")
    down = entries.get("hold") or entries["press"]
    return KeyDefinition(down.text(), entries["release"].text() if "release" in entries else None, "hold" in entries, node.line)


def parameter(node: Node) -> ParameterDefinition:
    """`{default: 1, min: 0.5, max: 2}`."""
    entries = known_keys(node, ("default", "min", "max"), ())
    if set(entries) != {"default", "min", "max"}:
        raise node.refuse("a parameter needs `default`, `min` and `max`")
    lowest, highest = entries["min"].number(-1e9, 1e9), entries["max"].number(-1e9, 1e9)
    if lowest > highest:
        raise node.refuse(f"min {lowest:g} is more than max {highest:g}")
    return ParameterDefinition(entries["default"].number(lowest, highest), lowest, highest, node.line)


def sentences(node: Node | None) -> Iterator[PropertyDefinition]:
    """The properties, each a line of text."""
    for one in [] if node is None else node.items():
        yield PropertyDefinition(one.text(), one.line)
