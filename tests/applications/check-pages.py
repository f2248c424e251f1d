#!/usr/bin/env python3
"""Checks the pages of a printed booklet: each has content beyond its upper half, apart from the line that counts its parts,
and none has content below that line or in its margins.

Usage: check-pages.py FILE.pdf
Needs pdftoppm of poppler-utils. Prints one line per failure, and "N pages".
"""
import subprocess
import sys
import tempfile
import pathlib

RESOLUTION = 25.4  # pixels per inch: a pixel is a millimetre
TOP, BOTTOM, SIDE = 12, 15, 10  # margins of Booklet.css, in millimetres
FIRST_OF_STEPS = 2  # the cover and the parts list come before
LAST_LINE = 6 / 182  # the line that counts parts, as a share of a sheet
WHITE = 235


def read_gray(path):
    """The rows of a binary PGM file."""
    data = path.read_bytes()
    magic, width, height, maximum = data.split(maxsplit=4)[:4]
    assert magic == b"P5" and maximum == b"255"
    width, height = int(width), int(height)
    pixels = data[len(data) - width * height:]
    return [pixels[row * width:(row + 1) * width] for row in range(height)]


def find_lowest(rows):
    """The height of the content as a share of the page without its margins, without the number of the page."""
    inner = rows[TOP:len(rows) - BOTTOM]
    inner = inner[:round(len(inner) * (1 - LAST_LINE))]
    used = [index for index, row in enumerate(inner) if min(row) < WHITE]
    return (used[-1] + 1) / len(inner) if used else 0.0


def main():
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["pdftoppm", "-gray", "-r", str(RESOLUTION), sys.argv[1], folder + "/page"], check=True)
        pages = sorted(pathlib.Path(folder).glob("page-*.pgm"))
        for number, page in enumerate(pages, 1):
            rows = read_gray(page)
            share = find_lowest(rows)
            if number > FIRST_OF_STEPS and share < 0.5:
                failures.append(f"page {number} is filled to {100 * share:.0f} % only")
            if number > FIRST_OF_STEPS and min(rows[len(rows) - BOTTOM - 1]) < WHITE:
                failures.append(f"page {number} has content below its last line")
            if any(min(row[:SIDE - 2] + row[len(row) - SIDE + 2:]) < WHITE for row in rows):
                failures.append(f"page {number} has content in its margins")
    for failure in failures:
        print(failure)
    print(f"{len(pages)} pages")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
