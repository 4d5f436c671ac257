import { unzipSync, zipSync } from "three/examples/jsm/libs/fflate.module.js";
import { describe, expect, it } from "vitest";
import type { LocalFile } from "./localFiles";
import { machineAmong } from "./machineFiles";

const local = (path: string, content: BlobPart = ""): LocalFile => ({
  path,
  file: new File([content], path.slice(path.lastIndexOf("/") + 1)),
});
const zip = (...paths: string[]): LocalFile =>
  local("door.zip", zipSync(Object.fromEntries(paths.map((path) => [path, new Uint8Array(3)]))));

describe("a machine among files", () => {
  it.each([["machine.yaml"], ["door/machine.yaml", "door/door.glb"]])("is a .zip of %s", async (...paths) => {
    const file = zip(...paths);
    expect(await machineAmong([file])).toBe(file.file);
  });

  it("is no .zip of a model, of another machine's text, or cut short", async () => {
    const cut = local("door.zip", zip("machine.yaml").file.slice(0, 40));
    for (const file of [zip("robot.gltf", "robot.bin"), zip("old-machine.yaml"), cut])
      expect(await machineAmong([file])).toBe(null);
  });

  it("is packed with all that its folder holds", async () => {
    const files = ["lamp/door.glb", "lamp/machine.yaml", "lamp/takes/a.bvh", "other.txt"].map((path) =>
      local(path),
    );
    const packed = await machineAmong(files);
    expect(packed?.name).toBe("lamp.zip");
    expect(Object.keys(unzipSync(new Uint8Array(await packed!.arrayBuffer()))).sort()).toEqual([
      "door.glb",
      "machine.yaml",
      "takes/a.bvh",
    ]);
  });

  it("is the outermost one", async () => {
    const packed = await machineAmong([local("a/b/machine.yaml", "inner"), local("a/machine.yaml", "outer")]);
    const entries = unzipSync(new Uint8Array(await packed!.arrayBuffer()));
    expect(new TextDecoder().decode(entries["machine.yaml"])).toBe("outer");
  });

  it("is a machine.yaml that was dropped by itself", async () => {
    expect((await machineAmong([local("machine.yaml")]))?.name).toBe("machine.zip");
  });

  it("is none among models", async () => {
    expect(await machineAmong([local("robot.gltf"), local("robot.bin")])).toBe(null);
  });
});
