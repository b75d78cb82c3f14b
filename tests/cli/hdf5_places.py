"""Where rows of a recording stand in its file, for the tests that damage them: hdf5_places.py FILE TABLE prints as JSON
the byte of each row of an uncompressed table, and how long a row is. Without TABLE: the byte at which the object header of
each table begins."""
import json
import sys

import h5py

with h5py.File(sys.argv[1], "r") as file:
    if len(sys.argv) == 2:
        headers = {}
        file.visititems(lambda name, item: headers.update({name: file.userblock_size + h5py.h5o.get_info(item.id).addr})
                        if isinstance(item, h5py.Dataset) else None)
        print(json.dumps(headers))
        sys.exit()
    table = file[sys.argv[2]]
    rows_in_chunk, row_bytes = table.chunks[0], table.dtype.itemsize
    start = file.userblock_size  # HDF5 counts from behind it
    print(json.dumps({"row_bytes": row_bytes, "rows": [
        start + table.id.get_chunk_info(row // rows_in_chunk).byte_offset + row % rows_in_chunk * row_bytes
        for row in range(len(table))]}))
