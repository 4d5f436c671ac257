import { describe, expect, it } from "vitest";
import { GlbError, chunksOf, layoutOf, tickOf, view } from "./glb";

const gltf = {
  asset: { version: "2.0", extras: { tick: "0000000123" } },
  nodes: [{ children: [1], extras: { joints: 3 } }, { mesh: 0, translation: [1, 2, 3] }, { mesh: 0 }],
  meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2, material: 0 }] }],
  materials: [{ name: "skin" }],
  accessors: [
    { bufferView: 0, count: 3, type: "VEC3", componentType: 5126 },
    { bufferView: 0, byteOffset: 36, count: 3, type: "VEC3", componentType: 5126 },
    { bufferView: 1, count: 3, type: "SCALAR", componentType: 5123 },
    { bufferView: 0, byteOffset: 4, count: 1, type: "MAT4", componentType: 5126 },
  ],
  bufferViews: [{ byteOffset: 0 }, { byteOffset: 72 }],
};

function glb(document: object, bin: Uint8Array): ArrayBuffer {
  const text = JSON.stringify(document);
  const json = new TextEncoder().encode(text.padEnd(Math.ceil(text.length / 4) * 4));
  const buffer = new ArrayBuffer(28 + json.length + bin.length);
  const words = new DataView(buffer);
  [0x46546c67, 2, buffer.byteLength, json.length, 0x4e4f534a].forEach((word, i) =>
    words.setUint32(i * 4, word, true),
  );
  new Uint8Array(buffer).set(json, 20);
  words.setUint32(20 + json.length, bin.length, true);
  words.setUint32(24 + json.length, 0x004e4942, true);
  new Uint8Array(buffer).set(bin, 28 + json.length);
  return buffer;
}

const bin = new Uint8Array(80);
new Float32Array(bin.buffer, 0, 18).set(Array.from({ length: 18 }, (_, i) => i));
new Uint16Array(bin.buffer, 72, 3).set([0, 1, 2]);

describe("glb", () => {
  const chunks = chunksOf(glb(gltf, bin));

  it("finds the tick in the extras", () => expect(tickOf(chunks)).toBe(123));

  it("knows where each array lies", () => {
    const primitive = layoutOf(chunks).primitives[0]!;
    expect([...view(chunks.bin, primitive.normals!)].slice(0, 3)).toEqual([9, 10, 11]);
    expect([...view(chunks.bin, primitive.indices!)]).toEqual([0, 1, 2]);
  });

  it("reads an array with gaps", () => {
    const every2nd = { offset: 72, count: 2, size: 1, componentType: 5123, normalized: false, stride: 4 };
    expect([...view(chunks.bin, every2nd)]).toEqual([0, 2]);
  });

  it("hangs the nodes under their parents", () => {
    const { nodes, primitives } = layoutOf(chunks);
    expect([primitives[0]!.node, nodes[1]!.parent, nodes[1]!.translation]).toEqual([1, 0, [1, 2, 3]]);
  });

  it("knows whose each primitive is", () => {
    expect(layoutOf(chunks).primitives.map(({ actor }) => actor)).toEqual([0, -1]);
  });

  it("finds the matrices of each actor's joints", () => {
    const { actors } = layoutOf(chunks);
    expect(actors.map((matrices) => [...view(chunks.bin, matrices)])).toEqual([
      Array.from({ length: 16 }, (_, i) => i + 1),
    ]);
  });

  it("refuses what is cut short", () => {
    expect(() => chunksOf(glb(gltf, bin).slice(0, 100))).toThrow(GlbError);
  });
});
