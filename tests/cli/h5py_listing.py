"""Prints how a recording is laid out, a line for each object, column and attribute; run by Debian's Python.

As `h5dump -A -p` would, without what differs from file to file: lengths, values of the header, addresses.
"""
import sys

import h5py


def of_type(kind):
    base, shape = (kind.subdtype if kind.subdtype else (kind, ()))
    words = "text" if base.kind == "S" else base.str
    return words + (f"[{shape[0]}]" if shape else "")


def attributes(thing):
    for name in sorted(thing.attrs):
        if name == "units":
            units = ", ".join(unit.decode() or "-" for unit in thing.attrs[name])
            yield f"  @{name} text[{len(thing.attrs[name])}]: {units}"
        else:
            yield f"  @{name} {of_type(thing.attrs.get_id(name).dtype)}"


def listing(file):
    found = {"/": file}
    file.visititems(lambda name, thing: found.update({"/" + name: thing}))
    shown = {}  # lists of columns -> the first table that has them
    for path in sorted(found):
        thing = found[path]
        if isinstance(thing, h5py.Group):
            yield f"{path} group"
        elif thing.chunks is None:
            yield f"{path} {of_type(thing.dtype)}"
        else:
            filters = [plist.get_filter(i)[0] for plist in [thing.id.get_create_plist()] for i in range(plist.get_nfilters())]
            yield f"{path} rows of {thing.dtype.itemsize} bytes, chunks of {thing.chunks[0]}, filters {filters}"
            columns = []
            for name in thing.dtype.names or ():
                kind, offset = thing.dtype.fields[name][:2]
                columns.append(f"  {name} {of_type(kind)} at {offset}")
            columns = "\n".join([*columns, *attributes(thing)])
            if columns:
                yield columns if columns not in shown else f"  columns of {shown[columns]}"
                shown.setdefault(columns, path)
            continue
        yield from attributes(thing)


with h5py.File(sys.argv[1], "r") as recording:
    print("\n".join(listing(recording)))
