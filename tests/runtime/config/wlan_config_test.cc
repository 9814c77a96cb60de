#include "runtime/config/wlan_config.h"

#include <gtest/gtest.h>

namespace openr_host::wlan_config_test {
namespace {

WlanResult Parse(std::string_view text) { return ParseWlanConfig("WLANCONF.TXT", text); }

std::string ErrorIn(std::string_view text) {
  const WlanResult result = Parse(text);
  return result.diagnostics.empty() ? "" : Render(result.diagnostics[0]);
}

TEST(WlanConfigTest, EmptyFileMeansTheDefaultsOfTheSystem) {
  const WlanResult result = Parse("");
  EXPECT_EQ(result.config.hostname, "AIBO");
  EXPECT_EQ(result.config.ether_ip, "10.0.1.100");
  EXPECT_FALSE(result.config.use_dhcp);
  EXPECT_TRUE(result.keys.empty());
}

TEST(WlanConfigTest, AllKeysAreRead) {
  const WlanResult result = Parse(
      "# settings\r\nHOSTNAME=DOG1\r\nETHER_IP=192.168.0.7\r\nETHER_NETMASK=255.255.0.0\r\n"
      "IP_GATEWAY=192.168.0.1\r\nESSID=My Net\r\nWEPENABLE=0\r\nWEPKEY=0x0123456789\r\n"
      "APMODE=1\r\nCHANNEL=11\r\nDNS_SERVER_1=192.168.0.2\r\nDNS_DEFDNAME=dogs.example\r\n"
      "USE_DHCP=1");
  EXPECT_EQ(Render(result.diagnostics), "");
  EXPECT_EQ(result.keys.size(), 12u);
  EXPECT_EQ(result.config.hostname, "DOG1");
  EXPECT_EQ(result.config.ether_ip, "192.168.0.7");
  EXPECT_EQ(result.config.ether_netmask, "255.255.0.0");
  EXPECT_EQ(result.config.ip_gateway, "192.168.0.1");
  EXPECT_EQ(result.config.essid, "My Net");
  EXPECT_FALSE(result.config.wep_enable);
  EXPECT_EQ(result.config.wep_key, "0x0123456789");
  EXPECT_EQ(result.config.ap_mode, 1);
  EXPECT_EQ(result.config.channel, 11);
  EXPECT_EQ(result.config.dns_server_1, "192.168.0.2");
  EXPECT_EQ(result.config.dns_default_domain, "dogs.example");
  EXPECT_TRUE(result.config.use_dhcp);
}

TEST(WlanConfigTest, BlankBesideTheEqualsSignIsRefused) {
  const std::string message =
      "WLANCONF.TXT:1: blank beside the key or '='; write KEY=VALUE without blanks, the robot does "
      "not accept them\n";
  EXPECT_EQ(ErrorIn("HOSTNAME =DOG\n"), message + "HOSTNAME =DOG\n        ^");
  EXPECT_EQ(ErrorIn("HOSTNAME= DOG\n"), message + "HOSTNAME= DOG\n         ^");
  EXPECT_EQ(ErrorIn(" HOSTNAME=DOG\n"), message + " HOSTNAME=DOG\n^");
  EXPECT_EQ(Parse("HOSTNAME = DOG\n").config.hostname, "AIBO");
}

TEST(WlanConfigTest, TrailingBlanksAreNoPartOfTheValue) {
  EXPECT_EQ(Parse("HOSTNAME=DOG  \t\r\n").config.hostname, "DOG");
}

TEST(WlanConfigTest, LineWithoutEqualsSignIsRefused) {
  EXPECT_EQ(ErrorIn("HOSTNAME DOG\n"),
            "WLANCONF.TXT:1: no '='; write KEY=VALUE, or '#' at the start of a comment\n"
            "HOSTNAME DOG\n"
            "^");
}

TEST(WlanConfigTest, MisspeltKeyGetsASuggestion) {
  EXPECT_EQ(ErrorIn("USEDHCP=1\n"),
            "WLANCONF.TXT:1: warning: unknown key 'USEDHCP' is ignored; did you mean 'USE_DHCP'?\n"
            "USEDHCP=1\n"
            "^");
}

TEST(WlanConfigTest, BadValueLeavesTheSettingAsItWas) {
  EXPECT_EQ(Parse("ETHER_IP=10.0.1.256\n").config.ether_ip, "10.0.1.100");
  EXPECT_EQ(ErrorIn("ETHER_IP=10.0.1.256\n"),
            "WLANCONF.TXT:1: ETHER_IP must be a dotted address such as 10.0.1.100\n"
            "ETHER_IP=10.0.1.256\n"
            "         ^");
}

TEST(WlanConfigTest, AddressesThatAreNoneAreRefused) {
  for (const char* value : {"", "10.0.1", "10.0.1.2.3", "10.0..1", "a.b.c.d", "10.0.1.-1",
                            "10.0.1.+1", "10.0.1.1x", "10.0.1."}) {
    SCOPED_TRACE(value);
    EXPECT_TRUE(HasErrors(Parse(std::string("ETHER_IP=") + value + "\n").diagnostics));
  }
}

TEST(WlanConfigTest, HostNameNeedsALetterAndAtMostEightCharacters) {
  for (const char* value : {"", "12345", "TOOLONGNM", "A-B"}) {
    SCOPED_TRACE(value);
    EXPECT_TRUE(HasErrors(Parse(std::string("HOSTNAME=") + value + "\n").diagnostics));
  }
  EXPECT_EQ(Parse("HOSTNAME=1234567A\n").config.hostname, "1234567A");
}

TEST(WlanConfigTest, WepKeyHasOneOfFourLengths) {
  for (const char* value :
       {"AIBO2", "ABCDEFGHIJKLM", "0x0123456789", "0x0123456789abcdefABCDEF0123"}) {
    SCOPED_TRACE(value);
    EXPECT_EQ(Parse(std::string("WEPKEY=") + value + "\n").config.wep_key, value);
  }
  for (const char* value : {"", "AIBO", "0x012345678", "0x01234567zz"}) {
    SCOPED_TRACE(value);
    EXPECT_TRUE(HasErrors(Parse(std::string("WEPKEY=") + value + "\n").diagnostics));
  }
}

TEST(WlanConfigTest, NumbersOutOfRangeAreRefused) {
  for (const char* line :
       {"CHANNEL=0", "CHANNEL=12", "CHANNEL=", "APMODE=3", "WEPENABLE=2", "CHANNEL=99999999999"}) {
    SCOPED_TRACE(line);
    EXPECT_TRUE(HasErrors(Parse(line).diagnostics));
  }
}

TEST(WlanConfigTest, KeyGivenTwiceKeepsTheLastValue) {
  const WlanResult result = Parse("CHANNEL=4\nCHANNEL=5\n");
  EXPECT_EQ(result.config.channel, 5);
  EXPECT_EQ(result.keys.size(), 1u);
  EXPECT_EQ(Render(result.diagnostics),
            "WLANCONF.TXT:2: warning: CHANNEL is set a second time; this line holds\n"
            "CHANNEL=5\n"
            "^\n");
}

}  // namespace
}  // namespace openr_host::wlan_config_test
