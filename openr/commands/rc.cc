// The command openr rc: controls a running robot from the command line (remote control).
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "cli/exit_code.h"
#include "cli/json_text.h"
#include "cli/print_plain.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/rc_actions.h"
#include "openr/commands/rc_both.h"
#include "openr/commands/rc_format.h"
#include "openr/remote/connection.h"

namespace openr_host {
namespace {

remote::Address AddressOf(const RcFlags& flags) {
  try {
    return remote::ParseAddress(flags.address);
  } catch (const remote::Error& error) {
    throw CLI::ValidationError("HOST", error.what());
  }
}

int Perform(const RcFlags& flags, const RcAction& action) {
  // Performs the action once for each robot if --with names a second robot.  With --log, performs
  // the action only once, because the action then uses both robots and writes one log with the
  // records of both.
  if (!flags.with.empty() && flags.log.empty()) {
    // Checks the address HOST before two robots are used, so that a wrong address is an error of
    // the command line, as it is with one robot.
    AddressOf(flags);
    return PerformAtBoth(flags, action);
  }
  try {
    remote::Connection robot(AddressOf(flags), OptionsOf(flags));
    action(&robot, flags);
    return kExitGood;
  } catch (const remote::Error& error) {
    if (error.code() != remote::ErrorCode::kRefused) throw;
    PrintPlain(stderr, "openr: {} refused: {}\n", FrameText(error.frame()), error.what());
    if (!flags.json) return kExitWrong;
    const nlohmann::ordered_json json = {
        {"frame", FrameJson(error.frame())}, {"error", error.text()}, {"status", error.status()}};
    PrintPlain("{}\n", JsonText(json));
    return kExitWrong;
  }
}

// Returns a check of a flag's value: it refuses numbers that no joint can have.  With `is_limit`,
// for limits of speed and acceleration, it also refuses 0 and negative numbers.
CLI::Validator JointValue(bool is_limit) {
  const auto problem = [is_limit](const std::string& text) {
    double value = 0;
    const bool is_number = CLI::detail::lexical_cast(text, value) && std::abs(value) < 1e6;
    if (!is_number) return fmt::format("'{}' is no number of degrees below 1000000", text);
    if (!is_limit || value > 0) return std::string();
    return fmt::format(
        "'{}' is no limit; it must be greater than 0 (get JOINT shows the one in force)", text);
  };
  return CLI::Validator(problem, "");
}

CLI::Validator IsRemoteAddress() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        try {
          remote::ParseAddress(text);
          return "";
        } catch (const remote::Error& error) {
          return error.what();
        }
      },
      "");
}

CLI::Validator KeyFramesPerVector() {
  const auto problem = [](const std::string& text) {
    if (text.size() == 1 && std::string("02468").find(text) != std::string::npos) {
      return std::string();
    }
    return fmt::format(
        "'{}' key frames cannot be sent at once; say 2, 4, 6 or 8, or 0 for the "
        "robot's own choice",
        text);
  };
  return CLI::Validator(problem, "");
}

// Throws CLI::ValidationError if `command` cannot be carried out at two robots at the same time.
void CheckForBoth(const RcFlags& flags, const std::string& command) {
  static const std::set<std::string> one_robot = {"stream", "log",    "camera",   "upload",
                                                  "delete", "reboot", "download", "shutdown"};
  if (flags.simulated)
    throw CLI::ValidationError("--with", "does not go with --simulated; HOST then is the robot");
  if (one_robot.contains(command) || flags.watch)
    throw CLI::ValidationError("--with",
                               fmt::format("'{}' is for one robot; call it for each", command));
}

// Adds the commands of openr rc to the command line.  The commands store their flags in one
// RcFlags, because HOST, --timeout and --json belong to all commands of openr rc.
class RcCommands {
 public:
  RcCommands(CLI::App* app, int* exit_code)
      : flags_(std::make_shared<RcFlags>()), exit_code_(exit_code) {
    rc_ = app->add_subcommand("rc", "Remote control of a running robot");
    rc_->add_option("HOST", flags_->address, "Where the robot is: HOST[:PORT]")->required();
    rc_->add_option("--with", flags_->with, "Does the same at a second robot: HOST[:PORT]")
        ->check(IsRemoteAddress());
    AddDurationFlag(rc_, "--timeout", &flags_->timeout_us, "How long to wait for an answer");
    rc_->add_option(
        "--token-file", flags_->token_file,
        "File with the token that openr run --listen asks for; with --with it is sent to both");
    rc_->add_flag("--json", flags_->json, "One JSON object per answer");
    rc_->require_subcommand(1);
    // Accepts the flags of `rc` also after the name of its command, as in "rc HOST info --json".
    rc_->fallthrough();
  }

  void AddAll() {
    Add(rc_, "info", "What robot this is, and what it does", &RcInfoAction);
    AddJoint("get", "Position of a joint", &RcGetAction);
    AddSensors();
    AddStreams();
    AddJoint("move", "Moves a joint", RcJointAction(rcMOVE, "deg"))
        ->add_option("VALUE", flags_->value, "Degrees")
        ->required()
        ->check(JointValue(false));
    Add(rc_, "pose", "Moves several joints with one packet", &RcPoseAction)
        ->add_option("GOAL", flags_->goals, "A joint and its degrees: neck_pan=30")
        ->required()
        ->expected(1, RC_MAX_BATCH);
    AddLimit("speed", "Limits the speed of a joint", rcSPEED, "deg/s");
    AddLimit("accel", "Limits the acceleration of a joint", rcACCEL, "deg/s^2");
    AddMotors();
    AddLight("led", "Switches a light; a controller of the robot may switch it back", rcLED);
    AddLight("ear", "Moves an ear; a controller of the robot may move it back", rcEAR);
    AddFollow();
    AddMotions();
    AddLog();
    AddCamera();
    AddController();
    Add(rc_, "reboot", "Shuts the robot down and boots it again", &RcRebootAction);
    Add(rc_, "shutdown", "Shuts the robot down", &RcShutdownAction);
  }

 private:
  CLI::App* Add(CLI::App* to, const char* name, const char* about, RcAction action) {
    CLI::App* const command = to->add_subcommand(name, about);
    command->fallthrough();
    command->callback([flags = flags_, exit_code = exit_code_, action, command] {
      if (!flags->with.empty()) CheckForBoth(*flags, command->get_name());
      *exit_code = Perform(*flags, action);
    });
    return command;
  }

  CLI::App* AddJoint(const char* name, const char* about, RcAction action) {
    CLI::App* const command = Add(rc_, name, about, std::move(action));
    command->add_option("JOINT", flags_->device, "Name, locator or number")->required();
    return command;
  }

  void AddLimit(const char* name, const char* about, RcCommand request, const char* unit) {
    AddJoint(name, about, RcJointAction(request, unit))
        ->add_option("VALUE", flags_->value, fmt::format("{}, greater than 0", unit))
        ->required()
        ->check(JointValue(true));
  }

  void AddLight(const char* name, const char* about, RcCommand request) {
    CLI::App* const command = Add(rc_, name, about, RcLightAction(request));
    command->add_option("NAME", flags_->device, "Name, locator or number")->required();
    command->add_option("STATE", flags_->state, "on or off")
        ->required()
        ->check(CLI::IsMember({"on", "off"}));
  }

  void AddMotors() {
    CLI::App* const motor =
        Add(rc_, "motor", "Switches motors; only this switches them on again", &RcMotorAction);
    motor->add_option("STATE", flags_->state, "on or off")
        ->required()
        ->check(CLI::IsMember({"on", "off"}));
    motor->add_option("JOINT", flags_->device, "One joint; without it all joints and motor power");
    AddJoint("gains", "Shows or sets the gains of a joint's servo", &RcGainsAction)
        ->add_option("PID", flags_->gains, "The new gains: P, I and D")
        ->expected(3)
        ->check(CLI::Range(0, RC_MAX_GAIN));
    Add(rc_, "power", "Motor power and battery", &RcPowerAction);
  }

  void AddSensors() {
    CLI::App* const command = Add(rc_, "sensors", "All sensor values", &RcSensorsAction);
    command->add_flag("--watch", flags_->watch, "Again and again, until Ctrl-C");
    AddDurationFlag(command, "--every", &flags_->every_us, "Time between two");
  }

  void AddStreams() {
    CLI::App* const command =
        Add(rc_, "stream", "What the robot sends by itself, until Ctrl-C", &RcStreamAction);
    command->add_option("STREAM", flags_->stream, "sensors, or keyframes of motions")
        ->required()
        ->check(CLI::IsMember({"sensors", "keyframes"}));
    AddDurationFlag(command, "--every", &flags_->stream_us,
                    "Shortest time between two; in steps of 32 ms of the robot's clock");
    command->add_option("--count", flags_->count, "How many; 0: no end")
        ->check(CLI::Range(0, 1'000'000'000))
        ->capture_default_str();
  }

  void AddFollow() {
    CLI::App* const command = rc_->add_subcommand(
        "follow",
        "Lets the robot HOST follow the pose and the motions of another one, until Ctrl-C");
    command->fallthrough();
    command->add_option("OTHER", flags_->with, "The robot that leads: HOST[:PORT]")
        ->required()
        ->check(IsRemoteAddress());
    command->add_flag("--track", flags_->track,
                      "Whatever the limits of speed and acceleration of HOST are");
    AddDurationFlag(command, "--every", &flags_->stream_us,
                    "Time between two poses; in steps of 32 ms of the robot's clock");
    command->add_option("--count", flags_->count, "How many reports, one a second; 0: no end")
        ->check(CLI::Range(0, 1'000'000'000))
        ->capture_default_str();
    command->callback(
        [flags = flags_, exit_code = exit_code_] { *exit_code = FollowRobot(*flags); });
  }

  void AddCamera() {
    CLI::App* const command =
        Add(rc_, "camera", "Writes a picture of the camera, as .ppm", &RcCameraAction);
    command->add_option("-o,--output", flags_->output, "The file to write")
        ->required()
        ->check(IsWritable());
    command
        ->add_option("--layer", flags_->layer,
                     "h (176 x 144), m (88 x 72), l (44 x 36), c (detected colours)")
        ->check(CLI::IsMember({"h", "m", "l", "c"}))
        ->capture_default_str();
    command->add_flag("--raw", flags_->raw, "All bands of the layer, as the robot has them");
  }

  void AddLog() {
    Add(rc_, "log", "Writes the last key frames of motions that the robot has", &RcLogAction)
        ->add_option("FILE", flags_->log, "The log file to write")
        ->required()
        ->check(IsWritable());
  }

  void AddMotions() {
    CLI::App* const mtn = rc_->add_subcommand("mtn", "Motions on the robot's stick");
    mtn->require_subcommand(1);
    mtn->fallthrough();
    CLI::App* const play = Add(mtn, "play", "Plays a motion", &RcPlayAction);
    play->add_option("FILE", flags_->file, "Its name on the stick: WALK.MTN")->required();
    play->add_option("--loops", flags_->loops, "How often")
        ->check(CLI::Range(1, 65535))
        ->capture_default_str();
    play->add_option("--keyframes", flags_->key_frames,
                     "Key frames per command vector: 2, 4, 6 or 8; 0: as the robot likes")
        ->check(KeyFramesPerVector())
        ->capture_default_str();
    CLI::Option* const log =
        play->add_option("--log", flags_->log,
                         "Waits for the end and writes the key frames to this file; with --with "
                         "the values of the second robot are the simulated ones")
            ->check(IsWritable());
    play->add_flag("--simulated", flags_->simulated,
                   "HOST is a simulation: its values go to the simulated ones of the log")
        ->needs(log);
    Add(mtn, "stop", "Stops the motion", &RcStopAction);
    Add(mtn, "list", "The motions on the stick, with their sizes", &RcListAction);
    Add(mtn, "upload", "Puts a motion on the stick", &RcUploadMotionAction)
        ->add_option("FILE", flags_->file, "A motion file of this computer")
        ->required();
    CLI::App* const download =
        Add(mtn, "download", "Fetches a motion from the stick", &RcDownloadAction);
    download->add_option("NAME", flags_->file, "Its name on the stick: WALK.MTN")->required();
    download->add_option("-o,--output", flags_->output, "Where to write it; default: NAME, here");
    Add(mtn, "delete", "Deletes a motion from the stick", &RcDeleteAction)
        ->add_option("NAME", flags_->file, "Its name on the stick: WALK.MTN")
        ->required();
  }

  void AddController() {
    CLI::App* const controller =
        rc_->add_subcommand("controller", "The controller program on the robot's stick");
    controller->require_subcommand(1);
    controller->fallthrough();
    Add(controller, "upload", "Replaces the controller; it runs after the next boot",
        &RcUploadControllerAction)
        ->add_option("FILE", flags_->file, "An image: CONTROLL.BIN")
        ->required();
  }

  const std::shared_ptr<RcFlags> flags_;
  int* const exit_code_;
  CLI::App* rc_;
};

}  // namespace

void AddRcCommand(CLI::App* app, int* exit_code) { RcCommands(app, exit_code).AddAll(); }

}  // namespace openr_host
