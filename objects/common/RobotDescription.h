//
// The constants of a robot, as the objects use them: the types of the tables in RobotConstants.cc.
//
// tools/genmodel generates the tables from the robot models (virtualrobot/model/*.json), for all
// models at once.  An object finds its robot at run time with OPENR::GetRobotDesign() and
// FindRobot().  No other file in objects/ has a constant of a robot.
//

#ifndef RobotDescription_h_DEFINED
#define RobotDescription_h_DEFINED

#include "FixedTypes.h"

// Sizes of arrays in the objects and in their messages, with room for every robot.  ERS-210 and
// ERS-7 have 18 joints; the ERS-7 has 26 LEDs and 16 sensors that do not measure a joint; no robot
// has more than 2 ears (plungers).
const int MAX_JOINTS = 20;
const int MAX_LEDS = 32;
const int MAX_PLUNGERS = 4;
const int MAX_SENSORS = 20;

struct JointConstants {
    const char* name;     // "LF_j1"
    const char* title;    // "Left fore leg J1"
    const char* locator;  // "PRM:/r2/c1-Joint2:j1"
    Sint32 minUrad;  // lower software limit in urad (10^-6 rad)
    Sint32 maxUrad;  // upper software limit in urad
    Sint32 minCdeg;  // lower software limit in 0.01 degree
    Sint32 maxCdeg;  // upper software limit in 0.01 degree
    Sint32 minSpeedCdeg;  // smallest value to which the speed limit can be set, in 0.01 degree/s
    Sint32 maxSpeedCdeg;  // largest value of the speed limit; also its value after start-up
    Uint16 gain[6];       // P, I, D gain, then P, I, D shift: the order of OPENR::SetJointGain()
    Sint16 sensorIndex;   // index of the joint's element in sensor vectors
    // Index of the joint in the vendor's MTN files; -1 if these files lack the joint.
    Sint16 mtnIndex;
};

// The kinds of LEDs.  An LED gets its commands as OLEDCommandValue2 or 3.
enum LedKind { ledLED2 = 2, ledLED3 = 3 };

struct LedConstants {
    const char* title;
    const char* locator;
    Sint32 kind;  // a value of LedKind
};

// The kinds of ears (plungers).  An ear gets its commands as OJointCommandValue3 or 4.
enum PlungerKind { plungerJOINT3 = 3, plungerJOINT4 = 4 };

struct PlungerConstants {
    const char* title;
    const char* locator;
    Sint32 kind;  // a value of PlungerKind
};

// Groups of sensors in Hohl 2004, table 3.8.  The table in docs/openr/ers210.md 7 shows the group
// of each sensor of the ERS-210.
enum SensorGroup { sensorBINARY = 1, sensorOTHER = 2 };

enum SensorKind {
    sensorkindSWITCH,        // value is 0 or 1
    sensorkindFORCE,         // value in 10^-6 N
    sensorkindLENGTH,        // value in 10^-6 m
    sensorkindTEMPERATURE,   // value in 10^-6 degree Celsius
    sensorkindACCELERATION,  // value in 10^-6 m/s^2
    sensorkindRAW            // value in A/D counts
};

// A sensor that is not the position of a joint.
struct SensorConstants {
    const char* title;
    const char* locator;
    Sint32 group;        // a value of SensorGroup
    Sint32 kind;         // a value of SensorKind
    Sint32 touchLimit;  // a value above this limit means touched; -1 if this is no touch sensor
    Sint16 sensorIndex;  // index of the sensor's element in sensor vectors
    Sint16 reserved;
};

struct CameraConstants {
    const char* locator;
    Sint32 width;  // width of the largest image layer, in pixels
    Sint32 height;
    Sint32 fovUrad;  // field of view from left to right, in urad
};

// A posture: angles in the order of RobotConstants::joints, inside the software limits.
struct PostureConstants {
    const char* name;  // "stand", "sit", "sleep", "crouch", "broadbase"
    Sint32 urad[MAX_JOINTS];
};

struct RobotConstants {
    const char* design;  // result of OPENR::GetRobotDesign(), such as "ERS-210"
    int numJoints;
    const JointConstants* joints;  // in the order of the Model Information guide, section 2.1
    int numLeds;
    const LedConstants* leds;
    int numPlungers;
    const PlungerConstants* plungers;
    int numSensors;                  // number of sensors that do not measure a joint
    const SensorConstants* sensors;  // in the order of sensorIndex
    int numSensorElements;           // number of elements of a sensor frame vector, joints included
    int numPostures;
    const PostureConstants* postures;
    Sint32 minAccelerationCdeg;  // in 0.01 degree/s^2, for every joint
    Sint32 defaultAccelerationCdeg;
    Sint32 maxAccelerationCdeg;
    CameraConstants camera;
};

// Returns the robot of this design; 0 when there is no such robot.
const RobotConstants* FindRobot(const char* design);

// Returns the posture of `robot` with this name; 0 when there is no such posture.  REQUIRES:
// `robot` is not 0.
const PostureConstants* FindPosture(const RobotConstants* robot, const char* name);

// The next functions return the index of the joint, LED, ear or sensor with this locator (OPEN-R
// name); -1 when `robot` has no such device.  REQUIRES: `robot` is not 0.
int FindJoint(const RobotConstants* robot, const char* locator);
int FindLed(const RobotConstants* robot, const char* locator);
int FindPlunger(const RobotConstants* robot, const char* locator);
int FindSensor(const RobotConstants* robot, const char* locator);

// Returns the number of sensors of `robot` that belong to `group`.
int CountSensors(const RobotConstants* robot, SensorGroup group);

#endif  // RobotDescription_h_DEFINED
