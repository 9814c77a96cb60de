#include "kit/wlan_file.h"

#include <gmock/gmock.h>

#include <deque>

namespace openr_host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<std::string> WarningsAbout(const std::string& text) {
  std::vector<std::string> messages;
  for (const Diagnostic& d :
       CheckWlanSettings("WLANCONF.TXT", ParseWlanConfig("WLANCONF.TXT", text)))
    messages.push_back(d.message);
  return messages;
}

TEST(WlanFileTest, WhatIsWrittenIsReadBackWithoutRemarks) {
  WlanConfig config;
  EXPECT_EQ(SetWlanKey("ESSID", "kitchen", &config), "");
  EXPECT_EQ(SetWlanKey("WEPKEY", "0x0123456789", &config), "");
  EXPECT_EQ(SetWlanKey("ETHER_IP", "192.168.1.5", &config), "");
  EXPECT_EQ(SetWlanKey("IP_GATEWAY", "192.168.1.1", &config), "");
  const std::string text = WlanText(config);
  const WlanResult read = ParseWlanConfig("WLANCONF.TXT", text);
  EXPECT_THAT(read.diagnostics, IsEmpty());
  EXPECT_EQ(read.config.essid, "kitchen");
  EXPECT_EQ(read.config.wep_key, "0x0123456789");
  EXPECT_EQ(read.config.ether_ip, "192.168.1.5");
  EXPECT_THAT(WarningsAbout(text), IsEmpty());
}

// Sony's file has these line ends (network.md 11.1).
TEST(WlanFileTest, LinesEndAsInSonysFile) {
  const std::string text = WlanText({});
  for (size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
    EXPECT_EQ(text[at - 1], '\r');
}

TEST(WlanFileTest, WhatTheRobotWouldNotTakeIsRefusedAndChangesNothing) {
  WlanConfig config;
  EXPECT_EQ(SetWlanKey("CHANNEL", "12", &config), "CHANNEL must be a number from 1 to 11");
  EXPECT_THAT(SetWlanKey("WEPKEY", "sixsix", &config), HasSubstr("5 or 13 characters"));
  EXPECT_THAT(SetWlanKey("HOSTNAME", "much-too-long", &config), HasSubstr("1 to 8 letters"));
  EXPECT_EQ(config.channel, 3);
  EXPECT_EQ(config.wep_key, "AIBO2");
}

TEST(WlanFileTest, SettingsWithoutAMeaningAreLeftOut) {
  WlanConfig config;
  SetWlanKey("USE_DHCP", "1", &config);
  SetWlanKey("WEPENABLE", "0", &config);
  SetWlanKey("APMODE", "1", &config);
  const std::string text = WlanText(config);
  for (const char* key : {"ETHER_IP=", "WEPKEY=", "CHANNEL="})
    EXPECT_THAT(text, Not(HasSubstr(key)));
}

class AskedTest : public ::testing::Test {
 protected:
  bool Ask(const std::deque<std::string>& answers) {
    std::deque<std::string> rest = answers;
    return AskForWlan(
        [&](const std::string& question, const std::string&) -> std::optional<std::string> {
          asked_.push_back(question);
          if (rest.empty()) return std::nullopt;
          const std::string answer = rest.front();
          rest.pop_front();
          return answer;
        },
        [&](const std::string& reason) { refused_.push_back(reason); }, &config_);
  }

  WlanConfig config_;
  std::vector<std::string> asked_, refused_;
};

TEST_F(AskedTest, AnEmptyAnswerKeepsTheValue) {
  EXPECT_TRUE(Ask(std::deque<std::string>(12)));
  EXPECT_EQ(WlanText(config_), WlanText({}));
}

TEST_F(AskedTest, ABadAnswerIsAskedAgain) {
  EXPECT_TRUE(Ask({"averylongname", "rex", "", "0", "1", "1"}));
  EXPECT_EQ(config_.hostname, "rex");
  EXPECT_THAT(refused_,
              ElementsAre("HOSTNAME must be 1 to 8 letters and digits, at least one letter"));
}

// No WEP, by an access point, DHCP: neither key, nor channel, nor addresses.
TEST_F(AskedTest, OnlyWhatHasAMeaningIsAsked) {
  EXPECT_TRUE(Ask({"rex", "kitchen", "0", "1", "1"}));
  EXPECT_EQ(asked_.size(), 5u);
}

TEST_F(AskedTest, YesAndNoCanBeWrittenAsWords) {
  EXPECT_TRUE(Ask({"", "", "N", "1", "y"}));
  EXPECT_FALSE(config_.wep_enable);
  EXPECT_TRUE(config_.use_dhcp);
  EXPECT_TRUE(Ask({"", "", "yes", "", "1", "no", "", "", "", "", ""}));
  EXPECT_TRUE(config_.wep_enable);
  EXPECT_FALSE(config_.use_dhcp);
  EXPECT_THAT(refused_, IsEmpty());
}

TEST_F(AskedTest, WhatIsNeitherYesNorNoIsAskedAgain) {
  EXPECT_TRUE(Ask({"", "", "maybe", "no", "1", "yes"}));
  EXPECT_FALSE(config_.wep_enable);
  EXPECT_THAT(refused_, ElementsAre("answer yes or no"));
}

TEST_F(AskedTest, TheEndOfTheInputIsNoAnswer) { EXPECT_FALSE(Ask({"rex", "kitchen"})); }

TEST(WlanSenseTest, TheGatewayMustBeInTheRobotsNetwork) {
  EXPECT_THAT(WarningsAbout("ETHER_IP=192.168.1.5\nWEPKEY=abcde\n"),
              ElementsAre(HasSubstr("IP_GATEWAY 10.0.1.1 is not in the robot's network")));
}

TEST(WlanSenseTest, MasksAndAddressesMustBeThoseOfAHost) {
  EXPECT_THAT(WarningsAbout("ETHER_NETMASK=255.0.255.0\nWEPKEY=abcde\n"),
              ElementsAre(HasSubstr("is no mask of a network")));
  EXPECT_THAT(WarningsAbout("ETHER_IP=10.0.1.255\nWEPKEY=abcde\n"),
              ElementsAre(HasSubstr("give the robot another one")));
}

TEST(WlanSenseTest, WhatIsRefusedIsNotMissing) {
  EXPECT_THAT(WarningsAbout("WEPENABLE=1\n"), ElementsAre(HasSubstr("there is no WEPKEY")));
  EXPECT_THAT(WarningsAbout("WEPENABLE=1\nWEPKEY=0x12\n"), IsEmpty());
  EXPECT_THAT(WarningsAbout("WEPENABLE=1\nWEPKEY = abcde\n"), IsEmpty());
  EXPECT_THAT(WarningsAbout("ETHER_IP=192.168.1.500\nIP_GATEWAY=192.168.1.1\n"), IsEmpty());
}

TEST(WlanSenseTest, SettingsThatDoNothingAreNamed) {
  EXPECT_THAT(WarningsAbout("USE_DHCP=1\nETHER_IP=10.0.1.9\nWEPENABLE=0\nWEPKEY=abcde\nAPMODE=1\n"
                            "CHANNEL=3\n"),
              ElementsAre(HasSubstr("ETHER_IP has no effect"), HasSubstr("WEPKEY has no effect"),
                          HasSubstr("CHANNEL has no effect")));
}

}  // namespace
}  // namespace openr_host
