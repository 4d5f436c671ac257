/** What the help says of the marks in cells and of the pointer. */

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
