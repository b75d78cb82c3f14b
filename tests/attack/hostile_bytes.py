"""Checksums and blocks of recordings and of HDF5, so that a lie looks like the truth."""
import struct

import numpy

JOURNAL_BYTES = 1 << 20
SIGNATURE = b"\x89HDF\r\n\x1a\n"


def _crc_table():
    table = []
    for byte in range(256):
        for _ in range(8):
            byte = byte >> 1 ^ (0x82F63B78 if byte & 1 else 0)
        table.append(byte)
    return table


_TABLE = _crc_table()


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc = crc >> 8 ^ _TABLE[(crc ^ byte) & 0xFF]
    return crc ^ 0xFFFFFFFF


def sealed(commit):
    """A row of /commits with its own checksum, its last four bytes."""
    commit["own_crc"] = crc32c(commit.tobytes()[:-4])
    return commit


def seal_header(file):
    """The checksum over the header's texts, as resources/manual/recording-format.md describes it."""
    def text(name):
        set_ = file["header/" + name]
        if set_.shape is None:
            return b""
        size = set_.id.get_type().get_size()
        out = numpy.zeros((), f"S{size}")
        set_.id.read(__import__("h5py").h5s.ALL, __import__("h5py").h5s.ALL, out, set_.id.get_type())
        return out.tobytes()
    parts = [b"1;%d;" % int(file.attrs["started_ns"])]
    for name in ("id", "started_utc", "operator", "subject", "notes", "touchpad", "camera", "robot", "profile", "surface",
                 "program", "tags"):
        value = text(name)
        parts.append(b"/header/%s:%d:%s;" % (name.encode(), len(value), value))
    state = file["header/step_state"][...].tobytes()
    parts.append(b"/header/step_state:%d:%s;" % (len(state), state))
    if file.attrs.get("arithmetic", 1) != 1:
        parts.append(b"arithmetic:%d;" % int(file.attrs["arithmetic"]))
    if "scene" in file["header"]:
        scene = file["header/scene"][...].tobytes()
        parts.append(b"/header/scene:%d:%d;" % (len(scene), crc32c(scene)))
    for name in ("lateness", "missing"):
        if name in file["header"] and (value := text(name)):
            parts.append(b"/header/%s:%d:%s;" % (name.encode(), len(value), value))
    file.attrs.modify("header_crc32c", numpy.int64(crc32c(b"".join(parts))))


def lookup3(data):
    """Bob Jenkins' hash, HDF5's checksum of its own blocks."""
    def rot(x, k):
        return (x << k | x >> (32 - k)) & 0xFFFFFFFF
    a = b = c = (0xDEADBEEF + len(data)) & 0xFFFFFFFF
    while len(data) > 12:
        a, b, c = ((x + y) & 0xFFFFFFFF for x, y in zip((a, b, c), struct.unpack("<III", data[:12])))
        a = (a - c) & 0xFFFFFFFF ^ rot(c, 4); c = (c + b) & 0xFFFFFFFF
        b = (b - a) & 0xFFFFFFFF ^ rot(a, 6); a = (a + c) & 0xFFFFFFFF
        c = (c - b) & 0xFFFFFFFF ^ rot(b, 8); b = (b + a) & 0xFFFFFFFF
        a = (a - c) & 0xFFFFFFFF ^ rot(c, 16); c = (c + b) & 0xFFFFFFFF
        b = (b - a) & 0xFFFFFFFF ^ rot(a, 19); a = (a + c) & 0xFFFFFFFF
        c = (c - b) & 0xFFFFFFFF ^ rot(b, 4); b = (b + a) & 0xFFFFFFFF
        data = data[12:]
    if not data:
        return c
    a, b, c = ((x + y) & 0xFFFFFFFF for x, y in zip((a, b, c), struct.unpack("<III", data.ljust(12, b"\0"))))
    for x, y, k in (("c", "b", 14), ("a", "c", 11), ("b", "a", 25), ("c", "b", 16), ("a", "c", 4), ("b", "a", 14), ("c", "b", 24)):
        value = {"a": a, "b": b, "c": c}
        value[x] = ((value[x] ^ value[y]) - rot(value[y], k)) & 0xFFFFFFFF
        a, b, c = value["a"], value["b"], value["c"]
    return c


def _length(data, at, most=700):
    """Of a block that ends in its checksum; nothing when it is longer than `most`."""
    for size in range(12, most):
        if at + size + 4 <= len(data) and struct.unpack_from("<I", data, at + size)[0] == lookup3(data[at:at + size]):
            return size
    return None


def forge_block(path, random, signature):
    """Some bytes of some of HDF5's blocks of a kind become anything; their checksums fit."""
    with open(path, "rb") as file:
        data = bytearray(file.read())
    places, at = [], data.find(signature, JOURNAL_BYTES)
    while at >= 0:
        places.append(at)
        at = data.find(signature, at + 1)
    random.shuffle(places)
    forged = 0
    for at in places:
        size = _length(bytes(data), at)
        if size is None:
            continue
        for _ in range(random.choice([1, 3])):
            length = random.choice([1, 2, 8])
            where = at + random.randrange(5, max(6, size - length))
            data[where:where + length] = random.choice([b"\xff" * length, bytes(length), random.randbytes(length)])
        struct.pack_into("<I", data, at + size, lookup3(bytes(data[at:at + size])))
        forged += 1
        if forged == 12:
            break
    if forged == 0 and signature != b"OHDR":
        forge_block(path, random, b"EAIB" if signature != b"EAIB" else b"OHDR")
        return
    with open(path, "wb") as file:
        file.write(data)


def forge_superblock(path, random):
    with open(path, "r+b") as file:
        if random.random() < 0.3:  # a second one, before
            file.seek(random.choice([0, 512, 4096, JOURNAL_BYTES // 2]))
            file.write(SIGNATURE + bytes([0]) * 88)
            return
        file.seek(JOURNAL_BYTES)
        block = bytearray(file.read(48))
        what = random.randrange(3)
        if what == 0:
            struct.pack_into("<Q", block, 12, random.choice([0, 512, 1 << 62]))  # where addresses count from
        elif what == 1:
            struct.pack_into("<Q", block, 20, random.choice([48, 1 << 40]))  # an extension
        else:
            block[8] = random.choice([0, 1, 2, 4, 255])
        struct.pack_into("<I", block, 44, lookup3(bytes(block[:44])))
        file.seek(JOURNAL_BYTES)
        file.write(block)


def make_trees_cyclic(path):
    """The first child of each node of HDF5's old B-trees becomes the node itself."""
    with open(path, "rb") as file:
        data = bytearray(file.read())
    at = data.find(b"TREE")
    while at >= 0:
        data[at + 5] = 1  # level: its children are nodes
        struct.pack_into("<Q", data, at + 24 + 8, at - JOURNAL_BYTES)
        at = data.find(b"TREE", at + 4)
    with open(path, "wb") as file:
        file.write(data)


def put_journal(path, pieces):
    body = b"".join(struct.pack("<QQ", at, len(data)) + data for at, data in pieces)[:JOURNAL_BYTES - 40]
    veiled = bytes(byte ^ 0xA5 for byte in body)
    numbers = struct.pack("<QQ", 7, len(veiled))
    with open(path, "r+b") as file:
        file.write(b"FYD journal 1\r\n\0" + numbers + struct.pack("<II", crc32c(numbers + veiled), 0) + veiled)
