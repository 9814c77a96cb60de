// Messages: against a ring of structs with one virtual call a message.
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>
#include <fmt/format.h>

#include <memory>

#include "bench/bench.h"
#include "runtime/core/code_object.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// The floor: what a message costs when nothing is looked up, ordered or counted.
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

// A subject that answers every ready with a notify of the same region.
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

// An observer that is ready again at once.
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

// `pairs` subjects and observers that play ping-pong; one operation is one message.
class PingPong {
 public:
  PingPong(int pairs, size_t bytes, bool traced) : system_(Options()) {
    system_.AddRobot("ERS-210", nullptr);
    system_.trace().set_hashing(traced);
    std::vector<Receiver*> receivers;
    for (int i = 0; i < pairs; ++i) {
      const std::string a = fmt::format("A{}", i);
      const std::string b = fmt::format("B{}", i);
      system_.AddObject<Sender>(0, a, a, bytes);
      receivers.push_back(system_.AddObject<Receiver>(0, b, b));
      system_.Connect({0, a + ".Out.Data.S", b + ".In.Data.O", "bench"});
    }
    system_.Boot();
    while (!system_.booted()) system_.Step();
    for (Receiver* receiver : receivers) receiver->Begin();
  }
  void Run(int64_t count) { system_.RunMessages(static_cast<uint64_t>(count)); }

 private:
  static SystemOptions Options() {
    SystemOptions options;
    options.free_deliveries = INT64_MAX;  // this game never waits
    return options;
  }
  System system_;
};

std::function<void(int64_t)> Lazy(int pairs, size_t bytes, bool traced) {
  auto game = std::make_shared<std::unique_ptr<PingPong>>();
  return [=](int64_t count) {
    if (*game == nullptr) *game = std::make_unique<PingPong>(pairs, bytes, traced);
    (*game)->Run(count);
  };
}

}  // namespace

std::vector<Row> MessageRows() {
  constexpr int64_t kCount = 1'000'000;
  return {
      {"notify and the ready that comes back",
       "ns a message",
       kCount,
       {{"ring, one virtual call", RunRing},
        {"notify/ready, 32 bytes", Lazy(1, 32, false)},
        {"notify/ready with trace hash", Lazy(1, 32, true)}},
       3.0},
      {"region of any size",
       "ns a message",
       kCount / 10,
       {{"32 bytes", Lazy(1, 32, false)},
        {"64 KiB", Lazy(1, 64 << 10, false)},
        {"1 MiB", Lazy(1, 1 << 20, false)}},
       1.0},
      {"10,000 code-built objects",
       "ns a message",
       kCount,
       {{"ring, one virtual call", RunRing}, {"5,000 pairs", Lazy(5000, 32, false)}},
       3.0},
  };
}

}  // namespace openr_host
