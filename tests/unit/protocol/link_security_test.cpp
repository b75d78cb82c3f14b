// Keys, handshake and sealed channel: the published bytes, and attacks on them.
#include <cstdlib>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "app/bench/parts/allocation_count.h"
#include "core/protocol/link/link_key_file.h"
#include "tests/unit/protocol/link_pair.h"

namespace fyd::protocol {
namespace {

void allElevens(std::span<std::uint8_t> out) { std::ranges::fill(out, std::uint8_t{0x11}); }
void allTwentyTwos(std::span<std::uint8_t> out) { std::ranges::fill(out, std::uint8_t{0x22}); }

template <class Container>
Packet packet(const Container& bytes) {
  return {bytes.begin(), bytes.end()};
}
std::array<std::uint8_t, 16> counting(std::uint8_t first) {
  std::array<std::uint8_t, 16> out{};
  for (std::size_t i = 0; i < 16; ++i) out[i] = static_cast<std::uint8_t>(first + i);
  return out;
}

// --- keys

TEST(LinkKey, WordsAndFingerprintAreThoseOfTheSecondImplementation) {
  const LinkKey key = testKey();
  EXPECT_EQ(key.words(), vectors().at("words"));
  EXPECT_EQ(key.fingerprint(), vectors().at("fingerprint"));
  EXPECT_EQ(packet(key.handshakeKey().view()), vectorBytes("handshake_key"));
}

TEST(LinkKey, ReadsItsOwnWordsInAnyCaseAndSpacing) {
  for (int i = 0; i < 200; ++i) {
    const LinkKey key = LinkKey::generate(seededRandom);
    std::string words = key.words();
    EXPECT_EQ(LinkKey::parseWords(words)->fingerprint(), key.fingerprint());
    std::ranges::replace(words, ' ', i % 2 == 0 ? '-' : '\n');
    if (i % 3 == 0) std::ranges::transform(words, words.begin(), [](char c) { return char(std::toupper(c)); });
    EXPECT_EQ(LinkKey::parseWords("  " + words + "\r\n")->fingerprint(), key.fingerprint());
    EXPECT_EQ(LinkKey::parseFile(key.fileText(), "file")->fingerprint(), key.fingerprint());
  }
}

TEST(LinkKey, AnyOneWrongOrSwappedWordIsNoticed) {
  const std::string words = testKey(0x5a).words();
  int accepted = 0;
  int tried = 0;
  for (std::size_t place = 0; place < kPairingWords; ++place) {
    for (int i = 0; i < 50; ++i) {
      std::string other = words;
      other.replace(5 * place, 4, LinkKey::generate(seededRandom).words().substr(0, 4));
      if (other == words) continue;
      ++tried;
      accepted += LinkKey::parseWords(other) ? 1 : 0;
    }
  }
  EXPECT_LE(accepted, 1) << "of " << tried;  // by chance 1 in 32 768
}

TEST(LinkKey, ErrorsNameThePlaceAndNeverAWord) {
  const std::string words = testKey().words();
  const auto message = [](std::string_view text) { return LinkKey::parseWords(text).error().text(); };
  EXPECT_THAT(message(words.substr(0, 59)), ::testing::HasSubstr("12 words; expected 13"));
  EXPECT_THAT(message(words + " baba"), ::testing::HasSubstr("14 words"));
  EXPECT_THAT(message(""), ::testing::HasSubstr("0 words"));
  EXPECT_THAT(message("baba secret"), ::testing::HasSubstr("word 2 is not a pairing word"));
  EXPECT_THAT(message("bado" + words.substr(4)), ::testing::HasSubstr("checksum"));
  const auto file = [](std::string_view text) { return LinkKey::parseFile(text, "k").error().text(); };
  EXPECT_THAT(file(""), ::testing::HasSubstr("no key"));
  EXPECT_THAT(file("# c\nfyd-link-key 2\n"), ::testing::HasSubstr("k, line 2: expected \"fyd-link-key 1\""));
  EXPECT_THAT(file("fyd-link-key 1\n"), ::testing::HasSubstr("no pairing code"));
  for (const std::string& text : {message("bado" + words.substr(4)), file("fyd-link-key 1\n" + words + " baba"),
                                  file("#\nfyd-link-key 1\n" + words.substr(0, 30) + "x")}) {
    for (std::size_t place = 0; place < kPairingWords; ++place) {
      EXPECT_THAT(text, ::testing::Not(::testing::HasSubstr(words.substr(5 * place, 4))));
    }
  }
}

TEST(LinkKeyFile, IsPrivateNeverOverwrittenAndRefusedWhenOpenToOthers) {
  std::string folder = ::testing::TempDir() + "fyd_key_XXXXXX";
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const std::string path = folder + "/key";
  const LinkKey key = LinkKey::generate();
  ASSERT_TRUE(writeKeyFile(key, path));
  struct stat state {};
  ASSERT_EQ(::stat(path.c_str(), &state), 0);
  EXPECT_EQ(state.st_mode & 07777U, 0600U);
  EXPECT_EQ(readKeyFile(path)->fingerprint(), key.fingerprint());
  EXPECT_THAT(writeKeyFile(key, path).error().text(), ::testing::HasSubstr("never overwritten"));
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  EXPECT_THAT(readKeyFile(path).error().text(), ::testing::HasSubstr("chmod 600"));
  EXPECT_THAT(readKeyFile(folder + "/none").error().text(), ::testing::HasSubstr("No such file"));
  EXPECT_THAT(readKeyFile(folder).error().text(), ::testing::HasSubstr("not a regular file"));
  EXPECT_THAT(writeKeyFile(key, folder + "/no/key").error().text(), ::testing::HasSubstr("No such file"));
}

// --- handshake

struct Finished {
  SessionKeys robot;
  SessionKeys touchpad;
};

Finished handshake() {
  const LinkKey key = testKey();
  Caller caller(key, counting(0x40), allElevens);
  std::array<std::uint8_t, kMaximumLinkDatagram> call{};
  std::array<std::uint8_t, kMaximumLinkDatagram> answer{};
  std::array<std::uint8_t, kMaximumLinkDatagram> payload{};
  const std::size_t call_size = caller.write(vectorBytes("robot_hello"), call);
  EXPECT_EQ(packet(Bytes(call).first(call_size)), vectorBytes("call"));
  Callee callee(key, Bytes(call).first(call_size));
  const auto hello = callee.read(Bytes(call).first(call_size), payload);
  EXPECT_TRUE(hello && packet(*hello) == vectorBytes("robot_hello"));
  const std::size_t answer_size = callee.write(vectorBytes("touchpad_hello"), allTwentyTwos, answer);
  EXPECT_EQ(packet(Bytes(answer).first(answer_size)), vectorBytes("answer"));
  const auto back = caller.read(Bytes(answer).first(answer_size), payload);
  EXPECT_TRUE(back && packet(*back) == vectorBytes("touchpad_hello"));
  return {.robot = caller.keys(), .touchpad = callee.keys()};
}

TEST(LinkHandshake, EveryByteIsThatOfTheSecondImplementation) {
  EXPECT_EQ(packet(makeHello(testKey(), counting(0x30))), vectorBytes("hello"));
  EXPECT_EQ(packet(makeChallenge(testKey(), counting(0x30), counting(0x40))), vectorBytes("challenge"));
  const Finished done = handshake();
  for (const SessionKeys* keys : {&done.robot, &done.touchpad}) {
    EXPECT_EQ(packet(keys->from_initiator.view()), vectorBytes("from_robot"));
    EXPECT_EQ(packet(keys->from_responder.view()), vectorBytes("from_touchpad"));
    EXPECT_EQ(packet(keys->transcript), vectorBytes("transcript"));
  }
  Packet sealed(200);
  Sealer robot(done.robot.from_initiator, sessionOf(done.robot));
  const Packet beat = vectorBytes("heartbeat");
  std::ranges::copy(beat, Sealer::messagePart(sealed).begin());
  EXPECT_EQ(packet(Bytes(sealed).first(robot.seal(sealed, beat.size()))), vectorBytes("sealed_heartbeat"));
  Sealer touchpad(done.robot.from_responder, sessionOf(done.robot), 258);
  const Packet touch = vectorBytes("touch");
  std::ranges::copy(touch, Sealer::messagePart(sealed).begin());
  EXPECT_EQ(packet(Bytes(sealed).first(touchpad.seal(sealed, touch.size()))), vectorBytes("sealed_touch"));
}

TEST(LinkHandshake, AnyBitTurnedInCallOrAnswerAndAnyTruncationFails) {
  const LinkKey key = testKey();
  std::array<std::uint8_t, kMaximumLinkDatagram> payload{};
  const auto callOpens = [&](Bytes call) {
    return call.size() >= kCallHeader && Callee(key, call).read(call, payload).has_value();
  };
  const Packet call = vectorBytes("call");
  ASSERT_TRUE(callOpens(call));
  for (std::size_t bit = 0; bit < 8 * call.size(); ++bit) {
    Packet flipped = call;
    flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_FALSE(callOpens(flipped)) << bit;
  }
  for (std::size_t size = 0; size < call.size(); ++size) EXPECT_FALSE(callOpens(Bytes(call).first(size))) << size;

  Caller caller(key, counting(0x40), allElevens);
  std::array<std::uint8_t, kMaximumLinkDatagram> out{};
  ASSERT_GT(caller.write(vectorBytes("robot_hello"), out), 0U);
  const Packet answer = vectorBytes("answer");
  for (std::size_t bit = 8 * kAnswerHeader; bit < 8 * answer.size(); bit += 3) {  // every key bit costs a X25519
    Packet flipped = answer;
    flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    // X25519 ignores the highest bit of a public key; the hash of it does not.
    EXPECT_FALSE(caller.read(flipped, payload)) << bit;
  }
  EXPECT_TRUE(caller.read(answer, payload));  // after all the wrong ones
}

TEST(LinkHandshake, WrongKeyOtherCookieAndUnsoundPublicKeysFail) {
  std::array<std::uint8_t, kMaximumLinkDatagram> payload{};
  const Packet call = vectorBytes("call");
  EXPECT_FALSE(Callee(testKey(1), call).read(call, payload));
  HelloNonce nonce{};
  Cookie cookie{};
  EXPECT_EQ(readHello(testKey(1), vectorBytes("hello"), nonce), LinkRefusal::key);
  EXPECT_EQ(readHello(testKey(), vectorBytes("challenge"), nonce), LinkRefusal::key);  // another key for each kind
  EXPECT_EQ(readChallenge(testKey(), vectorBytes("challenge"), counting(0x31), cookie), LinkRefusal::cookie);
  EXPECT_EQ(readChallenge(testKey(), vectorBytes("challenge"), counting(0x30), cookie), LinkRefusal::none);
  EXPECT_EQ(cookie, counting(0x40));

  // A public key of zero makes the shared secret zero: refused although its sender knows the key.
  const SecretBytes<32>& shared = testKey().handshakeKey();
  EphemeralKey zero;
  NoiseHandshake initiator(shared, {});
  NoiseHandshake responder(shared, {});
  std::array<std::uint8_t, 200> message{};
  const std::size_t size = initiator.writeFirst(zero, {}, message);
  ASSERT_TRUE(responder.readFirst(Bytes(message).first(size), payload));
  EXPECT_EQ(responder.writeSecond(EphemeralKey::make(seededRandom), {}, message), 0U);
}

TEST(LinkHandshake, CookiesAreBoundToAddressAndTime) {
  const CookieJar jar(seededRandom);
  const CookieJar other(seededRandom);
  const Endpoint from = linkAddress(1);
  constexpr LinkTime kAt = 12'345'678;  // the third slot of 5 s
  const Cookie cookie = jar.make(from, kAt);
  EXPECT_TRUE(jar.good(cookie, from, kAt));
  EXPECT_TRUE(jar.good(cookie, from, 19'999'999));
  EXPECT_FALSE(jar.good(cookie, from, 20'000'000));
  EXPECT_FALSE(jar.good(cookie, from, 9'999'999));
  EXPECT_FALSE(jar.good(cookie, linkAddress(2), kAt));
  EXPECT_FALSE(jar.good(cookie, linkAddress(1, 4491), kAt));
  EXPECT_FALSE(other.good(cookie, from, kAt));
  EXPECT_FALSE(jar.good(Bytes(cookie).first(15), from, kAt));
}

// --- sealed channel

class Channel : public ::testing::Test {
 protected:
  Packet seal(Sealer& sealer, std::uint8_t content = 0x5a, std::size_t size = 20) {
    Packet out(size + kSealOverhead);
    std::ranges::fill(Sealer::messagePart(out).first(size), content);
    EXPECT_EQ(sealer.seal(out, size), out.size());
    return out;
  }
  LinkRefusal open(Opener& opener, Bytes datagram) { return opener.open(datagram, plain_).refusal; }

  SecretBytes<32> key_ = testKey().handshakeKey();
  SecretBytes<32> other_ = testKey().helloKey();
  Sealer sealer_{key_, 77};
  Opener opener_{key_, 77};
  std::array<std::uint8_t, kMaximumLinkDatagram> plain_{};
};

TEST_F(Channel, CarriesMessagesOfEverySizeOnce) {
  for (std::size_t size = 1; size <= 1'290; size += 3) {
    const Packet sealed = seal(sealer_, static_cast<std::uint8_t>(size), size);
    const Opened got = opener_.open(sealed, plain_);
    ASSERT_TRUE(got.ok());
    EXPECT_EQ(packet(got.message), Packet(size, static_cast<std::uint8_t>(size)));
    EXPECT_EQ(open(opener_, sealed), LinkRefusal::repeated);
  }
}

TEST_F(Channel, AnyBitTurnedAndAnyTruncationIsRefusedAndDoesNoHarm) {
  const Packet sealed = seal(sealer_);
  for (std::size_t bit = 0; bit < 8 * sealed.size(); ++bit) {
    Packet flipped = sealed;
    flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_NE(open(opener_, flipped), LinkRefusal::none) << bit;
  }
  for (std::size_t size = 0; size < sealed.size(); ++size) {
    EXPECT_NE(open(opener_, Bytes(sealed).first(size)), LinkRefusal::none) << size;
  }
  Packet longer = sealed;
  longer.push_back(0);
  EXPECT_EQ(open(opener_, longer), LinkRefusal::key);
  EXPECT_EQ(open(opener_, sealed), LinkRefusal::none);  // none of that used its counter up
}

TEST_F(Channel, NamesTheReason) {
  const Packet sealed = seal(sealer_);
  const auto changed = [&](std::size_t at, std::uint8_t value) {
    Packet out = sealed;
    out[at] = value;
    return open(opener_, out);
  };
  EXPECT_EQ(changed(0, 'A'), LinkRefusal::magic);
  EXPECT_EQ(changed(1, 0x25), LinkRefusal::version);
  EXPECT_EQ(changed(1, 0x05), LinkRefusal::version);
  EXPECT_EQ(changed(1, 0x16), LinkRefusal::kind);
  EXPECT_EQ(changed(1, 0x11), LinkRefusal::kind);
  EXPECT_EQ(changed(2, 78), LinkRefusal::session);
  EXPECT_EQ(changed(4, 5), LinkRefusal::key);
  Opener stranger(other_, 77);
  EXPECT_EQ(open(stranger, sealed), LinkRefusal::key);
  EXPECT_EQ(open(opener_, Bytes(sealed).first(kSealOverhead)), LinkRefusal::size);
}

// What one end sends comes back at it: the keys of the directions differ.
TEST_F(Channel, ReflectionIsRefused) {
  const Finished done = handshake();
  Sealer robot(done.robot.from_initiator, sessionOf(done.robot));
  Opener at_robot(done.robot.from_responder, sessionOf(done.robot));
  Opener at_touchpad(done.touchpad.from_initiator, sessionOf(done.touchpad));
  const Packet sealed = seal(robot);
  EXPECT_EQ(open(at_robot, sealed), LinkRefusal::key);
  EXPECT_EQ(open(at_touchpad, sealed), LinkRefusal::none);
}

TEST_F(Channel, ReorderingAcrossTheWindowsEdge) {
  std::vector<Packet> sent;
  sent.reserve(3'000);
  for (int i = 0; i < 3'000; ++i) sent.push_back(seal(sealer_));
  EXPECT_EQ(open(opener_, sent[1'500]), LinkRefusal::none);
  EXPECT_EQ(open(opener_, sent[1'500 - 1'023]), LinkRefusal::none);  // the oldest of the window's 1024
  EXPECT_EQ(open(opener_, sent[1'500 - 1'024]), LinkRefusal::behind);
  EXPECT_EQ(open(opener_, sent[0]), LinkRefusal::behind);
  EXPECT_EQ(open(opener_, sent[1'501]), LinkRefusal::none);
  EXPECT_EQ(open(opener_, sent[1'500 - 1'023]), LinkRefusal::behind);  // the edge moved
  EXPECT_EQ(open(opener_, sent[1'501 - 1'023]), LinkRefusal::none);
  EXPECT_EQ(open(opener_, sent[1'500]), LinkRefusal::repeated);
  EXPECT_EQ(open(opener_, sent[2'999]), LinkRefusal::none);  // a jump over more than the whole window
  EXPECT_EQ(open(opener_, sent[2'998]), LinkRefusal::none);
  EXPECT_EQ(open(opener_, sent[1'976]), LinkRefusal::none);
  EXPECT_EQ(open(opener_, sent[1'975]), LinkRefusal::behind);
  EXPECT_EQ(open(opener_, sent[2'998]), LinkRefusal::repeated);
}

// Against a plain set of what was taken.
TEST(ReplayWindow, TakesEachCounterOnceInAnyOrder) {
  std::mt19937_64 random(3);
  ReplayWindow window;
  std::set<std::uint64_t> taken;
  std::uint64_t newest = 0;
  for (int i = 0; i < 200'000; ++i) {
    const std::uint64_t base = newest > 1'200 ? newest - 1'200 : 0;
    const std::uint64_t counter = random() % 500 == 0 ? newest + random() % 5'000 : base + random() % 1'300;
    LinkRefusal expected = LinkRefusal::none;
    if (!taken.empty() && counter + ReplayWindow::kSize <= newest) {
      expected = LinkRefusal::behind;
    } else if (taken.contains(counter)) {
      expected = LinkRefusal::repeated;
    }
    ASSERT_EQ(window.check(counter), expected) << counter << " newest " << newest;
    if (expected != LinkRefusal::none) continue;
    window.take(counter);
    taken.insert(counter);
    newest = std::max(newest, counter);
  }
}

TEST_F(Channel, CounterIsNeverUsedTwiceNotEvenAtItsEnd) {
  Sealer last(key_, 77, kLastCounter - 1);
  const Packet before_last = seal(last);
  const Packet the_last = seal(last);
  EXPECT_TRUE(last.exhausted());
  Packet none(100);
  EXPECT_EQ(last.seal(none, 20), 0U);
  EXPECT_EQ(none, Packet(100));
  EXPECT_EQ(open(opener_, the_last), LinkRefusal::none);
  EXPECT_EQ(open(opener_, before_last), LinkRefusal::none);
  EXPECT_EQ(open(opener_, the_last), LinkRefusal::repeated);
  Sealer first(key_, 77);
  EXPECT_EQ(open(opener_, seal(first)), LinkRefusal::behind);
}

TEST_F(Channel, AlteredPacketsAreNeverAccepted) {
  constexpr int kTries = 1'000'000;
  std::mt19937_64 random(4);
  int accepted = 0;
  for (int i = 0; i < kTries; ++i) {
    Packet sealed = seal(sealer_, static_cast<std::uint8_t>(random()), 1 + random() % 64);
    const Packet before = sealed;
    for (std::uint64_t n = 1 + random() % 4; n > 0; --n) {
      switch (random() % 4) {
        case 0: sealed[random() % sealed.size()] ^= static_cast<std::uint8_t>(1U << (random() % 8)); break;
        case 1: sealed[random() % sealed.size()] = static_cast<std::uint8_t>(random()); break;
        case 2: sealed.resize(1 + random() % sealed.size()); break;
        default: sealed.push_back(static_cast<std::uint8_t>(random()));
      }
    }
    if (sealed != before) accepted += open(opener_, sealed) == LinkRefusal::none ? 1 : 0;
  }
  EXPECT_EQ(accepted, 0);
}

TEST_F(Channel, DoesNotAllocate) {
  std::array<std::uint8_t, 200> buffer{};
  const bench::AllocationCount counted;
  for (int i = 0; i < 100; ++i) {
    const std::size_t size = sealer_.seal(buffer, 60);
    EXPECT_TRUE(opener_.open(Bytes(buffer).first(size), plain_).ok());
  }
  EXPECT_EQ(counted.count(), 0U);
}

TEST(SecretBytes, AreWipedWhenTheyGo) {
  alignas(SecretBytes<32>) std::array<unsigned char, sizeof(SecretBytes<32>)> storage{};
  auto* secret = new (storage.data()) SecretBytes<32>(testKey().helloKey());
  EXPECT_NE(packet(secret->view()), Packet(32));
  secret->~SecretBytes();
  const volatile unsigned char* left = storage.data();
  for (std::size_t i = 0; i < storage.size(); ++i) EXPECT_EQ(left[i], 0);
}

}  // namespace
}  // namespace fyd::protocol
