// Probe: an object through which a test sends and receives.
//
// A Probe has the services that the test gives it.  Its observers store the data they receive.  Its
// subjects send data for the test, and store which observers are ready.
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

// A notification that an observer received, with all its data.
struct ReceivedEvent {
  int64_t time_us = 0;
  uint64_t number = 0;  // number of the message
  std::string from;     // name of the sender, such as "Blinker.Blink"
  int notify_count = 1;
  std::vector<std::string> data;  // bytes of each datum

  // Returns datum `i` as a T.  If the message has no such datum, or a datum of another size,
  // reports a failure and returns zeros.
  template <typename T>
  T as(size_t i = 0, Place place = Place::Here()) const {
    static_assert(std::is_trivially_copyable_v<T>, "what objects send each other is plain data");
    T value{};
    if (CheckSize(i, sizeof value, place)) std::memcpy(&value, data[i].data(), sizeof value);
    return value;
  }
  // Returns datum `i` as a text up to its first NUL.
  std::string text(size_t i = 0, Place place = Place::Here()) const;

 private:
  bool CheckSize(size_t i, size_t size, const Place& place) const;
};

class ProbeObserver {
 public:
  // Returns all events so far.
  const std::vector<ReceivedEvent>& events() const { return events_; }
  size_t count() const { return events_.size(); }

  // Returns all data of events(), the notifications that this observer has received.  Each datum is
  // returned as a T.
  template <typename T>
  std::vector<T> values(Place place = Place::Here()) const {
    std::vector<T> all;
    for (const ReceivedEvent& event : events_) {
      for (size_t i = 0; i < event.data.size(); ++i) all.push_back(event.as<T>(i, place));
    }
    return all;
  }
  // Returns the last datum of the last event.  If no data have come, reports a failure and returns
  // zeros.
  template <typename T>
  T last(Place place = Place::Here()) const {
    if (CheckAny(place)) return events_.back().as<T>(events_.back().data.size() - 1, place);
    return T{};
  }
  void Clear() { events_.clear(); }

  // Sets whether this probe, an observer of the test, asserts ready by itself when it starts and
  // after every notification; by default the probe does so.  With `on` false, the probe is ready
  // only after the test has called AssertReady().
  void set_auto_ready(bool on) { auto_ready_ = on; }
  OStatus AssertReady();
  OStatus DeassertReady();

  // Sets a function that is called in the handler of every event, after the event was stored.
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

// A message "ready" or "not ready" that a subject of a Probe (an object through which a test sends
// and receives) got from an observer.
struct ReceivedReady {
  int64_t time_us = 0;
  std::string from;       // name of the sender, such as "Eye.Light"
  bool asserted = false;  // true: AssertReady(); false: DeassertReady()
};

class ProbeSubject {
 public:
  // Sends `value` to the connected observers.  Data for an observer that is not ready wait until
  // the observer is ready, as on the robot.  Reports a failure when no observer is connected.
  template <typename T>
  OStatus Send(const T& value, Place place = Place::Here()) {
    Set(value, place);
    return Notify();
  }
  // Set() and Notify() are the two steps of Send().  Several calls of Set() before Notify() send
  // several data in one event.
  template <typename T>
  OStatus Set(const T& value, Place place = Place::Here()) {
    static_assert(std::is_trivially_copyable_v<T>, "what objects send each other is plain data");
    return SetBytes(&value, sizeof value, place);
  }
  OStatus SetBytes(const void* bytes, size_t size, Place place = Place::Here());
  OStatus Notify();
  // Sends the characters of `text` and a NUL at their end.
  OStatus SendText(const std::string& text, Place place = Place::Here());

  // Returns whether all connected observers are ready.
  bool all_ready() const { return end_->IsAllReady() != 0; }
  // Returns whether at least one connected observer is ready.
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
  // Creates a subject or an observer for each name in `services`, such as "Eye.Light.int.O".
  // REQUIRES: CheckServices(services) does not throw.
  explicit Probe(const std::vector<std::string>& services);

  // Throws std::invalid_argument if a name in `services` is not the full name of a service.
  static void CheckServices(const std::vector<std::string>& services);

  // Return the subject or observer with the name `service`.  The first parts of its name are
  // enough, with or without the object: "Eye.Light" or "Light".  If the probe has no such service,
  // throws std::invalid_argument with the names of its services.
  ProbeSubject& subject(std::string_view service);
  ProbeObserver& observer(std::string_view service);

  // Returns the names of the handlers "DoInit", "DoStart", "DoStop", "DoDestroy" that were called,
  // in order.
  const std::vector<std::string>& calls() const { return calls_; }
  // Sets a function that DoStart calls before the observers assert ready.
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
