/** Puts a .gltf, or a character file, and the files that it names into one .zip, which the server reads. */

import type { LocalFile } from "./localFiles";
import { type Packed, zipped } from "./zipped";

interface GltfJson {
  buffers?: { uri?: unknown }[];
  images?: { uri?: unknown }[];
}

/** The files that a .gltf names by relative paths. */
export interface Named {
  buffers: string[];
  images: string[];
}

/** What the server reads, and what a model may need beside itself. */
const CHARACTER_FILES = [".yaml", ".yml"];
const SINGLE = [".glb", ".vrm", ".gltf", ".md2", ".x", ".chunk", ".bvh", ".trc"];
/** Formats of other programs, which can also write a .glb. */
const FOREIGN = [
  ".fbx",
  ".obj",
  ".dae",
  ".blend",
  ".stl",
  ".ply",
  ".usd",
  ".usdz",
  ".3ds",
  ".ma",
  ".max",
  ".c4d",
];
export const MODELS = [...SINGLE, ".zip", ...CHARACTER_FILES];
export const PARTS = [".bin", ".png", ".jpg", ".jpeg", ".webp", ".ktx2", ".txt"];

const endsWith =
  (...ends: string[]) =>
  ({ path }: LocalFile): boolean =>
    ends.some((end) => path.toLowerCase().endsWith(end));
const isGltf = endsWith(".gltf");
const isCharacterFile = endsWith(...CHARACTER_FILES);
const isModel = endsWith(...MODELS);
const isForeign = endsWith(...FOREIGN);
const isPart = endsWith(...SINGLE, ...PARTS);
const folderOf = ({ path }: LocalFile): string => path.slice(0, path.length - nameOf(path).length);
const nameOf = (path: string): string => path.slice(path.lastIndexOf("/") + 1);

/** Returns the character file among several files, or else the model; throws if none or several of them are one. */
export function modelAmong(files: readonly LocalFile[]): LocalFile {
  const texts = files.filter(isCharacterFile);
  const models = texts.length ? texts : files.length > 1 ? files.filter(isModel) : files;
  const [model, second] = models;
  if (!model) throw new Error("None of these files is a model. Drop a .glb, or a .gltf with its files.");
  if (second)
    throw new Error(
      `Import one model at a time: ${nameOf(model.path)} and ${nameOf(second.path)} are two. ` +
        "The other files may be the .bin and the pictures of a .gltf, or what a .yaml names.",
    );
  if (isForeign(model))
    throw new Error(
      `${nameOf(model.path)} is of a format that statwalk does not read. Save it as .glb: Blender does, and most programs.`,
    );
  return model;
}

function relative(entries: unknown): string[] {
  const uris = Array.isArray(entries) ? entries.map((entry: { uri?: unknown } | null) => entry?.uri) : [];
  return uris.flatMap((uri) => {
    if (typeof uri !== "string" || /^[a-z][a-z0-9+.-]*:/i.test(uri)) return [];
    try {
      return [decodeURIComponent(uri)];
    } catch {
      return [uri];
    }
  });
}

/** Returns the files that the text of a .gltf names; none for text that is not JSON: the server says what is wrong. */
export function namedBy(text: string): Named {
  try {
    const gltf = JSON.parse(text) as GltfJson | null;
    return { buffers: relative(gltf?.buffers), images: relative(gltf?.images) };
  } catch {
    return { buffers: [], images: [] };
  }
}

/**
 * Returns the file for each named path: the one with this path beside the model, else the one with this name.
 * Files dropped one by one have lost their folders.
 */
export function placed(model: LocalFile, paths: readonly string[], files: readonly LocalFile[]): Packed[] {
  const folder = folderOf(model);
  return [...new Set(paths)].flatMap((path) => {
    const source =
      files.find((file) => file.path === folder + path.replace(/^\.\//, "")) ??
      files.find((file) => nameOf(file.path).toLowerCase() === nameOf(path).toLowerCase());
    return source ? [{ path, source }] : [];
  });
}

/** Returns the files that a character file may name, by their paths from its folder. */
function besideCharacterFile(main: LocalFile, files: readonly LocalFile[]): Packed[] {
  const folder = folderOf(main);
  return files
    .filter((file) => file === main || isPart(file))
    .filter(({ path }) => path.startsWith(folder))
    .map((source) => ({ path: source.path.slice(folder.length), source }));
}

/**
 * Returns the one file to upload: the model alone, a .zip of a .gltf with the files that it names, or a .zip of a
 * character file with the files beside it. Throws if a buffer of a .gltf is missing; what else is missing is for
 * the server to say.
 */
export async function oneFile(files: readonly LocalFile[]): Promise<File> {
  const model = modelAmong(files);
  if (isCharacterFile(model))
    return zipped(nameOf(model.path).replace(/\.ya?ml$/i, ".zip"), besideCharacterFile(model, files));
  const { buffers, images } = isGltf(model) ? namedBy(await model.file.text()) : { buffers: [], images: [] };
  if (!buffers.length && !images.length) return model.file;
  const others = placed(model, [...buffers, ...images], files);
  const missing = buffers.filter((path) => !others.some((other) => other.path === path));
  if (missing.length)
    throw new Error(
      `${nameOf(model.path)} needs ${missing.slice(0, 3).join(", ")}${missing.length > 3 ? " …" : ""}: ` +
        "drop or choose these files together with it.",
    );
  return zipped(nameOf(model.path).replace(/\.gltf$/i, ".zip"), [
    { path: nameOf(model.path), source: model },
    ...others,
  ]);
}
