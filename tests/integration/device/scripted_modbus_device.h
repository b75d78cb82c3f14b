// A Modbus TCP device whose answers a test scripts; it uses only libmodbus, nothing of the project's server.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <thread>

#include <modbus/modbus.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "core/protocol/registers/drive_state.h"
#include "core/protocol/registers/register_codec.h"

namespace fyd::device {

class ScriptedModbusDevice {
 public:
  static constexpr int kClose = -1;    ///< closes the connection in place of an answer
  static constexpr int kSilence = -2;  ///< sends no answer
  static constexpr int kTrickle = -3;  ///< begins an answer, a byte every 20 ms, and does not end it
  /// Called for each transaction of function 0x17 with its number from 1, after the write took effect.
  /// @return 0, or an exception code, or one of the above
  using Script = std::function<int(ScriptedModbusDevice& device, int transaction)>;

  explicit ScriptedModbusDevice(Script script) : script_(std::move(script)) {
    identity.setSerial("SCRIPTED");
    state.status_word = protocol::statusBits(protocol::DriveState::switch_on_disabled);
    context_ = modbus_new_tcp("127.0.0.1", 0);
    listener_ = modbus_tcp_listen(context_, 1);
    sockaddr_in address{};
    socklen_t size = sizeof address;
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    mapping_ = modbus_mapping_new(0, 0, 256, 0);
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }
  ~ScriptedModbusDevice() {
    thread_.request_stop();
    ::shutdown(listener_, SHUT_RDWR);
    if (const int file = connection_.load(); file >= 0) ::shutdown(file, SHUT_RDWR);
    thread_.join();
    ::close(listener_);
    modbus_mapping_free(mapping_);
    modbus_free(context_);
  }

  [[nodiscard]] std::string address() const { return fmt::format("modbus-tcp:127.0.0.1:{}", port_); }
  std::uint16_t* registers() { return mapping_->tab_registers; }

  // Its data; the script may change them.
  protocol::DeviceIdentity identity;
  protocol::DeviceState state;
  protocol::Drive drive;
  bool echo_nonce = true;
  int sequence_end_ahead = 0;

 private:
  void run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      int listener = listener_;
      const int file = modbus_tcp_accept(context_, &listener);
      if (file < 0) return;
      connection_ = file;
      std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> request{};
      for (int length = 0; (length = modbus_receive(context_, request.data())) >= 0;) {
        if (length > 0 && !answer(request.data(), length)) break;
      }
      connection_ = -1;
      ::close(file);
    }
  }

  bool answer(const std::uint8_t* request, int length) {
    std::ranges::copy(encode(identity), registers());
    int outcome = 0;
    if (request[7] == 0x17) {
      const std::uint8_t* values = request + 17;
      const auto word = [&](std::uint16_t address) {
        const int at = 2 * (address - protocol::kCommandAddress);
        return static_cast<std::uint16_t>((values[at] << 8) | values[at + 1]);
      };
      drive.control(word(protocol::addressOf("control_word")));
      state.status_word = statusBits(drive.state()) | protocol::status_bit::kRemote;
      if (echo_nonce) state.nonce_echo = word(protocol::addressOf("nonce"));
      ++state.sequence;
      state.uptime_us += 1000;
      ++state.ir_count;
      ++state.bridge_count;
      outcome = script_(*this, ++transactions_);
      std::ranges::copy(encode(state), registers() + protocol::kStateAddress);
      registers()[protocol::addressOf("sequence_end")] += static_cast<std::uint16_t>(sequence_end_ahead);
    }
    if (outcome == kClose) return false;
    if (outcome == kSilence) return true;
    if (outcome == kTrickle) return trickle(request);
    if (outcome >= MODBUS_EXCEPTION_MAX) return undefinedException(request, outcome);
    if (outcome > 0)
      modbus_reply_exception(context_, request, static_cast<unsigned int>(outcome));
    else
      modbus_reply(context_, request, length, mapping_);
    return true;
  }

  /// libmodbus sends none that Modbus does not have.
  bool undefinedException(const std::uint8_t* request, int code) {
    const std::array<std::uint8_t, 9> out{request[0],
                                          request[1],
                                          0,
                                          0,
                                          0,
                                          3,
                                          request[6],
                                          static_cast<std::uint8_t>(request[7] | 0x80U),
                                          static_cast<std::uint8_t>(code)};
    return ::send(modbus_get_socket(context_), out.data(), out.size(), MSG_NOSIGNAL) == 9;
  }

  bool trickle(const std::uint8_t* request) {
    std::array<std::uint8_t, 259> out{};
    std::copy_n(request, 4, out.begin());  // transaction and protocol
    out[5] = 253;                          // bytes to come
    out[6] = request[6];
    out[7] = request[7];
    out[8] = 250;
    for (const std::uint8_t byte : out) {
      if (::send(connection_, &byte, 1, MSG_NOSIGNAL) != 1) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
  }

  Script script_;
  modbus_t* context_ = nullptr;
  modbus_mapping_t* mapping_ = nullptr;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  int transactions_ = 0;
  std::atomic<int> connection_{-1};
  std::jthread thread_;
};

}  // namespace fyd::device
