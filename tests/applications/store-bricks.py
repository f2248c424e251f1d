"""Writes a file of stored bricks, in a row of cells in the largest grid.

usage: store-bricks.py FILE.osgt COUNT

The file is small even if there are many bricks, since all have the same colour. It is written by the description of the format
in BrickCodec.cpp and BrickRecords.h, without the library."""

import base64
import struct
import sys
import zlib

PART_BYTES = 48 * 1024
SCENE = """#Ascii Scene
#Version 162
#Generator OpenSceneGraph 3.6.5

osgLego::LegoNode {
  UniqueID 1
  Settings "64"
  StoredBricks %s
}
"""


def short(number):
    result = bytearray()
    while number > 127:
        result.append(number & 127 | 128)
        number >>= 7
    return bytes(result + bytes([number]))


def encode(count):
    colors = bytes(3 * count)
    data = short(0) + short(count) + colors
    version = struct.pack("<I", 1)
    grid = struct.pack("<3IB6d", 1024, 1024, 2560, 2, 0, 0, 0, 1, 1, 1)
    rest = grid + struct.pack("<QQ", count, len(data)) + zlib.compress(data)
    return version + struct.pack("<I", zlib.crc32(version + rest)) + rest


def main():
    stored = encode(int(sys.argv[2]))
    parts = [base64.b64encode(stored[begin:begin + PART_BYTES]).decode() for begin in range(0, len(stored), PART_BYTES)]
    with open(sys.argv[1], "w") as file:
        file.write(SCENE % " ".join([str(len(parts)), *parts]))


main()
