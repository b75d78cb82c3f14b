"""The kinds of hostile files. Each takes (random, good recording, file to make, file nobody may see) and makes the file;
returns whether it is still a sound recording, with something strange beside what belongs to it."""
import os
import shutil
import struct
import zlib

import h5py
import numpy

import hostile_bytes

BAIT = ("secret", "pipe")
TABLES = ("commits", "telemetry", "inputs/steps", "motors", "inputs/finger", "inputs/ir", "events", "notes/index", "notes/text",
          "link", "camera/index", "camera/bytes", "overview/rows_25", "overview/rows_1000")
BYTES = ("notes/text", "camera/bytes")
TEXTS = ("header/profile", "header/touchpad", "header/program", "header/id")
TABLE_COUNT = 24
PLACE = {"telemetry": 0, "steps": 1, "motors": 2, "events": 13, "notes": 14, "note_text": 15, "link": 16, "pictures": 17,
         "picture_bytes": 18}


def opened(good, out):
    shutil.copyfile(good, out)
    return h5py.File(out, "r+", libver=("v110", "v110"))


def anew(file, name, properties, space, kind=None):
    """Puts another dataset in the place of one."""
    kind = kind if kind is not None else file[name].id.get_type()
    del file[name]
    links = h5py.h5p.create(h5py.h5p.LINK_CREATE)
    links.set_create_intermediate_group(True)
    return h5py.h5d.create(file.id, name.encode(), kind, space, properties, links)


def chunked(*rows):
    properties = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
    properties.set_chunk(rows)
    return properties


def growing(rows):
    return h5py.h5s.create_simple((rows,), (h5py.h5s.UNLIMITED,))


def like(file, name):
    return file[name].id.get_create_plist()


def pipe_beside(secret):
    pipe = os.path.join(os.path.dirname(secret), "pipe")
    os.mkfifo(pipe)
    return pipe


def huge_commits(random, good, out, secret):
    with opened(good, out) as file:
        rows = random.choice([1 << 20, 1 << 32, 1 << 40, 1 << 55, (1 << 63) - 2])
        anew(file, "commits", like(file, "commits"), growing(rows))
    return False


def huge_commits_with_a_last_row(random, good, out, secret):
    with opened(good, out) as file:
        last = file["commits"][-1:]
        rows = random.choice([1 << 20, 1 << 26, 1 << 33])
        anew(file, "commits", like(file, "commits"), growing(rows))
        file["commits"][rows - 1:] = last
    return False


def huge_commits_in_a_file_of_holes(random, good, out, secret):
    huge_commits(random, good, out, secret)
    os.truncate(out, 1 << random.choice([34, 38, 41]))
    return False


def huge_table(random, good, out, secret):
    with opened(good, out) as file:
        name = random.choice(TABLES[1:])
        file[name].resize((random.choice([1 << 33, 1 << 45, 1 << 60]),))
    return True  # beyond the last commit anything may stand; only lists may not claim so much


def lying_damaged_commit(random, good, out, secret):
    """As lying_commit, but its own checksum is wrong, as a bad disk leaves it."""
    return lying_commit(random, good, out, secret, sealed=False)


def lying_commit(random, good, out, secret, sealed=True):
    """A commit whose own checksum is right, which counts rows that are not there."""
    with opened(good, out) as file:
        commits = file["commits"]
        which = random.choice(["telemetry", "events", "notes", "pictures", "picture_bytes", "note_text", "all"])
        rows = random.choice([1 << 31, 1 << 44, 1 << 58])
        for set_ in [d for d in every_table(file) if d.name != "/commits"]:
            set_.resize((max(rows, len(set_)),))
        last = commits[-1:]
        for place in range(TABLE_COUNT) if which == "all" else [PLACE[which]]:
            last["rows"][0][place] = rows
        if which == "telemetry":
            last["rows"][0][:3] = rows
        last["number"] = len(commits)
        last["crc"] = [[random.getrandbits(32) for _ in range(TABLE_COUNT)]]
        commits.resize((len(commits) + 1,))
        commits[-1:] = hostile_bytes.sealed(last) if sealed else last
    return False


def every_table(file):
    found = []
    file.visititems(lambda name, o: found.append(o) if isinstance(o, h5py.Dataset) and o.chunks else None)
    return found


def external_storage(random, good, out, secret):
    with opened(good, out) as file:
        name = random.choice(BYTES + TABLES + TEXTS)
        kind = file[name].id.get_type()
        source = random.choice([secret, secret, pipe_beside(secret), "/dev/zero", "/dev/random", "/dev/tty", "/proc/self/mem"])
        size = os.path.getsize(secret) if source == secret else 1 << 20
        properties = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
        properties.set_external(source.encode(), 0, h5py.h5f.UNLIMITED)
        space = h5py.h5s.create(h5py.h5s.SCALAR) if name in TEXTS else h5py.h5s.create_simple((size // kind.get_size(),))
        anew(file, name, properties, space, kind)
    return False


def external_bytes_of_a_secret(random, good, out, secret):
    """What `recover` once took along: the commit even says how many bytes to copy."""
    with opened(good, out) as file:
        name = random.choice(["camera/bytes", "notes/text"])
        size = os.path.getsize(secret)
        properties = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
        properties.set_external(secret.encode(), 0, h5py.h5f.UNLIMITED)
        anew(file, name, properties, h5py.h5s.create_simple((size,)))
        with open(secret, "rb") as bait:
            crc = hostile_bytes.crc32c(bait.read(size))
        commits = file["commits"]
        last = commits[-1:]
        if name == "notes/text":
            note = numpy.zeros(1, file["notes/index"].dtype)
            note["text_bytes"] = size
            file["notes/index"].resize((1,))
            file["notes/index"][:] = note
            last["rows"][0][PLACE["notes"]] = 1
            last["crc"][0][PLACE["notes"]] = hostile_bytes.crc32c(note.tobytes())
        place = PLACE["note_text" if name == "notes/text" else "picture_bytes"]
        before = int(last["rows"][0][place])
        last["rows"][0][place] = size
        last["crc"][0][place] = crc if before == 0 else 0
        commits[-1:] = hostile_bytes.sealed(last)
    return False


def virtual_layout(random, good, out, secret):
    with opened(good, out) as file:
        name = random.choice(TABLES)
        set_ = file[name]
        source = random.choice([good, out, secret, pipe_beside(secret), "/dev/zero", "."])
        layout = h5py.VirtualLayout(shape=set_.shape, dtype=set_.dtype)
        if set_.shape[0] > 0:
            layout[:] = h5py.VirtualSource(source, name, shape=set_.shape)
        del file[name]
        file.create_virtual_dataset(name, layout)
    return False


def foreign_chunks(random, good, out, secret):
    with opened(good, out) as file:
        name = random.choice(TABLES)
        set_ = file[name]
        rows, kind, filters = set_[:], set_.dtype, {}
        rows_of_chunk = random.choice([1, 1_000_000, 7, 1 << 20])
        if kind.itemsize * rows_of_chunk >= 1 << 32:
            rows_of_chunk = 1_000_000
        if kind.itemsize < 2000 or rows_of_chunk < 1000:
            filters = {"compression": "gzip"}
        del file[name]
        made = file.create_dataset(name, shape=(0,), maxshape=(None,), dtype=kind, chunks=(rows_of_chunk,), **filters)
        if rows_of_chunk < 1000 or kind.itemsize < 1000:
            made.resize((len(rows),))
            made[:] = rows
    return False


def foreign_filters(random, good, out, secret):
    with opened(good, out) as file:
        name = random.choice(TABLES)
        set_ = file[name]
        rows, kind, chunk = set_[:], set_.dtype, set_.chunks
        filters = random.choice([{"compression": "gzip", "compression_opts": 9}, {"compression": "lzf"}, {"fletcher32": True},
                                 {"compression": "lzf", "shuffle": True}, {"compression": "gzip", "fletcher32": True}])
        del file[name]
        file.create_dataset(name, data=rows, maxshape=(None,), dtype=kind, chunks=chunk, **filters)
    return False


def unknown_filter(random, good, out, secret):
    with opened(good, out) as file:
        name = random.choice(TABLES)
        properties = chunked(*file[name].chunks)
        properties.set_filter(32_000 + random.randrange(700), h5py.h5z.FLAG_OPTIONAL, (1, 2, 3))
        anew(file, name, properties, growing(len(file[name])))
    return False


def contiguous_table(random, good, out, secret):
    with opened(good, out) as file:
        name = random.choice(TABLES)
        rows = file[name][:]
        del file[name]
        file.create_dataset(name, data=rows)
    return False


def soft_link(random, good, out, secret):
    with opened(good, out) as file:
        name = random.choice(TABLES + TEXTS + ("inputs", "header", "notes"))
        file.move(name, "elsewhere")
        file[name] = h5py.SoftLink(random.choice(["/elsewhere", "/" + name, "/nothing", "."]))
    return False


def external_link(random, good, out, secret):
    with opened(good, out) as file:
        name = random.choice(TABLES + TEXTS + ("inputs", "header", "notes"))
        del file[name]
        to = random.choice([good, out, secret, pipe_beside(secret), "/dev/zero", "/dev/tty"])
        file[name] = h5py.ExternalLink(to, name)
    return False


def wrong_kind(random, good, out, secret):
    with opened(good, out) as file:
        name = random.choice(TABLES + TEXTS + ("inputs", "header", "overview"))
        del file[name]
        what = random.randrange(4)
        if what == 0:
            file.create_group(name + "/deep")
        elif what == 1:
            file[name] = numpy.dtype([("a", "i4")])
        elif what == 2:
            file[name] = numpy.arange(12).reshape(3, 4)
        else:
            file.create_dataset(name, shape=(3, 3), maxshape=(None, None), chunks=(2, 2), dtype="f8")
    return False


def wrong_members(random, good, out, secret):
    with opened(good, out) as file:
        name = random.choice([t for t in TABLES if t not in BYTES])
        set_ = file[name]
        fields = [(n, set_.dtype[n].base.str, set_.dtype[n].shape) for n in set_.dtype.names]
        what = random.randrange(6)
        if what == 0:
            fields.pop(random.randrange(len(fields)))
        elif what == 1:
            fields.append(("one_more", "<f8", ()))
        elif what == 2:
            fields[0] = ("renamed", *fields[0][1:])
        elif what == 3:
            fields[0] = (fields[0][0], h5py.string_dtype(), ())
        elif what == 4:
            fields[-1] = (fields[-1][0], h5py.ref_dtype, ())
        else:
            fields[0] = (fields[0][0], ">f4", ())
        anew(file, name, like(file, name), growing(len(set_)), h5py.h5t.py_create(numpy.dtype(fields), logical=True))
    return False


def wrong_text(random, good, out, secret):
    with opened(good, out) as file:
        name = random.choice(TEXTS + ("header/step_state",))
        del file[name]
        what = random.randrange(4)
        if what == 0:
            file.create_dataset(name, data="x", dtype=h5py.string_dtype())  # of any length
        elif what == 1:
            kind = h5py.h5t.C_S1.copy()
            kind.set_size((1 << 32) - 1)
            h5py.h5d.create(file.id, name.encode(), kind, h5py.h5s.create(h5py.h5s.SCALAR))
        elif what == 2:
            file.create_dataset(name, shape=(1 << 40,), dtype="u1", chunks=(1 << 20,), maxshape=(None,))
        else:
            file.create_dataset(name, shape=(60_000_000,), dtype="S1" if name in TEXTS else "u1", chunks=(60_000_000,),
                                compression="gzip", fillvalue=b"a" if name in TEXTS else 7)[-1:] = b"a" if name in TEXTS else 7
    return False


def deep_nesting(random, good, out, secret):
    with opened(good, out) as file:
        group = file[random.choice(["/", "header", "inputs", "notes"])]
        for _ in range(random.choice([300, 3000])):
            group = group.create_group("g")
    return True


def cyclic_links(random, good, out, secret):
    with opened(good, out) as file:
        for name in ("header", "inputs", "camera", "notes"):
            file[name]["again"] = file["/"]
            file[name]["itself"] = file[name]
        file["round"] = h5py.SoftLink("/round")
        file["header/round"] = h5py.SoftLink("/inputs/round")
        file["inputs/round"] = h5py.SoftLink("/header/round")
    return True


def cyclic_table(random, good, out, secret):
    """A group in its own place on the way to a table."""
    with opened(good, out) as file:
        name = random.choice(["inputs", "header", "overview", "camera"])
        del file[name]
        file[name] = file["/"]
    return False


def absurd_attributes(random, good, out, secret):
    with opened(good, out) as file:
        what = random.randrange(4)
        if what == 0:
            for place in ("/", "telemetry", "header"):
                file[place].attrs.create("large", numpy.zeros(20_000_000, "u1"))
            return True
        if what == 1:
            for i in range(3000):
                file.attrs[f"a{i}"] = i
            return True
        name = random.choice(["fyd_recording", "started_ns", "header_crc32c"])
        del file.attrs[name]
        if what == 2:
            file.attrs.create(name, numpy.ones(10_000_000, "i8"))
        else:
            file.attrs.create(name, random.choice(["1", 1.5, [1, 1], h5py.Empty("i8")]))
    return False


def lying_index(random, good, out, secret):
    """The index of a table's chunks points anywhere; its own checksum is right."""
    shutil.copyfile(good, out)
    hostile_bytes.forge_block(out, random, random.choice([b"EAHD", b"EAIB", b"EADB", b"EASB"]))
    return False


def lying_object_header(random, good, out, secret):
    """Bytes of an object's header are anything; its checksum is right."""
    shutil.copyfile(good, out)
    hostile_bytes.forge_block(out, random, b"OHDR")
    return True  # it may be a byte that nobody reads


def deflate_bomb(random, good, out, secret):
    """A chunk of ours that unpacks to a thousand times its size."""
    with opened(good, out) as file:
        name = random.choice(["telemetry", "inputs/steps", "motors", "overview/rows_25"])
        packer = zlib.compressobj(9)
        bomb = b"".join(packer.compress(bytes(1 << 20)) for _ in range(600)) + packer.flush()
        for chunk in range(0, len(file[name]), file[name].chunks[0]):
            file[name].id.write_direct_chunk((chunk,), bomb[:random.choice([len(bomb), 100_000, 200])])
    return False


def png(width, height, body):
    def part(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    return (b"\x89PNG\r\n\x1a\n" + part(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) + part(b"IDAT", body)
            + part(b"IEND", b""))


def jpeg_segment(marker, data):
    return b"\xff" + bytes([marker]) + struct.pack(">H", len(data) + 2) + data


QUANTIZATION = jpeg_segment(0xdb, b"\x00" + b"\x01" * 64)


def progressive_jpeg(side, scans):
    """One component, and scans without end: each takes as long as the whole picture."""
    return (QUANTIZATION + jpeg_segment(0xc2, struct.pack(">BHHB", 8, side, side, 1) + b"\x01\x11\x00")
            + jpeg_segment(0xda, b"\x01\x01\x00\x00\x00\x00") * scans)


def baseline_jpeg(side, scans):
    """Three components, each scan of one of them, empty; its tables hold one code each."""
    code = bytes([1] + [0] * 15) + b"\x00"
    head = (QUANTIZATION + jpeg_segment(0xc0, struct.pack(">BHHB", 8, side, side, 3) + b"\x01\x11\x00\x02\x11\x00\x03\x11\x00")
            + jpeg_segment(0xc4, b"\x00" + code) + jpeg_segment(0xc4, b"\x10" + code))
    return b"\xff\xd8" + head + b"".join(jpeg_segment(0xda, bytes([1, 1 + i % 3, 0, 0, 63, 0])) for i in range(scans)) + b"\xff\xd9"


def commit_more(file, *tables):
    """One commit more, with these rows of (dataset, rows, its name in PLACE) and their checksums."""
    commits = file["commits"]
    last = commits[-1:]
    last["crc"] = 0
    for set_, rows, name in tables:
        set_.resize((len(set_) + len(rows),))
        set_[-len(rows):] = rows
        last["rows"][0][PLACE[name]] = len(set_)
        last["crc"][0][PLACE[name]] = hostile_bytes.crc32c(rows.tobytes())
    last["number"] = len(commits)
    commits.resize((len(commits) + 1,))
    commits[-1:] = hostile_bytes.sealed(last)


def picture_bomb(random, good, out, secret):
    """Pictures that are vast when unpacked; every checksum of the recording is right."""
    what = random.randrange(6)
    side = random.choice([30_000, 32_000, 1_000_000, (1 << 31) - 1])
    packer = zlib.compressobj(9)
    body = b"".join(packer.compress(bytes(1 << 20)) for _ in range(300)) + packer.flush()
    if what == 0:
        bomb = png(side, side, body)
    elif what == 1:  # an endless number of scans of a progressive picture
        bomb = b"\xff\xd8" + progressive_jpeg(65_500, 10_000)
    elif what == 4:  # a small frame where the marker behind one without a length would lead, taken for a length
        bomb = b"\xff\xd8" + b"\xff\x01" + progressive_jpeg(5_000, 6_000)
        led_to = 4 + struct.unpack(">H", bomb[4:6])[0]
        bomb = bomb.ljust(led_to, b"\x00")[:led_to] + jpeg_segment(0xc0, struct.pack(">BHHB", 8, 8, 8, 1) + b"\x01\x11\x00")
    elif what == 5:
        bomb = baseline_jpeg(5_700, 100_000)
    elif what == 2:
        bomb = b"P6 %d %d 255\n" % (30_000, 30_000)
    else:
        bomb = (b"II*\x00\x08\x00\x00\x00\x04\x00" + b"".join(struct.pack("<HHII", tag, 4, 1, side)
                                                             for tag in (256, 257, 278, 279)) + bytes(4))
    with opened(good, out) as file:
        index, data = file["camera/index"], file["camera/bytes"]
        row = index[-1:]
        row["bytes_start"], row["whole_bytes"], row["region_bytes"] = len(data), len(bomb), len(bomb)
        row["region_width_px"] = row["region_x_px"] = row["region_height_px"] = random.choice([side, -side, 10])
        commit_more(file, (index, row, "pictures"), (data, numpy.frombuffer(bomb + bomb, "u1"), "picture_bytes"))
    return True  # as a recording it is sound


def overlapping_notes(random, good, out, secret):
    """Notes that all have one long text: gigabytes of words in a file of half a megabyte."""
    with opened(good, out) as file:
        index, text = file["notes/index"], file["notes/text"]
        notes = numpy.zeros(15_000, index.dtype)
        notes["text_start"], notes["text_bytes"] = len(text), 200_000
        commit_more(file, (index, notes, "notes"), (text, numpy.full(200_000, ord("n"), "u1"), "note_text"))
    return True  # every row and checksum is right


def unwritten_value(random, good, out, secret):
    """A value that says to be vast, of which the file holds nothing."""
    with opened(good, out) as file:
        if random.randrange(2) == 0:
            file.create_dataset("header/scene", shape=(1 << 31,), dtype="u1")
        else:
            del file["header/step_state"]
            file.create_dataset("header/step_state", shape=(64 << 20,), dtype="u1")
    return False


def lying_journal(random, good, out, secret):
    shutil.copyfile(good, out)
    pieces = random.choice([
        [(1 << 60, b"x" * 100)],
        [((1 << 64) - 50, b"x" * 100)],
        [(random.randrange(1 << 20, os.path.getsize(out)), os.urandom(3000)) for _ in range(200)],
        [(1 << 20, bytes(2048))],
        [(os.path.getsize(out), b"y" * 500_000)],
    ])
    hostile_bytes.put_journal(out, pieces)
    return True  # a piece may change nothing; what it changes is damage


def foreign_start(random, good, out, secret):
    what = random.randrange(5)
    if what == 0:  # groups of the oldest kind
        with h5py.File(out, "w", libver="earliest", userblock_size=1 << 20) as file, h5py.File(good) as from_:
            for name in from_:
                from_.copy(name, file)
            for name, value in from_.attrs.items():
                file.attrs[name] = value
        return False
    if what == 1:  # no user block
        with h5py.File(out, "w", libver=("v110", "v110")) as file, h5py.File(good) as from_:
            for name in from_:
                from_.copy(name, file)
            for name, value in from_.attrs.items():
                file.attrs[name] = value
        return False
    shutil.copyfile(good, out)
    hostile_bytes.forge_superblock(out, random)
    return False


def cyclic_old_index(random, good, out, secret):
    """A group of the oldest kind whose index is its own child."""
    with h5py.File(out, "w", libver="earliest", userblock_size=1 << 20) as file:
        for i in range(200):
            file.create_group(f"g{i}")
    hostile_bytes.make_trees_cyclic(out)
    return False


def hostile_header(random, good, out, secret):
    """The header's texts are what is hard for those who read them; its checksum is right."""
    with opened(good, out) as file:
        texts = {"profile": random.choice(["[" * 100_000, "a = " + "[" * 50_000, "kp = 1e999999\n", "[control]\nkp = nan\n",
                                           "\x00\xff" * 1000, "a=1\n" * 500_000]),
                 "surface": random.choice(["[" * 200_000, '{"a":' * 100_000, "null", "[1e400]"]),
                 "notes": "\x1b]0;x\x07\x00" + "n" * 5_000_000}
        which = random.choice([["profile"], ["surface"], ["notes"], ["step_state"]])
        for name in which:
            if name == "step_state":
                state = numpy.array(file["header/step_state"])
                for _ in range(random.choice([1, 50, 5000])):
                    state[random.randrange(len(state))] = random.randrange(256)
                file["header/step_state"][...] = state
            else:
                text = texts[name].encode("latin-1")
                kind = h5py.h5t.C_S1.copy()
                kind.set_size(len(text))
                kind.set_strpad(h5py.h5t.STR_NULLPAD)
                kind.set_cset(h5py.h5t.CSET_UTF8)
                del file["header/" + name]
                made = h5py.h5d.create(file.id, b"header/" + name.encode(), kind, h5py.h5s.create(h5py.h5s.SCALAR))
                made.write(h5py.h5s.ALL, h5py.h5s.ALL, numpy.array(text, f"S{len(text)}"), kind)
        hostile_bytes.seal_header(file)
    return True


def not_a_file(random, good, out, secret):
    what = random.randrange(5)
    if what == 0:
        os.mkfifo(out)
    elif what == 1:
        os.mkdir(out)
    elif what == 2:
        os.symlink(out, out)
    elif what == 3:
        os.symlink(pipe_beside(secret), out)
    else:
        os.symlink(random.choice(["/dev/zero", "/dev/random", "/dev/tty", "/proc/self/mem"]), out)
    return False


ALL = [huge_commits, huge_commits_with_a_last_row, huge_commits_in_a_file_of_holes, huge_table, lying_commit, lying_damaged_commit, external_storage,
       external_bytes_of_a_secret, virtual_layout, foreign_chunks, foreign_filters, unknown_filter, contiguous_table, soft_link,
       external_link, wrong_kind, wrong_members, wrong_text, deep_nesting, cyclic_links, cyclic_table, absurd_attributes,
       lying_index, lying_object_header, deflate_bomb, picture_bomb, overlapping_notes, unwritten_value,
       lying_journal, foreign_start, cyclic_old_index,
       hostile_header, not_a_file]
