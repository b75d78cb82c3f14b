// A Modbus cycle of the touchpad beside bare libmodbus on the same line, and at the speeds of real serial lines.
#include <array>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <thread>

#include <modbus/modbus.h>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/line_bridge.h"
#include "app/bench/parts/table.h"
#include "core/device/touchpad/modbus_touchpad.h"
#include "core/sim/server/touchpad_process.h"

namespace fyd::bench {
namespace {

constexpr int kWarmUp = 50;
int loopbackCycles() { return wholeOrQuick(3000, 100); }
int slowCycles() { return wholeOrQuick(300, 10); }
constexpr int kReadRegisters = 16;
constexpr int kWrittenRegisters = 8;
constexpr int kBaud = 115'200;  // of the pseudo-terminals, which ignore it

std::string scratch(const char* name) {
  return (std::filesystem::temp_directory_path() / fmt::format("fyd-bench-{}-{}", name, ::getpid())).string();
}

device::DeviceParameters patient() {
  device::DeviceParameters parameters;
  parameters.response_timeout_ms = 1000.0;
  return parameters;
}

device::ModbusAddress addressOf(const std::string& text) {
  auto address = device::parseModbusAddress(text);
  return address ? *address : device::ModbusAddress{};
}

/// Bare libmodbus: the cost of any client that uses it.
class Bare {
 public:
  explicit Bare(const device::ModbusAddress& address)
      : context_(address.tcp ? modbus_new_tcp("127.0.0.1", address.host.port)
                             : modbus_new_rtu(address.port.c_str(), address.baud, 'N', 8, 1)) {
    modbus_set_slave(context_, 1);
    modbus_set_response_timeout(context_, 1, 0);
    good_ = modbus_connect(context_) == 0;
  }
  ~Bare() {
    modbus_close(context_);
    modbus_free(context_);
  }
  Bare(const Bare&) = delete;
  Bare& operator=(const Bare&) = delete;
  bool operator()(int written, int read) {
    ++values_[1];
    return good_ && modbus_write_and_read_registers(context_, protocol::kCommandAddress, written, values_.data(),
                                                    protocol::kStateAddress, read, answer_.data()) == read;
  }

 private:
  modbus_t* context_;
  bool good_ = false;
  std::array<std::uint16_t, 16> values_{0, 0, 0, 0, 0, 1000, 1, 1};
  std::array<std::uint16_t, 32> answer_{};
};

struct Cycles {
  Quantiles us;
  double per_s = 0.0;
  double mean_age_ms = 0.0;  ///< of the newest encoder reading, over all moments of the run
  int failed = 0;
};

/// Cycles back to back. A reading is as old as its transaction was long when it arrives, and ages until the next.
template <class Cycle>
Cycles measure(int cycles, Cycle&& cycle) {
  Cycles out;
  for (int i = 0; i < kWarmUp; ++i) static_cast<void>(cycle());
  std::vector<double> ns = timeEach(cycles, [&] { out.failed += cycle() ? 0 : 1; });
  double total = 0.0;
  double age = 0.0;
  for (std::size_t i = 0; i + 1 < ns.size(); ++i) {
    total += ns[i];
    age += ns[i + 1] * (ns[i] + ns[i + 1] / 2.0);
  }
  out.per_s = 1e9 * static_cast<double>(ns.size() - 1) / total;
  out.mean_age_ms = age / total / 1e6;
  for (double& one : ns) one /= 1e3;
  out.us = quantiles(ns);
  return out;
}

std::vector<std::string> row(const std::string& line, const std::string& client, const std::string& registers,
                             const Cycles& cycles, const Cycles& baseline) {
  return {line,
          client,
          registers,
          number(cycles.us.p50),
          number(cycles.us.p99),
          number(cycles.per_s),
          number(cycles.us.p50 / baseline.us.p50),
          number(cycles.mean_age_ms),
          std::to_string(cycles.failed)};
}

/// The touchpad client as the station uses it, with one duty in each batch.
Cycles wholeClient(const device::ModbusAddress& address, int cycles) {
  device::ModbusTouchpad touchpad(address, patient());
  return measure(cycles, [&] {
    const std::array<device::VibrationDuty, 1> duties = {{{10.0, -10.0}}};
    touchpad.queueVibration(duties);
    return touchpad.exchange({.active = true}, Clock::now()).has_value();
  });
}

void addLine(Table& table, const std::string& line, const std::string& text, int cycles) {
  const device::ModbusAddress address = addressOf(text);
  const auto bare = [&](int written, int read) {
    Bare client(address);
    return measure(cycles, [&] { return client(written, read); });
  };
  const Cycles base = bare(kWrittenRegisters, kReadRegisters);
  table.rows.push_back(row(line, "bare libmodbus (baseline)", "16 + 8", base, base));
  {
    device::ModbusLink link(address, std::chrono::seconds(1), std::chrono::milliseconds(30));
    std::array<std::uint16_t, kWrittenRegisters> values{0, 0, 0, 0, 0, 1000, 1, 0};
    std::array<std::uint16_t, kReadRegisters> answer{};
    static_cast<void>(link.open());
    const Cycles ours = measure(cycles, [&] {
      ++values[1];
      return link.writeAndRead(protocol::kCommandAddress, values, protocol::kStateAddress, answer).has_value();
    });
    table.rows.push_back(row(line, "ModbusLink", "16 + 8", ours, base));
  }
  const Cycles whole_base = bare(kWrittenRegisters + 1, protocol::kStateRegisters);
  table.rows.push_back(row(line, "bare libmodbus (baseline)", "26 + 9", whole_base, whole_base));
  table.rows.push_back(row(line, "ModbusTouchpad", "26 + 9", wholeClient(address, cycles), whole_base));
}

double cpuShareAt250Hz(const device::ModbusAddress& address) {
  const auto cpu_s = [] {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  };
  const int exchanges = wholeOrQuick(500, 50);
  device::ModbusTouchpad touchpad(address, patient());
  const double before = cpu_s();
  const Instant start = Clock::now();
  for (int i = 1; i <= exchanges; ++i) {
    static_cast<void>(touchpad.exchange({}, Clock::now()));
    std::this_thread::sleep_until(start + i * touchpad.period());
  }
  return (cpu_s() - before) / toSeconds(Clock::now() - start);
}

}  // namespace

Table bench_modbus() {
  Table table{.subject = "modbus",
              .title = "One Modbus cycle (function 0x17) of the touchpad",
              .columns = {{"line", Role::group},
                          {"client", Role::method},
                          {"registers read + written", Role::group},
                          {"p50", "µs", Role::cost},
                          {"p99", "µs"},
                          {"cycles", "1/s"},
                          "p50 ratio",
                          {"mean age of an encoder reading", "ms"},
                          {"failed", "cycles", Role::error}},
              .rows = {},
              .notes = {}};
  sim::TouchpadProcessOptions options;
  options.modbus_tcp = protocol::parseEndpoint("127.0.0.1:0").value();
  options.modbus_rtu = scratch("rtu");
  auto process = sim::TouchpadProcess::start(options);
  if (!process) return table;
  const std::string tcp = (*process)->addresses()[0];
  addLine(table, "TCP loopback", tcp, loopbackCycles());
  addLine(table, "pseudo-terminal", fmt::format("modbus-rtu:{}:{}", options.modbus_rtu, kBaud), loopbackCycles());
  for (const int baud : {115'200, 1'000'000}) {
    const std::string path = scratch("bridge");
    auto bridge = LineBridge::start(options.modbus_rtu, path, baud);
    if (!bridge) continue;
    addLine(table, fmt::format("bridge at {} Bd", baud), fmt::format("modbus-rtu:{}:{}", path, kBaud), slowCycles());
  }
  table.notes = {
      "All clients speak with the same simulated touchpad in this process. The bridge delivers a group of bytes when "
      "its last bit would have come over a wire of that speed (10 bits a byte); its own sleeping adds about 0.1 ms.",
      "Mean age: over all moments of a run of cycles back to back, from the moment the request was sent.",
      fmt::format("CPU of the thread that exchanges at 250 Hz over TCP: {} % of a core.",
                  number(100.0 * cpuShareAt250Hz(addressOf(tcp))))};
  return table;
}

}  // namespace fyd::bench
