// The fuzz target dds_message: messages of a forged worker, and a forged master, as they are
// decoded.
#include <memory>

#include "distribution/marshaller.h"
#include "runtime/core/api.h"
#include "runtime/core/code_object.h"
#include "runtime/core/current.h"
#include "runtime/core/system.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {
namespace {

// Makes a forged message from the input.  Small numbers are as likely as large ones, so that some
// of them are ids and tokens that exist; 0xff is the id of `region`, a region that exists.
class Forger {
 public:
  Forger(std::string_view bytes, uint32_t region) : input_(bytes), region_(region) {}

  bool AtEnd() const { return input_.empty(); }

  openr_wire_Message Next() {
    BeginFuzzStep(input_.taken());
    arena_.Clear();
    openr_wire_Message message{};
    message.sender = static_cast<int32_t>(Number());
    message.target = static_cast<int32_t>(Number());
    message.selector = static_cast<uint32_t>(Number());
    message.payload._d = static_cast<openr_wire_PayloadKind>(input_.U8() % 4);
    switch (message.payload._d) {
      case openr_wire_PAYLOAD_BYTES:
        message.payload._u.bytes = Bytes();
        break;
      case openr_wire_PAYLOAD_NOTIFY:
        message.payload._u.notify = Notify();
        break;
      case openr_wire_PAYLOAD_READY:
        message.payload._u.ready = Ready();
        break;
      case openr_wire_PAYLOAD_ANT:
        message.payload._u.ant = {Bytes(), static_cast<uint32_t>(Number()),
                                  static_cast<uint32_t>(Number()), Bytes()};
        break;
    }
    return message;
  }

 private:
  uint64_t Number() {
    const uint8_t kind = input_.U8();
    if (kind == 0xff) return region_;
    return kind < 0xf0 ? kind : input_.U64();
  }
  openr_wire_Bytes Bytes() {
    const std::string_view bytes = input_.Text(static_cast<size_t>(input_.U8()) * 2);
    return arena_.Bytes(bytes.data(), bytes.size());
  }
  openr_wire_Notify Notify() {
    openr_wire_Notify notify{};
    notify.subject = static_cast<int32_t>(Number());
    notify.notifications = static_cast<uint32_t>(Number());
    std::vector<openr_wire_NotifiedRegion> parts(input_.U8() % 20);
    for (openr_wire_NotifiedRegion& part : parts) {
      part = {Number(),
              static_cast<uint32_t>(Number()),
              static_cast<uint32_t>(Number()),
              static_cast<uint32_t>(Number()),
              static_cast<uint32_t>(Number()),
              Bytes()};
    }
    notify.parts = arena_.Sequence<decltype(notify.parts)>(parts);
    return notify;
  }
  openr_wire_Ready Ready() {
    openr_wire_Ready ready{};
    ready.command = static_cast<uint32_t>(Number());
    ready.observer = static_cast<int32_t>(Number());
    std::vector<openr_wire_ReturnedRegion> regions(input_.U8() % 20);
    for (openr_wire_ReturnedRegion& region : regions) region = {Number(), Bytes()};
    ready.regions = arena_.Sequence<decltype(ready.regions)>(regions);
    return ready;
  }

  FuzzBytes input_;
  const uint32_t region_;
  WireArena arena_;
};

// Decodes all messages of the input in a process of its own.  Returns how many regions came.
int DecodeAll(std::string_view bytes, bool is_worker) {
  System system;
  system.AddRobot("ERS-210", nullptr);
  auto* const object = system.AddObject<CodeObject>(0, "object");
  const uint32_t region = system.regions().New(64, object->host().id);
  Marshaller marshaller(&system, is_worker);
  int regions = 0;
  Forger forger(bytes, region);
  while (!forger.AtEnd()) {
    Message message;
    const openr_wire_Message forged = forger.Next();
    const CurrentScope scope(&system, &object->host());
    const bool is_good = marshaller.Decode(forged, &message).empty();
    if (is_good && message.kind == PayloadKind::kNotify) {
      regions += static_cast<int>(forged.payload._u.notify.parts._length);
    }
    marshaller.ReleaseSample();
  }
  marshaller.PeerIsLost();
  return regions;
}

}  // namespace

bool fuzz::dds_message(std::string_view bytes) {
  const int of_master = DecodeAll(bytes, true);
  return DecodeAll(bytes, false) > 0 && of_master > 0;
}

}  // namespace openr_host
