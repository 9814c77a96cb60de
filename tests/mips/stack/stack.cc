// How much stack the objects' logic takes on MIPS at most: "RCServer 3412" per object, in bytes.
//
//   stack FOLDER     a folder to write a motion to, which is read as from a Memory Stick
//
// The stack that the SDK's library needs below our calls is not measured, nor that of newlib, the C
// library of the robot, which has glibc here.
#include <device/led.h>
#include <device/mtn.h>
#include <device/robot.h>
#include <device/servo.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "ByteOrder.h"
#include "ControllerApi.h"
#include "Crc32.h"
#include "MoverCore.h"
#include "RemoteProtocol.h"
#include "RequestHandler.h"
#include "StickFile.h"
#include "dump.h"

namespace {

const size_t DEPTH = 256 * 1024;
const char PAINT = 0x5a;

int numReads;  // good motions that were read

// Deepest use of any Measure() since the last Report().
size_t mark;

// Below this frame; nothing else runs on this stack.
__attribute__((noinline)) void Measure(void (*body)()) {
  volatile char* const top = static_cast<volatile char*>(__builtin_frame_address(0)) - 256;
  for (size_t i = 0; i < DEPTH; i++) *(top - i) = PAINT;
  body();
  size_t used = DEPTH;
  while (used > 0 && *(top - used + 1) == PAINT) used--;
  if (used > mark) mark = used;
}

// Says nothing of an object that has not read its motion: what was measured was not the deepest.
void Report(const char* object) {
  if (numReads > 0) printf("%s %u\n", object, static_cast<unsigned>(mark));
  mark = 0;
  numReads = 0;
}

std::string folder;
std::vector<Uint8> motion;

void ReadMotion(std::vector<Uint8>* bytes, std::string* error) {
  if (ReadStickFile(folder + "/TEST.MTN", bytes, error)) numReads++;
}

// ---- RCServer

class ServerPort : public RequestPort {
 public:
  virtual bool PostMover(const MoverCommand&) { return true; }
  virtual void PostLedEar(const LedEarState&) {}
  virtual bool ReadFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error) {
    if (path.find("TEST.MTN") == std::string::npos) return ReadStickFile(path, bytes, error);
    ReadMotion(bytes, error);
    return true;
  }
  virtual void ReadBattery(Sint32* capacity, Sint32* temperature) { *capacity = *temperature = 0; }
  virtual void WantImage(bool) {}
  virtual bool ReadPower(RcPower* power) {
    memset(power, 0, sizeof(*power));
    return true;
  }
  virtual bool ReadGains(int, Uint16* gains) {
    memset(gains, 0, 6 * sizeof(*gains));
    return false;
  }
  virtual void EndRun(bool) {}
};

RequestHandler* handler;
RcFramer* request;

void TakeRequest() { request->Next(); }

void AnswerRequest() {
  static Uint8 bytes[RC_MAX_PACKET];
  RcWriter out(bytes, RC_MAX_PACKET);
  handler->Answer(0, *request, &out);
}

void Ask(int command, const std::vector<Uint8>& payload, int version = RC_VERSION) {
  Uint8 bytes[RC_MAX_PACKET];
  RcWriter in(bytes, RC_MAX_PACKET);
  for (int i = 0; i < RC_HEADER_SIZE; i++) in.U8(0);
  for (size_t i = 0; i < payload.size(); i++) in.U8(payload[i]);
  in.PutHeader(command, 1, version);
  RcFramer framer;
  framer.Append(bytes, in.Size());
  request = &framer;
  Measure(TakeRequest);
  Measure(AnswerRequest);
}

void AppendNumber(std::vector<Uint8>* payload, Uint32 number) {
  Uint8 bytes[4];
  PutU32(bytes, number);
  payload->insert(payload->end(), bytes, bytes + 4);
}

// Uploads the motion to the stick, lists and downloads it.
void AskForFiles() {
  static const char name[] = "\0\7NEW.MTN";
  const std::vector<Uint8> file(name, name + 9);
  std::vector<Uint8> payload = file;
  AppendNumber(&payload, static_cast<Uint32>(motion.size()));
  AppendNumber(&payload, Crc32(0, &motion[0], static_cast<int>(motion.size())));
  Ask(rcUPLOAD_BEGIN, payload, RC_VERSION_FILES);
  for (size_t at = 0; at < motion.size(); at += RC_MAX_UPLOAD_DATA) {
    const size_t left = motion.size() - at;
    const size_t count = left < RC_MAX_UPLOAD_DATA ? left : RC_MAX_UPLOAD_DATA;
    payload.clear();
    AppendNumber(&payload, static_cast<Uint32>(at));
    payload.insert(payload.end(), motion.begin() + at, motion.begin() + at + count);
    Ask(rcUPLOAD_DATA, payload, RC_VERSION_FILES);
  }
  Ask(rcUPLOAD_END, std::vector<Uint8>(), RC_VERSION_FILES);
  Ask(rcMTN_LIST, std::vector<Uint8>(2, 0), RC_VERSION_FILES);
  payload = file;
  AppendNumber(&payload, 0);
  Ask(rcDOWNLOAD, payload, RC_VERSION_FILES);
  Ask(rcDELETE, file, RC_VERSION_FILES);
}

// Makes the folders of motions and images of a stick in `folder`.
void MakeStick() {
  static const char* const names[] = {"/MS",
                                      "/MS/OPEN-R",
                                      "/MS/OPEN-R/MW",
                                      "/MS/OPEN-R/MW/DATA",
                                      "/MS/OPEN-R/MW/DATA/P",
                                      "/MS/OPEN-R/MW/OBJS"};
  for (int i = 0; i < 6; i++) mkdir((folder + names[i]).c_str(), 0777);
}

void MeasureServer() {
  ServerPort port;
  RequestHandler server(&port);
  MakeStick();
  server.Begin(FindRobot("ERS-210"), folder);
  SetValueMessage news;
  memset(&news, 0, sizeof(news));
  news.state = moverACCEPTING_COMMANDS;
  server.SetMover(news);
  handler = &server;
  for (int command = 0; command < 256; command++) {
    for (int size = 0; size < 8; size++) {
      Ask(command, std::vector<Uint8>(static_cast<size_t>(size), 1));
      Ask(command, std::vector<Uint8>(static_cast<size_t>(size), 99));
      Ask(command, std::vector<Uint8>(static_cast<size_t>(size), 0), RC_VERSION_FILES);
    }
  }
  AskForFiles();
  static const char* const files[] = {"\x8TEST.MTN", "\x8NONE.MTN"};
  for (int i = 0; i < 2; i++) {
    std::vector<Uint8> payload(files[i], files[i] + 9);
    const Uint8 loops[] = {2, 0, 0};
    payload.insert(payload.end(), loops, loops + 3);
    Ask(rcMTN_PLAY, payload);
  }
  Report("RCServer");
}

// ---- JointMover

class Dog : public MoverPort {
 public:
  virtual Sint32 Measure(int) { return 0; }
  virtual void EnableGain(int, const Sint32*) {}
  virtual void SetMotorPower(bool) {}
  virtual void DisableGain(int) {}
  virtual void StateChanged(MoverState) {}
  virtual void Report(const SetValueMessage&) {}
  virtual void InitialPostureReached() {}
};

MoverCore* mover;
VectorPlan plan;  // a member of the object, too
bool has_vector;

void MakeVector() { has_vector = mover->NextVector(&plan); }
void EndVector() { mover->VectorEnded(); }
void PlayFile() {
  std::vector<Uint8> bytes;
  std::string error;
  ReadMotion(&bytes, &error);
  static MoverCommand command = {moverkindPLAY, 0, 0, 2, 0, "TEST.MTN", {0, 0, 0}};
  mover->Play(command, bytes.empty() ? 0 : &bytes[0], bytes.size(), &error);
}
void PlayNothing() {
  static MoverCommand command = {moverkindPLAY, 0, 0, 2, 0, "TEST.MTN", {0, 0, 0}};
  std::string error;
  mover->Play(command, &motion[0], motion.size() / 2, &error);
}
void MoveOne() {
  static MoverCommand command = {moverkindPOSITION, 1, 100000, 0, 0, "", {0, 0, 0}};
  mover->MoveJoint(command);
}

void MeasureMover() {
  Dog dog;
  MoverCore core(&dog);
  core.Begin(FindRobot("ERS-210"));
  mover = &core;
  for (int i = 0; i < 600; i++) {
    Measure(MakeVector);
    if (has_vector) Measure(EndVector);
    if (i % 60 == 59) Measure(MoveOne);
    if (i == 400) Measure(PlayNothing);
    if (i == 450) Measure(PlayFile);
  }
  Report("JointMover");
}

// ---- Controller

class Wrapper : public ControllerPort {
 public:
  virtual bool IsLedReady() { return true; }
  virtual bool IsEarReady() { return true; }
  virtual bool IsBatchMoverReady() { return true; }
  virtual void SendLeds(Uint32, int) {}
  virtual void SendEars(Uint32) {}
  virtual void SendBatch(const BatchMoverCommand&) {}
  virtual void SendMover(const MoverCommand&) {}
  virtual bool ReadFile(const std::string&, std::vector<Uint8>* bytes, std::string* error) {
    ReadMotion(bytes, error);
    return true;
  }
  virtual int BatteryCapacity() { return 50; }
  virtual void TimeStepRounded(int, int) {}
  virtual void UnknownDevice(const char*) {}
  virtual void Remark(const char*) {}
  virtual void Print(const char*) {}
  virtual void RunLoop(void (*body)(void*), void* argument) { body(argument); }
  virtual bool SuspendLoop() { return false; }
  virtual void ContinueLoop() {}
  virtual void EndLoop() {}
  virtual void EnableCamera(bool) {}
};

ControllerCore* wrapper;

int Run(int) {
  const DeviceTag device = robot_get_device("PRM:/r1/c1-Joint2:j1");
  servo_set_position(device, 0.1f);
  servo_set_velocity(device, 0.1f);
  led_set(robot_get_device("PRM:/r1/c1/c2/c3/l2-LED2:l2"), 1);
  MTN* const file = mtn_new("TEST.MTN");
  if (file != 0) mtn_play(file);
  mtn_delete(file);
  mtn_new("NONSENSE.NAME");
  return 64;
}
int Main() {
  robot_run(Run);
  return 0;
}
void BeginController() { wrapper->Execute(Main); }
void GoOn() { wrapper->LedReady(); }

void MeasureController() {
  Wrapper port;
  ControllerCore core(&port);
  core.Begin(FindRobot("ERS-210"));
  SetControllerCore(&core);
  wrapper = &core;
  Measure(BeginController);
  for (int i = 0; i < 5; i++) Measure(GoOn);
  SetControllerCore(0);
  Report("Controller");
}

// ---- PowerMonitor: one formatted line

void FormatLine() {
  numReads++;  // none to read
  char line[243];
  snprintf(line, sizeof(line), "%s %d %u %08x", "PowerMonitor: capacity", 50, 60u, 70u);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  folder = argv[1];
  Draw draw(12);
  motion = MakeMotion(15, 150, &draw);
  FILE* const file = fopen((folder + "/TEST.MTN").c_str(), "wb");
  if (file == 0) return 1;
  fwrite(&motion[0], 1, motion.size(), file);
  fclose(file);
  MeasureServer();
  MeasureMover();
  MeasureController();
  Measure(FormatLine);
  Report("PowerMonitor");
  return 0;
}
