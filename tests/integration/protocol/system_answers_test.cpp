// What the system may answer to a key's file or to a socket, and hardly ever does: a call that is interrupted, a disk
// that fails, a queue that is full. The next answer to a call is replaced here; all others are the system's own.
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/protocol/link/link_key_file.h"
#include "core/protocol/udp_socket.h"
#include "tests/no_free_file.h"
#include "tests/temporary_folder.h"
#include "tests/wait.h"

namespace fyd::protocol {
namespace {

enum class Call : std::uint8_t { fstat, fsync, read, write, ioctl, getsockname, sendto, recvfrom };
std::array<std::atomic<int>, 8> next_error{};  ///< of each call, an errno; 0: none

std::atomic<int>& nextError(Call call) { return next_error[static_cast<std::size_t>(call)]; }

/// Fails once, where the test says so, or asks the system.
template <class Ask>
auto failOrAsk(Call call, Ask&& ask) -> decltype(ask()) {
  const int error = nextError(call).exchange(0);
  if (error == 0) return ask();
  errno = error;
  return -1;
}

}  // namespace
}  // namespace fyd::protocol

// In place of the C library's, for this program alone.
extern "C" int fstat(int file, struct stat* out) noexcept {
  return fyd::protocol::failOrAsk(fyd::protocol::Call::fstat, [&] { return ::fstatat(file, "", out, AT_EMPTY_PATH); });
}
extern "C" int fsync(int file) {
  return fyd::protocol::failOrAsk(fyd::protocol::Call::fsync,
                                  [&] { return static_cast<int>(::syscall(SYS_fsync, file)); });
}
extern "C" ssize_t read(int file, void* out, std::size_t size) {
  return fyd::protocol::failOrAsk(fyd::protocol::Call::read,
                                  [&] { return ssize_t{::syscall(SYS_read, file, out, size)}; });
}
extern "C" ssize_t write(int file, const void* bytes, std::size_t size) {
  return fyd::protocol::failOrAsk(fyd::protocol::Call::write,
                                  [&] { return ssize_t{::syscall(SYS_write, file, bytes, size)}; });
}
/// Of any number of arguments, of which a socket gives one.
extern "C" int ioctlOfOne(int file, unsigned long request, void* argument) __asm__("ioctl");
int ioctlOfOne(int file, unsigned long request, void* argument) {
  return fyd::protocol::failOrAsk(fyd::protocol::Call::ioctl,
                                  [&] { return static_cast<int>(::syscall(SYS_ioctl, file, request, argument)); });
}
extern "C" int getsockname(int socket, sockaddr* out, socklen_t* size) noexcept {
  return fyd::protocol::failOrAsk(fyd::protocol::Call::getsockname,
                                  [&] { return static_cast<int>(::syscall(SYS_getsockname, socket, out, size)); });
}
extern "C" ssize_t sendto(int socket, const void* bytes, std::size_t size, int flags, const sockaddr* to,
                          socklen_t to_size) {
  return fyd::protocol::failOrAsk(fyd::protocol::Call::sendto, [&] {
    return ssize_t{::syscall(SYS_sendto, socket, bytes, size, flags, to, to_size)};
  });
}
extern "C" ssize_t recvfrom(int socket, void* out, std::size_t size, int flags, sockaddr* from, socklen_t* from_size) {
  return fyd::protocol::failOrAsk(fyd::protocol::Call::recvfrom, [&] {
    return ssize_t{::syscall(SYS_recvfrom, socket, out, size, flags, from, from_size)};
  });
}

namespace fyd::protocol {
namespace {

/// Each answer that a test prepares must have been given.
class SystemAnswers : public testing::Test {
 protected:
  ~SystemAnswers() override {
    for (auto& error : next_error) EXPECT_EQ(error.exchange(0), 0) << "the call did not come";
  }
  const Folder folder;
  const std::string path = folder.file("key");
  const LinkKey key = LinkKey::generate();
};

TEST_F(SystemAnswers, AKeyFileThatCannotBeReadIsNamedWithTheReason) {
  ASSERT_TRUE(writeKeyFile(key, path));
  for (const Call call : {Call::fstat, Call::read}) {
    nextError(call) = EIO;
    const auto got = readKeyFile(path);
    ASSERT_FALSE(got);
    EXPECT_EQ(got.error().text(), "key file " + path + ": Input/output error");
  }
}

TEST_F(SystemAnswers, AnInterruptedCallIsMadeAgain) {
  nextError(Call::write) = EINTR;
  ASSERT_TRUE(writeKeyFile(key, path));
  nextError(Call::read) = EINTR;
  const auto got = readKeyFile(path);
  ASSERT_TRUE(got) << got.error().text();
  EXPECT_EQ(got->fingerprint(), key.fingerprint());
}

TEST_F(SystemAnswers, AKeyFileThatTheDiskDoesNotKeepIsNotLeftBehind) {
  nextError(Call::fsync) = EIO;
  const auto done = writeKeyFile(key, path);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().text(), "key file " + path + ": Input/output error");
  EXPECT_FALSE(std::filesystem::exists(path));
}

UdpSocket loopback() { return UdpSocket::open(parseEndpoint("127.0.0.1:0").value()).value(); }

TEST_F(SystemAnswers, ASocketThatCannotBePreparedIsRefusedWithTheReason) {
  const auto refused = [](Call call) {
    nextError(call) = ENOBUFS;
    const auto socket = UdpSocket::open(parseEndpoint("127.0.0.1:0").value());
    return socket ? std::string("opened") : socket.error().text();
  };
  EXPECT_EQ(refused(Call::ioctl), "UDP 127.0.0.1:0: cannot be set to non-blocking: No buffer space available");
  EXPECT_EQ(refused(Call::getsockname), "UDP 127.0.0.1:0: cannot tell its own address: No buffer space available");
}

TEST_F(SystemAnswers, AFullQueueIsNoRefusal) {
  UdpSocket socket = loopback();
  const UdpSocket other = loopback();
  const std::array<std::uint8_t, 3> payload{1, 2, 3};
  const auto sentAfter = [&](int error) {
    nextError(Call::sendto) = error;
    return socket.send(payload, other.local());
  };
  EXPECT_EQ(sentAfter(EAGAIN), SendOutcome::would_block) << "the socket's own queue";
  EXPECT_EQ(sentAfter(ENOBUFS), SendOutcome::would_block) << "the interface's";
  EXPECT_EQ(sentAfter(EPERM), SendOutcome::refused) << "a firewall";
  EXPECT_EQ(sentAfter(0), SendOutcome::sent);
}

TEST_F(SystemAnswers, AnErrorOfAnEarlierSendIsNotTheEndOfAReceive) {
  UdpSocket socket = loopback();
  UdpSocket other = loopback();
  ASSERT_EQ(other.send(std::array<std::uint8_t, 1>{7}, socket.local()), SendOutcome::sent);
  std::vector<std::uint8_t> buffer(100);
  nextError(Call::recvfrom) = ECONNREFUSED;
  const auto got = socket.receive(buffer, kPatience);
  ASSERT_TRUE(got);
  EXPECT_EQ(got->from, other.local());
}

TEST_F(SystemAnswers, ADatagramThatComesWhileItIsWaitedForIsReceived) {
  UdpSocket socket = loopback();
  UdpSocket other = loopback();
  ASSERT_EQ(other.send(std::array<std::uint8_t, 1>{7}, socket.local()), SendOutcome::sent);
  std::vector<std::uint8_t> buffer(100);
  nextError(Call::recvfrom) = EAGAIN;  // it was not there yet
  const auto got = socket.receive(buffer, kPatience);
  ASSERT_TRUE(got);
  EXPECT_EQ(got->from, other.local());
}

// A socket takes several files, of which any may be one too many.
TEST(UdpSocket, WithoutEnoughFreeFilesSaysThatItCannotBeOpened) {
  if (kSanitizerNeedsAFile) GTEST_SKIP() << "the sanitizer needs a file itself";
  const Endpoint local = parseEndpoint("127.0.0.1:0").value();
  constexpr std::size_t kEnough = 16;
  std::size_t refused = 0;
  for (std::size_t free = 0; free < kEnough; ++free) {
    std::vector<int> kept;
    for (std::size_t i = 0; i < free; ++i) kept.push_back(::dup(STDERR_FILENO));
    const NoFreeFile none;
    for (const int file : kept) ::close(file);
    const auto socket = UdpSocket::open(local);
    if (socket) break;
    ++refused;
    EXPECT_EQ(socket.error().text(), "UDP 127.0.0.1:0: cannot open a socket: Too many open files") << free;
  }
  EXPECT_GT(refused, 1U) << "without any, and with too few";
  EXPECT_LT(refused, kEnough);
  EXPECT_TRUE(UdpSocket::open(local)) << "there are files again";
}

}  // namespace
}  // namespace fyd::protocol
