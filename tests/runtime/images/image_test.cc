// Objects loaded from images: statics, heaps, files and ends of methods of their own.
#include <OPENR/RCRegion.h>
#include <elf.h>
#include <gtest/gtest.h>

#include <cfenv>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/core/arithmetic_watch.h"
#include "runtime/core/dispatcher.h"
#include "runtime/core/image_info.h"
#include "runtime/core/image_object.h"
#include "runtime/core/load_image.h"
#include "runtime/core/load_stick.h"
#include "tests/runtime/images/image_fixture.h"

namespace openr_host {
namespace {

// Returns the place of ImageInfo::headers_version in the bytes of an image; 0 if there is none.
size_t PlaceOfHeadersVersion(const std::string& bytes) {
  const auto* const header = reinterpret_cast<const Elf64_Ehdr*>(bytes.data());
  const auto* const sections = reinterpret_cast<const Elf64_Shdr*>(bytes.data() + header->e_shoff);
  for (int i = 0; i < header->e_shnum; ++i) {
    if (sections[i].sh_type != SHT_DYNSYM) continue;
    const char* const names = bytes.data() + sections[sections[i].sh_link].sh_offset;
    const auto* const symbols =
        reinterpret_cast<const Elf64_Sym*>(bytes.data() + sections[i].sh_offset);
    for (size_t k = 0; k < sections[i].sh_size / sizeof(Elf64_Sym); ++k) {
      if (std::string_view(names + symbols[k].st_name) != "openr_image_info") continue;
      const Elf64_Shdr& home = sections[symbols[k].st_shndx];
      return home.sh_offset + (symbols[k].st_value - home.sh_addr) +
             offsetof(ImageInfo, headers_version);
    }
  }
  return 0;
}

// Writes `version` into the image `file` as the version of the headers, and returns the version
// that was there.
uint32_t ReplaceHeadersVersion(const fs::path& file, uint32_t version) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  const size_t place = PlaceOfHeadersVersion(bytes);
  EXPECT_NE(place, 0u);
  uint32_t former;
  std::memcpy(&former, bytes.data() + place, sizeof former);
  std::memcpy(bytes.data() + place, &version, sizeof version);
  std::ofstream(file, std::ios::binary) << bytes;
  return former;
}

TEST_F(ImageTest, BootsSaysItsStateAndAnswers) {
  Start();
  EXPECT_EQ(Findings(), "");
  EXPECT_EQ(system->FindObject(0, "probe")->statistics().state(), "probing");
  EXPECT_EQ(system->FindObject(0, "probe")->limits().priority, 144);
  EXPECT_EQ(talker->Ask("oid"), "known");
  EXPECT_EQ(talker->Ask("stream"), "3.25 1 ff");
}

TEST_F(ImageTest, EveryInstanceHasItsOwnStatics) {
  Start();
  EXPECT_EQ(talker->Ask("count"), "1");
  EXPECT_EQ(talker->Ask("count"), "2");
  const std::string random = talker->Ask("random");
  Start();  // another System, another load of the same file
  EXPECT_EQ(talker->Ask("count"), "1");
  EXPECT_EQ(talker->Ask("random"), random);
}

TEST_F(ImageTest, TwoRobotsOfOneSystemHaveStaticsOfTheirOwn) {
  Start();
  EXPECT_EQ(talker->Ask("count"), "1");
  const int second = system->AddRobot("ERS-210", stick);
  Object* const other = LoadImage(system.get(), second, "/MS/OPEN-R/MW/OBJS/PROBE.BIN", "test");
  ASSERT_NE(other, nullptr) << Findings();
  EXPECT_EQ(talker->Ask("count"), "2");
}

TEST_F(ImageTest, SeesTheStickInAnyCaseAndNothingElse) {
  Start();
  EXPECT_EQ(talker->Ask("read"), "hello stick");
  EXPECT_EQ(talker->Ask("size"), "11");
  EXPECT_EQ(talker->Ask("list"), "listed");
  EXPECT_EQ(talker->Ask("read outside"), "no file");
  EXPECT_EQ(talker->Ask("read dotdot"), "no file");
  EXPECT_NE(Findings().find("'/etc/passwd' cannot be opened: on the robot every path is absolute"),
            std::string::npos);
}

// field-notes.md, 13.1
TEST_F(ImageTest, APathThatIsNotAbsoluteNamesNoFileAndIsReported) {
  Write("HELLO.TXT", "hello root");
  Start();
  EXPECT_EQ(talker->Ask("read relative"), "no file");
  EXPECT_NE(Findings().find("'HELLO.TXT' cannot be opened: on the robot every path is absolute"),
            std::string::npos)
      << Findings();
}

TEST_F(ImageTest, FilesItWritesAreOnTheStickInUpperCaseAndPartOfTheState) {
  Start();
  const uint64_t before = system->state_hash();
  EXPECT_EQ(talker->Ask("write"), "written");
  std::ifstream file(root / "OPEN-R/MW/DATA/P/OUT.TXT");
  std::string text;
  std::getline(file, text);
  EXPECT_EQ(text, "from the probe");
  const uint64_t written = system->state_hash();
  Write("OPEN-R/MW/DATA/P/OUT.TXT", "something else");
  EXPECT_NE(system->state_hash(), written);
  EXPECT_NE(before, written);
}

TEST_F(ImageTest, AStickThatFailsIsAnErrorOfTheCallNotOfTheRun) {
  Start();
  system->robot(0).stick = std::make_shared<FailingStick>(stick, 1, EIO);
  EXPECT_EQ(talker->Ask("write"), "cannot write");
  EXPECT_EQ(talker->Ask("write"), "written");
}

TEST_F(ImageTest, AWriteProtectedStickRefusesWriters) {
  stick->set_writable(false);
  Start();
  EXPECT_EQ(talker->Ask("write"), "cannot write");
  EXPECT_EQ(talker->Ask("read"), "hello stick");
}

TEST_F(ImageTest, ExitEndsTheMethodAndTheObjectGoesOn) {
  Start();
  SendExtra("DoExit");
  EXPECT_NE(printed.find("before exit"), std::string::npos);
  EXPECT_EQ(talker->Ask("count"), "1");
}

TEST_F(ImageTest, AbortIsReportedAndEndsTheMethodOnly) {
  Start();
  SendExtra("DoAbort");
  EXPECT_NE(Findings().find("abort() called"), std::string::npos);
  EXPECT_EQ(talker->Ask("count"), "1");
}

// The parameter: whether floating-point faults raise SIGFPE.  They do not with a sanitizer.
class RoundingTest : public ImageTest, public testing::WithParamInterface<bool> {
 protected:
  RoundingTest() { ArithmeticWatch::SetCatches(GetParam()); }
  ~RoundingTest() override { ArithmeticWatch::SetCatches(false); }

  // Expects that this process rounds to the nearest number.
  static void ExpectNearest() {
    EXPECT_EQ(std::fegetround(), FE_TONEAREST);
    volatile double one = 1, three = 3;
    EXPECT_EQ(one / three, 1.0 / 3);
  }
};

TEST_P(RoundingTest, AModeEndsWithItsHandlerAndIsNotThatOfTheSdk) {
  Start();
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(talker->Ask("round"), "began nearest, goes on up");
    ExpectNearest();
  }
  EXPECT_NE(printed.find("0.4 is printed as 0\n"), std::string::npos) << printed;
}

TEST_P(RoundingTest, AModeIsNotThatOfOthersWhileItsHandlerWaits) {
  Start();
  EXPECT_EQ(talker->Ask("round wait"), "began nearest, goes on up");
  EXPECT_EQ(talker->rounding, FE_TONEAREST);
  ExpectNearest();
}

TEST_P(RoundingTest, AModeEndsWithAHandlerThatDoesNotReturnNormally) {
  for (const char* const how : {"round exit", "round throw"}) {
    SCOPED_TRACE(how);
    Start();
    EXPECT_EQ(talker->Ask(how), "(no answer)");
    ExpectNearest();
    SendExtra("DoExit");  // takes a stack that was in use before
    ExpectNearest();
  }
}

INSTANTIATE_TEST_SUITE_P(Signals, RoundingTest, testing::Bool());

TEST_F(ImageTest, AnUncaughtExceptionIsReportedWithItsText) {
  Start();
  SendExtra("DoThrow");
  EXPECT_NE(Findings().find("uncaught exception in DoThrow: thrown by the probe"),
            std::string::npos);
  EXPECT_EQ(talker->Ask("count"), "1");
}

TEST_F(ImageTest, LongIsThirtyTwoBitsInConsoleFormats) {
  Start();
  talker->Ask("long");
  EXPECT_NE(printed.find("-5    42|"), std::string::npos) << printed;
}

TEST_F(ImageTest, StopAndDestroyRunAtShutdown) {
  Start();
  system->Shutdown();
  system->RunFor(1000);
  EXPECT_TRUE(system->powered_off());
  EXPECT_LT(printed.find("stopped"), printed.find("destroyed"));
}

TEST_F(ImageTest, AReloadedImageStartsFreshUnderItsOidAndIsConnectedAgain) {
  Start();
  EXPECT_EQ(talker->Ask("count"), "1");
  EXPECT_EQ(talker->Ask("count"), "2");
  const ObjectId id = system->FindObject(0, "probe")->id;
  system->object_table().Reload(id);
  system->RunFor(1000);
  EXPECT_EQ(Findings(), "");
  EXPECT_EQ(system->FindObject(0, "probe")->id, id);
  EXPECT_LT(printed.find("stopped"), printed.find("destroyed"));
  EXPECT_EQ(talker->Ask("count"), "1");
  EXPECT_EQ(talker->Ask("count"), "2");
}

TEST_F(ImageTest, WhatAReloadedImageWasLentGoesBack) {
  Start();
  RCRegion* region = nullptr;
  RunAs(talker, [&] {
    region = new RCRegion(16);
    std::strcpy(region->Base(), "count");
    talker->out->SetData(region);
    talker->out->NotifyObservers();  // on its way when the reload begins
    EXPECT_EQ(region->NumberOfReference(), 2);
  });
  system->object_table().Reload(system->FindObject(0, "probe")->id);
  system->RunFor(1000);
  EXPECT_EQ(region->NumberOfReference(), 1);
  EXPECT_EQ(talker->Ask("count"), "1");
}

// The answer waits for its observer, which waits in a handler, when the reload begins.
TEST_F(ImageTest, WhatTheOldImageHasSentArrivesUnchanged) {
  Start();
  system->Post(system->NewMessage(talker->host().id, talker->sleep));
  system->RunFor(100);
  RunAs(talker, [&] {
    talker->out->SetData("count", sizeof "count");
    talker->out->NotifyObservers();
  });
  system->RunFor(100);
  EXPECT_EQ(talker->answer, "");
  system->object_table().Reload(system->FindObject(0, "probe")->id);
  system->RunFor(100);
  EXPECT_NE(printed.find("destroyed"), std::string::npos);
  // New regions, whose memory would be that of the answer if the reload had freed it.
  std::vector<RCRegion*> regions;
  RunAs(talker, [&] {
    for (int i = 0; i < 8; ++i) regions.push_back(new RCRegion(2));
  });
  system->RunFor(2 * Talker::kSleepUs);
  EXPECT_EQ(talker->answer, "1");
  EXPECT_EQ(system->regions().CountOf(kNoObject), 0);  // the answer was given back
  EXPECT_EQ(Findings(), "");
  EXPECT_EQ(talker->Ask("count"), "1");
  RunAs(talker, [&] {
    for (RCRegion* const region : regions) region->RemoveReference();
  });
}

// Keeps all notifications.
class NotificationGate : public Gate {
 public:
  OwnedMessage Admit(OwnedMessage message) override {
    if (message->kind == PayloadKind::kNotify) kept.push_back(std::move(message));
    return message;
  }
  void ForEach(const std::function<void(const Message&)>& visit) const override {
    for (const OwnedMessage& message : kept) visit(*message);
  }
  std::vector<OwnedMessage> kept;
};

TEST_F(ImageTest, WhatAGateKeepsOfTheOldImageArrivesUnchanged) {
  Start();
  NotificationGate gate;
  RunAs(talker, [&] {
    talker->out->SetData("count", sizeof "count");
    talker->out->NotifyObservers();
  });
  system->Step();  // the image gets the question
  system->dispatcher().set_gate(&gate);
  system->RunFor(100);
  ASSERT_EQ(gate.kept.size(), 1u);  // the answer
  system->object_table().Reload(system->FindObject(0, "probe")->id);
  system->RunFor(1000);
  EXPECT_NE(printed.find("destroyed"), std::string::npos);
  // New regions, whose memory would be that of the answer if the reload had freed it.
  std::vector<RCRegion*> regions;
  RunAs(talker, [&] {
    for (int i = 0; i < 8; ++i) regions.push_back(new RCRegion(2));
  });
  system->dispatcher().set_gate(nullptr);
  system->Readmit(std::move(gate.kept[0]));
  gate.kept.clear();
  system->RunFor(1000);
  EXPECT_EQ(talker->answer, "1");
  EXPECT_EQ(system->regions().CountOf(kNoObject), 0);  // the answer was given back
  EXPECT_EQ(Findings(), "");
  RunAs(talker, [&] {
    for (RCRegion* const region : regions) region->RemoveReference();
  });
}

// The reload deletes the regions of the old object after the constructors of the new one have run.
TEST_F(ImageTest, RegionsThatConstructorsMakeOutliveAReload) {
  Write("OPEN-R/MW/DATA/P/REGION.TXT", "");
  Start();
  EXPECT_EQ(talker->Ask("region"), "made early");
  const ObjectId id = system->FindObject(0, "probe")->id;
  EXPECT_EQ(system->regions().CountOf(id), 1);
  system->object_table().Reload(id);
  system->RunFor(1000);
  EXPECT_EQ(system->regions().CountOf(id), 1);
  EXPECT_EQ(system->regions().CountOf(kNoObject), 0);
  EXPECT_EQ(talker->Ask("region"), "made early");
}

// The reload ends the events of the old object after the constructors of the new one have run.
TEST_F(ImageTest, TimeEventsThatConstructorsOrderOutliveAReload) {
  Write("OPEN-R/MW/DATA/P/EVENT.TXT", "");
  Start();
  system->object_table().Reload(system->FindObject(0, "probe")->id);
  system->RunFor(400'000);
  EXPECT_EQ(talker->ticks, 0);
  system->RunFor(600'000);
  EXPECT_EQ(talker->ticks, 1);  // the event of the old object has ended with it
}

constexpr char kAllEarly[] = "sent 0, registered 0, ordered 0, asked 0, me";

// An OID is valid in constructors of global objects (core.md, 10.1).
TEST_F(ImageTest, AConstructorSendsToItsOwnObjectAndGivesItAName) {
  Write("OPEN-R/MW/DATA/P/OWN.TXT", "");
  Start();
  EXPECT_EQ(Findings(), "");
  EXPECT_EQ(talker->Ask("early"), std::string("1 early, ") + kAllEarly);
  system->RunFor(1'000'000);
  EXPECT_EQ(talker->Ask("early"), "2 early, sent 0, registered 0, ordered 0, asked 0");
}

// The old object has the id of the new one, and the same names, while the constructors run.
TEST_F(ImageTest, WhatConstructorsSendAndRegisterOutlivesAReload) {
  Write("OPEN-R/MW/DATA/P/OWN.TXT", "");
  Start();
  system->RunFor(1'000'000);
  const ObjectId id = system->FindObject(0, "probe")->id;
  Robot& robot = system->robot(0);
  const auto names = robot.names;
  const auto directory = robot.directory;
  EXPECT_TRUE(names.contains("early bird"));
  EXPECT_TRUE(directory.contains("Probe.Early.Text.S"));
  system->object_table().Reload(id);
  system->RunFor(1000);
  EXPECT_EQ(Findings(), "");
  EXPECT_EQ(robot.names, names);
  EXPECT_EQ(robot.directory, directory);
  EXPECT_EQ(talker->questions, 2);
  EXPECT_EQ(talker->Ask("early"), std::string("1 early, ") + kAllEarly);
}

TEST_F(ImageTest, AReloadThatThrowsInAConstructorSendsAndRegistersNothing) {
  Start();
  Write("OPEN-R/MW/DATA/P/OWN.TXT", "");
  Write("OPEN-R/MW/DATA/P/THROW.TXT", "");
  const auto names = system->robot(0).names;
  const auto directory = system->robot(0).directory;
  system->object_table().Reload(system->FindObject(0, "probe")->id);
  system->RunFor(1'000'000);
  EXPECT_NE(Findings().find("throws an exception: thrown early"), std::string::npos) << Findings();
  EXPECT_EQ(system->robot(0).names, names);
  EXPECT_EQ(system->robot(0).directory, directory);
  EXPECT_EQ(talker->questions, 0);
  EXPECT_EQ(talker->Ask("count"), "1");
}

TEST_F(ImageTest, AnImageThatWasCutOffIsRefused) {
  const fs::path image = root / "OPEN-R/MW/OBJS/PROBE.BIN";
  fs::resize_file(image,
                  5000);  // in the middle of the segments; debug information comes after them
  System broken;
  broken.AddRobot("ERS-210", stick);
  ASSERT_FALSE(LoadStick(&broken, 0));
  EXPECT_NE(broken.findings().all()[0].text.find("ends too early"), std::string::npos);
}

// field-notes.md, 1.14
TEST_F(ImageTest, AnImageBuiltWithOtherHeadersIsRefusedWithBothVersions) {
  const uint32_t other = kHeadersVersion + 1;
  EXPECT_EQ(ReplaceHeadersVersion(root / "OPEN-R/MW/OBJS/PROBE.BIN", other), kHeadersVersion);
  System refusing;
  refusing.AddRobot("ERS-210", stick);
  ASSERT_FALSE(LoadStick(&refusing, 0));
  EXPECT_EQ(
      refusing.findings().all()[0].text,
      fmt::format("OBJECT.CFG:1: /MS/OPEN-R/MW/OBJS/PROBE.BIN was built with version {} of "
                  "the headers of openr-host, this is version {}; build all its sources again",
                  other, kHeadersVersion));
}

TEST_F(ImageTest, AnImageThatDoesNotSayTheVersionOfItsHeadersIsLoaded) {
  ReplaceHeadersVersion(root / "OPEN-R/MW/OBJS/PROBE.BIN", 0);
  Start();
  EXPECT_EQ(Findings(), "");
  EXPECT_EQ(talker->Ask("count"), "1");
}

TEST_F(ImageTest, AReloadThatCannotBeLoadedChangesNothing) {
  Start();
  EXPECT_EQ(talker->Ask("count"), "1");
  Write("OPEN-R/MW/OBJS/PROBE.BIN", "not an image");
  system->object_table().Reload(system->FindObject(0, "probe")->id);
  system->RunFor(1000);
  EXPECT_NE(Findings().find("reload: /MS/OPEN-R/MW/OBJS/PROBE.BIN is not an object image"),
            std::string::npos)
      << Findings();
  EXPECT_EQ(talker->Ask("count"), "2");
}

#if !defined(__SANITIZE_ADDRESS__)
TEST_F(ImageTest, ItsHeapIsItsOwnAndCounted) {
  Start();
  const Object* const probe = system->FindObject(0, "probe");
  EXPECT_EQ(talker->Ask("heap"), "999");
  const size_t before = probe->memory().arena()->bytes_in_use();
  talker->Ask("keep");
  EXPECT_GE(probe->memory().arena()->bytes_in_use(), before + 100000);
}

// The path of a file on the host has another length on each host, so it must not be in the heap.
TEST_F(ImageTest, RemovingAFileTakesNothingOfItsHeap) {
  constexpr int kMany = 1'000'000;
  Start();
  const auto count_allocations = [this] {
    int& left = system->robot(0).memory.allocations_until_failure;
    left = kMany;
    talker->Ask("remove");
    return kMany - std::exchange(left, -1);
  };
  count_allocations();  // the first call makes tables that later calls use
  const int without_file = count_allocations();
  EXPECT_EQ(talker->answer, "-1");
  Write("OPEN-R/MW/DATA/P/GONE.TXT", "text");
  EXPECT_EQ(count_allocations(), without_file);
  EXPECT_EQ(talker->answer, "0");
}
#endif

TEST_F(ImageTest, AMissingImageIsNamedWithFileAndLine) {
  Write("OPEN-R/MW/CONF/OBJECT.CFG", "# objects\n/MS/OPEN-R/MW/OBJS/NOTHERE.BIN\n");
  System broken;
  broken.AddRobot("ERS-210", stick);
  EXPECT_FALSE(LoadStick(&broken, 0));
  ASSERT_FALSE(broken.findings().all().empty());
  EXPECT_EQ(broken.findings().all()[0].text.find(
                "OBJECT.CFG:2: /MS/OPEN-R/MW/OBJS/NOTHERE.BIN does not exist"),
            0u);
}

TEST_F(ImageTest, ABinaryForTheRobotIsToldApartFromGarbage) {
  const std::string gzip = "\x1f\x8b\x08 and so on";
  Write("OPEN-R/MW/OBJS/PROBE.BIN", gzip);
  System broken;
  broken.AddRobot("ERS-210", stick);
  EXPECT_FALSE(LoadStick(&broken, 0));
  EXPECT_NE(broken.findings().all()[0].text.find("is a damaged gzip file"), std::string::npos);
  Write("OPEN-R/MW/OBJS/PROBE.BIN", "text");
  System again;
  again.AddRobot("ERS-210", stick);
  EXPECT_FALSE(LoadStick(&again, 0));
  EXPECT_NE(again.findings().all()[0].text.find("is not an object image"), std::string::npos);
}

}  // namespace
}  // namespace openr_host
