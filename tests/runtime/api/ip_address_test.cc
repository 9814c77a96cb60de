#include <IPAddress.h>
#include <IPv4Types.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace {

std::string Text(const IPAddress& address) {
  char text[16];
  EXPECT_EQ(address.GetAsString(text), text);
  return text;
}

TEST(IPAddressTest, IsKeptInTheOrderOfTheHost) {
  EXPECT_EQ(IPAddress("10.0.1.2").Address(), 0x0a000102u);
  EXPECT_EQ(IPAddress(10, 0, 1, 2).Address(), 0x0a000102u);
}

TEST(IPAddressTest, TextGoesInAndOut) {
  EXPECT_EQ(Text("192.168.254.1"), "192.168.254.1");
  EXPECT_EQ(Text(IPAddress()), "0.0.0.0");
  EXPECT_EQ(Text(0xffffffffu), "255.255.255.255");
}

TEST(IPAddressTest, TheLiteralZeroIsANumber) {
  const IPAddress address = 0;
  EXPECT_EQ(address.Address(), 0u);
}

TEST(IPAddressTest, MalformedTextIsAddressZero) {
  for (const char* text :
       {"", "10", "10.0.1", "10.0.1.2.3", "10.0.1.256", "10..1.2", "10.0.1.2 ", " 10.0.1.2",
        "-1.0.0.1", "+1.0.0.1", "a.b.c.d", "10.0.1.", "10,0,1,2", "99999999999.0.0.1"}) {
    EXPECT_EQ(IPAddress(text).Address(), 0u) << '"' << text << '"';
  }
  EXPECT_EQ(IPAddress(static_cast<const char*>(nullptr)).Address(), 0u);
}

TEST(IPAddressTest, ComparesAsANumber) {
  EXPECT_TRUE(IPAddress("10.0.1.2") == IPAddress(10, 0, 1, 2));
  EXPECT_TRUE(IPAddress("10.0.1.2") != IP_ADDR_ANY);
  EXPECT_TRUE(IPAddress("10.0.1.2") < IPAddress("200.0.0.1"));
}

TEST(IPAddressTest, MasksAndDifferencesAreAddresses) {
  EXPECT_EQ(Text(IPAddress("10.0.1.2") & IPAddress("255.255.255.0")), "10.0.1.0");
  EXPECT_EQ(Text(IPAddress("10.0.1.2") ^ IPAddress("10.0.0.0")), "0.0.1.2");
}

TEST(IPAddressTest, SpecialAddressesAreKnown) {
  EXPECT_TRUE(IPAddress("224.0.0.0").InMulticast());
  EXPECT_TRUE(IPAddress("239.255.255.255").InMulticast());
  EXPECT_FALSE(IPAddress("240.0.0.0").InMulticast());
  EXPECT_TRUE(IP_ADDR_BROADCAST.InBroadcast());
  EXPECT_FALSE(IPAddress("10.0.1.255").InBroadcast());
  EXPECT_TRUE(IPAddress("127.3.2.1").InLoop());
  EXPECT_FALSE(IPAddress("128.0.0.1").InLoop());
  EXPECT_TRUE(IPAddress("224.0.0.1").AllHostsGroup());
  EXPECT_FALSE(IPAddress("224.0.0.2").AllHostsGroup());
}

TEST(IPAddressTest, StreamsItsText) {
  std::ostringstream out;
  out << IPAddress("10.0.1.2");
  EXPECT_EQ(out.str(), "10.0.1.2");
}

}  // namespace
