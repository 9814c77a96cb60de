#include "runtime/config/service_name.h"

#include <gtest/gtest.h>

namespace openr_host::service_name_test {
namespace {

std::string FaultIn(std::string_view text) {
  ServiceNameFault fault;
  EXPECT_FALSE(ParseServiceName(text, &fault).has_value());
  return fault.message;
}

TEST(ServiceNameTest, FourPartsAreTakenApart) {
  const auto name = ParseServiceName("OVirtualRobotComm.Effector.OCommandVectorData.O", nullptr);
  ASSERT_TRUE(name.has_value());
  EXPECT_EQ(name->object, "OVirtualRobotComm");
  EXPECT_EQ(name->short_name, "Effector");
  EXPECT_EQ(name->data, "OCommandVectorData");
  EXPECT_EQ(name->direction, 'O');
  EXPECT_FALSE(name->is_subject());
}

TEST(ServiceNameTest, ComposeUndoesParse) {
  EXPECT_EQ(Compose(*ParseServiceName("A.b.char.S", nullptr)), "A.b.char.S");
}

TEST(ServiceNameTest, NamesThatDifferInTheirDataOnly) {
  const ServiceName name = *ParseServiceName("A.b.C.S", nullptr);
  const auto differ = [&name](const char* other) {
    return DifferInDataOnly(name, *ParseServiceName(other, nullptr));
  };
  EXPECT_TRUE(differ("A.b.D.S"));
  for (const char* const other : {"A.b.C.S", "X.b.D.S", "A.x.D.S", "A.b.D.O"})
    EXPECT_FALSE(differ(other)) << other;
}

TEST(ServiceNameTest, CaseCounts) {
  EXPECT_NE(ParseServiceName("A.b.C.S", nullptr), ParseServiceName("A.B.C.S", nullptr));
}

TEST(ServiceNameTest, TooFewOrTooManyPartsAreRefused) {
  EXPECT_EQ(FaultIn("A.B.S"),
            "'A.B.S' has 3 parts, a service name has 4: Object.Service.Data.S for a subject, .O "
            "for an observer");
  EXPECT_EQ(FaultIn("A"),
            "'A' has 1 part, a service name has 4: Object.Service.Data.S for a subject, .O for an "
            "observer");
  EXPECT_NE(FaultIn("A.B.C.D.S"), "");
  EXPECT_NE(FaultIn(""), "");
}

TEST(ServiceNameTest, EmptyPartIsRefusedAtItsOffset) {
  ServiceNameFault fault;
  EXPECT_FALSE(ParseServiceName("A..C.S", &fault).has_value());
  EXPECT_EQ(fault.message,
            "'A..C.S' has an empty part; a service name is Object.Service.Data.S "
            "or .O");
  EXPECT_EQ(fault.offset, 2);
}

TEST(ServiceNameTest, DirectionInLowerCaseIsRefusedWithARemedy) {
  ServiceNameFault fault;
  EXPECT_FALSE(ParseServiceName("A.B.C.s", &fault).has_value());
  EXPECT_EQ(fault.message,
            "'A.B.C.s' ends in '.s'; a subject ends in '.S', an observer in '.O'; did you mean "
            "'.S'?");
  EXPECT_EQ(fault.offset, 6);
}

TEST(ServiceNameTest, ZeroForTheLetterOIsPointedOut) {
  EXPECT_EQ(FaultIn("A.B.C.0"),
            "'A.B.C.0' ends in '.0'; a subject ends in '.S', an observer in '.O'; did you mean "
            "'.O'?");
}

TEST(ServiceNameTest, GatewayProxyLetterIsNoDirection) {
  EXPECT_EQ(FaultIn("TCPGateway.Proxy.AperiosMessage.P"),
            "'TCPGateway.Proxy.AperiosMessage.P' ends in '.P'; a subject ends in '.S', an observer "
            "in '.O'");
}

}  // namespace
}  // namespace openr_host::service_name_test
