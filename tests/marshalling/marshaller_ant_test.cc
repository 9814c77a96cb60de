// Messages of the network stack between two Systems: they have an address, which must not be sent,
// and data at that address.
#include <EndpointTypes.h>
#include <TCPEndpointMsg.h>

#include "runtime/ipstack/ant_message.h"
#include "runtime/ipstack/ip_stack.h"
#include "tests/marshalling/marshaller_fixture.h"

namespace openr_host {
namespace {

// Two Systems with a network stack, and the object's memory at one id in both.
class AntMarshallerTest : public MarshallerTest {
 protected:
  AntMarshallerTest() {
    for (System* system : {&here, &there}) system->AddObject<CodeObject>(0, IpStack::kName);
    stack = here.FindObject(0, IpStack::kName)->id;
    region = here.regions().New(16, sender->id);
    memory = here.regions().BaseOf(region);
    std::memcpy(memory, "0123456789abcdef", 16);
    copy = there.regions().AdoptOwn(region, 16, sender->id);
  }

  template <typename Ant>
  static Message MessageOf(const Ant& ant, ObjectId from, ObjectId to) {
    Message message = Blank();
    message.kind = PayloadKind::kHashed;
    message.payload_hash = 1;
    message.sender = from;
    message.target = to;
    std::memcpy(message.payload, static_cast<const void*>(&ant), sizeof ant);
    message.size = sizeof ant;
    return message;
  }
  Message Send(void* buffer, int size) {
    return MessageOf(TCPEndpointSendMsg(endpoint, static_cast<byte*>(buffer), size), sender->id,
                     stack);
  }
  Message Received(void* buffer, int size) {
    return MessageOf(TCPEndpointReceiveMsg(endpoint, static_cast<byte*>(buffer), 0, size), stack,
                     sender->id);
  }
  static void* BufferIn(const unsigned char* payload) {
    TCPEndpointSendMsg ant;
    std::memcpy(static_cast<void*>(&ant), payload, sizeof ant);
    return ant.buffer;
  }

  antModuleRef endpoint = MakeModuleRef(EndpointType_TCP, 3);
  ObjectId stack = kNoObject;
  uint32_t region = 0;
  char* memory = nullptr;
  char* copy = nullptr;
};

TEST_F(AntMarshallerTest, ARequestBringsTheDataThatAreToBeSent) {
  Message out;
  ASSERT_EQ(Carry(Send(memory + 4, 6), &out), "");
  EXPECT_EQ(wire.payload._d, openr_wire_PAYLOAD_ANT);
  EXPECT_EQ(wire.payload._u.ant.offset, 4u);
  EXPECT_EQ(wire.payload._u.ant.data._length, 6u);
  EXPECT_EQ(out.size, sizeof(TCPEndpointSendMsg));
  EXPECT_EQ(BufferIn(out.payload), copy + 4);
  EXPECT_EQ(std::string(copy, 16), std::string("\0\0\0\0", 4) + "456789" + std::string(6, '\0'));
}

// The address is worth nothing in another process, and would differ from run to run.
TEST_F(AntMarshallerTest, NoAddressIsSent) {
  Message out;
  ASSERT_EQ(Carry(Send(memory + 4, 6), &out), "");
  EXPECT_EQ(BufferIn(wire.payload._u.ant.message._buffer), nullptr);
  char elsewhere[4] = "abc";
  ASSERT_EQ(Carry(Send(elsewhere, 3), &out), "");
  EXPECT_EQ(BufferIn(wire.payload._u.ant.message._buffer), nullptr);
  EXPECT_EQ(wire.payload._u.ant.data._length, 0u) << "memory that no peer can have";
  EXPECT_EQ(BufferIn(out.payload), nullptr);
}

TEST_F(AntMarshallerTest, AnAnswerBringsTheDataThatWereReceived) {
  Message out;
  ASSERT_EQ(Carry(Received(memory, 3), &out), "");
  EXPECT_EQ(std::string(copy, 4), std::string("012\0", 4));
  ASSERT_EQ(Carry(Received(memory + 10, 100), &out), "");
  EXPECT_EQ(wire.payload._u.ant.data._length, 6u) << "up to the end of the region";
  EXPECT_EQ(std::string(copy + 10, 6), "abcdef");
  ASSERT_EQ(Carry(Received(memory, -1), &out), "");
  EXPECT_EQ(wire.payload._u.ant.data._length, 0u);
  ASSERT_EQ(Carry(MessageOf(TCPEndpointReceiveMsg(endpoint, reinterpret_cast<byte*>(memory), 0, 9),
                            sender->id, stack),
                  &out),
            "");
  EXPECT_EQ(wire.payload._u.ant.data._length, 0u) << "a request to receive has no data yet";
}

TEST_F(AntMarshallerTest, HashedBytesOfOthersArePlainBytes) {
  Message out;
  ASSERT_EQ(
      Carry(MessageOf(TCPEndpointSendMsg(endpoint, nullptr, 3), sender->id, sender->id), &out), "");
  EXPECT_EQ(wire.payload._d, openr_wire_PAYLOAD_BYTES);
}

TEST_F(AntMarshallerTest, ForgedDataStayWithinTheirRegion) {
  ours.Encode(Send(memory, 4), nullptr, &arena, &wire);
  openr_wire_Ant& ant = wire.payload._u.ant;
  const auto decode = [&](uint32_t id, uint32_t offset, const std::string& data) {
    ant.region = id;
    ant.offset = offset;
    ant.data = arena.Bytes(data.data(), data.size());
    Message out = Blank();
    const std::string problem = theirs.Decode(wire, &out);
    if (!problem.empty()) return problem;
    const auto* const buffer = static_cast<const char*>(BufferIn(out.payload));
    return buffer == nullptr ? std::string("null") : std::to_string(buffer - copy);
  };
  EXPECT_EQ(decode(region, 12, "wxyz"), "12");
  EXPECT_EQ(std::string(copy + 12, 4), "wxyz");
  EXPECT_EQ(decode(region, 12, "12345"), "network data beyond their buffer");
  EXPECT_EQ(decode(region, 15, ""), "15");
  EXPECT_EQ(decode(region, 16, ""), "null");
  EXPECT_EQ(decode(region, 0xffffffff, "1"), "null");
  EXPECT_EQ(decode(0, 0, "1"), "null");
  EXPECT_EQ(decode(region + 1, 0, "1"), "null");
  EXPECT_EQ(std::string(copy + 12, 4), "wxyz");
}

TEST_F(AntMarshallerTest, AForgedAddressIsNotUsed) {
  ours.Encode(Send(memory, 4), nullptr, &arena, &wire);
  openr_wire_Ant& ant = wire.payload._u.ant;
  TCPEndpointSendMsg forged(endpoint, reinterpret_cast<byte*>(memory), 4);
  ant.message = arena.Bytes(&forged, sizeof forged);
  for (const uint32_t id : {0u, region + 1}) {
    ant.region = id;
    Message out = Blank();
    ASSERT_EQ(theirs.Decode(wire, &out), "");
    EXPECT_EQ(BufferIn(out.payload), nullptr) << id;
  }
}

// The network stack reports such a message itself.
TEST_F(AntMarshallerTest, AMessageThatIsTooShortIsCarriedAsItIs) {
  Message message = Send(memory, 4);
  message.size = sizeof(antEnvMsg);
  Message out;
  ASSERT_EQ(Carry(message, &out), "");
  EXPECT_EQ(out.size, sizeof(antEnvMsg));
  EXPECT_EQ(wire.payload._u.ant.data._length, 0u);
  message.size = sizeof(antEnvMsg) - 1;
  EXPECT_EQ(Carry(message, &out),
            "a network message of " + std::to_string(sizeof(antEnvMsg) - 1) + " bytes");
}

}  // namespace
}  // namespace openr_host
