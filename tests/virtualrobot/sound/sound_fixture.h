// A robot whose speaker plays into memory, with an object that sends it sound and one that
// listens to the microphone.
#pragma once

#include "tests/virtualrobot/comm_fixture.h"

namespace openr_host {

// Sends sound vectors and notes when each ready comes.
class Player : public CodeObject {
 public:
  explicit Player(const std::string& name = "Player") {
    play = AddSubject(name + ".Play.OSoundVectorData.S", [this](const OReadyEvent&) {
      readies.push_back(system().now_us() / kFrameUs);
      if (on_ready) on_ready();
    });
  }

  OPrimitiveID Open() {
    OPrimitiveID id = 0;
    EXPECT_EQ(OPENR::OpenPrimitive(kSpeaker, &id), oSUCCESS);
    return id;
  }

  // A vector with one sound, all of whose bytes are `value`.
  RCRegion* NewSound(size_t bytes, int value) {
    MemoryRegionID id = 0;
    OSoundVectorData* data = nullptr;
    EXPECT_EQ(OPENR::NewSoundVectorData(1, bytes, &id, &data), oSUCCESS);
    data->SetNumData(1);
    data->GetInfo(0)->Set(odataSOUND_VECTOR, Open(), bytes);
    std::memset(data->GetData(0), value, bytes);
    return new RCRegion(data->vectorInfo.memRegionID, data->vectorInfo.offset, data,
                        data->vectorInfo.totalSize);
  }
  static OSoundVectorData* Data(RCRegion* region) {
    return reinterpret_cast<OSoundVectorData*>(region->Base());
  }
  void Send(const std::vector<RCRegion*>& regions) {
    for (RCRegion* region : regions) play->SetData(region);
    play->NotifyObservers();
  }

  OSubject* play;
  std::vector<int64_t> readies;  // frame boundaries
  std::function<void()> on_ready;
};

class Listener : public CodeObject {
 public:
  Listener() {
    mic = AddObserver("Listener.Mic.OSoundVectorData.O", [this](const ONotifyEvent& event) {
      times.push_back(system().now_us());
      if (on_vector) on_vector(reinterpret_cast<OSoundVectorData*>(event.RCData(0)->Base()));
      mic->AssertReady();
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    mic->AssertReady();
    return oSUCCESS;
  }
  OObserver* mic;
  std::vector<int64_t> times;
  std::function<void(OSoundVectorData*)> on_vector;
};

class SoundTest : public VirtualRobotCommTest {
 protected:
  explicit SoundTest(const char* name = "ers210") : SoundTest(Wire(), name) {}

  void AddListener() {
    listener = system.AddObject<Listener>(dog, "listener");
    system.Connect({dog, "OVirtualRobotAudioComm.Mic.OSoundVectorData.S",
                    "Listener.Mic.OSoundVectorData.O", "test"});
  }
  // Boots with motor power, which the speaker's amplifier needs, and forgets the first ready.
  void BootForSound() {
    Boot();
    RunAs(player, [&] { OPENR::SetMotorPower(opowerON); });
    player->readies.clear();
  }
  OStatus Ask(OPrimitiveRequest request) {
    return OPENR::ControlPrimitive(player->Open(), request, nullptr, 0, nullptr, 0);
  }
  template <typename T>
  OStatus Ask(OPrimitiveRequest request, T param) {
    return OPENR::ControlPrimitive(player->Open(), request, &param, sizeof param, nullptr, 0);
  }

  // The sound as text: for each frame its number and runs of equal samples, as "12:64x256 64x0".
  std::string Heard() const {
    std::string text;
    for (const MemorySoundSink::Entry& entry : sink->entries) {
      text += fmt::format("{}{}:", text.empty() ? "" : "; ", entry.frame);
      for (size_t i = 0; i < entry.samples.size();) {
        size_t end = i;
        while (end < entry.samples.size() && entry.samples[end] == entry.samples[i]) ++end;
        text += fmt::format("{}{}x{}", i == 0 ? "" : " ", end - i, entry.samples[i]);
        i = end;
      }
    }
    return text;
  }

  MemorySoundSink* sink = nullptr;
  Player* player = nullptr;
  Listener* listener = nullptr;

 private:
  struct Wired {
    MemorySoundSink* sink;
    VirtualRobotOptions options;
  };
  SoundTest(Wired wired, const char* name)
      : VirtualRobotCommTest(std::move(wired.options), name), sink(wired.sink) {
    player = system.AddObject<Player>(dog, "player");
    system.Connect({dog, "Player.Play.OSoundVectorData.S",
                    "OVirtualRobotAudioComm.Speaker.OSoundVectorData.O", "test"});
  }
  static Wired Wire() {
    auto sink = std::make_unique<MemorySoundSink>();
    MemorySoundSink* const seen = sink.get();
    return {seen, {std::move(sink), Tones(), nullptr, {}}};
  }
  // A source of 1000 samples: 0, 1, 2... on the left side and 0, -1, -2... on the right side.
  static std::unique_ptr<SoundSource> Tones() {
    std::vector<OSoundSampleStereo16> samples;
    for (sword i = 0; i < 1000; ++i) samples.push_back({i, static_cast<sword>(-i)});
    return std::make_unique<MemorySoundSource>(std::move(samples));
  }
};

}  // namespace openr_host
