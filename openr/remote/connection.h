// Connection, a client of the robot's remote control (docs/remote-control.md).
//
//   openr::remote::Connection robot(openr::remote::ParseAddress("127.0.0.1:54000"));
//   const int pan = robot.Find(rcdeviceJOINT, "neck_pan");
//   robot.SetSpeed(pan, 60);  // degrees/s
//   robot.Move(pan, 30);      // degrees
//
// All failures are exceptions of the class Error (error.h).  Their texts say what the user can do.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "RemoteCamera.h"
#include "RemoteFiles.h"
#include "RemoteLog.h"
#include "RemoteProtocol.h"
#include "RemoteStreams.h"
#include "openr/remote/address.h"
#include "openr/remote/error.h"
#include "openr/remote/picture.h"

namespace openr::remote {

class TcpStream;

// Names in this library for the structs of the remote-control protocol.  The robot uses the same
// structs; the header files that declare them (Remote*.h) describe their values and units.
using Info = RcInfo;  // describes the design of the robot and what the robot does now
// Describes a device: its names, and the limits of a joint or the kind of a sensor.
using Description = RcDescription;
// Describes a joint; the units of the fields are 0.01 degree, 0.01 degree/s and 0.01 degree/s^2.
using JointState = RcJointState;
using Gains = RcGains;
using Power = RcPower;
using Sensors = RcSensors;
using SetValues = RcSetValues;
using PlayAnswer = RcPlayAnswer;
using ListEntry = RcListEntry;

using Bytes = std::vector<uint8_t>;

struct Options {
  // Time limit for connecting, and for each answer.
  std::chrono::milliseconds timeout{3000};
  // The token, a secret that some servers ask for (openr run --listen); "": no token is sent.
  std::string token = {};
};

// The number of a request that was sent.  It is never 0.
using RequestId = uint16_t;

// The answer of the robot to a request.
struct Answer {
  // Number of the frame of 8 ms to which the robot's newest sensor values belong; 0xffffffff: no
  // frame is known.
  uint32_t frame = 0xffffffff;
  int status = rcOK;  // result of the request, an RcStatus
  std::string error;  // the robot's error text if the status is not rcOK
  Bytes payload;      // payload of the answer; empty if the status is not rcOK
};

// A request that is sent in a batch, that is, with others in one packet.  `payload` has no header.
struct Call {
  int command;  // number of the command, an RcCommand
  Bytes payload;
};

// A packet of a stream of events (sensor values or set values).  The robot sends these packets
// without further requests.
struct Event {
  RequestId subscription = 0;  // id of the subscription, which Subscribe() has returned
  uint32_t frame = 0;
  int stream = 0;  // kind of the stream, an RcStream
  // Number of times that the robot left out the values of this stream between the previous event
  // and this event.
  int left_out = 0;
  Bytes values;  // Sensors or SetValues as bytes, which Read() converts to the struct
};

// A function that is called during a transfer with two numbers: the bytes that were transferred,
// and the size of the file.  The first call has 0 bytes.
using Progress = std::function<void(size_t done, size_t size)>;

// A TCP connection to a robot.  The caller owns it and uses it in one thread at a time.
//
// Functions throw Error.  If Error::IsConnectionUsable() is false, the connection cannot be used
// any more.  It does not connect again by itself, because its subscriptions and begun uploads are
// lost, and other clients may have changed the robot meanwhile; the caller must decide what to do.
//
// Requests use version 1 of the protocol if it has the command, so that older robots answer them.
class Connection {
 public:
  explicit Connection(const Address& address, Options options = {});
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  const Address& address() const { return address_; }

  // Returns the frame number in the last answer for which a function of this class has waited: the
  // number of the frame of 8 ms to which the robot's newest sensor values belonged.
  uint32_t frame() const { return frame_; }

  // ---- Functions that describe the robot and its devices.  An index is the number of a device in
  // the robot's model, from 0.

  Info GetInfo();

  // Returns all devices of the kind `kind`.  Asks the robot only in the first call, because its
  // devices never change.
  const std::vector<Description>& Devices(RcDeviceKind kind);

  // Returns the index of a device.  `name` is its short name ("LF_j1"), title ("Left fore leg J1"),
  // locator ("PRM:/r2/c1-Joint2:j1", its name in OPEN-R) or number.  If the robot has no such
  // device, throws Error (kNoDevice) with a list of all devices.
  int Find(RcDeviceKind kind, const std::string& name);

  // ---- Functions that read and command joints, lights and ears

  JointState GetJoint(int joint);

  // Move(), SetSpeed() and SetAcceleration() return the value that is now in force: the wanted
  // value, or the joint's limit if the wanted value is beyond it.  They return before the joint has
  // moved.  Values beyond 10^6 count as 10^6. REQUIRES: the value is a number.
  double Move(int joint, double degrees);
  double SetSpeed(int joint, double degrees_per_s);
  double SetAcceleration(int joint, double degrees_per_s2);

  // Returns a request of Move(), SetSpeed() or SetAcceleration(), to be sent with Send() or
  // Batch(). `command` is rcMOVE, rcSPEED or rcACCEL.
  static Call JointCall(RcCommand command, int joint, double value);
  // Returns the position, speed or acceleration that is now in force for the joint, from the answer
  // to a request of JointCall().
  double InForce(const Answer& answer) const;

  void SetLed(int led, bool on);
  void SetEar(int ear, bool on);

  // Switches the motor of a joint on or off.  RC_ALL_JOINTS switches all motors and the motor
  // power.
  void SwitchMotor(int joint, bool on);
  Gains GetGains(int joint);
  // Sets the gains P, I and D of a joint's servo, each 0 to RC_MAX_GAIN; returns the new gains.
  Gains SetGains(int joint, int p, int i, int d);

  // ---- Functions that read sensors, power and the camera

  Sensors GetSensors();
  Power GetPower();

  // Asks for a picture and waits for the picture, at most for the time limit of the options.
  // `layer` is 0, 1 or 2 for a picture of high (H), medium (M) or low (L) resolution, and 3 for the
  // detected colours (C).
  Picture TakePicture(int layer);

  // ---- Functions that play motions, and that list, transfer and delete files of the stick. `name`
  // is a file name of 8+3 characters, such as "WALK.MTN".

  // Starts a motion; returns before the motion begins.  `loops` is 1 to 65535.
  // `key_frames_per_vector` is 2, 4, 6, 8 or 0 (the robot chooses).
  PlayAnswer PlayMotion(const std::string& name, int loops = 1, int key_frames_per_vector = 0);
  void StopMotion();

  // Returns the motion files, sorted by name, with sizes in bytes.
  std::vector<ListEntry> ListMotions();

  // Uploads a file to the stick; replaces a file of the same name.  The robot checks the content.
  // If the robot refuses the file or the connection ends, the old file stays.
  void Upload(RcFileKind kind, const std::string& name, const std::string& bytes,
              const Progress& progress = {});
  std::string Download(RcFileKind kind, const std::string& name, const Progress& progress = {});
  void DeleteMotion(const std::string& name);

  // ---- Functions that end the run.  The robot answers no further request of this client.

  void Reboot();
  void Shutdown();

  // ---- Functions that receive events, which the robot sends without further requests

  // Subscribes to a stream of events (sensor values or set values); replaces an earlier
  // subscription to it.  `period` is the smallest number of frames between two events: a multiple
  // of 4 and not 0 for sensors, 0 or more for set values. Functions of this class acknowledge
  // events when they receive them.  While the caller calls no function, the robot gets no
  // acknowledgement and sends events only every 28 frames.
  RequestId Subscribe(RcStream stream, int period);
  void Unsubscribe(RcStream stream);

  // Waits for the next event, as long as the robot answers.  If no event comes within the time
  // limit of the options, sends INFO to test that the robot still answers, and throws Error if it
  // does not.  Of the events that have arrived while other functions waited, only the newest
  // kEventsMax are kept for this function.
  Event NextEvent();
  // Returns the next event; nullopt if no event arrives until `deadline`.  If `deadline` is in the
  // past, still receives bytes that have arrived already.
  std::optional<Event> NextEvent(std::chrono::steady_clock::time_point deadline);
  static constexpr size_t kEventsMax = 1000;

  // ---- Functions that send requests of any kind, and can send several without waiting

  // Sends a request, waits for its answer and returns the answer.  `version` is the version of the
  // protocol; 0: the first version that has the command.
  Answer Request(int command, const Bytes& payload = {}, int version = 0);

  // Sends a request and returns at once.  The caller must pass the id once to Wait(), WaitForAny()
  // or Drop().  The robot answers in the order of the requests; the caller may wait in any order.
  // At most kInFlight requests should wait for answers, because more answers may fill the buffers
  // of the network, and then neither side can send.
  RequestId Send(int command, const Bytes& payload = {}, int version = 0);
  static constexpr size_t kInFlight = 32;

  // Returns whether the answer to the request `id` has arrived, so that Wait() returns at once.
  // Throws Error (kTimeout) if the request was sent longer ago than the time limit of the options.
  bool IsAnswered(RequestId id);
  // Waits for the answer to the request `id` and returns it; throws Error (kRefused) if the robot
  // refuses the request.
  Answer Wait(RequestId id);
  // Waits for the answer to the request `id` and returns it, even if the robot refuses the request.
  Answer WaitForAny(RequestId id);
  void Drop(RequestId id);  // makes the library throw the answer away when it arrives

  // Sends a request for each payload without waiting for answers in between, so that many requests
  // take few round trips.  If the robot refuses requests, throws the first refusal after all
  // answers have arrived.
  std::vector<Answer> RequestAll(int command, const std::vector<Bytes>& payloads);

  // Sends up to RC_MAX_BATCH requests in one packet, which the robot carries out in the same frame.
  // Returns their answers in the same order.  A refusal is an answer, too, and does not end the
  // batch.
  std::vector<Answer> Batch(const std::vector<Call>& calls);
  RequestId SendBatch(const std::vector<Call>& calls);
  // Waits for the answer to SendBatch() and returns the answers to the single requests of this
  // batch.  `count` is the number of requests in the batch.
  std::vector<Answer> WaitForBatch(RequestId id, size_t count);

  // ---- Functions for programs that serve several robots in one thread

  // Returns the socket, for poll().  REQUIRES: the caller uses it with poll() only.
  int descriptor() const;
  // Returns the answer to the request `id` if it has been received, and then forgets the request;
  // else nullopt.  Does not wait and does not read from the socket.  To read what has arrived, call
  // NextEvent() with a deadline in the past.
  std::optional<Answer> TakeAnswer(RequestId id);
  // Returns the answers to the single requests of a batch.  `answer` is the answer to SendBatch(),
  // `count` the number of requests in the batch.
  std::vector<Answer> ReadBatch(const Answer& answer, size_t count) const;

  // Makes the payload of a request from `payload`, a struct of the remote-control protocol.
  template <typename Payload>
  static Bytes BytesOf(const Payload& payload) {
    uint8_t bytes[RC_MAX_PACKET];
    RcWriter writer(bytes, sizeof bytes);
    payload.Write(&writer);
    return {bytes, bytes + writer.Size()};
  }

  // Reads the payload of an answer into a struct of the remote-control protocol, or the values of
  // an event into Sensors or SetValues.
  template <typename Payload>
  Payload Read(const Answer& answer) const {
    return Read<Payload>(answer.payload);
  }
  template <typename Values>
  Values Read(const Event& event) const {
    return Read<Values>(event.values);
  }

 private:
  Connection(const Address& address, Options options, bool is_probe);

  template <typename Payload>
  Payload Read(const Bytes& bytes) const {
    Payload payload{};
    RcReader reader(bytes.data(), static_cast<int>(bytes.size()));
    if (!payload.Read(&reader)) ThrowMalformed();
    return payload;
  }

  // A request that was sent, and whose answer no function has taken yet.
  struct Pending {
    std::chrono::steady_clock::time_point sent;
    bool is_dropped = false;
    std::optional<Answer> answer;
  };

  bool RobotGoesOn() const;
  void SendBytes(const Bytes& bytes);
  bool ReceivePacket(std::chrono::steady_clock::time_point deadline);
  void HandlePacket();
  void StoreAnswer(const RcAnswerHeader& header);
  void KeepEvent(const RcAnswerHeader& header);
  Picture WaitForPicture();
  [[noreturn]] void Throw(ErrorCode code, const std::string& text,
                          const std::string& advice = "") const;
  void ShowToken();
  [[noreturn]] void ThrowMalformed() const;
  [[noreturn]] void ThrowSilent() const;
  [[noreturn]] void ThrowLost() const;

  const Address address_;
  const Options options_;
  const bool is_probe_;  // true: RobotGoesOn() has made this connection to test the robot
  std::unique_ptr<TcpStream> stream_;
  RcFramer framer_;
  RequestId last_id_ = 0;
  std::map<RequestId, Pending> pending_;
  std::deque<Event> events_;  // events that have arrived and that NextEvent() has not returned yet
  uint32_t frame_ = 0xffffffff;
  std::optional<std::vector<Description>> devices_[NUM_RC_DEVICES];
};

}  // namespace openr::remote
