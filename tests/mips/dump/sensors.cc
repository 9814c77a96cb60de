// SensorReader on vectors built by hand.  The two SDK functions it calls are here.
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <stdarg.h>
#include <string.h>

#include "SensorReader.h"
#include "dump.h"

namespace {

const int kElements = 31;

// As the robot lays a vector out: header, 31 blocks of information, 31 of data.
struct Vector {
  OSensorFrameVectorData* Head() { return reinterpret_cast<OSensorFrameVectorData*>(words); }
  slongword words[(192 + kElements * (32 + 256)) / 4];
};

}  // namespace

OStatus OPENR::OpenPrimitive(const char* locator, OPrimitiveID* id) {
  *id = 7;
  for (const char* c = locator; *c != 0; c++) *id = *id * 31 + static_cast<Uint8>(*c);
  return oSUCCESS;
}

OStatus osyslog(OSyslogPriority priority, const char* format, ...) {
  printf("log %u ", priority);
  va_list arguments;
  va_start(arguments, format);
  vprintf(format, arguments);
  va_end(arguments);
  printf("\n");
  return oSUCCESS;
}

void DumpSensors() {
  const RobotConstants* robot = FindRobot("ERS-210");
  SensorReader reader;
  reader.Open(robot);
  Draw draw(10);
  for (int round = 0; round < 50; round++) {
    static Vector vector;
    memset(&vector, 0, sizeof(vector));
    OSensorFrameVectorData* head = vector.Head();
    head->SetNumData(kElements);
    for (int i = 0; i < kElements; i++) {
      OSensorFrameInfo* info = head->GetInfo(i);
      info->frameNumber = static_cast<longword>(4 * round);
      info->numFrames = static_cast<longword>(round % 5);
      info->dataOffset = static_cast<longword>(192 + 32 * kElements + 256 * i);
      for (int f = 0; f < 4; f++) head->GetData(i)->frame[f].value = draw.Between(-9999, 9999);
    }
    for (int j = 0; j < robot->numJoints; j++) {
      if (robot->joints[j].sensorIndex < 0) continue;
      OPENR::OpenPrimitive(robot->joints[j].locator,
                           &head->GetInfo(robot->joints[j].sensorIndex)->primitiveID);
    }
    for (int i = 0; i < robot->numSensors; i++) {
      OPENR::OpenPrimitive(robot->sensors[i].locator,
                           &head->GetInfo(robot->sensors[i].sensorIndex)->primitiveID);
    }
    SensorValues values;
    memset(&values, 0, sizeof(values));
    reader.Read(head, &values);
    PrintBytes("sensors", reinterpret_cast<const Uint8*>(&values), sizeof(values));
  }
}
