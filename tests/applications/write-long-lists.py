#!/usr/bin/env python3
"""Writes a model whose booklet has long lists of parts: a submodel of 112 to 224 parts, which hang from a beam on a column, and
other parts on the ground around it, all in many colours.

Usage: write-long-lists.py COLOURS.csv FILE.ldr
"""
import csv
import random
import sys

STUD, BRICK = 20, 24  # of LDraw
LAYERS = range(2, 16)  # of the parts that hang
random.seed(1)
colors = []
for row in csv.reader(line for line in open(sys.argv[1]) if not line.startswith("#")):
    colors += [int(row[0])] if row[0].isdigit() else []
lines = []


def place(design, x, height, z, turned=False, color=None):
    """Place a part. @param x,z its middle in studs. @param height in bricks. @param turned whether its long side is along Z."""
    rotation = "0 0 1 0 1 0 -1 0 0" if turned else "1 0 0 0 1 0 0 0 1"
    lines.append(f"1 {color or random.choice(colors)} {x * STUD:g} {-height * BRICK} {z * STUD:g} {rotation} {design}.dat")


for height in LAYERS:  # crossed layers of 8 x 16 studs
    for index in range(8):
        turned = height % 2 == 1
        middle = (index % 4 * 2 + 1, index // 4 * 8 + 4) if turned else (4, index * 2 + 1)
        if random.random() < 0.5:
            place(3007, middle[0], height, middle[1], turned)
            continue
        for shift in (-0.5, 0.5):
            place(3008, middle[0] + shift * turned, height, middle[1] + shift * (not turned), turned)
for height in range(LAYERS[-1] + 1):
    place(3003, -1, height, 7, color=4)
place(3007, 2, LAYERS[-1] + 1, 7, color=4)
for index in range(70):  # on the ground
    design = random.choice((3007, 3008))
    place(design, index % 10 * 9 - 36, 0, index // 10 * 3 + (20 if design == 3007 else 20.5))
open(sys.argv[2], "w").write("\n".join(lines) + "\n")
