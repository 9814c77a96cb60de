// Network settings from the Memory Stick.
#include "runtime/ipstack/parameters.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

class ParametersTest : public testing::Test {
 protected:
  ParametersTest() {
    std::string name = testing::TempDir() + "openr_parameters_XXXXXX";
    root = mkdtemp(name.data());
    std::filesystem::create_directories(root / "OPEN-R/SYSTEM/CONF");
  }
  ~ParametersTest() override { std::filesystem::remove_all(root); }

  void Write(const char* name, const char* text) {
    std::ofstream(root / "OPEN-R/SYSTEM/CONF" / name) << text;
  }
  Parameters Read(const std::string& address = "") {
    FolderStick stick(root);
    return Parameters(&stick, address);
  }

  std::filesystem::path root;
};

TEST_F(ParametersTest, ComeFromWlanconf) {
  Write("WLANCONF.TXT", "ETHER_IP=192.168.1.7\r\nDNS_DEFDNAME=example.net\r\n");
  Write("WLANDFLT.TXT", "ETHER_IP=192.168.1.8\r\n");
  EXPECT_EQ(Read().wlan().ether_ip, "192.168.1.7");
  EXPECT_EQ(Read().wlan().dns_default_domain, "example.net");
}

TEST_F(ParametersTest, ComeFromWlandfltWithoutWlanconf) {
  Write("WLANDFLT.TXT", "ETHER_IP=192.168.1.8\n");
  EXPECT_EQ(Read().wlan().ether_ip, "192.168.1.8");
}

TEST_F(ParametersTest, AreSonysWithoutAFileAndWithoutAStick) {
  EXPECT_EQ(Read().wlan().ether_ip, "10.0.1.100");
  EXPECT_EQ(Parameters(nullptr, "").wlan().ether_ip, "10.0.1.100");
}

TEST_F(ParametersTest, GivenAddressReplacesTheOneOfTheFile) {
  Write("WLANCONF.TXT", "ETHER_IP=192.168.1.7\n");
  EXPECT_EQ(Read("10.0.1.101").wlan().ether_ip, "10.0.1.101");
}

TEST_F(ParametersTest, BadLinesAreReported) {
  Write("WLANCONF.TXT", "ETHER_IP = 192.168.1.7\n");
  ASSERT_EQ(Read().diagnostics().size(), 1u);
  EXPECT_EQ(Read().diagnostics()[0].file, "WLANCONF.TXT");
}

TEST_F(ParametersTest, LongTextIsCutToTheRoomOfAMessage) {
  Write("WLANCONF.TXT", "ESSID=0123456789abcdef0123456789abcdef\n");
  antEnvInitGetParamMsg message("ESSID");
  EXPECT_EQ(Read().Get(&message), ANT_SUCCESS);
  EXPECT_STREQ(message.value.str, "0123456789abcdef0123456789abcde");
}

}  // namespace
}  // namespace openr_host
