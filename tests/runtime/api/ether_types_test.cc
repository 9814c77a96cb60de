// Addresses of Ethernet cards.
#include <EtherTypes.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace {

TEST(EtherMACAddressTest, TheDefaultIsAllZeros) {
  EXPECT_TRUE(EtherMACAddress() == EtherMACAddress(0, 0, 0, 0, 0, 0));
}

TEST(EtherMACAddressTest, OctetsGoInAndOutInTheirOrder) {
  byte in[6] = {1, 2, 3, 4, 5, 0xfe};
  byte out[8] = {};
  const EtherMACAddress address(in);
  address.ToByte(out + 1);
  EXPECT_EQ(std::string(out, out + 8), std::string("\0\1\2\3\4\5\376\0", 8));
}

TEST(EtherMACAddressTest, EveryOctetCounts) {
  const EtherMACAddress address(1, 2, 3, 4, 5, 6);
  EXPECT_TRUE(address == EtherMACAddress(1, 2, 3, 4, 5, 6));
  for (int i = 0; i < ETHER_ADDR_LEN; ++i) {
    EtherMACAddress other = address;
    other.octet[i] ^= 0x80;
    EXPECT_FALSE(address == other) << i;
    EXPECT_TRUE(address != other) << i;
  }
}

TEST(EtherMACAddressTest, BroadcastIsAllOnes) {
  EXPECT_TRUE(EtherMACAddress(0xff, 0xff, 0xff, 0xff, 0xff, 0xff).IsBroadcast());
  EXPECT_FALSE(EtherMACAddress(0xff, 0xff, 0xff, 0xff, 0xff, 0xfe).IsBroadcast());
  EXPECT_FALSE(EtherMACAddress().IsBroadcast());
}

TEST(EtherMACAddressTest, MulticastIsTheLowBitOfTheFirstOctet) {
  EXPECT_TRUE(EtherMACAddress(0x01, 0x00, 0x5e, 0, 0, 1).IsMulticast());
  EXPECT_TRUE(EtherMACAddress(0xff, 0xff, 0xff, 0xff, 0xff, 0xff).IsMulticast());
  EXPECT_FALSE(EtherMACAddress(0x02, 0x01, 0x01, 0x01, 0x01, 0x01).IsMulticast());
}

TEST(EtherMACAddressTest, IsStreamedAsSixPairsOfDigits) {
  std::ostringstream out;
  out << EtherMACAddress(0x02, 0, 0xab, 0, 0, 0x1f);
  EXPECT_EQ(out.str(), "02:00:ab:00:00:1f");
}

}  // namespace
