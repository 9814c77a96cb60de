#include <gtest/gtest.h>

#include <random>

#include "RemoteFiles.h"
#include "RemotePacket.h"
#include "RemoteProtocol.h"

namespace openr_host {
namespace {

std::vector<uint8_t> Packet(int command, int tag, const std::vector<uint8_t>& payload = {}) {
  std::vector<uint8_t> bytes(RC_MAX_PACKET);
  RcWriter out(bytes.data(), RC_MAX_PACKET);
  for (int i = 0; i < RC_HEADER_SIZE; ++i) out.U8(0);
  for (const uint8_t byte : payload) out.U8(byte);
  out.PutHeader(command, tag);
  bytes.resize(out.Size());
  return bytes;
}

TEST(RemotePacketTest, IsWrittenAsDocumented) {
  EXPECT_EQ(Packet(rcMOVE, 7, {1, 0xb8, 0x0b, 0, 0}),
            (std::vector<uint8_t>{0x52, 0x43, 13, 0, 1, 0x11, 7, 0, 1, 0xb8, 0x0b, 0, 0}));
}

TEST(RemotePacketTest, ArrivesWholeHoweverItIsCut) {
  const std::vector<uint8_t> bytes = Packet(rcMOVE, 7, {1, 2, 3, 4, 5});
  for (size_t cut = 1; cut < bytes.size(); ++cut) {
    RcFramer framer;
    framer.Append(bytes.data(), static_cast<int>(cut));
    ASSERT_EQ(framer.Next(), RcFramer::NEEDS_MORE) << cut;
    framer.Append(bytes.data() + cut, static_cast<int>(bytes.size() - cut));
    ASSERT_EQ(framer.Next(), RcFramer::PACKET) << cut;
    EXPECT_EQ(framer.PayloadSize(), 5);
    EXPECT_EQ(framer.Payload()[4], 5);
    EXPECT_EQ(framer.Next(), RcFramer::NEEDS_MORE);
  }
}

TEST(RemotePacketTest, SeveralInOnePieceComeOneAfterTheOther) {
  std::vector<uint8_t> bytes;
  for (int tag = 0; tag < 50; ++tag) {
    const std::vector<uint8_t> packet = Packet(rcGET, tag, {3});
    bytes.insert(bytes.end(), packet.begin(), packet.end());
  }
  RcFramer framer;
  framer.Append(bytes.data(), static_cast<int>(bytes.size()));
  for (int tag = 0; tag < 50; ++tag) {
    ASSERT_EQ(framer.Next(), RcFramer::PACKET);
    EXPECT_EQ(framer.Header().tag, tag);
  }
  EXPECT_EQ(framer.Next(), RcFramer::NEEDS_MORE);
}

TEST(RemotePacketTest, OneOfFullSizeFits) {
  const std::vector<uint8_t> bytes =
      Packet(rcUPLOAD_DATA, 1, std::vector<uint8_t>(RC_MAX_PACKET - RC_HEADER_SIZE, 9));
  RcFramer framer;
  framer.Append(bytes.data(), static_cast<int>(bytes.size()) - 1);
  ASSERT_EQ(framer.Next(), RcFramer::NEEDS_MORE);
  EXPECT_GE(framer.Room(), RC_MAX_PACKET);
  framer.Append(&bytes.back(), 1);
  EXPECT_EQ(framer.Next(), RcFramer::PACKET);
}

TEST(RemotePacketTest, SomethingElseIsRefusedAtTheSecondByte) {
  RcFramer framer;
  const uint8_t bytes[] = {'G', 'E'};
  framer.Append(bytes, 2);
  EXPECT_EQ(framer.Next(), RcFramer::BROKEN);
  EXPECT_EQ(framer.Error(), "a packet begins with 'RC', not with the bytes 47 45");
}

TEST(RemotePacketTest, AnAbsurdSizeIsRefused) {
  for (const int size : {0, 7, 1025, 65535}) {
    std::vector<uint8_t> bytes = Packet(rcINFO, 0);
    bytes[2] = size & 0xff;
    bytes[3] = size >> 8;
    RcFramer framer;
    framer.Append(bytes.data(), static_cast<int>(bytes.size()));
    EXPECT_EQ(framer.Next(), RcFramer::BROKEN) << size;
    EXPECT_NE(framer.Error(), "") << size;
  }
}

TEST(RemotePacketTest, RandomBytesNeverCrashTheFramer) {
  std::mt19937 random(3);
  for (int round = 0; round < 2000; ++round) {
    RcFramer framer;
    for (int piece = 0; piece < 5; ++piece) {
      std::vector<uint8_t> bytes(random() % 300);
      for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random());
      if (piece == 0 && bytes.size() > 3) {
        bytes[0] = 'R';
        bytes[1] = 'C';
        bytes[3] &= 1;
      }
      framer.Append(bytes.data(), static_cast<int>(bytes.size()));
      for (int i = 0; i < 100 && framer.Next() == RcFramer::PACKET; ++i)
        ASSERT_GE(framer.PayloadSize(), 0);
    }
  }
}

TEST(RemotePacketTest, TakingMoreThanThereIsRoomForChangesNothing) {
  RcFramer framer;
  const std::vector<uint8_t> bytes(5000, 'R');
  framer.Append(bytes.data(), 5000);
  EXPECT_EQ(framer.Next(), RcFramer::NEEDS_MORE);
  EXPECT_EQ(framer.Room(), 2 * RC_MAX_PACKET);
}

TEST(RemoteWriterTest, OverflowIsFlaggedAndWritesNothingOutside) {
  uint8_t bytes[4] = {9, 9, 9, 9};
  RcWriter out(bytes, 3);
  out.U16(1);
  out.U32(0xffffffff);
  EXPECT_TRUE(out.HasOverflowed());
  EXPECT_EQ(bytes[2], 9);
  EXPECT_EQ(bytes[3], 9);
}

// Terminals obey control bytes, and a name may hold any.
TEST(RemoteWriterTest, StringsAreAscii) {
  uint8_t bytes[64];
  RcWriter out(bytes, 64);
  out.String("a\x1b[2Jb\n~ \xc3\xa9");
  const std::string sent(reinterpret_cast<char*>(bytes) + 1, bytes[0]);
  EXPECT_EQ(sent, "a?[2Jb?~ ??");
}

TEST(RemoteReaderTest, StringsAreAsciiWhateverTheOtherSideSends) {
  const uint8_t bytes[] = {5, 'a', 0x1b, 0, 0x7f, 0xe9};
  RcReader in(bytes, 6);
  EXPECT_EQ(in.String(), "a????");
  EXPECT_TRUE(in.IsComplete());
}

TEST(RemoteReaderTest, MissingBytesGiveZerosAndAFlag) {
  const uint8_t bytes[] = {5, 'a', 'b'};
  RcReader in(bytes, 3);
  EXPECT_EQ(in.String(), "");
  EXPECT_TRUE(in.HasFailed());
  EXPECT_EQ(in.U32(), 0u);
  EXPECT_FALSE(in.IsComplete());
}

TEST(RemoteReaderTest, BytesLeftOverMakeAPayloadIncomplete) {
  const uint8_t bytes[] = {1, 2};
  RcReader in(bytes, 2);
  EXPECT_EQ(in.U8(), 1);
  EXPECT_FALSE(in.IsComplete());
  EXPECT_FALSE(in.HasFailed());
}

template <class Message>
Message ThereAndBack(const Message& message) {
  uint8_t bytes[RC_MAX_PACKET];
  RcWriter out(bytes, RC_MAX_PACKET);
  message.Write(&out);
  for (int size = 0; size < out.Size(); ++size) {
    RcReader in(bytes, size);
    Message ignored{};
    EXPECT_FALSE(ignored.Read(&in)) << "read from " << size << " of " << out.Size() << " bytes";
  }
  RcReader in(bytes, out.Size());
  Message read{};
  EXPECT_TRUE(read.Read(&in));
  return read;
}

TEST(RemoteProtocolTest, EveryStructReadsWhatItWrites) {
  EXPECT_EQ(ThereAndBack(RcInfo{18, 9, 2, 6, 7, 2, 6, "ERS-210", "test", false, 0, 0, 0}).design,
            "ERS-210");
  EXPECT_EQ(ThereAndBack(RcDescription{"a", "b", "c", {1, -2, 3}}).values,
            (std::vector<int32_t>{1, -2, 3}));
  EXPECT_EQ(ThereAndBack(RcJointState{-1, 2, 3}).position, -1);
  const RcSensors sensors = ThereAndBack(RcSensors{8, {1, 2}, {3}, {-4, 5, 6}, {7, 8}, {-1}});
  EXPECT_EQ(sensors.other, (std::vector<int32_t>{-4, 5, 6}));
  EXPECT_EQ(sensors.keyFrame, (std::vector<int32_t>{-1}));
  EXPECT_EQ(ThereAndBack(RcPlayRequest{"WALK.MTN", 3, 2}).file, "WALK.MTN");
  EXPECT_EQ(ThereAndBack(RcPlayAnswer{1136, 72, 5}).durationMs, 1136u);
  EXPECT_EQ(ThereAndBack(RcList{2, 0, {{"A.MTN", 7}, {"B.MTN", 8}}}).entries[1].size, 8u);
  EXPECT_EQ(ThereAndBack(RcUploadBegin{1, "A.MTN", 3, 0xfedcba98}).crc, 0xfedcba98);
  EXPECT_EQ(ThereAndBack(RcFileName{0, "A.MTN"}).name, "A.MTN");
  EXPECT_EQ(ThereAndBack(RcDownload{0, "A.MTN", 1004}).offset, 1004u);
}

}  // namespace
}  // namespace openr_host
