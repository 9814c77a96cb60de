// Angles, robot tables, trajectories.
#include "Angle.h"
#include "ByteOrder.h"
#include "MtnName.h"
#include "RobotDescription.h"
#include "TextFormat.h"
#include "Trajectory.h"
#include "dump.h"

namespace {

void DumpRobot(const char* design) {
  const RobotConstants* robot = FindRobot(design);
  if (robot == 0) {
    printf("robot %s: none\n", design);
    return;
  }
  printf("robot %s %d %d %d %d %d %d %d %d\n", robot->design, robot->numJoints, robot->numLeds,
         robot->numPlungers, robot->numSensors, robot->numSensorElements,
         robot->minAccelerationCdeg, robot->defaultAccelerationCdeg, robot->maxAccelerationCdeg);
  for (int j = 0; j < robot->numJoints; j++) {
    const JointConstants& c = robot->joints[j];
    printf("joint %s %s %s %d %d %d %d %d %d %d %d %d\n", c.name, c.title, c.locator, c.minUrad,
           c.maxUrad, c.minCdeg, c.maxCdeg, c.minSpeedCdeg, c.maxSpeedCdeg, c.sensorIndex,
           c.mtnIndex, FindJoint(robot, c.locator));
  }
  for (int i = 0; i < robot->numSensors; i++) {
    const SensorConstants& c = robot->sensors[i];
    printf("sensor %s %d %d %d %d\n", c.locator, c.group, c.kind, c.touchLimit, c.sensorIndex);
  }
  for (int p = 0; p < robot->numPostures; p++) {
    printf("posture %s", robot->postures[p].name);
    for (int j = 0; j < robot->numJoints; j++) printf(" %d", robot->postures[p].urad[j]);
    printf("\n");
  }
}

}  // namespace

void DumpNumbers() {
  for (Sint32 cdeg = -4000000; cdeg <= 4000000; cdeg += 9973) {
    const Sint32 urad = UradFromCdeg(cdeg);
    printf("angle %d %d %d\n", cdeg, urad, CdegFromUrad(urad));
  }
  Draw draw(1);
  for (int i = 0; i < 2000; i++) {
    const Sint64 high = draw.Between(-0x7fffff, 0x7fffff);
    const Sint64 numerator = high * 0x1000000 + draw.Next();
    const Sint64 factor = draw.Between(1, 65536);
    const Sint64 denominator = 1 + factor * draw.Next();
    const Sint64 quotient = DivideRounded(numerator, denominator);
    printf("divide %08x%08x\n",
           static_cast<Uint32>(static_cast<unsigned long long>(quotient) >> 32),
           static_cast<Uint32>(quotient));
    Uint8 bytes[5];
    PutU32(bytes + 1, draw.Next() * 977u);
    PutU16(bytes, static_cast<Uint16>(draw.Next()));
    printf("bytes %d %u %u\n", GetS32(bytes + 1), GetU32(bytes + 1), GetU16(bytes + 1));
  }
  static const char* const names[] = {"walk.mtn",  "WALK.MTN",     "a.b.mtn",       "",
                                      "/MS/A.MTN", "LONGNAME.MTN", "TOOLONGNA.MTN", "A B.MTN",
                                      "x.MTNN",    "\xe4.MTN",     "$&#{}~.MTN"};
  for (size_t i = 0; i < sizeof(names) / sizeof(names[0]); i++) {
    char name[MTN_NAME_SIZE];
    std::string error;
    const bool good = MtnFileName(names[i], name, &error);
    printf("name %s: %s\n", names[i], good ? name : error.c_str());
  }
  printf("%s\n", TextFormat("%s %d %300d", "text", -7, 8).c_str());
  DumpRobot("ERS-210");
  DumpRobot("ERS-220");
  DumpRobot("ERS-7");
  DumpRobot("ERS-9");
}

void DumpTrajectories() {
  Draw draw(2);
  for (int run = 0; run < 60; run++) {
    Trajectory way;
    way.Reset(draw.Between(-2000000, 2000000));
    way.SetSpeed(draw.Between(1, 30000));
    way.SetAcceleration(draw.Between(1, 300000));
    for (int frame = 0; frame < 250; frame++) {
      if (frame % 60 == 0) way.SetGoal(draw.Between(-2500000, 2500000));
      if (frame % 90 == 40) way.SetSpeed(draw.Between(1, 30000));
      if (frame % 90 == 70) way.SetAcceleration(draw.Between(1, 300000));
      if (frame == 200) way.Halt();
      const Sint32 urad = way.Step();
      printf("way %d %d %d %d\n", run, urad, way.Goal(), way.IsMoving() ? 1 : 0);
    }
  }
}
