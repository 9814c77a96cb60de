// The remote control: packets, and answers to requests.
#include <string.h>

#include "ByteOrder.h"
#include "MoverState.h"
#include "RemoteProtocol.h"
#include "RequestHandler.h"
#include "dump.h"

namespace {

std::vector<Uint8> Packet(int command, int tag, const std::vector<Uint8>& payload) {
  Uint8 bytes[RC_MAX_PACKET];
  RcWriter out(bytes, RC_MAX_PACKET);
  for (int i = 0; i < RC_HEADER_SIZE; i++) out.U8(0);
  for (size_t i = 0; i < payload.size(); i++) out.U8(payload[i]);
  out.PutHeader(command, tag);
  return std::vector<Uint8>(bytes, bytes + out.Size());
}

std::vector<Uint8> Noise(int size, Draw* draw) {
  std::vector<Uint8> bytes;
  for (int i = 0; i < size; i++) bytes.push_back(static_cast<Uint8>(draw->Next()));
  return bytes;
}

class RequestedRobot : public RequestPort {
 public:
  RequestedRobot() : handler(this), draw_(6) {
    handler.Begin(FindRobot("ERS-210"));
    SensorValues values;
    memset(&values, 0, sizeof(values));
    values.frame = 2500;
    for (int j = 0; j < MAX_JOINTS; j++) values.joint[j] = j * 17453;
    for (int i = 0; i < MAX_SENSORS; i++) values.sensor[i] = 100 + i;
    handler.SetSensors(values);
    SetValueMessage message;
    memset(&message, 0, sizeof(message));
    message.state = moverACCEPTING_COMMANDS;
    message.keyFrame = -1;
    handler.SetMover(message);
  }
  virtual bool PostMover(const MoverCommand& command) {
    PrintBytes("mover", reinterpret_cast<const Uint8*>(&command), sizeof(command));
    return true;
  }
  virtual void PostLedEar(const LedEarState& change) {
    PrintBytes("lights", reinterpret_cast<const Uint8*>(&change), sizeof(change));
  }
  virtual bool ReadFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error) {
    printf("read %s\n", path.c_str());
    if (path[path.size() - 5] != 'K') {
      *error = path + ": no such file on the Memory Stick";
      return false;
    }
    *bytes = MakeMotion(4, 6, &draw_);
    return true;
  }
  virtual void WantImage(bool) {}
  virtual bool ReadPower(RcPower* power) {
    memset(power, 0, sizeof(*power));
    return true;
  }
  virtual bool ReadGains(int joint, Uint16* gains) {
    for (int i = 0; i < 6; i++) gains[i] = static_cast<Uint16>(joint + i);
    return true;
  }
  virtual void ReadBattery(Sint32* capacity, Sint32* temperature) {
    *capacity = 87;
    *temperature = 2500;
  }
  virtual void EndRun(bool reboot) { printf("end %d\n", reboot); }
  void Ask(int command, int tag, const std::vector<Uint8>& payload) {
    const std::vector<Uint8> bytes = Packet(command, tag, payload);
    RcFramer framer;
    framer.Append(&bytes[0], static_cast<int>(bytes.size()));
    if (framer.Next() != RcFramer::PACKET) return;
    Uint8 answer[RC_MAX_PACKET];
    RcWriter out(answer, RC_MAX_PACKET);
    handler.Answer(0, framer, &out);
    PrintBytes("answer", answer, out.Size());
  }

  RequestHandler handler;

 private:
  Draw draw_;
};

std::vector<Uint8> IndexAndNumber(int index, Sint32 value) {
  std::vector<Uint8> payload(5);
  payload[0] = static_cast<Uint8>(index);
  PutS32(&payload[1], value);
  return payload;
}

}  // namespace

void PrintBytes(const char* what, const Uint8* bytes, int size) {
  printf("%s", what);
  for (int i = 0; i < size; i++) printf(" %02x", bytes[i]);
  printf("\n");
}

// A stream of packets in pieces of odd sizes, with a broken byte now and then.
void DumpPackets() {
  Draw draw(5);
  for (int run = 0; run < 40; run++) {
    std::vector<Uint8> stream;
    for (int i = 0; i < 12; i++) {
      const int command = draw.Between(0, 255);
      const int tag = draw.Between(0, 65535);
      const int size = draw.Between(0, 300);
      const std::vector<Uint8> bytes = Packet(command, tag, Noise(size, &draw));
      stream.insert(stream.end(), bytes.begin(), bytes.end());
    }
    if (run % 4 == 3) stream[draw.Next() % stream.size()] ^= 0x20;
    RcFramer framer;
    size_t at = 0;
    bool broken = false;
    while (at < stream.size() && !broken) {
      int piece = draw.Between(1, 400);
      if (piece > framer.Room()) piece = framer.Room();
      if (piece > static_cast<int>(stream.size() - at))
        piece = static_cast<int>(stream.size() - at);
      framer.Append(&stream[at], piece);
      at += static_cast<size_t>(piece);
      for (;;) {
        const RcFramer::Result result = framer.Next();
        if (result == RcFramer::NEEDS_MORE) break;
        if (result == RcFramer::BROKEN) {
          printf("broken: %s\n", framer.Error().c_str());
          broken = true;
          break;
        }
        RcReader in(framer.Payload(), framer.PayloadSize());
        const unsigned a = in.U8(), b = in.U16(), c = in.U32();  // in this order
        const int d = in.S32();
        const std::string text = in.String();
        printf("packet %d %d %d: %u %u %u %d %u %d %d\n", framer.Header().command,
               framer.Header().tag, framer.PayloadSize(), a, b, c, d,
               static_cast<unsigned>(text.size()), in.HasFailed(), in.IsComplete());
      }
    }
  }
}

void DumpRequests() {
  RequestedRobot robot;
  for (int command = 0; command < 256; command++) {
    robot.Ask(command, command, std::vector<Uint8>());
    for (int index = 0; index < 32; index += 5) {
      robot.Ask(command, 7, std::vector<Uint8>(1, static_cast<Uint8>(index)));
      robot.Ask(command, 8, std::vector<Uint8>(2, static_cast<Uint8>(index % 5)));
      robot.Ask(command, 9, IndexAndNumber(index, index * 977 - 9000));
    }
  }
  Draw draw(7);
  for (int i = 0; i < 1500; i++) {
    const int command = draw.Between(0, 0x72);
    const int size = draw.Between(0, 12);
    robot.Ask(command, i, Noise(size, &draw));
  }
  static const char* const files[] = {"WALK.MTN", "walk.mtn", "NONE.MTN", "a/b.mtn"};
  for (size_t i = 0; i < 4; i++) {
    std::vector<Uint8> payload(1, static_cast<Uint8>(strlen(files[i])));
    payload.insert(payload.end(), files[i], files[i] + strlen(files[i]));
    payload.push_back(3);
    payload.push_back(0);
    payload.push_back(4);
    robot.Ask(rcMTN_PLAY, 1, payload);
  }
}
