import { unzipSync } from "three/examples/jsm/libs/fflate.module.js";
import { describe, expect, it } from "vitest";
import { modelAmong, namedBy, oneFile, placed } from "./modelFiles";
import type { LocalFile } from "./localFiles";

const local = (path: string, content = ""): LocalFile => ({
  path,
  file: new File([content], path.slice(path.lastIndexOf("/") + 1)),
});
const TEXT = JSON.stringify({
  buffers: [{ uri: "robot.bin" }, { uri: "data:;base64,AAAA" }],
  images: [{ uri: "textures/arm%201.png" }, { bufferView: 0 }],
});

describe("the files of a .gltf", () => {
  it("are the relative ones, without escapes", () => {
    expect(namedBy(TEXT)).toEqual({ buffers: ["robot.bin"], images: ["textures/arm 1.png"] });
  });

  it.each(["", "null", "[]", '{"buffers": 3}', '{"images": [null, 4]}'])("are none in %j", (text) => {
    expect(namedBy(text)).toEqual({ buffers: [], images: [] });
  });

  it("are found by name where the folders are lost", () => {
    const files = [local("robot.gltf"), local("Arm 1.PNG")];
    expect(placed(files[0]!, ["textures/arm 1.png"], files)).toEqual([
      { path: "textures/arm 1.png", source: files[1] },
    ]);
  });

  it("are found by path where two have the same name", () => {
    const files = [local("a/skin.png"), local("m/robot.gltf"), local("m/b/skin.png"), local("m/a/skin.png")];
    expect(placed(files[1]!, ["a/skin.png", "b/skin.png"], files).map(({ source }) => source)).toEqual([
      files[3],
      files[2],
    ]);
  });
});

describe("the file to upload", () => {
  it("is the model itself if it names no other file", async () => {
    const model = local("robot.gltf", "{}");
    expect(await oneFile([model])).toBe(model.file);
  });

  it("is a zip of a character file with what lies beside it", async () => {
    const files = [
      local("fox/fox.yaml", "model: fox.glb"),
      local("fox/fox.glb", "model"),
      local("fox/keys/walk.txt", "keys"),
      local("fox/picture.psd"),
      local("other.txt"),
    ];
    const zip = await oneFile(files);
    const entries = unzipSync(new Uint8Array(await zip.arrayBuffer()));
    expect(zip.name).toBe("fox.zip");
    expect(Object.keys(entries).sort()).toEqual(["fox.glb", "fox.yaml", "keys/walk.txt"]);
  });

  it("is a zip of the .gltf with its files, and no others", async () => {
    const files = [
      local("arm 1.png", "picture"),
      local("robot.gltf", TEXT),
      local("robot.bin", "numbers"),
      local("readme.txt", "words"),
    ];
    const zip = await oneFile(files);
    const entries = unzipSync(new Uint8Array(await zip.arrayBuffer()));
    const texts = Object.entries(entries).map(([path, bytes]) => [path, new TextDecoder().decode(bytes)]);
    expect(zip.name).toBe("robot.zip");
    expect(Object.fromEntries(texts)).toEqual({
      "robot.gltf": TEXT,
      "robot.bin": "numbers",
      "textures/arm 1.png": "picture",
    });
  });

  it("is refused if a buffer is missing, by its name", async () => {
    await expect(oneFile([local("robot.gltf", TEXT)])).rejects.toThrow("robot.gltf needs robot.bin");
  });

  it("is refused if two are models, or none", () => {
    expect(() => modelAmong([local("a.glb"), local("b.gltf")])).toThrow("a.glb and b.gltf");
    expect(() => modelAmong([local("a.png"), local("b.bin")])).toThrow("None of these files is a model");
  });

  it("of another program's format is refused with the way out, and any other single file is tried", () => {
    expect(() => modelAmong([local("walk.FBX")])).toThrow(
      "walk.FBX is of a format that statwalk does not read",
    );
    expect(modelAmong([local("robot.backup")]).path).toBe("robot.backup");
  });
});
