// Every function about devices is called in one System and answered by the robot of another.
#include "distribution/remote_services.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "distribution/worker_call_list.h"
#include "distribution/worker_calls.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

constexpr OStatus kStatus = 4711;  // the status that every function of the fake robot returns

std::string GainsOf(const word gains[6]) {
  return fmt::format("{} {} {} {} {} {}", gains[0], gains[1], gains[2], gains[3], gains[4],
                     gains[5]);
}

// Records its calls, and returns values of its own.
class NotingRobot : public RobotServices {
 public:
  OStatus OpenPrimitive(const char* locator, OPrimitiveID* id) override {
    *id = 0x1234;
    return Note("open {}", locator);
  }
  OStatus ClosePrimitive(OPrimitiveID id) override { return Note("close {}", id); }
  OStatus ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param,
                           size_t param_size, void* result, size_t result_size) override {
    if (result != nullptr) std::memset(result, 'r', result_size);
    return Note("control {} {} '{}' {}", id, request,
                std::string(static_cast<char*>(param), param == nullptr ? 0 : param_size),
                result == nullptr ? "nothing" : fmt::format("{}", result_size));
  }
  OStatus EnableJointGain(OPrimitiveID id) override { return Note("enable {}", id); }
  OStatus DisableJointGain(OPrimitiveID id) override { return Note("disable {}", id); }
  OStatus SetJointGain(OPrimitiveID id, const word gains[6]) override {
    return Note("set gain {} {}", id, GainsOf(gains));
  }
  OStatus GetJointGain(OPrimitiveID id, word gains[6]) override {
    for (int i = 0; i < 6; ++i) gains[i] = static_cast<word>(60000 + i);
    return Note("get gain {}", id);
  }
  OStatus RegisterDefaultJointGain(OPrimitiveID id, const word gains[6]) override {
    return Note("register gain {} {}", id, GainsOf(gains));
  }
  OStatus SetDefaultJointGain(OPrimitiveID id) override { return Note("set default {}", id); }
  OStatus GetDefaultJointGain(OPrimitiveID id, word gains[6]) override {
    for (int i = 0; i < 6; ++i) gains[i] = static_cast<word>(i);
    return Note("get default {}", id);
  }
  OStatus GetJointValue(OPrimitiveID id, OJointValue* value) override {
    *value = OJointValue(-1, 2, -3, 4, 5);
    return Note("joint {}", id);
  }
  OStatus GetSensorValue(OPrimitiveID id, OSensorValue* value) override {
    value->value = -980;
    value->signal = 17;
    return Note("sensor {}", id);
  }
  OStatus NewSyncKey(OVRSyncKey* key) override {
    *key = 0xfffffffe;
    return Note("new key");
  }
  OStatus CancelSyncKey(OVRSyncKey key) override { return Note("cancel {}", key); }
  OStatus DivideSyncKey(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2) override {
    *key1 = key + 1;
    *key2 = key + 2;
    return Note("divide {}", key);
  }
  OStatus SetCdtVectorData(MemoryRegionID id) override {
    return Note("cdt '{}'", system->regions().BaseOf(id));
  }
  OStatus SetMotorPower(OPower power) override { return Note("motors {}", power); }
  OStatus GetBootCondition(OBootCondition* condition) override {
    *condition = OBootCondition(obcbBOOT_TIMER, 1234567, obcbttABSOLUTE, 3);
    return Note("boot?");
  }
  OStatus Shutdown(const OBootCondition& condition) override {
    return Note("shutdown {} {} {} {}", condition.bitmap, condition.bootTime,
                condition.bootTimeType, condition.vibrationLevel);
  }
  OStatus GetPowerStatus(OPowerStatus* status) override {
    *status = OPowerStatus(0x80000001, 2, 93, 3010, 1500, 8100, -420, -11, 2);
    return Note("power?");
  }
  OStatus ObservePowerStatus(const OPowerStatus& notify, const OServiceEntry& entry) override {
    return Note("observe {} {} of {} {}", notify.robotStatus, notify.timeDif,
                ObjectIdOf(entry.GetOID()), entry.GetSelector());
  }
  OStatus UnobservePowerStatus(const OServiceEntry& entry) override {
    return Note("unobserve of {} {}", ObjectIdOf(entry.GetOID()), entry.GetSelector());
  }
  OStatus SetTime(const OTime& time) override {
    return Note("time {} {}", time.GetClock(), time.GetTimeDif());
  }
  OStatus GetTime(OTime* time) override {
    *time = OTime(86400, 9);
    return Note("time?");
  }
  OStatus SetTimeDifference(sbyte hours) override { return Note("hours {}", hours); }
  OStatus GetTimeDifference(sbyte* hours) override {
    *hours = -12;
    return Note("hours?");
  }
  OStatus SetVolumeSwitch(OVolumeSwitch volume) override { return Note("volume {}", volume); }
  OStatus GetVolumeSwitch(OVolumeSwitch* volume) override {
    *volume = ovolumeSW2;
    return Note("volume?");
  }

  template <typename... T>
  OStatus Note(fmt::format_string<T...> format, T&&... values) {
    heard = fmt::format(format, std::forward<T>(values)...);
    return kStatus;
  }

  System* system = nullptr;
  std::string heard;
};

// Answers questions at once, like the master does.
class DirectLink : public MasterLink {
 public:
  explicit DirectLink(System* master)
      : master_(master),
        calls_(
            master, [](ObjectId) { return true; }, [](const std::string&) {}) {}

  CallResult Ask(uint32_t function, const CallArguments& arguments) override {
    const CurrentScope scope(master_, master_->object(0));
    return WorkerCallList::Call(function, *this, arguments);
  }
  int32_t Post(OwnedMessage, int64_t) override { return 0; }
  void Tell(uint32_t, const CallArguments&) override {}
  void RecordWait(uint64_t, int64_t, std::string_view) override {}
  void RecordWaitForLine(uint64_t, size_t) override {}

  // The targets of calls.
  SystemCalls* operator()(SystemCalls*) { return &calls_; }
  CheckedCalls* operator()(CheckedCalls*) { return &calls_; }
  RobotServices* operator()(RobotServices*) { return master_->robot(0).services.get(); }

 private:
  System* const master_;
  CheckedCalls calls_;
};

class RemoteServicesTest : public testing::Test {
 protected:
  RemoteServicesTest()
      : link(&master), worker(OptionsWith(&link)), services(&link, &worker.regions()) {
    auto noting = std::make_unique<NotingRobot>();
    robot = noting.get();
    robot->system = &master;
    master.robot(master.AddRobot("ERS-210", nullptr)).services = std::move(noting);
  }
  static SystemOptions OptionsWith(MasterLink* link) {
    SystemOptions options;
    options.make_calls = [link](System* system) {
      return std::make_unique<WorkerCalls>(system, link);
    };
    return options;
  }
  // Returns what the robot was asked by a call with this result.
  std::string Heard(OStatus status) {
    EXPECT_EQ(status, kStatus);
    return std::exchange(robot->heard, "(nothing)");
  }

  System master;
  DirectLink link;
  System worker;
  RemoteServices services;
  NotingRobot* robot = nullptr;
};

TEST_F(RemoteServicesTest, Primitives) {
  OPrimitiveID id = 0;
  EXPECT_EQ(Heard(services.OpenPrimitive("PRM:/a", &id)), "open PRM:/a");
  EXPECT_EQ(id, 0x1234u);
  EXPECT_EQ(Heard(services.ClosePrimitive(id)), "close 4660");
  char param[] = "a\0b";
  char result[8] = "-------";
  EXPECT_EQ(Heard(services.ControlPrimitive(7, 3, param, 3, result, 4)),
            std::string("control 7 3 'a\0b' 4", 19));
  EXPECT_STREQ(result, "rrrr---");
  EXPECT_EQ(Heard(services.ControlPrimitive(7, 3, nullptr, 0, nullptr, 0)),
            "control 7 3 '' nothing");
}

TEST_F(RemoteServicesTest, Gains) {
  const word gains[6] = {1, 2, 3, 65535, 5, 6};
  word read[6] = {};
  EXPECT_EQ(Heard(services.EnableJointGain(7)), "enable 7");
  EXPECT_EQ(Heard(services.DisableJointGain(7)), "disable 7");
  EXPECT_EQ(Heard(services.SetJointGain(7, gains)), "set gain 7 1 2 3 65535 5 6");
  EXPECT_EQ(Heard(services.GetJointGain(7, read)), "get gain 7");
  EXPECT_EQ(GainsOf(read), "60000 60001 60002 60003 60004 60005");
  EXPECT_EQ(Heard(services.RegisterDefaultJointGain(7, gains)), "register gain 7 1 2 3 65535 5 6");
  EXPECT_EQ(Heard(services.SetDefaultJointGain(7)), "set default 7");
  EXPECT_EQ(Heard(services.GetDefaultJointGain(7, read)), "get default 7");
  EXPECT_EQ(GainsOf(read), "0 1 2 3 4 5");
}

TEST_F(RemoteServicesTest, Values) {
  OJointValue joint;
  EXPECT_EQ(Heard(services.GetJointValue(7, &joint)), "joint 7");
  EXPECT_EQ(joint.value, -1);
  EXPECT_EQ(joint.pwmDuty, -3);
  EXPECT_EQ(joint.refSignal, 5);
  OSensorValue sensor;
  EXPECT_EQ(Heard(services.GetSensorValue(8, &sensor)), "sensor 8");
  EXPECT_EQ(sensor.value, -980);
  EXPECT_EQ(sensor.signal, 17);
}

TEST_F(RemoteServicesTest, SyncKeys) {
  OVRSyncKey first = 0, second = 0;
  EXPECT_EQ(Heard(services.NewSyncKey(&first)), "new key");
  EXPECT_EQ(first, 0xfffffffe);
  EXPECT_EQ(Heard(services.CancelSyncKey(first)), "cancel 4294967294");
  EXPECT_EQ(Heard(services.DivideSyncKey(100, &first, &second)), "divide 100");
  EXPECT_EQ(first, 101u);
  EXPECT_EQ(second, 102u);
}

TEST_F(RemoteServicesTest, ADetectionTableComesWithItsBytes) {
  const uint32_t region = worker.calls().NewRegion(6, 0);
  std::memcpy(worker.regions().BaseOf(region), "table", 6);
  EXPECT_EQ(Heard(services.SetCdtVectorData(region)), "cdt 'table'");
}

TEST_F(RemoteServicesTest, Power) {
  EXPECT_EQ(Heard(services.SetMotorPower(opowerON)), "motors true");
  EXPECT_EQ(Heard(services.SetMotorPower(opowerOFF)), "motors false");
  OBootCondition boot;
  EXPECT_EQ(Heard(services.GetBootCondition(&boot)), "boot?");
  EXPECT_EQ(boot.bitmap, obcbBOOT_TIMER);
  EXPECT_EQ(boot.bootTime, 1234567);
  EXPECT_EQ(boot.bootTimeType, obcbttABSOLUTE);
  EXPECT_EQ(boot.vibrationLevel, 3);
  EXPECT_EQ(Heard(services.Shutdown(boot)),
            fmt::format("shutdown {} 1234567 {} 3", obcbBOOT_TIMER, obcbttABSOLUTE));
  OPowerStatus power;
  EXPECT_EQ(Heard(services.GetPowerStatus(&power)), "power?");
  EXPECT_EQ(power.robotStatus, 0x80000001);
  EXPECT_EQ(power.temperature, 3010);
  EXPECT_EQ(power.current, -420);
  EXPECT_EQ(power.timeDif, -11);
  EXPECT_EQ(power.volume, 2);
}

TEST_F(RemoteServicesTest, PowerIsObservedInTheNameOfTheAsker) {
  const OServiceEntry entry(OidOf(3), 12);
  OPowerStatus filter;
  filter.robotStatus = 6;
  filter.timeDif = -2;
  EXPECT_EQ(Heard(services.ObservePowerStatus(filter, entry)), "observe 6 -2 of 3 12");
  EXPECT_EQ(Heard(services.UnobservePowerStatus(entry)), "unobserve of 3 12");
}

TEST_F(RemoteServicesTest, ClockAndVolume) {
  EXPECT_EQ(Heard(services.SetTime(OTime(1000, -3))), "time 1000 -3");
  OTime time;
  EXPECT_EQ(Heard(services.GetTime(&time)), "time?");
  EXPECT_EQ(time.GetClock(), 86400);
  EXPECT_EQ(time.GetTimeDif(), 9);
  EXPECT_EQ(Heard(services.SetTimeDifference(-5)), "hours -5");
  sbyte hours = 0;
  EXPECT_EQ(Heard(services.GetTimeDifference(&hours)), "hours?");
  EXPECT_EQ(hours, -12);
  EXPECT_EQ(Heard(services.SetVolumeSwitch(ovolumeSW3)), "volume 3");
  OVolumeSwitch volume = 0;
  EXPECT_EQ(Heard(services.GetVolumeSwitch(&volume)), "volume?");
  EXPECT_EQ(volume, ovolumeSW2);
}

// Master and worker may be of different builds if both have the same VERSION (openr_wire.idl), so a
// function keeps its number as long as VERSION does not change.
TEST(WorkerCallListTest, TheFunctionsHaveTheNumbersOfTheProtocol) {
  EXPECT_EQ(WorkerCallList::NumberOf<&SystemCalls::OpenBox>(), 0u);
  EXPECT_EQ(WorkerCallList::NumberOf<&SystemCalls::NoteFileWritten>(), 25u);
  EXPECT_EQ(WorkerCallList::NumberOf<&CheckedCalls::SetCdtVectorData>(), 26u);
  EXPECT_EQ(WorkerCallList::NumberOf<&RobotServices::OpenPrimitive>(), 27u);
  EXPECT_EQ(WorkerCallList::NumberOf<&RobotServices::ClosePrimitive>(), 28u);
  EXPECT_EQ(WorkerCallList::NumberOf<&CheckedCalls::ControlPrimitive>(), 29u);
  EXPECT_EQ(WorkerCallList::NumberOf<&RobotServices::EnableJointGain>(), 30u);
  EXPECT_EQ(WorkerCallList::NumberOf<&RobotServices::GetSensorValue>(), 38u);
  EXPECT_EQ(WorkerCallList::NumberOf<&RobotServices::DivideSyncKey>(), 41u);
  EXPECT_EQ(WorkerCallList::NumberOf<&RobotServices::SetMotorPower>(), 42u);
  EXPECT_EQ(WorkerCallList::NumberOf<&RobotServices::UnobservePowerStatus>(), 47u);
  EXPECT_EQ(WorkerCallList::NumberOf<&RobotServices::GetVolumeSwitch>(), 53u);
}

}  // namespace
}  // namespace openr_host
