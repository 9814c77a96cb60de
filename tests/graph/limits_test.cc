// Compares the stack and heap that the four objects use at work with the sizes in their .ocf files.
// docs/robot-build.md has the table; it is printed with OPENR_PRINT_LIMITS set.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "Crc32.h"
#include "RemoteFiles.h"
#include "RemoteProtocol.h"
#include "runtime/core/arena.h"
#include "tests/graph/graph.h"

namespace openr_host {
namespace {

// With AddressSanitizer frames are larger, and the heap is the host's.
#if !defined(__SANITIZE_ADDRESS__)

constexpr const char* kObjects[] = {"PowerMonitor", "JointMover", "RCServer", "Controller"};

std::string Packet(int command, const std::string& payload = "", int version = RC_VERSION) {
  uint8_t bytes[RC_MAX_PACKET];
  RcWriter out(bytes, RC_MAX_PACKET);
  for (int i = 0; i < RC_HEADER_SIZE; ++i) out.U8(0);
  for (const char c : payload) out.U8(static_cast<uint8_t>(c));
  out.PutHeader(command, 1, version);
  return {reinterpret_cast<char*>(bytes), static_cast<size_t>(out.Size())};
}

std::string PlayRequest(const std::string& file) {
  return static_cast<char>(file.size()) + file + std::string("\1\0\0", 3);
}

// A connection for some packets; returns how many bytes came back.
size_t Ask(Graph* graph, openr::testing::TcpClient* client, const std::string& packets,
           std::chrono::milliseconds time) {
  const size_t heard = client->heard().size();
  client->Connect(RC_PORT).Send(packets);
  graph->RunFor(time);
  EXPECT_TRUE(client->done()) << client->WaitsFor();
  client->Close();
  graph->RunFor(std::chrono::milliseconds(100));
  return client->heard().size() - heard;
}

// Requests for files: the list, a download, an upload and its removal.  Each string is sent by a
// client of its own.
std::vector<std::string> FileRequests(const std::string& motion) {
  const auto name = std::string("\0\7NEW.MTN", 9);
  const auto number = [](size_t value) {
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift);
    return bytes;
  };
  const uint32_t crc =
      Crc32(0, reinterpret_cast<const Uint8*>(motion.data()), static_cast<int>(motion.size()));
  std::string upload =
      Packet(rcUPLOAD_BEGIN, name + number(motion.size()) + number(crc), RC_VERSION_FILES);
  for (size_t at = 0; at < motion.size(); at += RC_MAX_UPLOAD_DATA) {
    upload +=
        Packet(rcUPLOAD_DATA, number(at) + motion.substr(at, RC_MAX_UPLOAD_DATA), RC_VERSION_FILES);
  }
  return {Packet(rcMTN_LIST, std::string(2, '\0'), RC_VERSION_FILES),
          upload + Packet(rcUPLOAD_END, "", RC_VERSION_FILES),
          Packet(rcDOWNLOAD, name + number(0), RC_VERSION_FILES),
          Packet(rcDELETE, name, RC_VERSION_FILES)};
}
constexpr const char* kWalk = "/MS/OPEN-R/MW/DATA/P/WALK.MTN";

// The requests of version 2, alone and in a batch, but those that end the run.
void AskVersion2(Graph* graph, openr::testing::TcpClient* client) {
  for (int command = 0; command < 0x80; ++command) {
    if (command == rcREBOOT || command == rcSHUTDOWN || command == rcEVENT) continue;
    for (const auto& payload : {std::string(), std::string(1, 1), std::string(2, 0),
                                std::string("\0\4\0", 3), std::string(7, 1)}) {
      const std::string packet = Packet(command, payload, RC_VERSION_FILES);
      const std::string batch = Packet(rcBATCH, packet + packet, RC_VERSION_FILES);
      EXPECT_GT(Ask(graph, client, packet + batch, std::chrono::milliseconds(200)), 0u) << command;
    }
  }
  const std::string layer_h = Packet(rcCAMERA, std::string(1, 0), RC_VERSION_FILES);
  const std::string part = Packet(rcCAMERA_PART, std::string(2, 0), RC_VERSION_FILES);
  EXPECT_GT(Ask(graph, client, layer_h + part, std::chrono::milliseconds(300)), 0u);
}

// Every request of the remote control, with and without arguments, good files and bad.
void AskEverything(Graph* graph) {
  auto& client = graph->AddClient();
  for (int command = 0; command < 0x80; ++command) {
    for (const char* payload : {"", "\1", "\1\1", "\1\1\1\1\1"}) {
      const std::string packet = Packet(command, payload);
      EXPECT_GT(Ask(graph, &client, packet, std::chrono::milliseconds(100)), 0u) << command;
    }
  }
  AskVersion2(graph, &client);
  for (const char* file : {"BOW.MTN", "NONE.MTN", "WALK.MTN", "LIE.MTN"}) {
    const std::string packets = Packet(rcMTN_PLAY, PlayRequest(file)) + "no packet";
    EXPECT_GT(Ask(graph, &client, packets, std::chrono::seconds(12)), 0u) << file;
  }
  for (const std::string& packets : FileRequests(graph->stick().Read(kWalk).value())) {
    EXPECT_GT(Ask(graph, &client, packets, std::chrono::milliseconds(500)), 0u);
  }
}

// PowerMonitor has something to do.
void ShutDown(Graph* graph) {
  graph->PressPause();
  graph->RunFor(std::chrono::seconds(1));
}

class LimitsTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    GraphOptions options = kIdeal;
    options.measure_stacks = true;
    Graph graph(options);
    ASSERT_TRUE(graph.RunToStanding());
    AskEverything(&graph);
    ShutDown(&graph);
    for (const char* name : kObjects) {
      const Object* const object = graph.system().FindObject(0, name);
      ASSERT_NE(object, nullptr) << name;
      marks_.push_back({name, object->statistics().stack_max(), object->limits().stack_bytes,
                        object->memory().arena()->bytes_in_use_max(), object->limits().heap_bytes});
    }
    if (std::getenv("OPENR_PRINT_LIMITS") == nullptr) return;
    for (const Mark& mark : marks_) {
      fmt::print("{}: stack {} of {}, heap {} of {}\n", mark.object, mark.stack, mark.stack_ocf,
                 mark.heap, mark.heap_ocf);
    }
  }

  struct Mark {
    std::string object;
    size_t stack, stack_ocf, heap, heap_ocf;
  };
  inline static std::vector<Mark> marks_;
};

// Frames of a 64-bit host are larger than the robot's; what suffices for them leaves room there for
// the SDK's functions below, which do not count here.  check_mips.sh measures the robot's.
TEST_F(LimitsTest, EvenTheHostsFramesFitTheStacksOfTheOcfFiles) {
  ASSERT_EQ(marks_.size(), 4u);
  for (const Mark& mark : marks_) {
    EXPECT_GT(mark.stack, 100u) << mark.object << ": was it measured?";
    EXPECT_LE(mark.stack * 5 / 4, mark.stack_ocf) << mark.object;
  }
}

// The heap grows by that much when it is used up; within one step it grows once, at the boot.
TEST_F(LimitsTest, TheHeapOfEveryObjectStaysWithinOneStepOfGrowth) {
  ASSERT_EQ(marks_.size(), 4u);
  for (const Mark& mark : marks_) EXPECT_LE(mark.heap * 5 / 4, mark.heap_ocf) << mark.object;
}

#endif

}  // namespace
}  // namespace openr_host
