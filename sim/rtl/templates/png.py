"""png.py PICTURE.ppm PICTURE.png: converts a picture of bytes (P6) to PNG."""

import re
import struct
import sys
import zlib


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def main():
    source, target = sys.argv[1:]
    with open(source, "rb") as file:
        content = file.read()
    head = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", content)
    width, height = int(head[1]), int(head[2])
    pixels = content[head.end():]
    if len(pixels) != 3 * width * height:
        sys.exit(f"{source}: the picture has {len(pixels)} bytes instead of {3 * width * height}; make it again")
    rows = b"".join(b"\0" + pixels[3 * width * y:3 * width * (y + 1)] for y in range(height))
    with open(target, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


main()
