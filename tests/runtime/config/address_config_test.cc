#include "runtime/config/address_config.h"

#include <gtest/gtest.h>

#include "runtime/config/line_file.h"

namespace openr_host::address_config_test {
namespace {

std::string Problem(std::string_view text) {
  AddressPair pair;
  return ParseAddressPair(text, &pair);
}

TEST(AddressConfigTest, APairIsTwoAddresses) {
  AddressPair pair;
  EXPECT_EQ(ParseAddressPair("10.0.1.2=127.0.0.1", &pair), "");
  EXPECT_EQ(pair, (AddressPair{0x0a000102, 0x7f000001}));
  EXPECT_EQ(AddressText(pair.robot), "10.0.1.2");
}

TEST(AddressConfigTest, WhatIsWrongIsSaid) {
  constexpr char kForm[] = "; write ROBOT=HOST, such as 10.0.1.2=127.0.0.1";
  EXPECT_EQ(Problem("10.0.1.2"), std::string("'10.0.1.2' is no pair of addresses") + kForm);
  for (const char* bad : {"10.0.1", "10.0.1.256", "10.0.1.2.3", "10..1.2", "mypc", "", " 10.0.1.2",
                          "10.0.1.2:80", "0x0a.0.1.2", "10.0.1.0002"}) {
    SCOPED_TRACE(bad);
    const std::string expected =
        std::string("'") + bad +
        "' is no address; write four numbers of 0 to 255 with dots between them, such as 10.0.1.2 "
        "(names are not looked up)" +
        kForm;
    EXPECT_EQ(Problem(std::string(bad) + "=127.0.0.1"), expected);
    EXPECT_EQ(Problem(std::string("10.0.1.2=") + bad), expected);
  }
  EXPECT_EQ(
      Problem("10.0.1.2=0.0.0.0"),
      std::string("'0.0.0.0' is no address of one computer, but of any, many or all") + kForm);
  EXPECT_EQ(Problem("224.0.0.1=127.0.0.1").substr(0, 24), "'224.0.0.1' is no addres");
  EXPECT_EQ(Problem("127.0.0.1=10.0.1.2").substr(0, 45),
            "'127.0.0.1' cannot stand for another address:");
}

TEST(AddressConfigTest, AnAddressIsMappedOnce) {
  std::vector<AddressPair> pairs;
  EXPECT_EQ(AddAddressPair({0x0a000102, 0x7f000001}, &pairs), "");
  EXPECT_EQ(AddAddressPair({0x0a000102, 0x7f000002}, &pairs),
            "10.0.1.2 stands for 127.0.0.1 already");
  EXPECT_EQ(pairs.size(), 1u);
}

TEST(AddressConfigTest, AFileHoldsAPairPerLineAndTheFirstOfTwoListsWins) {
  const AddressConfig config = ParseAddressConfig(
      "HOSTADDR.CFG", "# of 2003\r\n10.0.1.2 127.0.0.1\r\n[ERS-7]\n10.0.1.3 127.0.0.1\n",
      "ERS-210");
  EXPECT_EQ(Render(config.diagnostics), "");
  ASSERT_EQ(config.pairs.size(), 1u);
  const std::vector<AddressPair> merged =
      MergeAddressPairs({{0x0a000102, 0x7f000002}}, {config.pairs[0], {5, 6}});
  EXPECT_EQ(merged, (std::vector<AddressPair>{{0x0a000102, 0x7f000002}, {5, 6}}));
}

TEST(AddressConfigTest, ABadAddressIsNamedWithItsFileAndLine) {
  const AddressConfig config = ParseAddressConfig(
      "HOSTADDR.CFG", "# of 2003\n10.0.1.2 10.0.1.0002\n10.0.1.3 224.0.0.1\n", "ERS-210");
  EXPECT_EQ(Render(config.diagnostics),
            "HOSTADDR.CFG:2: '10.0.1.0002' is no address; write four numbers of 0 to 255 with dots "
            "between them, such as 10.0.1.2 (names are not looked up); the line is left out\n"
            "10.0.1.2 10.0.1.0002\n^\n"
            "HOSTADDR.CFG:3: '224.0.0.1' is no address of one computer, but of any, many or all; "
            "the line is left out\n10.0.1.3 224.0.0.1\n^\n");
  EXPECT_TRUE(config.pairs.empty());
}

TEST(AddressConfigTest, ABadLineIsNamedAndLeftOut) {
  const AddressConfig config =
      ParseAddressConfig("HOSTADDR.CFG", "10.0.1.2=127.0.0.1\n10.0.1.2 127.0.0.1\n", "ERS-210");
  EXPECT_EQ(Render(config.diagnostics),
            "HOSTADDR.CFG:1: a line holds two addresses: what programs call it, and where it is; "
            "the line is left out\n10.0.1.2=127.0.0.1\n^\n");
  EXPECT_EQ(config.pairs.size(), 1u);
}

}  // namespace
}  // namespace openr_host::address_config_test
