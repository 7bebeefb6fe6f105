"""Reads a single-channel OpenEXR file of scan lines of 32-bit floats, without or with ZIP compression, using only the
published file layout."""

import struct
import zlib

import numpy

LINES = {0: 1, 2: 1, 3: 16}  # lines of a block, by the number of the compression: none, ZIPS, ZIP


def _text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def _attributes(data):
    """Returns each attribute's bytes by name, and where the header ends."""
    found, at = {}, 8
    while data[at] != 0:
        name, at = _text(data, at)
        _, at = _text(data, at)
        size = struct.unpack_from("<i", data, at)[0]
        found[name], at = data[at + 4:at + 4 + size], at + 4 + size
    return found, at + 1


def _inflated(block):
    """Decompresses a block, whose bytes are stored as differences, the even ones first."""
    raw = numpy.frombuffer(zlib.decompress(block), numpy.uint8).astype(numpy.int64)
    raw[1:] -= 128
    plain = numpy.cumsum(raw).astype(numpy.uint8)
    half = (len(plain) + 1) // 2
    joined = numpy.empty_like(plain)
    joined[0::2], joined[1::2] = plain[:half], plain[half:]
    return joined.tobytes()


def read(data):
    """Returns the rows of numbers."""
    attributes, at = _attributes(data)
    left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    lines = LINES[attributes["compression"][0]]
    rows = numpy.empty((height, width), numpy.float32)
    for (offset,) in struct.iter_unpack("<Q", data[at:at + 8 * -(-height // lines)]):
        first, size = struct.unpack_from("<2i", data, offset)
        block = data[offset + 8:offset + 8 + size]
        count = min(lines, height - (first - top))
        plain = block if size == count * width * 4 else _inflated(block)
        rows[first - top:first - top + count] = numpy.frombuffer(plain, "<f4").reshape(count, width)
    return rows
