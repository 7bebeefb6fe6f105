"""Writes small PNG files of each kind of pixel, byte by byte, for surface()."""
import struct
import zlib


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write(name, width, depth, colour, rows, palette=b""):
    """Rows of bytes, none of them filtered."""
    header = struct.pack(">IIBBBBB", width, len(rows), depth, colour, 0, 0, 0)
    data = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
    if palette:
        data += chunk(b"PLTE", palette)
    data += chunk(b"IDAT", zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))) + chunk(b"IEND", b"")
    with open(f"heights_{name}.png", "wb") as file:
        file.write(data)


GREY, RGB, PALETTE, GREY_ALPHA, RGB_ALPHA = 0, 2, 3, 4, 6
write("grey", 3, 8, GREY, [[0, 128, 255], [10, 20, 30]])
write("inverted", 3, 8, GREY, [[0, 128, 255], [10, 20, 30]])
write("white", 2, 8, GREY, [[255, 200], [250, 255]])
write("deep", 2, 16, GREY, [struct.pack(">HH", 1000, 40000), struct.pack(">HH", 65535, 300)])
write("bits", 2, 1, GREY, [[0b10000000], [0b01000000], [0b11000000]])
write("colour", 3, 8, RGB, [[255, 0, 0, 0, 255, 0, 0, 0, 255], [10, 20, 30, 1, 2, 3, 200, 100, 50]])
write("palette", 2, 8, PALETTE, [[0, 1], [2, 1]], bytes([255, 0, 0, 0, 255, 0, 10, 20, 30]))
write("clear", 2, 8, RGB_ALPHA, [[255, 255, 255, 128, 0, 0, 0, 0], [100, 100, 100, 255, 100, 100, 100, 10]])
write("grey_clear", 2, 8, GREY_ALPHA, [[10, 255, 20, 0], [30, 3, 40, 255]])
