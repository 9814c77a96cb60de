// Objects a test speaks and listens through.
//
// A Probe has the services it is given.  Its observers write down what they get; its
// subjects send what the test says, and write down who is ready.
//
//   Probe& eye = bench.AddProbe("Eye", {"Eye.Light.int.O", "Eye.Speed.int.S"});
//   eye.subject("Speed").Send(5);
//   EXPECT_EQ(eye.observer("Light").values<int>(), (std::vector{1, 0}));
#pragma once

#include <cstdint>
#include <cstring>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "runtime/core/code_object.h"
#include "testing/place.h"

namespace openr::testing {

// One event of an observer.
struct ReceivedEvent {
  int64_t time_us = 0;
  uint64_t number = 0;  // of the message
  std::string from;     // "Blinker.Blink"
  int notify_count = 1;
  std::vector<std::string> data;  // bytes

  // Datum `i` as a T; a failure and zeros when it has not its size.
  template <typename T>
  T as(size_t i = 0, Place place = Place::Here()) const {
    static_assert(std::is_trivially_copyable_v<T>, "what objects send each other is plain data");
    T value{};
    if (CheckSize(i, sizeof value, place)) std::memcpy(&value, data[i].data(), sizeof value);
    return value;
  }
  // Datum `i` up to its first NUL.
  std::string text(size_t i = 0, Place place = Place::Here()) const;

 private:
  bool CheckSize(size_t i, size_t size, const Place& place) const;
};

class ProbeObserver {
 public:
  // All events so far.
  const std::vector<ReceivedEvent>& events() const { return events_; }
  size_t count() const { return events_.size(); }

  // All data of all events, each as a T.
  template <typename T>
  std::vector<T> values(Place place = Place::Here()) const {
    std::vector<T> all;
    for (const ReceivedEvent& event : events_) {
      for (size_t i = 0; i < event.data.size(); ++i) all.push_back(event.as<T>(i, place));
    }
    return all;
  }
  // The last datum of the last event.  A failure and zeros when there is none.
  template <typename T>
  T last(Place place = Place::Here()) const {
    if (CheckAny(place)) return events_.back().as<T>(events_.back().data.size() - 1, place);
    return T{};
  }
  void Clear() { events_.clear(); }

  // Says ready when the probe starts and after every event (the default), or only when the
  // test says so.
  void set_auto_ready(bool on) { auto_ready_ = on; }
  OStatus AssertReady();
  OStatus DeassertReady();

  // Called in the handler of every event, after it was written down.
  void set_on_event(std::function<void(const ONotifyEvent&)> call) { on_event_ = std::move(call); }

  const std::string& service() const { return service_; }
  OObserver& end() { return *end_; }

 private:
  friend class Probe;
  bool CheckAny(const Place& place) const;

  std::string service_;
  openr_host::CodeObject* probe_ = nullptr;
  OObserver* end_ = nullptr;
  bool auto_ready_ = true;
  std::vector<ReceivedEvent> events_;
  std::function<void(const ONotifyEvent&)> on_event_;
};

// One message of an observer to a subject of a probe.
struct ReceivedReady {
  int64_t time_us = 0;
  std::string from;       // "Eye.Light"
  bool asserted = false;  // AssertReady() or DeassertReady()
};

class ProbeSubject {
 public:
  // Sets the value and notifies.  What nobody is ready for waits, as on the robot.  A failure
  // when no observer is connected.
  template <typename T>
  OStatus Send(const T& value, Place place = Place::Here()) {
    Set(value, place);
    return Notify();
  }
  // The same in two steps: several data for one event.
  template <typename T>
  OStatus Set(const T& value, Place place = Place::Here()) {
    static_assert(std::is_trivially_copyable_v<T>, "what objects send each other is plain data");
    return SetBytes(&value, sizeof value, place);
  }
  OStatus SetBytes(const void* bytes, size_t size, Place place = Place::Here());
  OStatus Notify();
  // A text with its NUL.
  OStatus SendText(const std::string& text, Place place = Place::Here());

  // Whether every observer, or at least one, is ready.
  bool all_ready() const { return end_->IsAllReady() != 0; }
  bool any_ready() const { return end_->IsAnyReady() != 0; }
  const std::vector<ReceivedReady>& readies() const { return readies_; }

  void set_on_ready(std::function<void(const OReadyEvent&)> call) { on_ready_ = std::move(call); }

  const std::string& service() const { return service_; }
  OSubject& end() { return *end_; }

 private:
  friend class Probe;

  std::string service_;
  openr_host::CodeObject* probe_ = nullptr;
  OSubject* end_ = nullptr;
  std::vector<ReceivedReady> readies_;
  std::function<void(const OReadyEvent&)> on_ready_;
};

class Probe : public openr_host::CodeObject {
 public:
  // Full names of services.  REQUIRES: CheckServices() accepts them.
  explicit Probe(const std::vector<std::string>& services);

  // Throws std::invalid_argument for what is no service.
  static void CheckServices(const std::vector<std::string>& services);

  // By full name, "Eye.Light" or "Light".  Throws std::invalid_argument that lists the ones
  // there are.
  ProbeSubject& subject(std::string_view service);
  ProbeObserver& observer(std::string_view service);

  // "DoInit", "DoStart", ... as they came.
  const std::vector<std::string>& calls() const { return calls_; }
  // Runs in DoStart, before the observers say that they are ready.
  void set_on_start(std::function<void()> call) { on_start_ = std::move(call); }

  OStatus DoInit(const OSystemEvent& event) override;
  OStatus DoStart(const OSystemEvent& event) override;
  OStatus DoStop(const OSystemEvent& event) override;
  OStatus DoDestroy(const OSystemEvent& event) override;

 private:
  void AddSubjectEnd(const std::string& service);
  void AddObserverEnd(const std::string& service);
  void Hear(ProbeObserver* observer, const ONotifyEvent& event);

  std::deque<ProbeSubject> subjects_;
  std::deque<ProbeObserver> observers_;
  std::vector<std::string> calls_;
  std::function<void()> on_start_;
};

}  // namespace openr::testing
