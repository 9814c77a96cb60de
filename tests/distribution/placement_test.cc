// The placement file and --place, and the errors reported for wrong lines.
#include "distribution/placement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "distribution/join_advice.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

// Returns all errors in a file "where.cfg" with this text.
std::string Complaints(const std::string& text) {
  std::vector<Diagnostic> diagnostics;
  ParsePlacement("where.cfg", text, &diagnostics);
  return Render(diagnostics);
}

TEST(PlacementTest, AFileNamesObjectsProcessesAndHosts) {
  std::vector<Diagnostic> diagnostics;
  const Placement placement = ParsePlacement("where.cfg",
                                             "# object     process\r\n"
                                             "RCServer     network\n"
                                             "\n"
                                             "BallTracker  vision\n"
                                             "Camera       vision\n"
                                             "@vision      192.168.1.7\n",
                                             &diagnostics);
  EXPECT_EQ(Render(diagnostics), "");
  EXPECT_THAT(placement.process_of,
              ElementsAre(Pair("BallTracker", "vision"), Pair("Camera", "vision"),
                          Pair("RCServer", "network")));
  EXPECT_THAT(placement.host_of, ElementsAre(Pair("vision", "192.168.1.7")));
  EXPECT_THAT(placement.Processes(), ElementsAre("network", "vision"));
}

TEST(PlacementTest, AnEmptyFilePlacesNothing) {
  std::vector<Diagnostic> diagnostics;
  EXPECT_TRUE(ParsePlacement("where.cfg", "# nobody\n", &diagnostics).empty());
  EXPECT_TRUE(diagnostics.empty());
}

TEST(PlacementTest, ALineWithoutTwoWordsIsReported) {
  EXPECT_EQ(Complaints("Camera vision\nRCServer\n"),
            "where.cfg:2: a line has two words: an object and its process, or @process and the "
            "address of its host\nRCServer\n^\n");
  EXPECT_THAT(Complaints("Camera vision now\n"), ::testing::StartsWith("where.cfg:1: a line has"));
}

TEST(PlacementTest, NamesWithWildcardsAreRefusedWithACaret) {
  EXPECT_EQ(
      Complaints("Camera vi*\n"),
      "where.cfg:1: 'vi*' is no name for a process: up to 64 letters, digits, '_', '-' and '.'\n"
      "Camera vi*\n"
      "       ^\n");
  for (const char* name : {"a/b", "?", "a=b", "\xc3\xa4"})
    EXPECT_NE(Complaints(std::string("Camera ") + name + "\n"), "") << name;
  EXPECT_NE(Complaints("Camera " + std::string(65, 'a') + "\n"), "");
  EXPECT_EQ(Complaints("Camera " + std::string(64, 'a') + "\n"), "");
}

TEST(PlacementTest, AnObjectHasOnePlace) {
  EXPECT_EQ(Complaints("Camera vision\nCamera eyes\n"),
            "where.cfg:2: Camera is placed in 'vision' already\nCamera eyes\n       ^\n");
  EXPECT_EQ(Complaints("Camera vision\nCamera vision\n"), "") << "said twice, meant once";
}

TEST(PlacementTest, AProcessHasOneHostAndAnObject) {
  EXPECT_THAT(Complaints("Camera vision\n@vision 10.0.0.1\n@vision 10.0.0.2\n"),
              ::testing::StartsWith("where.cfg:3: process 'vision' has a host already"));
  EXPECT_THAT(Complaints("Camera vision\n@visoin 10.0.0.1\n"),
              ::testing::StartsWith("where.cfg:2: no object is placed in 'visoin'"));
}

std::string HostComplaints(const std::string& text, const std::string& own_address) {
  std::vector<Diagnostic> none;
  return Render(WrongHosts(ParsePlacement("where.cfg", text, &none), own_address));
}

TEST(PlacementTest, AnotherHostHasToReachThisOne) {
  const std::string text = "Camera vision\n@vision 192.168.1.7\n";
  EXPECT_EQ(HostComplaints(text, "127.0.0.1"),
            "where.cfg:2: 192.168.1.7 cannot reach this run at 127.0.0.1; give --dds-address, the "
            "address of this host in the network of that one\n@vision 192.168.1.7\n        ^\n");
  EXPECT_EQ(HostComplaints(text, "192.168.1.2"), "");
  EXPECT_EQ(HostComplaints("Camera vision\n@vision 127.0.0.2\n", "127.0.0.1"), "");
  EXPECT_EQ(HostComplaints("Camera vision\n@vision localhost\n", "127.0.0.1"), "");
}

TEST(PlacementTest, AHostThatNobodyKnowsIsRefused) {
  const std::string complaint =
      HostComplaints("Camera vision\n@vision here..there\n", "192.168.1.2");
  EXPECT_THAT(complaint,
              ::testing::StartsWith("where.cfg:2: host 'here..there' cannot be found ("));
  EXPECT_THAT(complaint, ::testing::EndsWith("; give its address\n@vision here..there\n"
                                             "        ^\n"));
}

TEST(PlacementTest, TheCommandLineAddsToTheFile) {
  Placement placement;
  EXPECT_EQ(AddPlace("Camera=vision", &placement), "");
  EXPECT_EQ(AddPlace("Camera=eyes", &placement), "Camera is placed in 'vision' already");
  EXPECT_EQ(AddPlace("Camera", &placement), "it is OBJECT=PROCESS");
  EXPECT_EQ(AddPlace("=vision", &placement), "it is OBJECT=PROCESS");
  EXPECT_NE(AddPlace("RCServer=", &placement), "");
  EXPECT_THAT(placement.process_of, ElementsAre(Pair("Camera", "vision")));
}

TEST(JoinAdviceTest, TheAdviceHasTheFlagsThatAreNeeded) {
  BusOptions bus;
  bus.run = "openr";
  EXPECT_EQ(JoinAdvice("vision", "127.0.0.1", bus),
            "start it on 127.0.0.1 with: openr join --process vision");
  bus.run = "team";
  bus.domain = 7;
  bus.address = "192.168.1.2";
  bus.lease_s = 60;
  bus.config_file = "alpha.xml";
  EXPECT_EQ(JoinAdvice("vision", "192.168.1.7", bus),
            "start it on 192.168.1.7 with: openr join --process vision --run-name team "
            "--dds-domain 7 --dds-address 192.168.1.7 --dds-peer 192.168.1.2 --dds-lease 60 "
            "--dds-config FILE --stick DIR");
}

}  // namespace
}  // namespace openr_host
