// Tests of the parts of which a bench is built: sticks, images, stand-ins, probes.
#include "openr/simulation/simulation.h"
#include "tests/testing/doubler.h"

namespace openr::testing {
namespace {

using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

std::string ImageFile(const std::string& name) { return std::string(OPENR_IMAGES) + "/" + name; }

// The text of what `call` throws.
std::string ErrorOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::exception& e) {
    return e.what();
  }
  return "(nothing thrown)";
}

TEST(BuildTest, AnImageRunsAsItWasBuilt) {
  Bench bench;
  EXPECT_EQ(bench.AddImage(ImageFile("TROUBLE.BIN")).name, "Trouble");
  EXPECT_TRUE(bench.stick().Has("/MS/OPEN-R/MW/OBJS/TROUBLE.BIN"));
  bench.Boot();
  EXPECT_THAT(bench.console(), HasSubstr("Trouble is running"));
}

TEST(BuildTest, AnImageReplacesAnImageOfTheSameName) {
  Bench bench;
  const std::string name = "/MS/OPEN-R/MW/OBJS/TROUBLE.BIN";
  bench.stick().ImportImage(ImageFile("TROUBLE.BIN"), name);
  EXPECT_EQ(ErrorOf([&] { bench.stick().ImportImage(ImageFile("TROUBLE.BIN"), name); }),
            "(nothing thrown)");
}

TEST(BuildTest, AnImageSeesTheStickOfTheBench) {
  Bench bench;
  bench.stick().Write("/MS/OPEN-R/MW/DATA/P/TROUBLE.TXT", "print");
  bench.AddImage(ImageFile("TROUBLE.BIN"));
  bench.Boot();
  EXPECT_THAT(bench.console(), HasSubstr("said by an object"));
}

TEST(BuildTest, AnImageThatIsNoneSaysWhy) {
  Bench bench;
  EXPECT_THAT(ErrorOf([&] { bench.AddImage(ImageFile("NOBODY.BIN")); }),
              HasSubstr("NOBODY.BIN: cannot be read; the image of an object is what "
                        "openr_add_object() builds"));
  bench.stick().Write("/MS/OPEN-R/MW/DATA/P/TEXT.BIN", "not an image at all");
  const std::string text_file = bench.stick().Locate("/MS/OPEN-R/MW/DATA/P/TEXT.BIN").path;
  EXPECT_THAT(ErrorOf([&] { bench.AddImage(text_file); }), HasSubstr("TEXT.BIN is not"));
}

TEST(BuildTest, AProbeHasTheServicesItIsGiven) {
  Bench bench;
  Probe& probe = bench.AddProbe("Eye", {"Eye.Light.int.O", "Eye.Speed.int.S"});
  EXPECT_EQ(probe.observer("Light").service(), "Eye.Light.int.O");
  EXPECT_EQ(probe.subject("Eye.Speed").service(), "Eye.Speed.int.S");
  EXPECT_EQ(ErrorOf([&] { probe.subject("Light"); }),
            "probe Eye has no subject 'Light'; it has: Eye.Speed.int.S");
  EXPECT_THAT(ErrorOf([&] { bench.AddProbe("Ear", {"Ear.Move"}); }),
              HasSubstr("'Ear.Move' is no service: "));
  EXPECT_EQ(ErrorOf([&] { bench.AddProbe("Eye", {}); }), "there is an object 'Eye' already");
}

TEST(BuildTest, WatchWantsASubjectAndFeedAnObserver) {
  Bench bench;
  EXPECT_EQ(ErrorOf([&] { bench.Watch("A.In.int.O"); }), "'A.In.int.O' is an observer: Feed() it");
  EXPECT_EQ(ErrorOf([&] { bench.Feed("A.Out.int.S"); }), "'A.Out.int.S' is a subject: Watch() it");
}

TEST(BuildTest, AServiceMayBeNamedByItsFirstParts) {
  Bench bench;
  bench.Add<Doubler>("Doubler");
  ProbeObserver& out = bench.Watch("Doubler.Out");
  ProbeSubject& in = bench.Feed("Doubler.In.int");
  EXPECT_EQ(out.service(), "Test1.Out.int.O");
  bench.Boot();
  bench.RunFor(1ms);
  in.Send(2);
  bench.RunFor(1ms);
  EXPECT_EQ(out.values<int>(), Ints{4});
}

TEST(BuildTest, AServiceOfAnImageMayBeNamedByItsFirstParts) {
  Bench bench({.stick = OPENR_STICK, .body = "ideal"});
  EXPECT_EQ(bench.Watch("Controller.Led").service(), "Test1.Led.OCommandVectorData.O");
  EXPECT_EQ(bench.Watch("OVirtualRobotComm.Sensor").service(),
            "Test2.Sensor.OSensorFrameVectorData.O");
}

TEST(BuildTest, ANameThatIsNotEnoughIsRefused) {
  Bench bench;
  bench.Add<Doubler>("Doubler");
  bench.AddProbe("A", {"A.Out.int.S", "A.Out.float.S", "A.Back.int.O"});
  EXPECT_EQ(ErrorOf([&] { bench.Watch("A.Out"); }),
            "'A.Out' may be A.Out.float.S or A.Out.int.S; write the whole name");
  EXPECT_EQ(ErrorOf([&] { bench.Watch("A.Back"); }), "'A.Back.int.O' is an observer: Feed() it");
  EXPECT_EQ(ErrorOf([&] { bench.Watch("Doubler.Owt"); }),
            "there is no subject 'Doubler.Owt' on this bench yet; did you mean 'Doubler.Out'?; add "
            "its object first, or write the whole name");
  EXPECT_THAT(ErrorOf([&] { bench.Watch("Nobody"); }), HasSubstr("'Nobody' is no service: "));
}

TEST(BuildTest, AWireToNobodyFailsTheBoot) {
  Bench bench;
  bench.Add<Doubler>("Doubler");
  bench.Watch("Doubler.Owt.int.S");
  EXPECT_NONFATAL_FAILURE(bench.Boot(),
                          "The runtime found an error: bench.Wire: OServiceManager::Connect() : "
                          "Doubler.Owt.int.S NOT FOUND; did you mean 'Doubler.Out.int.S'?");
}

TEST(BuildTest, ASubjectWithoutAnObserverSaysSo) {
  Bench bench;
  Probe& probe = bench.AddProbe("A", {"A.Out.int.S"});
  bench.Boot();
  EXPECT_NONFATAL_FAILURE(probe.subject("Out").Send(1),
                          "Nobody is connected to A.Out.int.S, so nobody hears it");
}

TEST(BuildTest, DataOfAnotherTypeThanAskedForIsAFailure) {
  Bench bench;
  bench.Add<Doubler>("Doubler");
  ProbeObserver& out = bench.Watch("Doubler.Out.int.S");
  ProbeSubject& in = bench.Feed("Doubler.In.int.O");
  bench.Boot();
  bench.RunFor(1ms);
  EXPECT_NONFATAL_FAILURE(out.last<int>(), "Test1.Out.int.O has received nothing");
  in.Send(1);
  bench.RunFor(1ms);
  EXPECT_NONFATAL_FAILURE(out.last<double>(),
                          " of Doubler.Out: datum 0 has 4 bytes, the type asked for has 8");
  EXPECT_NONFATAL_FAILURE(out.events()[0].as<int>(1), " has 1 data, number 1 was asked for");
}

TEST(BuildTest, AProbeHearsWhoIsReady) {
  Bench bench;
  bench.Add<Doubler>("Doubler");
  ProbeSubject& in = bench.Feed("Doubler.In.int.O");
  bench.Boot();
  bench.RunFor(1ms);
  EXPECT_TRUE(in.all_ready());
  ASSERT_EQ(in.readies().size(), 1u);
  EXPECT_EQ(in.readies()[0].from, "Doubler.In");
  EXPECT_TRUE(in.readies()[0].asserted);
  in.Send(1);
  EXPECT_FALSE(in.any_ready());
}

// ---- Sticks

TEST(StickTest, TheStickIsACopy) {
  Bench bench({.stick = OPENR_STICK});
  const std::string name = "/MS/OPEN-R/MW/CONF/CONNECT.CFG";
  const std::string before = bench.stick().Read(name).value_or("");
  EXPECT_THAT(before, HasSubstr("JointMover"));
  bench.stick().Write(name, "# nobody\n");
  EXPECT_EQ(bench.stick().Read(name), "# nobody\n");
  EXPECT_EQ(Bench({.stick = OPENR_STICK}).stick().Read(name), before);
}

TEST(StickTest, FilesAreWrittenListedAndRemoved) {
  Bench bench;
  BenchStick& stick = bench.stick();
  stick.Write("/MS/OPEN-R/APP/PC/TABLE.TXT", "1 2 3");  // in folders that are new
  stick.Write("/MS/ROOT.TXT", "");
  EXPECT_THAT(stick.List(), ElementsAre("/MS/OPEN-R/APP/PC/TABLE.TXT", "/MS/ROOT.TXT"));
  EXPECT_EQ(stick.Read("/ms/open-r/app/pc/table.txt"), "1 2 3");
  stick.Remove("/MS/ROOT.TXT");
  EXPECT_FALSE(stick.Has("/MS/ROOT.TXT"));
  EXPECT_EQ(stick.Read("/MS/ROOT.TXT"), std::nullopt);
  EXPECT_THAT(ErrorOf([&] { stick.Write("TABLE.TXT", ""); }),
              HasSubstr("'TABLE.TXT' cannot be written"));
}

TEST(StickTest, WhatIsNoStickIsRefused) {
  EXPECT_THAT(ErrorOf([] { Bench bench({.stick = OPENR_IMAGES}); }),
              HasSubstr("holds no folder OPEN-R"));
  EXPECT_EQ(ErrorOf([] { Bench bench({.body = "jelly"}); }),
            "no body 'jelly'; there are: none, ideal, ode");
}

// The same run as the program's: what a bench finds holds for `openr run`.
TEST(StickTest, ABenchRunsAsTheProgramDoes) {
  openr_host::SimulationOptions options;
  options.stick = OPENR_STICK;
  options.body = "ideal";
  options.seed = 7;
  options.host_network = false;
  options.console = [](std::string_view) {};
  openr_host::Simulation simulation(options);
  simulation.system().Boot();
  simulation.system().RunFor(2'000'000);

  Bench bench({.stick = OPENR_STICK, .body = "ideal", .seed = 7});
  bench.Boot();
  bench.RunFor(2s - Duration(bench.now_us()));
  EXPECT_EQ(bench.trace_hash(), simulation.system().trace_hash());
  EXPECT_EQ(bench.state_hash(), simulation.system().state_hash());
}

// ---- Stand-ins

TEST(ReplaceTest, AProbeStandsInWithTheSameServicesAtTheSamePlace) {
  Bench bench({.stick = OPENR_STICK, .replace = {"JointMover"}, .body = "ideal"});
  Probe& mover = bench.probe("JointMover");
  std::vector<std::string> names;
  for (const auto& object : bench.system().objects()) {
    if (!object->is_system()) names.push_back(object->name);
  }
  EXPECT_THAT(names, ElementsAre("PowerMonitor", "JointMover", "RCServer", "Controller"));
  mover.observer("Mover");
  mover.subject("SetValue");
  bench.Boot();
  EXPECT_THAT(mover.calls(), ElementsAre("DoInit", "DoStart"));
  bench.Expect("JointMover.MainExecution", "Controller.MainExecution");
  mover.subject("MainExecution").Send(0);
  EXPECT_TRUE(bench.RunUntilMet(1s));
  EXPECT_EQ(bench.Findings(), "");
}

TEST(ReplaceTest, AProbeForAFileHasNameAndServicesOfTheObject) {
  Bench bench({.stick = OPENR_STICK, .replace = {"JOINTMOV.BIN"}, .body = "ideal"});
  bench.probe("JointMover").observer("Mover");
  EXPECT_TRUE(bench.Boot());
  EXPECT_EQ(bench.Findings(), "");
}

TEST(ReplaceTest, AnythingMayStandIn) {
  Bench bench(
      {.stick = OPENR_STICK,
       .replace = {{"CONTROLL.BIN",  // by its file: it need not exist
                    [](Bench& b) { b.AddProbe("Mine", {"Controller.Ear.OCommandVectorData.S"}); }},
                   "PowerMonitor"}});
  EXPECT_EQ(bench.probe("Mine").subject("Ear").service(), "Controller.Ear.OCommandVectorData.S");
  EXPECT_THROW(bench.object("Controller"), std::invalid_argument);
  EXPECT_EQ(bench.probe("PowerMonitor").calls().size(), 0u);
}

TEST(ReplaceTest, NobodyToReplaceIsAnError) {
  EXPECT_EQ(ErrorOf([] { Bench bench({.stick = OPENR_STICK, .replace = {"JointMovr"}}); }),
            "replace: there is no object 'JointMovr' on the stick; did you mean 'JointMover'?");
}

// ---- Looking

TEST(LookTest, DevicesByNameAndLocator) {
  Bench bench({.stick = OPENR_STICK, .body = "ideal"});
  bench.Boot();
  bench.RunFor(100ms);
  const auto& joint = bench.model().joints[0];
  EXPECT_EQ(bench.JointDeg(joint.name), bench.JointDeg(joint.locator));
  EXPECT_THAT(ErrorOf([&] { bench.JointDeg("RF_j7"); }), HasSubstr("no joint 'RF_j7'"));
  EXPECT_EQ(bench.LedIntensity(bench.model().leds[0].name), 0);
  const int battery = bench.model().FindSensorByLocator(bench.model().sensors[0].locator);
  EXPECT_EQ(battery, 0);
  EXPECT_EQ(bench.SensorValue(bench.model().sensors[0].name), bench.dog().sensor(0).value);
  EXPECT_FALSE(bench.Standing());
  EXPECT_NE(bench.state("JointMover"), "");
}

TEST(FindingsTest, AnErrorFailsTheTestUnlessItIsExpected) {
  const auto build = [](Bench& bench) {
    bench.Add<Doubler>("Doubler").on_alarm = [] { throw std::runtime_error("boom"); };
    bench.Boot();
    bench.Inject(ToEntry("Doubler", "Alarm"), 1);
  };
  Bench bench;
  build(bench);
  EXPECT_NONFATAL_FAILURE(
      bench.RunFor(1ms),
      "The runtime found an error of Doubler: uncaught exception in Alarm: boom");
  Bench expecting;
  expecting.ExpectFinding(HasSubstr("boom"));
  build(expecting);
  expecting.RunFor(1ms);
  expecting.Verify();
  EXPECT_THAT(expecting.Findings(), ContainsRegex("error: Doubler: uncaught exception in Alarm: "
                                                  "boom; .* \\(message [0-9]+: 1\\)\n"));
  expecting.ExpectFinding(HasSubstr("crash"));
  EXPECT_NONFATAL_FAILURE(
      expecting.Verify(),
      "No finding has a text that has substring \"crash\".  Findings:\nerror: ");
  Bench allowing;
  allowing.AllowFindings();
  build(allowing);
  EXPECT_TRUE(allowing.RunFor(1ms));
}

TEST(GuardTest, GuardedRegionsAreReadOnlyForTheirReceiver) {
  const auto write_into = [](bool guard) {
    Bench bench({.guard_regions = guard});
    bench.Add<Doubler>("Doubler");
    ProbeSubject& in = bench.Feed("Doubler.In.int.O");
    ProbeObserver& out = bench.Watch("Doubler.Out.int.S");
    out.set_on_event([](const ONotifyEvent& event) { *event.RCData(0)->Base() = 1; });
    bench.Boot();
    bench.RunFor(1ms);
    in.Send(1);
    bench.RunFor(1ms);
  };
  RunInCopy([&] { write_into(false); }, Place::Here());
  EXPECT_NONFATAL_FAILURE(RunInCopy([&] { write_into(true); }, Place::Here()),
                          "The copy of the process ");
}

TEST(SeedTest, TheEnvironmentGivesTheSeedThatATestDoesNot) {
  setenv("OPENR_SEED", "5", 1);
  EXPECT_EQ(BenchOptions().seed, 5u);
  EXPECT_EQ((BenchOptions{.seed = 3}).seed, 3u);
  setenv("OPENR_SEED", "five", 1);
  EXPECT_THAT(ErrorOf([] { SeedOfEnvironment(); }),
              "OPENR_SEED='five' is no number from 0 to 18446744073709551615");
  unsetenv("OPENR_SEED");
  EXPECT_EQ(BenchOptions().seed, 1u);
}

TEST(BuildTest, TheBatteryIsAsTheOptionsSay) {
  for (const auto& [battery, percent] :
       {std::pair{"100%", 100}, std::pair{"drain", 98}, std::pair{"12%", 10}}) {
    Bench bench({.body = "ideal", .battery = battery});
    bench.Boot();
    bench.RunFor(110s);  // two per cent
    EXPECT_EQ(bench.dog().power().Status().remainingCapacity, percent) << battery;
  }
  EXPECT_THAT(ErrorOf([] { Bench({.body = "ideal", .battery = "half"}); }),
              HasSubstr("battery: 'half' is none of 100%"));
}

}  // namespace
}  // namespace openr::testing
