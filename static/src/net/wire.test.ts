import { describe, expect, it } from "vitest";
import { WireError, isGlb, readPoseFrame } from "./wire";

const HEADER = 32;

/** A frame of one cast, written out by hand after the contract: n=2, J=1, W=1, L=1. */
function handmade(): ArrayBuffer {
  const floatCount = 2 * (3 + 4 + 3 + 1 + 7 + 1 + 1);
  const length = HEADER + 16 + floatCount * 4 + 2 * 4;
  const buffer = new ArrayBuffer(length);
  const words = new Uint32Array(buffer);
  words.set([0x31575453, 7, 42, 99, 0x89abcdef, 0x01234567, 1, length]);
  words.set([2, 1, 1, 1], 8);
  const values = new Float32Array(buffer, HEADER + 16, floatCount);
  for (let i = 0; i < floatCount; i++) values[i] = i;
  words.set([4, 5], 12 + floatCount);
  return buffer;
}

describe("readPoseFrame", () => {
  it("reads the header", () => {
    const frame = readPoseFrame(handmade());
    expect([frame.epoch, frame.tick, frame.head, frame.hash]).toEqual([7, 42, 99, "0123456789abcdef"]);
  });

  it("lays the arrays out in the contract's order", () => {
    const cast = readPoseFrame(handmade()).casts[0]!;
    const firsts = [
      cast.translation,
      cast.rotation,
      cast.scale,
      cast.weights,
      cast.root,
      cast.phase,
      cast.blend,
    ].map((a) => a[0]);
    expect(firsts).toEqual([0, 6, 14, 20, 22, 36, 38]);
    expect([...cast.state]).toEqual([4, 5]);
  });

  it("copies nothing", () => {
    const buffer = handmade();
    expect(readPoseFrame(buffer).casts[0]!.rotation.buffer).toBe(buffer);
  });

  it.each([
    ["a wrong magic", (b: ArrayBuffer) => new Uint32Array(b).set([1], 0)],
    ["a wrong length", (b: ArrayBuffer) => new Uint32Array(b).set([8], 7)],
    ["more joints than bytes", (b: ArrayBuffer) => new Uint32Array(b).set([1000], 9)],
    ["more casts than bytes", (b: ArrayBuffer) => new Uint32Array(b).set([2], 6)],
  ])("refuses %s", (_, spoil) => {
    const buffer = handmade();
    spoil(buffer);
    expect(() => readPoseFrame(buffer)).toThrow(WireError);
  });

  it("tells a GLB from a pose frame", () => {
    const glb = new Uint32Array([0x46546c67, 2, 12]).buffer;
    expect([isGlb(glb), isGlb(handmade())]).toEqual([true, false]);
  });
});
