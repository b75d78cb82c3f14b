#include "core/protocol/registers/register_map.h"

#include <fmt/format.h>

#include "core/protocol/registers/drive_state.h"

namespace fyd::protocol {
namespace {

std::string addresses(const RegisterInfo& info) {
  if (info.registers == 1) return fmt::format("{}", info.address);
  return fmt::format("{}–{}", info.address, info.address + info.registers - 1);
}

std::string scaled(const RegisterInfo& info) {
  if (info.unit.empty()) return "";
  return info.scale == 1.0 ? std::string(info.unit) : fmt::format("{} {}", info.scale, info.unit);
}

}  // namespace

const RegisterInfo* registerAt(std::uint16_t address) {
  for (const RegisterInfo& info : kRegisters) {
    if (address >= info.address && address < info.address + info.registers) return &info;
  }
  return nullptr;
}

std::string_view toString(RegisterType type) {
  switch (type) {
    case RegisterType::u16: return "uint16";
    case RegisterType::i16: return "int16";
    case RegisterType::u32: return "uint32";
    case RegisterType::f32: return "float32";
    case RegisterType::text: return "text";
    case RegisterType::duty_pair: return "2 × int8";
  }
  return "?";
}

std::string registerMapMarkdown() {
  std::string out = "| address | name | type | one step is | access | meaning |\n|---|---|---|---|---|---|\n";
  for (const RegisterInfo& info : kRegisters) {
    out += fmt::format("| {} | `{}` | {} | {} | {} | {} |\n", addresses(info), info.name, toString(info.type),
                       scaled(info), info.access == RegisterAccess::read ? "read" : "read, write", info.help);
  }
  out += "\n| number | state of the motors | bits of the status word |\n|---|---|---|\n";
  for (int i = 0; i < kDriveStates; ++i) {
    const auto state = static_cast<DriveState>(i);
    out += fmt::format("| {} | {} | 0x{:02X} |\n", i, toString(state), statusBits(state));
  }
  return out;
}

}  // namespace fyd::protocol
