// The fuzz target dds_forged: the samples of a worker that lies to a running master.  The master
// must refuse the process, and must not crash or change what belongs to others.
#include "tests/distribution/forged.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {
namespace {

// Makes samples from the input.  Small numbers are as likely as large ones, so that some of them
// are ids, regions and tokens that exist.
class Liar final : public ForgedTest {
 public:
  explicit Liar(std::string_view bytes) : input_(bytes) {
    // Runs the master only for a short time, because a worker may order a time event with a period
    // of 1 us, as any object may.  Each of its messages costs the master some microseconds.
    run_us_ = 20'000;
  }

  // Lets the worker send its samples until the master has refused it.  Returns whether the first
  // handlers were believed, and a later one was refused for a region that it has given back twice.
  bool Run() {
    const std::string before = TextHere();
    for (int handlers = 0; !input_.empty() && handlers < 4; ++handlers) {
      BeginFuzzStep(input_.taken());
      std::vector<openr_wire_ToMaster> samples;
      const int count = 1 + input_.U8() % 3;
      for (int i = 0; i < count; ++i) samples.push_back(Sample());
      // Each sample may make the master wait for the end of one more handler.  Health() ends
      // others, such as those of a time event with a period.
      for (int i = 0; i <= count; ++i) samples.push_back(Stopped());
      Deliver(samples);
      FuzzCheck(losses_.size() <= 1, "a process is lost once");
      FuzzCheck(TextHere() == before, "a region of another object is changed");
      FuzzCheck(system_.regions().OwnerOf(region_here_) == sender_->host().id,
                "a region of another object is taken");
      if (losses_.empty()) continue;
      FuzzCheck(losses_[0].find("'liar'") != std::string::npos, "the loss names the process");
      return handlers > 0 && losses_[0].find("given back twice") != std::string::npos;
    }
    return false;
  }

 private:
  void TestBody() override {}

  // Ends the handler for whose end the master waits, because no sample has come for 10 ms of wall
  // time.  On a busy machine a sample may only be late, so an input may end more handlers there.
  // Ends the worker instead after many such waits.
  std::string Health() override {
    if (++ended_handlers_ > kEndedHandlersMax) return "process 'liar' has ended";
    channel_->Send(Stopped());
    return "";
  }

  uint64_t Number() {
    const uint8_t number = input_.U8();
    switch (number) {
      case 0xff:
        return input_.U64();
      case 0xfe:
        return static_cast<uint64_t>(remote_->id);
      case 0xfd:
        return static_cast<uint64_t>(sender_->host().id);
      case 0xfc:
        return region_here_;
      case 0xfb:
        return region_there_;
      case 0xfa:
        return kBytes;
      default:
        return number;
    }
  }
  uint32_t Number32() { return static_cast<uint32_t>(Number()); }
  openr_wire_Bytes SomeBytes() {
    const std::string_view bytes = input_.Text(input_.U8() % 64);
    return arena_.Bytes(bytes.data(), bytes.size());
  }
  std::vector<uint64_t> Numbers() {
    std::vector<uint64_t> numbers(input_.U8() % 6);
    for (uint64_t& number : numbers) number = Number();
    return numbers;
  }
  std::vector<openr_wire_NotifiedRegion> Parts() {
    std::vector<openr_wire_NotifiedRegion> parts(input_.U8() % 4);
    for (openr_wire_NotifiedRegion& part : parts) {
      part = {Number(), Number32(), Number32(), Number32(), Number32(), SomeBytes()};
    }
    return parts;
  }
  openr_wire_ToMaster Sample() {
    switch (input_.U8() % 10) {
      case 0:
      case 1:
        return NoteOf(Number32(), Numbers());
      case 2: {
        const auto object = static_cast<int32_t>(Number());
        const uint32_t function = Number32();
        return AskOf(object, function, Numbers(), std::string(input_.Text(input_.U8() % 32)));
      }
      case 3: {
        std::vector<openr_wire_NotifiedRegion> parts = Parts();
        return Notify(std::move(parts), Number32());
      }
      case 4: {
        std::vector<openr_wire_ReturnedRegion> regions(input_.U8() % 4);
        for (openr_wire_ReturnedRegion& region : regions) region = {Number(), SomeBytes()};
        return Ready(std::move(regions));
      }
      case 5: {
        openr_wire_Message message = Message(openr_wire_PAYLOAD_BYTES);
        message.sender = static_cast<int32_t>(Number());
        message.target = static_cast<int32_t>(Number());
        message.selector = Number32();
        message.is_reply = input_.U8() % 4 == 0;
        message.reply_box = Number();
        message.payload._u.bytes = SomeBytes();
        return Post(message, static_cast<int64_t>(Number()));
      }
      case 6: {
        openr_wire_Message message = Message(openr_wire_PAYLOAD_ANT);
        message.payload._u.ant = {SomeBytes(), Number32(), Number32(), SomeBytes()};
        return Post(message);
      }
      case 7: {
        openr_wire_ToMaster stopped = Stopped();
        stopped.body._u.stopped.object = static_cast<int32_t>(Number());
        stopped.body._u.stopped.timeout_us = static_cast<int64_t>(Number());
        return stopped;
      }
      case 8:
        return State(Number32(), std::string(input_.Text(input_.U8() % 32)));
      default:
        return Loaded({static_cast<ObjectId>(Number())});
    }
  }

  static constexpr int kEndedHandlersMax = 20;

  FuzzBytes input_;
  int ended_handlers_ = 0;  // number of handlers that Health() has ended
};

}  // namespace

bool fuzz::dds_forged(std::string_view bytes) { return Liar(bytes).Run(); }

}  // namespace openr_host
