/** Plays a short tone for every action; the pitch depends on the name, so that you can tell actions apart. */

/** Semitones of a pentatonic scale: any two of its tones are in harmony. */
const SCALE = [0, 2, 4, 7, 9];
const LOWEST_HZ = 330;
const OCTAVES = 2;
const SECONDS = 0.35;
const LOUDNESS = 0.12;
const STORED = "statwalk.muted";

/** Returns the pitch of a name, Hz. */
export function pitchOf(name: string): number {
  let hash = 2166136261;
  for (const letter of name) hash = Math.imul(hash ^ letter.codePointAt(0)!, 16777619) >>> 0;
  const step = hash % (SCALE.length * OCTAVES);
  return LOWEST_HZ * 2 ** (Math.floor(step / SCALE.length) + SCALE[step % SCALE.length]! / 12);
}

export class Sounds {
  private context: AudioContext | null = null;

  /** True until the user asks for sound. */
  get muted(): boolean {
    return localStorage.getItem(STORED) !== "no";
  }

  set muted(value: boolean) {
    localStorage.setItem(STORED, value ? "yes" : "no");
  }

  /** Plays the tone of `name`, if the user has clicked or typed before: browsers are silent until then. */
  play(name: string): void {
    if (this.muted || !navigator.userActivation.hasBeenActive) return;
    this.context ??= new AudioContext();
    const now = this.context.currentTime;
    const tone = new OscillatorNode(this.context, { type: "triangle", frequency: pitchOf(name) });
    const volume = new GainNode(this.context, { gain: LOUDNESS });
    volume.gain.exponentialRampToValueAtTime(1e-4, now + SECONDS);
    tone.connect(volume).connect(this.context.destination);
    tone.start(now);
    tone.stop(now + SECONDS);
  }
}
