#include "runtime/base/parse_ip_address.h"

#include <gtest/gtest.h>

namespace openr_host {
namespace {

TEST(ParseIpAddressTest, FourNumbersAreAnAddress) {
  EXPECT_EQ(ParseIpAddress("10.0.1.2"), 0x0a000102u);
  EXPECT_EQ(ParseIpAddress("010.000.001.255"), 0x0a0001ffu);
  EXPECT_EQ(ParseIpAddress("0.0.0.0"), 0u);
}

TEST(ParseIpAddressTest, AnythingElseIsNone) {
  for (const char* const text :
       {"", "10.0.1", "10.0.1.", "10.0.1.2.3", "10.0.1.256", "10..1.2", "10.0.1.0002", " 10.0.1.2",
        "10.0.1.2 ", "-1.0.1.2", "+1.0.1.2", "0x0a.0.1.2", "10.0.1.2:80", "host"})
    EXPECT_EQ(ParseIpAddress(text), std::nullopt) << text;
}

}  // namespace
}  // namespace openr_host
