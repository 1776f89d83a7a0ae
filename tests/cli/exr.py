"""OpenEXR files of the program, read: scan lines, 32-bit floats, compressed by zip or not at all."""
import array
import itertools
import struct
import zlib

LINES = {0: 1, 2: 1, 3: 16}  # of a block, by compression: none, zips, zip


def _text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def _attributes(data, at):
    found = {}
    while data[at]:
        name, at = _text(data, at)
        _, at = _text(data, at)
        size, = struct.unpack_from("<i", data, at)
        found[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    return found, at + 1


def _unzipped(data, size):
    if len(data) == size:  # what does not compress stands as it is
        return data
    halves = bytes(itertools.accumulate(zlib.decompress(data), lambda a, b: (a + b - 128) & 255))
    out = bytearray(size)
    out[0::2], out[1::2] = halves[:(size + 1) // 2], halves[(size + 1) // 2:]
    return bytes(out)


def names(path):
    """Names of channels, in the order of the file."""
    with open(path, "rb") as file:
        return _header(file.read())[0]


def _header(data):
    assert data[:4] == b"\x76\x2f\x31\x01", "no OpenEXR"
    header, at = _attributes(data, 8)
    left, top, right, bottom = struct.unpack("<4i", header["dataWindow"])
    found, place = [], 0
    while header["channels"][place]:
        name, place = _text(header["channels"], place)
        kind, = struct.unpack_from("<i", header["channels"], place)
        assert kind == 2, f"{name} is no float"
        found.append(name)
        place += 16
    return found, right - left + 1, bottom - top + 1, LINES[header["compression"][0]], at


def read(path):
    """Channels by name, in the order of the file: rows from the top, each an array of floats."""
    with open(path, "rb") as file:
        data = file.read()
    found, width, height, lines, at = _header(data)
    planes = {name: [] for name in found}
    for block in range((height + lines - 1) // lines):
        place, = struct.unpack_from("<q", data, at + 8 * block)
        first, size = struct.unpack_from("<2i", data, place)
        count = min(lines, height - first)
        values = array.array("f", _unzipped(data[place + 8:place + 8 + size],
                                            4 * width * count * len(found)))
        for row in range(count):
            for i, name in enumerate(found):
                start = (row * len(found) + i) * width
                planes[name].append(values[start:start + width])
    return planes
