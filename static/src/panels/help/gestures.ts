/** What the help says of fixed keys, of the marks in cells and of the pointer. */

type Lines = readonly (readonly [string, string])[];

export const MARKS: Lines = [
  ["WALK", "the next state; the row's own state: stay"],
  ["WALK!", "its motion restarts"],
  ["–", "the event is dropped"],
  ["blank", "the event waits for its buffer"],
  ["⇥", "at the end of the motion"],
  ["⟂", "at a marker of the motion"],
  ["◫", "in a window of phases"],
  ["≈", "entered at the same phase"],
  ["↦", "entered at this phase"],
  ["◆", "with an action"],
  ["⑂ 2", "alternatives: conditions or chance"],
];

/** Keys that can't be changed: they act where the focus is. */
export const FOCUSED: Lines = [
  ["ctrl Z", "undo: the version before"],
  ["ctrl Y", "redo; ctrl shift Z, too"],
  ["alt Enter", "inspect the focused cell or state"],
  ["arrows", "in the table: the next cell; in the graph: the next state"],
  ["Enter", "in the table: edit the cell; in the graph: open the state"],
  ["N, P", "in the graph: the state's arrows"],
  ["A", "in the graph: a new arrow"],
  ["Delete", "in the graph: delete the arrow's cell"],
  ["T", "in the graph: travel there, or unfold"],
  ["shift arrows", "in the graph: move the state"],
  ["ctrl S", "in the YAML: keep the text"],
  ["Esc", "close, drop what is typed"],
];

export const POINTER: Lines = [
  ["drag", "turn around the character"],
  ["right drag", "move sideways and up"],
  ["wheel", "nearer, farther"],
  ["cell", "edit it: STATE, STATE!, -, STATE at end"],
  ["state, twice", "travel there by the fastest events"],
  ["timeline", "drag: the past; click: why?"],
  ["shift drag", "on the timeline: select a span"],
  ["wheel", "on the timeline: zoom; with shift: move"],
];
