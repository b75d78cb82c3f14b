"""An independent Modbus program for the tests: python3-pymodbus as client or server, in a process of its own.

  pymodbus_peer.py client HOST PORT     exercises a touchpad's registers, prints what it found as JSON
  pymodbus_peer.py server PORT SCENARIO a touchpad made of plain registers; good, warm, wrong-magic, wrong-version or
                                        short
"""
import json
import struct
import sys

MAGIC = [0x4659, 0x4454]
STATE, STATE_SIZE, COMMAND = 64, 26, 128


def client(host, port):
    from pymodbus.client import ModbusTcpClient
    from pymodbus.register_read_message import ReadWriteMultipleRegistersRequest

    link = ModbusTcpClient(host, port=int(port), timeout=2)
    assert link.connect()
    found = {}
    found["identity"] = link.read_holding_registers(0, 15, slave=1).registers
    cycle = ReadWriteMultipleRegistersRequest(read_address=STATE, read_count=STATE_SIZE, write_address=COMMAND,
                                              write_registers=[0, 1, 0xBEEF, 0, 0, 1000, 1, 0], unit=1)
    found["state"] = link.execute(cycle).registers
    found["bridge"] = struct.unpack(">f", struct.pack(">HH", *found["state"][6:8]))[0]

    def exception(answer):
        return getattr(answer, "exception_code", 0) if answer.isError() else 0

    found["coils"] = exception(link.read_coils(0, 1, slave=1))
    found["hole"] = exception(link.read_holding_registers(20, 1, slave=1))
    found["past_the_end"] = exception(link.read_holding_registers(160, 20, slave=1))
    found["read_only"] = exception(link.write_register(74, 5, slave=1))
    found["watchdog_too_short"] = exception(link.write_register(32, 5, slave=1))
    found["watchdog"] = exception(link.write_register(32, 200, slave=1))
    found["watchdog_reads"] = link.read_holding_registers(32, 1, slave=1).registers
    other = ModbusTcpClient(host, port=int(port), timeout=2)
    found["second_master"] = exception(other.write_registers(COMMAND, [0, 2], slave=1))
    found["second_reader"] = other.read_holding_registers(0, 2, slave=1).registers
    print(json.dumps(found))


def server(port, scenario):
    from pymodbus.datastore import ModbusSequentialDataBlock, ModbusServerContext, ModbusSlaveContext
    from pymodbus.server import StartTcpServer

    class Touchpad(ModbusSequentialDataBlock):
        def setValues(self, address, values):
            super().setValues(address, values)
            if address <= COMMAND + 2 < address + len(values):  # the nonce, echoed in the state
                super().setValues(STATE + 1, [self.getValues(COMMAND + 2, 1)[0]])
                for name in (STATE, STATE + 25, STATE + 9, STATE + 14):
                    super().setValues(name, [(self.getValues(name, 1)[0] + 1) % 65536])

    registers = [0] * (70 if scenario == "short" else 200)
    serial = b"PYMODBUS".ljust(16, b"\0")
    registers[0:15] = MAGIC + [0x0100, 0x0203] + list(struct.unpack(">8H", serial)) + [3, 2, 32]
    if scenario == "wrong-magic":
        registers[0] = 0x1234
    if scenario == "wrong-version":
        registers[2] = 0x0700
    if scenario != "short":
        registers[STATE + 4] = 0x0250  # switch-on disabled, voltage present, writes obeyed
        if scenario == "warm":
            registers[STATE + 4] |= 1 << 7  # close to the thermal limit
        registers[STATE + 6:STATE + 8] = struct.unpack(">HH", struct.pack(">f", 0.25))
        registers[STATE + 10:STATE + 13] = [1000, 2000, 3000]
    block = Touchpad(0, registers)
    StartTcpServer(context=ModbusServerContext(slaves=ModbusSlaveContext(hr=block, zero_mode=True), single=True),
                   address=("127.0.0.1", int(port)))


if __name__ == "__main__":
    {"client": client, "server": server}[sys.argv[1]](*sys.argv[2:])
