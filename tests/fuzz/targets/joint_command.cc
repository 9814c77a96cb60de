// The fuzz target joint_command: commands for joints from ROS 2, and the answers of the robot.
#include "openr/ros2/joint_command.h"

#include <cmath>
#include <cstring>
#include <memory>
#include <set>

#include "RemoteProtocol.h"
#include "openr/inspect/recorded_network.h"
#include "runtime/base/hasher.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {
namespace {

constexpr int kModelJoints = 8;
constexpr int kTurnCentideg = 36000;

// Returns a robot whose joints are named "a" to "h".  Its model is not read from a file, because
// the fuzz program must not need one.
RobotModel EightJoints() {
  RobotModel model;
  model.name = "robot";
  for (int i = 0; i < kModelJoints; ++i)
    model.joints.emplace_back().name = std::string(1, static_cast<char>('a' + i));
  return model;
}

// A robot whose remote control takes the commands.  Each step of the input is a byte, whose high
// bits say what happens, and its arguments.
class CommandedRobot {
 public:
  CommandedRobot()
      : client_(std::make_unique<ReplayedNetwork>([] { return std::vector<NetworkEvent>(); }),
                [](const std::string&) {}) {
    client_.Listen(kListener, RC_PORT);
    client_.Accept(kListener, kListener + 1);
  }

  void Step(FuzzBytes* input) {
    const uint8_t step = input->U8();
    switch (step >> 5) {
      case 0:
      case 1:
      case 2:
      case 3:
        AddJoint(step, input);
        break;
      case 4:
        Command();
        break;
      case 5:
        Read(input->U8());
        break;
      case 6:
        Answer(step, input);
        break;
      case 7:
        if ((step & 1) != 0) client_.Close(handle_);
        if ((step & 2) != 0) client_.Drop(handle_, false);
        if ((step & 4) != 0) client_.Accept(kListener, ++last_handle_);
        if ((step & 8) != 0) client_.GiveUp();
        break;
    }
  }
  bool has_found() const { return has_found_; }

 private:
  static constexpr NetHandle kListener = 1;

  // Adds a joint to the next command: a byte of its name or a text, and two numbers, of which each
  // may be missing.
  void AddJoint(uint8_t step, FuzzBytes* input) {
    std::string name(1, static_cast<char>('a' + step % kModelJoints));
    if ((step & 0x18) == 0x18) name = input->Text(input->U8());
    command_.joints.push_back(name);
    if ((step & 0x20) == 0) command_.position_rad.push_back(Number(input));
    if ((step & 0x40) != 0) command_.velocity_rad_s.push_back(Number(input));
  }

  // Returns a small number in most cases, and any bits else.
  static double Number(FuzzBytes* input) {
    const uint8_t kind = input->U8();
    if (kind < 0xf0) return (kind - 120) / 16.0;
    const uint64_t bits = input->U64();
    double number;
    std::memcpy(&number, &bits, sizeof number);
    return number;
  }

  void Command() {
    static const RobotModel model = EightJoints();
    std::map<int, JointTarget> targets;
    const std::string problem = ReadJointCommand(command_, model, &targets);
    FuzzCheck(problem.empty() == !targets.empty(), "a command is refused or has targets");
    FuzzCheck(targets.empty() || targets.size() == command_.joints.size(),
              "a target for each joint");
    for (const auto& [joint, target] : targets) {
      FuzzCheck(joint >= 0 && joint < kModelJoints, "a joint of the robot");
      FuzzCheck(std::isfinite(target.position_rad) && target.speed_rad_s >= 0, "a target");
    }
    client_.SetTargets(targets);
    command_ = {};
  }

  // Lets the robot read at most `size` bytes of the client.
  void Read(size_t size) {
    if (handle_ != 0) client_.Receive(handle_, size);
    for (const NetworkEvent& event : client_.Poll()) {
      if (event.kind == NetworkEvent::Kind::kAccepted) Begin(event.handle);
      if (event.kind == NetworkEvent::Kind::kClosed) handle_ = 0;
      FuzzCheck(event.bytes.size() <= size, "no more bytes than the robot has asked for");
      framer_.Append(reinterpret_cast<const Uint8*>(event.bytes.data()),
                     static_cast<int>(event.bytes.size()));
      while (Packet()) {
      }
    }
  }

  void Begin(NetHandle handle) {
    handle_ = handle;
    framer_.Reset();
    moved_.clear();
  }

  // Checks the next packet of the client.  Returns false if there is none.
  bool Packet() {
    const RcFramer::Result result = framer_.Next();
    FuzzCheck(result != RcFramer::BROKEN, "the client sends packets");
    if (result == RcFramer::NEEDS_MORE) return false;
    RcReader reader(framer_.Payload(), framer_.PayloadSize());
    const int command = framer_.Header().command, joint = static_cast<int>(reader.U8());
    const auto value = static_cast<int>(reader.S32());
    FuzzCheck(command == rcMOVE || command == rcSPEED, "a movement or a speed");
    FuzzCheck(joint < kModelJoints, "a joint of the robot");
    if (command == rcSPEED) FuzzCheck(value >= 0, "a speed without sign");
    if (command == rcMOVE) {
      FuzzCheck(std::abs(value) <= kTurnCentideg, "a turn at most");
      if (value == kTurnCentideg) moved_.insert(joint);
    }
    // All joints have the same branches.
    ReachFuzzState(moved_.size());
    has_found_ |= moved_.size() > 2;
    return true;
  }

  // Lets the robot answer a request, or send bytes that are no answer.
  void Answer(uint8_t step, FuzzBytes* input) {
    if (handle_ == 0) return;
    std::string bytes(input->Text(input->U8()));
    if ((step & 1) != 0) {
      uint8_t header[RC_ANSWER_HEADER_SIZE];
      RcWriter writer(header, sizeof header);
      writer.U16(RC_MAGIC);
      writer.U16(static_cast<Uint32>(RC_ANSWER_HEADER_SIZE + bytes.size()));
      writer.U8(RC_VERSION);
      writer.U8(rcMOVE);
      writer.U16(0);
      writer.U32(0);
      writer.U16((step & 2) != 0 ? rcerrorBUSY : rcOK);
      writer.U16(0);
      bytes.insert(0, reinterpret_cast<const char*>(header), sizeof header);
    }
    client_.Send(handle_, bytes.data(), bytes.size());
  }

  JointClient client_;
  Ros2JointCommand command_;
  NetHandle handle_ = 0, last_handle_ = kListener + 1;
  RcFramer framer_;
  std::set<int> moved_;  // joints that this connection has moved by a whole turn
  bool has_found_ = false;
};

}  // namespace

bool fuzz::joint_command(std::string_view bytes) {
  CommandedRobot robot;
  FuzzBytes input(bytes);
  while (!input.empty()) {
    BeginFuzzStep(input.taken());
    robot.Step(&input);
  }
  return robot.has_found();
}

}  // namespace openr_host
