#include "bench/ping_pong.h"

#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>
#include <fmt/format.h>

#include <string>
#include <vector>

#include "runtime/core/code_object.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

class Ring {
 public:
  struct Item {
    int target;
    void* data;
  };
  class Actor {
   public:
    virtual ~Actor() = default;
    virtual void Handle(Ring* ring, void* data) = 0;
  };
  void Post(int target, void* data) { items_[head_++ & kMask] = {target, data}; }
  void Run(int64_t count) {
    for (; count > 0; --count) {
      const Item item = items_[tail_++ & kMask];
      actors[static_cast<size_t>(item.target)]->Handle(this, item.data);
    }
  }
  std::vector<std::unique_ptr<Actor>> actors;

 private:
  static constexpr uint32_t kMask = 0xffff;
  std::vector<Item> items_{std::vector<Item>(kMask + 1)};
  uint32_t head_ = 0;
  uint32_t tail_ = 0;
};

class Player : public Ring::Actor {
 public:
  explicit Player(int peer) : peer_(peer) {}
  void Handle(Ring* ring, void* data) override { ring->Post(peer_, data); }

 private:
  const int peer_;
};

class Sender : public CodeObject {
 public:
  Sender(const std::string& name, size_t bytes) {
    out = AddSubject(name + ".Out.Data.S", [this](const OReadyEvent&) { Send(); });
    region = new RCRegion(bytes);
  }
  void Send() {
    out->SetData(region);
    out->NotifyObservers();
  }
  OSubject* out;
  RCRegion* region;
};

class Receiver : public CodeObject {
 public:
  explicit Receiver(const std::string& name) {
    in = AddObserver(name + ".In.Data.O", [this](const ONotifyEvent&) { in->AssertReady(); });
  }
  void Begin() {
    const CurrentScope scope(&system(), &host());
    in->AssertReady();
  }
  OObserver* in;
};

SystemOptions WithoutCrowdingDelay() {
  SystemOptions options;
  options.free_deliveries = INT64_MAX;  // no limit, because virtual time stands still in this game
  return options;
}

}  // namespace

void RunRing(int64_t count) {
  static Ring ring = [] {
    Ring made;
    made.actors.push_back(std::make_unique<Player>(1));
    made.actors.push_back(std::make_unique<Player>(0));
    made.Post(0, nullptr);
    return made;
  }();
  ring.Run(count);
}

struct PingPong::Game {
  System system{WithoutCrowdingDelay()};
};

PingPong::PingPong(int pairs, size_t bytes, bool traced) : game_(std::make_unique<Game>()) {
  System& system = game_->system;
  system.AddRobot("ERS-210", nullptr);
  system.trace().set_hashing(traced);
  std::vector<Receiver*> receivers;
  for (int i = 0; i < pairs; ++i) {
    const std::string a = fmt::format("A{}", i);
    const std::string b = fmt::format("B{}", i);
    system.AddObject<Sender>(0, a, a, bytes);
    receivers.push_back(system.AddObject<Receiver>(0, b, b));
    system.Connect({0, a + ".Out.Data.S", b + ".In.Data.O", "bench"});
  }
  system.Boot();
  while (!system.booted()) system.Step();
  for (Receiver* receiver : receivers) receiver->Begin();
}

PingPong::~PingPong() = default;

void PingPong::Run(int64_t count) { game_->system.RunMessages(static_cast<uint64_t>(count)); }

}  // namespace openr_host
