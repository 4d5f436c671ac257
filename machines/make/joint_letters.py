"""The letters on the plinths of the joints, of small boxes."""

from shapes import Mesh, box, joined

SIZE = 0.028
"""metres: one box"""
LETTERS = {
    "R": ("##.", "#.#", "##.", "#.#", "#.#"),
    "P": ("##.", "#.#", "##.", "#..", "#.."),
    "H": ("#.#", "#.#", "###", "#.#", "#.#"),
    "1": (".#.", "##.", ".#.", ".#.", "###"),
    "2": ("##.", "..#", ".#.", "#..", "###"),
    "3": ("##.", "..#", ".#.", "..#", "##."),
    "~": ("...", ".##", "##.", "...", "..."),
}


def written(text: str) -> Mesh:
    """The text in boxes, around the origin, in the plane of X and Y."""
    boxes = []
    width = 4 * len(text) - 1
    for place, letter in enumerate(text):
        for row, line in enumerate(LETTERS[letter]):
            for column, mark in enumerate(line):
                if mark == "#":
                    x, y = 4 * place + column - (width - 1) / 2, 2 - row
                    boxes.append(box((SIZE, SIZE, 0.02), 0.002, 1).moved(x * SIZE, y * SIZE))
    return joined(*boxes)
