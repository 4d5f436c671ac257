/** A sentence for the user, or one with a button that does something about it. */
export type Notice = string | { text: string; words: string; act: () => void };
