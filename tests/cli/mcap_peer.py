"""An MCAP reader for the tests, written from the format's public specification alone.

Reads front to back, checks every length, CRC, index and count against the records themselves, and returns the messages.
"""
import json
import struct
import zlib

MAGIC = b"\x89MCAP0\r\n"
(HEADER, FOOTER, SCHEMA, CHANNEL, MESSAGE, CHUNK, MESSAGE_INDEX, CHUNK_INDEX, ATTACHMENT, ATTACHMENT_INDEX, STATISTICS,
 METADATA, METADATA_INDEX, SUMMARY_OFFSET, DATA_END) = range(1, 16)


class Malformed(AssertionError):
    pass


def expect(condition, what):
    if not condition:
        raise Malformed(what)


class Fields:
    """Takes the fields of one record's content in their order."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def number(self, form):
        value, = struct.unpack_from("<" + form, self.data, self.at)
        self.at += struct.calcsize(form)
        return value

    def bytes(self, count):
        expect(self.at + count <= len(self.data), "a field reaches beyond its record")
        self.at += count
        return self.data[self.at - count:self.at]

    def string(self):
        return self.bytes(self.number("I")).decode("utf-8")

    def pairs(self, key, value):
        inner = Fields(self.bytes(self.number("I")))
        out = []
        while inner.at < len(inner.data):
            out.append((key(inner), value(inner)))
        return out

    def rest(self):
        return self.bytes(len(self.data) - self.at)

    def end(self):
        expect(self.at == len(self.data), f"{len(self.data) - self.at} bytes too many in a record")


def texts(fields):
    return dict(fields.pairs(Fields.string, Fields.string))


def records(data, at, end):
    while at < end:
        opcode, length = struct.unpack_from("<BQ", data, at)
        expect(at + 9 + length <= end, f"record {opcode} at {at} reaches beyond its section")
        yield opcode, at, 9 + length, Fields(data[at + 9:at + 9 + length])
        at += 9 + length


class File:
    def __init__(self, path):
        with open(path, "rb") as file:
            self.data = file.read()
        data = self.data
        expect(data[:8] == MAGIC and data[-8:] == MAGIC, "no magic at both ends")
        self.schemas, self.channels, self.messages = {}, {}, []
        self.chunks, self.attachments, self.metadata = {}, {}, {}
        self.read_data()
        self.read_summary()

    def take_schema(self, fields):
        schema = (fields.number("H"), fields.string(), fields.string(), fields.bytes(fields.number("I")))
        expect(schema[0] != 0, "schema 0")
        return schema

    def take_channel(self, fields):
        return (fields.number("H"), fields.number("H"), fields.string(), fields.string(), texts(fields))

    def read_chunk(self, at, length, fields):
        first, last, size, crc = (fields.number(form) for form in "QQQI")
        expect(fields.string() == "", "compressed")
        inside = fields.bytes(fields.number("Q"))
        fields.end()
        expect(len(inside) == size, "uncompressed size")
        expect(crc != 0 and crc == zlib.crc32(inside), "chunk CRC")
        index = {}
        for opcode, offset, _, record in records(inside, 0, len(inside)):
            if opcode == SCHEMA:
                schema = self.take_schema(record)
                expect(self.schemas.setdefault(schema[0], schema) == schema, "two schemas of one id")
            elif opcode == CHANNEL:
                channel = self.take_channel(record)
                expect(channel[1] in self.schemas, "channel before its schema")
                self.channels[channel[0]] = channel
            else:
                expect(opcode == MESSAGE, f"opcode {opcode} in a chunk")
                channel, sequence, logged, published = (record.number(form) for form in "HIQQ")
                expect(channel in self.channels, "message before its channel")
                expect(first <= logged <= last, "message outside its chunk's times")
                self.messages.append((self.channels[channel][2], sequence, logged, published, record.rest()))
                index.setdefault(channel, []).append((logged, offset))
        times = [time for entries in index.values() for time, _ in entries]
        expect((first, last) == ((min(times), max(times)) if times else (0, 0)), "chunk's times")
        self.chunks[at] = {"times": (first, last), "length": length, "size": size, "index": index, "offsets": {},
                           "index_length": 0}
        return self.chunks[at]

    def read_data(self):
        data, chunk, end = self.data, None, None
        for opcode, at, length, fields in records(data, 8, len(data) - 8):
            if at == 8:
                expect(opcode == HEADER, "the first record is no header")
                self.profile, self.library = fields.string(), fields.string()
            elif opcode == CHUNK:
                chunk = self.read_chunk(at, length, fields)
            elif opcode == MESSAGE_INDEX:
                channel = fields.number("H")
                entries = fields.pairs(lambda f: f.number("Q"), lambda f: f.number("Q"))
                expect(entries == chunk["index"][channel], "message index")
                expect(channel not in chunk["offsets"], "two indexes of one channel")
                chunk["offsets"][channel] = at
                chunk["index_length"] += length
            elif opcode == ATTACHMENT:
                content = fields.data
                logged, created, name, kind = fields.number("Q"), fields.number("Q"), fields.string(), fields.string()
                body = fields.bytes(fields.number("Q"))
                expect(fields.number("I") == zlib.crc32(content[:-4]), "attachment CRC")
                fields.end()
                self.attachments[at] = (length, logged, created, len(body), name, kind)
                self.attached = getattr(self, "attached", {}) | {name: body}
            elif opcode == METADATA:
                name = fields.string()
                self.metadata[at] = (length, name, texts(fields))
            else:
                expect(opcode == DATA_END, f"opcode {opcode} in the data section")
                end = at + length
                break
        expect(end is not None, "no end of the data")
        for each in self.chunks.values():
            expect(each["offsets"].keys() == each["index"].keys(), "a channel of a chunk has no index")
        self.summary_start = end

    def read_summary(self):
        data = self.data
        footer = len(data) - 8 - 9 - 20
        expect(struct.unpack_from("<BQ", data, footer) == (FOOTER, 20), "no footer at the end")
        start, offset_start, crc = struct.unpack_from("<QQI", data, footer + 9)
        expect(start == self.summary_start, "summary does not begin after the data")
        expect(crc != 0 and crc == zlib.crc32(data[start:footer + 9 + 16]), "summary CRC")
        groups, order, statistics, chunks, schemas, channels = {}, [], None, 0, set(), set()
        for opcode, at, length, fields in records(data, start, offset_start):
            if opcode not in groups:
                order.append(opcode)
                groups[opcode] = [at, 0]
            expect(order[-1] == opcode, "summary is not grouped")
            groups[opcode][1] += length
            if opcode == SCHEMA:
                schema = self.take_schema(fields)
                expect(self.schemas[schema[0]] == schema, "summary's schema differs")
                schemas.add(schema[0])
            elif opcode == CHANNEL:
                channel = self.take_channel(fields)
                expect(self.channels[channel[0]] == channel, "summary's channel differs")
                channels.add(channel[0])
            elif opcode == CHUNK_INDEX:
                times = (fields.number("Q"), fields.number("Q"))
                chunk = self.chunks[fields.number("Q")]
                expect((times, fields.number("Q")) == (chunk["times"], chunk["length"]), "chunk index")
                offsets = dict(fields.pairs(lambda f: f.number("H"), lambda f: f.number("Q")))
                expect(offsets == chunk["offsets"], "offsets of message indexes")
                expect(fields.number("Q") == chunk["index_length"], "length of message indexes")
                expect((fields.string(), fields.number("Q"), fields.number("Q")) == ("", chunk["size"], chunk["size"]),
                       "sizes in a chunk index")
                chunks += 1
            elif opcode == ATTACHMENT_INDEX:
                entry = self.attachments[fields.number("Q")]
                found = (*(fields.number("Q") for _ in range(4)), fields.string(), fields.string())
                expect(found == entry, "attachment index")
            elif opcode == METADATA_INDEX:
                entry = self.metadata[fields.number("Q")]
                expect((fields.number("Q"), fields.string()) == entry[:2], "metadata index")
            else:
                expect(opcode == STATISTICS and statistics is None, f"opcode {opcode} in the summary")
                statistics = [fields.number(form) for form in "QHIIIIQQ"]
                counts = dict(fields.pairs(lambda f: f.number("H"), lambda f: f.number("Q")))
            fields.end()
        expect(chunks == len(self.chunks) and schemas == set(self.schemas) and channels == set(self.channels),
               "summary is not complete")
        times = [message[2] for message in self.messages]
        expect(statistics == [len(self.messages), len(self.schemas), len(self.channels), len(self.attachments),
                              len(self.metadata), len(self.chunks), min(times), max(times)], "statistics")
        for channel, (_, _, topic, _, _) in self.channels.items():
            expect(counts[channel] == len(self.on(topic)), "messages of a channel")
        found = {}
        for kind, _, _, fields in records(data, offset_start, footer):
            expect(kind == SUMMARY_OFFSET, "no summary offset")
            opcode, at, length = (fields.number(form) for form in "BQQ")
            found[opcode] = [at, length]
        expect(found == groups, "summary offsets")

    def on(self, topic):
        return [message for message in self.messages if message[0] == topic]

    def json(self, topic):
        """(time in s since 1970, content) of each message."""
        return [(message[2] / 1e9, json.loads(message[4])) for message in self.on(topic)]
