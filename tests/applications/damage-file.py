#!/usr/bin/env python3
"""Writes damaged copies of a file, damaged-N.EXTENSION: one half of them cut off, the other half with changed bytes.

Usage: damage-file.py FILE COUNT
"""

import os
import random
import sys


def main():
    name, count = sys.argv[1], int(sys.argv[2])
    extension = os.path.splitext(name)[1]
    with open(name, "rb") as file:
        content = file.read()
    chance = random.Random(name)
    for number in range(count):
        if number % 2 == 0:
            damaged = bytearray(content[:chance.randrange(1, len(content))])
        else:
            damaged = bytearray(content)
            for _ in range(chance.choice([1, 4, 16])):
                damaged[chance.randrange(len(damaged))] = chance.randrange(256)
        with open(f"damaged-{number}{extension}", "wb") as file:
            file.write(damaged)


main()
