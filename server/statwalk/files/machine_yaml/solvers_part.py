"""Reads `solvers` of a machine file.

solvers:
  reach:
    solver: two-bone                 # or ccd, fabrik, force, look-at
    chain: [Arm, Forearm, Hand]      # or {from: Arm, to: Hand}
    target: grip                     # a parameter of kind point; look-at: or direction
    pole: [0, 0, -1]                 # or a parameter of kind point or direction
    rotation: palm                   # of the end: a parameter of kind rotation, or [x, y, z, w]
    weight: {STAT: 1, WALK: part}    # by state; or a number 0…1, a parameter or a channel for all states
    ease: 0.3
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

from statwalk.files.machine_yaml import fields
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.expression_definition import ANGLES, LENGTH, channel_of_name
from statwalk.machine.definition.parameter_definition import ParameterDefinition, fitting
from statwalk.machine.definition.solver_definition import SolverDefinition

SOLVERS = ("two-bone", "ccd", "fabrik", "force", "look-at")
ONLY: Mapping[str, tuple[str, ...]] = {
    "forward": ("look-at",),
    "cone_deg": ("look-at",),
    "travel": ("force", "two-bone", "ccd", "fabrik"),
    "rotation": ("two-bone", "ccd", "fabrik", "force"),
}
KEYS = (
    *("solver", "chain", "target", "space", "pole", "rotation", "weight", "ease", "travel", "softening"),
    *("tolerance", "iterations", "sensitivity", "forward", "cone_deg", "anchor", "grab"),
)
MOST_JOINTS, MOST_ITERATIONS, MOST_SOLVERS = 256, 1_000, 32
SMALLEST, LARGEST = 1e-9, 1e6
"""metres: of a tolerance, and of a tolerance or softening"""


def solvers(
    node: Node | None, parameters: Mapping[str, ParameterDefinition], states: Collection[str]
) -> dict[str, SolverDefinition]:
    """Reads the solvers by name, in the order in which they work; `states`: of the base, with composites.

    :raises MachineError: when a field is unknown, missing or out of range, or a name does not exist.
    """
    entries = fields.named(node, "solver", MOST_SOLVERS)
    return {name: _solver(entry, parameters, states) for name, entry in entries.items()}


def _solver(
    node: Node, parameters: Mapping[str, ParameterDefinition], states: Collection[str]
) -> SolverDefinition:
    entries = node.entries(*KEYS)
    kind = fields.chosen(fields.required(node, "solver"), "solver", SOLVERS)
    for key, solvers_with_it in ONLY.items():
        if key in entries and kind not in solvers_with_it:
            raise entries[key].refuse(f"`{key}` is for {', '.join(solvers_with_it)}, not for {kind}")
    if "anchor" in entries and kind == "look-at":
        raise entries["anchor"].refuse("look-at has no `anchor`: its chain turns where it is")
    weight = _weight(entries["weight"], parameters, states) if "weight" in entries else 1.0
    if "ease" in entries and not isinstance(weight, dict):
        raise entries["ease"].refuse("`ease` is for a weight by state; a parameter has `smooth` of its own")
    return SolverDefinition(
        line=node.line,
        solver=kind,
        chain=joints_of_chain(fields.required(node, "chain")),
        target=_vector(
            fields.required(node, "target"),
            parameters,
            ("point", "direction") if kind == "look-at" else ("point",),
        ),
        space="model" if "space" in entries and _space(entries["space"]) == "model" else "stage",
        pole=_pole(entries["pole"], parameters) if "pole" in entries else None,
        rotation=_rotation(entries["rotation"], parameters) if "rotation" in entries else None,
        weight=weight,
        ease=fields.seconds(entries["ease"]) if "ease" in entries else SolverDefinition.ease,
        travel=fields.seconds(entries["travel"]) if "travel" in entries else None,
        anchor=entries["anchor"].text() if "anchor" in entries else "",
        grab=_grab(entries["grab"], weight) if "grab" in entries else False,
        softening=entries["softening"].number(0, LARGEST) if "softening" in entries else 0.0,
        tolerance=entries["tolerance"].number(SMALLEST, LARGEST)
        if "tolerance" in entries
        else SolverDefinition.tolerance,
        iterations=fields.whole(entries["iterations"], 1, MOST_ITERATIONS)
        if "iterations" in entries
        else None,
        sensitivity={
            joint: entry.number(0, 1) for joint, entry in fields.mapping(entries.get("sensitivity")).items()
        },
        forward=_direction(entries["forward"]) if "forward" in entries else SolverDefinition.forward,
        cone_deg=entries["cone_deg"].number(0, 180) if "cone_deg" in entries else SolverDefinition.cone_deg,
    )


def _space(node: Node) -> str:
    return fields.chosen(node, "space", ("stage", "model"))


def _grab(node: Node, weight: object) -> bool:
    if node.truth() and (not isinstance(weight, str) or channel_of_name(weight)):
        raise node.refuse("`grab` needs a parameter as `weight`: it is 1 while the handle is dragged, else 0")
    return node.truth()


def joints_of_chain(node: Node) -> tuple[str, ...]:
    """Reads `[a, b, c]` or `{from: a, to: c}`.

    :raises MachineError: when it is neither, or has too many joints.
    """
    if isinstance(node.value, list):
        joints = node.items()
        if not 0 < len(joints) <= MOST_JOINTS:
            raise node.refuse(f"a chain has 1 to {MOST_JOINTS} joints, not {len(joints)}")
        return tuple(joint.text() for joint in joints)
    node.entries("from", "to")
    return fields.required(node, "from").text(), fields.required(node, "to").text()


def _vector(node: Node, parameters: Mapping[str, ParameterDefinition], kinds: tuple[str, ...]) -> str:
    """The name of a parameter of one of some kinds."""
    every = dict.fromkeys(written.vector or name for name, written in parameters.items())
    name = fields.chosen(node, "parameter", every)
    found = next(written for key, written in parameters.items() if name in (key, written.vector))
    if found.kind not in kinds:
        raise node.refuse(f"{name} is a {found.kind}; a parameter of kind {' or '.join(kinds)} is needed")
    return name


def _pole(node: Node, parameters: Mapping[str, ParameterDefinition]) -> str | tuple[float, float, float]:
    if isinstance(node.value, list):
        return _direction(node)
    return _vector(node, parameters, ("point", "direction"))


def _rotation(
    node: Node, parameters: Mapping[str, ParameterDefinition]
) -> str | tuple[float, float, float, float]:
    if not isinstance(node.value, list):
        return _vector(node, parameters, ("rotation",))
    numbers = [part.number(-1, 1) for part in node.items()]
    try:
        x, y, z, w = fitting("rotation", "rotation", numbers)
    except ValueError as error:
        raise node.refuse(str(error)) from None
    return x, y, z, w


def _direction(node: Node) -> tuple[float, float, float]:
    x, y, z = fields.point(node)
    if max(abs(x), abs(y), abs(z)) < 1e-6:
        raise node.refuse("a direction needs a length above 0")
    return x, y, z


def _weight(
    node: Node, parameters: Mapping[str, ParameterDefinition], states: Collection[str]
) -> float | str | dict[str, float | str]:
    """A number 0…1, a parameter or a channel, or one of them by state."""
    if isinstance(node.value, str):
        return _one_weight(node, parameters)
    entries = node.entries()
    for name, entry in entries.items():
        if name not in states:
            raise entry.unknown("state", name, states)
    return {name: _one_weight(entry, parameters) for name, entry in entries.items()}


def _one_weight(node: Node, parameters: Mapping[str, ParameterDefinition]) -> float | str:
    if node.text() in parameters:
        return _vector(node, parameters, ("number", "flag"))
    if channel := channel_of_name(node.text()):
        if channel[1] in (*ANGLES, LENGTH):
            kind = "a length" if channel[1] == LENGTH else "an angle"
            raise node.refuse(
                f"{node.text()} is {kind}; weights are parameters, translations, scales and morph weights"
            )
        return node.text()
    if not node.text()[:1].isalpha():
        return node.number(0, 1)
    raise node.unknown("parameter", node.text(), parameters)
