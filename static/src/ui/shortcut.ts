/** Keys of the viewer, what they do, and their words in the help. */
export interface Shortcut {
  keys: readonly [string, ...string[]];
  words: string;
  act: () => void;
}
