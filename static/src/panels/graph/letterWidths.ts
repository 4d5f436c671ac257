/** Measures texts as the graph writes its labels. */

/** Of the letters whose widths are measured, pixels. */
const SIZE = 100;

/** Returns a function that gives the width of a text as a multiple of its letters' height, in the font of the page. */
export function letterWidths(): (text: string) => number {
  const pen = document.createElement("canvas").getContext("2d")!;
  pen.font = `500 ${SIZE}px ${getComputedStyle(document.body).fontFamily}`;
  const known = new Map<string, number>();
  return (text) => {
    const width = known.get(text) ?? pen.measureText(text).width / SIZE;
    known.set(text, width);
    return width;
  };
}
