"""Reads one channel of an OpenEXR file: scan lines of 32-bit floats, uncompressed, ZIPS or ZIP."""
import struct
import zlib

import numpy as np

LINES = {0: 1, 2: 1, 3: 16}  # lines of a block, by compression


def read_text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode("ascii"), end + 1


def read_header(data):
    attributes, at = {}, 8
    while data[at] != 0:
        name, at = read_text(data, at)
        _, at = read_text(data, at)
        (length,) = struct.unpack_from("<i", data, at)
        attributes[name] = data[at + 4:at + 4 + length]
        at += 4 + length
    return attributes, at + 1


def channel_names(chlist):
    names, at = [], 0
    while chlist[at] != 0:
        name, at = read_text(chlist, at)
        (kind,) = struct.unpack_from("<i", chlist, at)
        if kind != 2:
            raise ValueError(f"channel {name} is not of 32-bit floats")
        names.append(name)
        at += 16
    return names


def unpack(data, length):
    """Reverses ZIP's filter: bytes are stored as differences, the even ones before the odd ones."""
    if len(data) == length:
        return data
    steps = np.frombuffer(zlib.decompress(data), np.uint8).astype(np.int64)
    steps[1:] -= 128
    values = (np.cumsum(steps) & 255).astype(np.uint8)
    half = (len(values) + 1) // 2
    out = np.empty(len(values), np.uint8)
    out[0::2], out[1::2] = values[:half], values[half:]
    return out.tobytes()


def read(path, channel):
    """The channel as an array of rows."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:4] != b"\x76\x2f\x31\x01":
        raise ValueError(f"{path} is not an OpenEXR file")
    attributes, at = read_header(data)
    names = channel_names(attributes["channels"])
    compression = attributes["compression"][0]
    x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    lines = LINES[compression]
    picture = np.empty((height, width), np.float32)
    for (start,) in struct.iter_unpack("<Q", data[at:at + 8 * -(-height // lines)]):
        y, length = struct.unpack_from("<ii", data, start)
        count = min(lines, y1 - y + 1)
        block = unpack(data[start + 8:start + 8 + length], count * len(names) * width * 4)
        rows = np.frombuffer(block, "<f4").reshape(count, len(names), width)
        picture[y - y0:y - y0 + count] = rows[:, names.index(channel)]
    return picture
