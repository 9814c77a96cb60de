// Files over the remote control, with the real RCServer and a network in this process.
#include <gtest/gtest.h>

#include <algorithm>

#include "Crc32.h"
#include "RemoteFiles.h"
#include "RemoteProtocol.h"
#include "tests/graph/graph.h"

namespace openr_host {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

std::string FilePacket(int command, const std::string& payload = "",
                       int version = RC_VERSION_FILES) {
  uint8_t bytes[RC_MAX_PACKET];
  RcWriter out(bytes, RC_MAX_PACKET);
  for (int i = 0; i < RC_HEADER_SIZE; ++i) out.U8(0);
  out.Bytes(reinterpret_cast<const Uint8*>(payload.data()), static_cast<int>(payload.size()));
  out.PutHeader(command, 1, version);
  return {reinterpret_cast<char*>(bytes), static_cast<size_t>(out.Size())};
}

template <typename Payload>
std::string FilePacketWith(int command, const Payload& payload) {
  uint8_t bytes[RC_MAX_PACKET];
  RcWriter out(bytes, RC_MAX_PACKET);
  payload.Write(&out);
  return FilePacket(command, {reinterpret_cast<char*>(bytes), static_cast<size_t>(out.Size())});
}

std::string BeginPacket(const std::string& name, const std::string& bytes) {
  const uint32_t crc =
      Crc32(0, reinterpret_cast<const Uint8*>(bytes.data()), static_cast<int>(bytes.size()));
  return FilePacketWith(rcUPLOAD_BEGIN,
                        RcUploadBegin{rcfileMOTION, name, static_cast<Uint32>(bytes.size()), crc});
}

// The packets with the bytes from `offset` to `end`.
std::string DataPackets(const std::string& bytes, size_t offset, size_t end) {
  std::string packets;
  for (size_t at = offset; at < end;) {
    const size_t count = std::min<size_t>(RC_MAX_UPLOAD_DATA, end - at);
    std::string payload;
    for (int shift = 0; shift < 32; shift += 8) payload += static_cast<char>(at >> shift);
    packets += FilePacket(rcUPLOAD_DATA, payload + bytes.substr(at, count));
    at += count;
  }
  return packets;
}

// The status of every answer that a client has heard, in order.
std::vector<int> StatusesOf(const std::string& heard) {
  std::vector<int> statuses;
  for (size_t at = 0; at + RC_ANSWER_HEADER_SIZE <= heard.size();) {
    RcFramer framer;
    const size_t count = std::min<size_t>(heard.size() - at, RC_MAX_PACKET);
    framer.Append(reinterpret_cast<const Uint8*>(heard.data()) + at, static_cast<int>(count));
    RcAnswerHeader header;
    if (framer.Next() != RcFramer::PACKET || !header.Read(framer)) break;
    statuses.push_back(header.status);
    at += header.header.size;
  }
  return statuses;
}

constexpr char kFolder[] = "/MS/OPEN-R/MW/DATA/P/";

class RemoteFilesTest : public testing::Test {
 protected:
  RemoteFilesTest() : graph(kIdeal), motion(*graph.stick().Read(InFolder("WALK.MTN"))) {
    graph.RunFor(seconds(1));
  }

  static std::string InFolder(const std::string& name) { return kFolder + name; }

  openr::testing::TcpClient& Connect() {
    auto& client = graph.AddClient();
    client.Connect(RC_PORT);
    graph.RunFor(milliseconds(100));
    return client;
  }
  std::vector<int> Send(openr::testing::TcpClient* client, const std::string& packets) {
    const size_t heard = client->heard().size();
    client->Send(packets);
    graph.RunFor(milliseconds(500));
    return StatusesOf(client->heard().substr(heard));
  }
  int NumTemporary() {
    const auto all = graph.stick().List();
    return static_cast<int>(std::count_if(all.begin(), all.end(), [](const std::string& name) {
      return name.find("UPLOAD") != std::string::npos;
    }));
  }

  Graph graph;
  const std::string motion;
};

TEST_F(RemoteFilesTest, PacketsOfAnUploadMayArriveTogether) {
  const auto statuses =
      Send(&Connect(), BeginPacket("NEW.MTN", motion) + DataPackets(motion, 0, motion.size()) +
                           FilePacket(rcUPLOAD_END) + FilePacket(rcMTN_LIST, {"\0\0", 2}));
  EXPECT_EQ(statuses, std::vector<int>(statuses.size(), rcOK));
  EXPECT_EQ(statuses.size(), 3 + (motion.size() + RC_MAX_UPLOAD_DATA - 1) / RC_MAX_UPLOAD_DATA);
  EXPECT_EQ(graph.stick().Read(InFolder("NEW.MTN")), motion);
  EXPECT_EQ(NumTemporary(), 0);
}

TEST_F(RemoteFilesTest, BytesOfAnUploadMayArriveOneByOne) {
  auto& client = Connect();
  const std::string all = BeginPacket("NEW.MTN", motion) + DataPackets(motion, 0, motion.size()) +
                          FilePacket(rcUPLOAD_END);
  for (const char byte : all) client.Send(std::string(1, byte));
  graph.RunFor(seconds(60));
  EXPECT_TRUE(client.done()) << client.WaitsFor();
  EXPECT_EQ(graph.stick().Read(InFolder("NEW.MTN")), motion);
}

TEST_F(RemoteFilesTest, AClientThatVanishesLeavesNoFileAndDisturbsNobody) {
  auto& other = Connect();
  EXPECT_EQ(Send(&other, BeginPacket("OTHER.MTN", motion) + DataPackets(motion, 0, 100)),
            (std::vector<int>{rcOK, rcOK}));
  for (const bool resets : {false, true}) {
    auto& client = Connect();
    Send(&client, BeginPacket("GONE.MTN", motion) + DataPackets(motion, 0, 2000));
    EXPECT_EQ(NumTemporary(), 2);
    resets ? client.Reset() : client.Close();
    graph.RunFor(milliseconds(300));
    EXPECT_EQ(NumTemporary(), 1);
  }
  EXPECT_EQ(Send(&other, DataPackets(motion, 100, motion.size()) + FilePacket(rcUPLOAD_END)).back(),
            rcOK);
  EXPECT_EQ(graph.stick().Read(InFolder("OTHER.MTN")), motion);
  EXPECT_FALSE(graph.stick().Has(InFolder("GONE.MTN")));
}

TEST_F(RemoteFilesTest, BytesThatAreNoPacketEndTheUpload) {
  auto& client = Connect();
  const auto statuses =
      Send(&client, BeginPacket("NEW.MTN", motion) + DataPackets(motion, 0, 500) + "no packet");
  EXPECT_EQ(statuses, (std::vector<int>{rcOK, rcOK, rcerrorBAD_PACKET}));
  EXPECT_TRUE(client.ended());
  EXPECT_EQ(NumTemporary(), 0);
}

TEST_F(RemoteFilesTest, AMotionThatPlaysMayBeReplacedAndDeleted) {
  WhenStanding(kIdeal, [&](Graph& standing) {
    auto& client = standing.AddClient();
    client.Connect(RC_PORT).Send(FilePacket(rcMTN_PLAY, "\7LIE.MTN" + std::string("\1\0\0", 3)));
    standing.RunFor(seconds(1));
    client.Send(BeginPacket("LIE.MTN", motion) + DataPackets(motion, 0, motion.size()) +
                FilePacket(rcUPLOAD_END) +
                FilePacketWith(rcDELETE, RcFileName{rcfileMOTION, "LIE.MTN"}));
    standing.RunFor(milliseconds(500));
    const auto statuses = StatusesOf(client.heard());
    EXPECT_EQ(statuses, std::vector<int>(statuses.size(), rcOK));
    EXPECT_FALSE(standing.stick().Has(InFolder("LIE.MTN")));
    standing.RunFor(seconds(15));
    EXPECT_EQ(standing.MoverStates().back(), "accepting-commands") << "it was played to its end";
  });
}

TEST_F(RemoteFilesTest, InVersion1TheCommandsStayReserved) {
  auto& client = Connect();
  const auto statuses = Send(&client, FilePacket(rcMTN_LIST, {"\0\0", 2}, RC_VERSION) +
                                          FilePacket(rcSHUTDOWN, "", RC_VERSION));
  EXPECT_EQ(statuses, (std::vector<int>{rcerrorNOT_IMPLEMENTED, rcerrorNOT_IMPLEMENTED}));
}

TEST_F(RemoteFilesTest, TheAnswerToAShutdownComesBeforeIt) {
  for (const int command : {rcSHUTDOWN, rcREBOOT}) {
    Graph robot(kIdeal);
    robot.RunFor(seconds(1));
    auto& client = robot.AddClient();
    client.Connect(RC_PORT).Send(FilePacket(command) + FilePacket(rcINFO));
    robot.RunFor(seconds(2));
    EXPECT_EQ(StatusesOf(client.heard()), std::vector<int>{rcOK}) << "nothing is answered after it";
    EXPECT_TRUE(client.ended());
    ASSERT_TRUE(robot.system().end().has_value());
    const std::string end = robot.system().end()->why;
    const bool says_why_it_stays_off = end.find("to boot again, but") != std::string::npos;
    EXPECT_TRUE(end.starts_with("RCServer shut the robot down")) << end;
    EXPECT_EQ(says_why_it_stays_off, command == rcREBOOT) << end;
  }
}

}  // namespace
}  // namespace openr_host
