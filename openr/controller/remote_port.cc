#include "openr/controller/remote_port.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "Angle.h"
#include "ControllerApi.h"
#include "MoverState.h"
#include "runtime/base/read_file.h"
#include "runtime/base/spelling.h"
#include "runtime/base/terminal_text.h"
#include "runtime/base/wall_clock.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
namespace remote = openr::remote;

constexpr int kFrameMs = 8;
// Longest time for which RemotePort waits for packets of the robot, so that it soon notices when
// Ctrl-C is pressed.
constexpr int64_t kSliceNs = 50'000'000;
constexpr int64_t kBetweenWarningsNs = 1'000'000'000;
// Number of events from the robot after which RemotePort looks for the robot's answers to commands,
// even if more events wait.  Without this limit many events could keep RemotePort from reading the
// answers.
constexpr int kEventsAtOnce = 64;
// Number of different frame numbers of a robot: after the largest number, counting begins again at
// 0 (docs/remote-control.md).
constexpr uint32_t kFramesMax = 0x0ffffff1;

// Returns whether the frame number `frame` is later than `other`.  After the largest frame number,
// counting begins again at 0, so a smaller number can be the later one.
bool IsAfter(uint32_t frame, uint32_t other) {
  const uint32_t difference = (frame + kFramesMax - other % kFramesMax) % kFramesMax;
  return difference > 0 && difference < kFramesMax / 2;
}

const RobotConstants* ConstantsOf(remote::Connection* robot) {
  const std::string design = robot->GetInfo().design;
  const RobotConstants* const constants = FindRobot(design.c_str());
  if (constants != nullptr) return constants;
  throw std::runtime_error(fmt::format("{}: the robot is a '{}', which this openr does not know",
                                       robot->address().Text(), design));
}

// Returns a time of the wall clock as openr/remote takes it.  Both count from the origin of the
// host's monotonic clock.
std::chrono::steady_clock::time_point RemoteTime(int64_t time_ns) {
  return std::chrono::steady_clock::time_point(std::chrono::nanoseconds(time_ns));
}

void Say(const std::string& text) { fmt::print(stderr, "openr: {}\n", TerminalText(text)); }

}  // namespace

RemotePort::RemotePort(const remote::Address& address, remote::Options options, std::string folder,
                       std::function<void()> on_step)
    : address_(address),
      options_(options),
      folder_(std::move(folder)),
      on_step_(std::move(on_step)),
      robot_(address, options),
      constants_(ConstantsOf(&robot_)),
      core_(this),
      joints_(constants_),
      heard_ns_(WallClockNs()) {
  core_.Begin(constants_);
  robot_.Subscribe(rcstreamSENSORS, RC_FRAMES_PER_VECTOR);
}

RemotePort::~RemotePort() = default;

bool RemotePort::Stands() const {
  return state_ >= moverACCEPTING_COMMANDS && state_ < NUM_MOVER_STATES;
}

void RemotePort::Check() const {
  if (failure_) std::rethrow_exception(failure_);
}

bool RemotePort::TakeNewStep(int* step_ms) {
  *step_ms = std::exchange(step_ms_, 0);
  return *step_ms > 0;
}

// Calls `function`, which sends the robot a request.  If the call fails, returns false and sets
// `*refusal` to the reason.  If the connection to the robot has failed, also keeps the error, which
// Check() throws later.
template <typename Function>
bool RemotePort::Guarded(const Function& function, std::string* refusal) {
  if (failure_) {
    *refusal = "the connection to the robot has ended";
    return false;
  }
  try {
    function();
    return true;
  } catch (const remote::Error& error) {
    *refusal = error.text();
    if (!error.IsConnectionUsable()) failure_ = std::current_exception();
  } catch (const std::exception& error) {
    *refusal = error.what();
  }
  return false;
}

// ---- Functions that handle events from the robot

void RemotePort::ReceiveUntil(int64_t deadline_ns, const std::function<bool()>& is_ended) {
  // Receives packets of the robot at least once, even after the deadline, because a controller
  // whose iterations are always late must get sensor values, too.
  do {
    auto event = robot_.NextEvent(RemoteTime(std::min(deadline_ns, WallClockNs() + kSliceNs)));
    for (int i = 0; i < kEventsAtOnce && event; ++i) {
      HandleEvent(*event);
      event = robot_.NextEvent({});
    }
    if (event) HandleEvent(*event);
    HandleAnswers(false);
    PingIfSilent();
  } while (WallClockNs() < deadline_ns && !is_ended());
  CopyNewPicture();
}

void RemotePort::HandleEvent(const remote::Event& event) {
  heard_ns_ = WallClockNs();
  if (event.stream == rcstreamSENSORS) {
    StoreSensors(robot_.Read<remote::Sensors>(event), event.frame);
  }
}

void RemotePort::StoreSensors(const remote::Sensors& sensors, uint32_t frame) {
  SensorValues values{};
  values.frame = frame;
  const auto at = [](const std::vector<Sint32>& all, size_t i) {
    return i < all.size() ? all[i] : 0;
  };
  for (int j = 0; j < constants_->numJoints; ++j) {
    values.joint[j] = UradFromCdeg(at(sensors.joints, static_cast<size_t>(j)));
  }
  size_t binary = 0, other = 0;
  for (int i = 0; i < constants_->numSensors; ++i) {
    values.sensor[i] = constants_->sensors[i].group == sensorBINARY ? at(sensors.binary, binary++)
                                                                    : at(sensors.other, other++);
  }
  core_.SetSensors(values);
  battery_percent_ = at(sensors.misc, 0);
  // Ignores the robot's state in sensor values that are older than the answer to MTN_PLAY, the
  // request to play a motion.  These values still say that no motion plays.
  if (!playing_.empty() && !IsAfter(frame, play_frame_)) return;
  state_ = sensors.state == 0xff ? -1 : sensors.state;
  const int key_frame = sensors.keyFrame.empty() ? -1 : sensors.keyFrame[0];
  if (!playing_.empty())
    StoreMotionState(key_frame, state_ == moverACCEPTING_COMMANDS && key_frame < 0);
  for (const auto& [joint, why] : busy_) {
    if (state_ > moverACCEPTING_COMMANDS) {
      // Marks the position of the joint as not sent, so that Changes() returns it again when the
      // motion is over.
      joints_.Forget(joint);
    } else {
      WarnOfRefusal(why);
    }
  }
  busy_.clear();
}

void RemotePort::StoreMotionState(int key_frame, bool is_over) {
  SetValueMessage message{};
  message.state = state_;
  message.keyFrame = key_frame;
  message.isOver = is_over ? 1 : 0;
  playing_.copy(message.file, sizeof message.file - 1);
  if (is_over) playing_.clear();
  SetMotionValues(message);
}

void RemotePort::CopyNewPicture() {
  if (camera_ == nullptr) return;
  std::string rgb;
  Uint8* const buffer = camera_->CopyNewPicture(&rgb) ? CameraBuffer() : nullptr;
  const auto size = static_cast<size_t>(3 * constants_->camera.width * constants_->camera.height);
  if (buffer != nullptr && rgb.size() == size) std::memcpy(buffer, rgb.data(), size);
  const std::string problem = camera_->TakeProblem();
  if (!problem.empty()) Say("no images of the camera: " + problem);
}

// Sends the request INFO when the robot has been silent for long, so that a robot that has stopped
// is noticed.
void RemotePort::PingIfSilent() {
  if (life_ != 0) {
    if (!robot_.IsAnswered(life_)) return;
    robot_.Drop(std::exchange(life_, 0));
    heard_ns_ = WallClockNs();
  } else if (std::chrono::nanoseconds(WallClockNs() - heard_ns_) > options_.timeout) {
    life_ = robot_.Send(rcINFO);
  }
}

void RemotePort::HandleAnswers(bool waits) {
  while (!batches_.empty() && (waits || robot_.IsAnswered(batches_.front().id))) {
    const Batch batch = std::move(batches_.front());
    batches_.pop_front();
    const auto answers = robot_.WaitForBatch(batch.id, batch.commands.size());
    heard_ns_ = WallClockNs();
    for (size_t i = 0; i < answers.size(); ++i) {
      const RobotCommand& command = batch.commands[i];
      if (answers[i].status == rcOK) continue;
      const std::string why = fmt::format("{} was refused: {}", command.what, answers[i].error);
      if (answers[i].status == rcerrorBUSY && command.joint >= 0) {
        // The robot refuses a position while a motion plays, and the next sensor values tell
        // whether a motion plays.  So keeps the refusal until then: if a motion plays, the position
        // is sent again later, else the user gets a warning.
        busy_.emplace_back(command.joint, why);
      } else {
        WarnOfRefusal(why);
      }
    }
  }
}

// Warns the user that the robot has refused a command.  Warns at most once a second, because a
// controller may give the command in each iteration of its loop.
void RemotePort::WarnOfRefusal(const std::string& text) {
  const int64_t now_ns = WallClockNs();
  if (warned_ns_ && now_ns - *warned_ns_ < kBetweenWarningsNs) return;
  warned_ns_ = now_ns;
  Say(text);
}

void RemotePort::Finish() {
  camera_.reset();
  HandleAnswers(true);
}

// ---- Functions that send commands

// Sends all changes of an iteration.  ControllerCore sends joints, ears and lights in this order,
// and sends the lights in every iteration.  So the call of SendLeds() is the last one of the
// iteration.
void RemotePort::SendLeds(Uint32 on, int frames) {
  step_ms_ = frames * kFrameMs;
  std::vector<RobotCommand> commands;
  if (wanted_) commands = joints_.Changes(*wanted_, state_ > moverACCEPTING_COMMANDS);
  AddLights(rcEAR, "ear", constants_->numPlungers, wanted_ears_, &sent_ears_, &commands);
  AddLights(rcLED, "light", constants_->numLeds, on, &sent_leds_, &commands);
  std::string ignored;
  // Ignores the text of an error, because Check() throws this error after the iteration of the
  // controller's loop.
  Guarded([&] { Send(commands); }, &ignored);
}

void RemotePort::AddLights(RcCommand command, const char* kind, int count, Uint32 now, Uint32* sent,
                           std::vector<RobotCommand>* commands) const {
  for (int i = 0; i < count; ++i) {
    const Uint32 is_on = now >> i & 1;
    if (is_on == (*sent >> i & 1)) continue;
    commands->push_back({{command, {static_cast<uint8_t>(i), static_cast<uint8_t>(is_on)}},
                         fmt::format("{} {}", kind, i)});
  }
  *sent = now;
}

void RemotePort::Send(const std::vector<RobotCommand>& commands) {
  for (size_t at = 0; at < commands.size(); at += RC_MAX_BATCH) {
    const size_t end = std::min(commands.size(), at + RC_MAX_BATCH);
    Batch batch{0,
                {commands.begin() + static_cast<ptrdiff_t>(at),
                 commands.begin() + static_cast<ptrdiff_t>(end)}};
    std::vector<remote::Call> calls;
    for (const RobotCommand& command : batch.commands) calls.push_back(command.call);
    batch.id = robot_.SendBatch(calls);
    batches_.push_back(std::move(batch));
  }
}

// Plays a motion.  If the robot refuses the motion, tells the controller at once that the motion is
// over.
void RemotePort::SendMover(const MoverCommand& command) {
  playing_ = command.file;
  std::string refusal;
  const auto play = [&] {
    robot_.PlayMotion(playing_, command.loops, command.keyFramesPerVector);
    play_frame_ = robot_.frame();
    state_ = moverPREPARE_MTN;  // assumed until sensor values give the real state of JointMover
  };
  if (Guarded(play, &refusal)) return;
  Say(fmt::format("mtn_play: {} was refused: {}", playing_, refusal));
  StoreMotionState(-1, true);
}

// ---- Functions that read files: motions of the controller's folder or of the robot's stick

bool RemotePort::ReadFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error) {
  const std::string name = path.substr(path.rfind('/') + 1);
  return Guarded(
      [&] {
        const std::string text = FetchMotion(name);
        bytes->assign(text.begin(), text.end());
      },
      error);
}

// Returns the path of the motion file `name` in the controller's folder; "" if the folder has no
// such file.
std::string RemotePort::LocalMotion(const std::string& name) const {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    if (EqualsIgnoringCase(entry.path().filename().string(), name)) return entry.path().string();
  }
  return "";
}

// Returns the bytes of a motion.  If the controller's folder has the motion file, first uploads it
// to the robot's stick, where `openr controller build` would put it, too.
std::string RemotePort::FetchMotion(const std::string& name) {
  const std::string local = LocalMotion(name);
  if (local.empty()) return robot_.Download(rcfileMOTION, name);
  const std::string bytes = ReadFileOrThrow(local);
  std::string there;
  try {
    there = robot_.Download(rcfileMOTION, name);
  } catch (const remote::Error& error) {
    if (error.status() != rcerrorNO_SUCH_FILE) throw;
  }
  if (there == bytes) return bytes;
  robot_.Upload(rcfileMOTION, name, bytes);
  Say(fmt::format("{}: put on the robot's stick as {}", local, name));
  return bytes;
}

// ---- Functions that fetch pictures of the camera, and functions that print messages for the user

void RemotePort::EnableCamera(bool on) {
  if (on && camera_ == nullptr) {
    camera_ = std::make_unique<CameraFetcher>(address_, options_);
  } else if (!on) {
    camera_.reset();
  }
}

void RemotePort::TimeStepRounded(int asked_ms, int used_ms) {
  if (asked_ms == rounded_ms_) return;
  rounded_ms_ = asked_ms;
  Say(fmt::format("a time step of {} ms is no multiple of 8; {} ms are used", asked_ms, used_ms));
}

void RemotePort::UnknownDevice(const char* locator) {
  const std::vector<const char*> known = core_.Devices().Locators();
  Say(fmt::format(
      "robot_get_device: there is no device '{:.80}'; what it is told goes nowhere, and "
      "it reads 0{}",
      locator, DidYouMean(locator, {known.begin(), known.end()})));
}

void RemotePort::Remark(const char* text) { Say(text); }

void RemotePort::Print(const char* text) {
  std::fputs(text, stdout);
  std::fflush(stdout);
}

// ---- Functions that let the main() of a controller be an endless loop

// Blocks the main() of the controller in robot_step() until ControllerCore calls ContinueLoop();
// then returns true.  Meanwhile each call of on_step_() runs one iteration of ControllerCore.  The
// object Controller of a simulated robot must not block, so it needs a second stack for its main().
// On this computer, main() may block, so no second stack is needed.
bool RemotePort::SuspendLoop() {
  is_continued_ = false;
  while (!is_continued_) on_step_();
  return true;
}

}  // namespace openr_host
