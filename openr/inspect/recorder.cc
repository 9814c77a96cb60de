#include "openr/inspect/recorder.h"

#include <utility>

#include "openr/inspect/recorded_network.h"
#include "runtime/base/assert.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {

void Recorder::RecordNetworks(SimulationOptions* options) {
  options->network_filter = [this, inside = options->network_filter](
                                int robot, std::unique_ptr<Network> inner) {
    if (inside) inner = inside(robot, std::move(inner));
    return std::make_unique<RecordingNetwork>(
        std::move(inner), [this, robot](const std::vector<NetworkEvent>& events) {
          if (writer_ != nullptr) writer_->AddNetwork(robot, events);
        });
  };
}

void Recorder::Begin(Simulation* simulation, const SimulationOptions& options,
                     const std::string& stick, bool is_free, const std::string& schedule) {
  System& system = simulation->system();
  ASSERT(!system.booted() && system.now_us() == 0);
  TraceHeader header;
  header.program = OPENR_VERSION;
  header.stick = stick;
  header.stick_hash = system.robot(0).stick_hash;
  // Leaves write_protected false for an explored run, which is a run with a schedule, because a
  // replay write-protects the stick of every explored run anyway.
  header.write_protected =
      options.robots == 1 && schedule.empty() && !system.robot(0).stick->writable();
  header.robot = options.robot;
  header.body = options.body;
  header.world = options.world;
  header.cost = options.cost_file;
  header.battery = options.battery;
  header.microphone = options.microphone;
  header.images = options.images;
  for (const AddressPair& pair : options.addresses)
    header.addresses.push_back(AddressText(pair.robot) + "=" + AddressText(pair.host));
  header.robots = options.robots;
  header.together = options.together;
  header.more_sticks = options.more_sticks;
  for (size_t i = 1; i <= options.more_sticks.size() && i < static_cast<size_t>(options.robots);
       ++i)
    header.more_stick_hashes.push_back(system.robot(static_cast<int>(i)).stick_hash);
  header.seed = options.seed;
  header.strict = options.strict;
  header.is_free = is_free;
  header.schedule = schedule;
  header.payloads = payloads_;
  writer_ = std::make_unique<TraceWriter>(file_, header);
  system.inputs().OnAdd([this, &system](int robot, std::string_view line) {
    writer_->AddInput(robot, line, system.now_us());
  });
  // Records changes of the stick only if there is one robot, because several robots can only read
  // their sticks.
  if (options.robots == 1) {
    auto* const stick = dynamic_cast<FolderStick*>(system.robot(0).stick.get());
    ASSERT(stick != nullptr);
    stick->OnFirstChange([this, stick](const MemoryStick::Location& location) {
      // Asks for the folder of the stick at each change, because a view or a branch of this run
      // (openr/rewind) has a copy of the stick in another folder.
      writer_->AddStick(location.path.substr(stick->root().size() + 1), location.path);
    });
  }
  // Writes the last block when an object ends the process, so that the recording has the messages
  // up to the crash.
  ending_action_ = std::make_unique<EndingAction>([this](Ending* ending) {
    writer_->AddEnded(EndOf(*ending));
    writer_->Flush();
  });
  system.trace().AddSink([this, &system](const TraceRecord& record, const Message& message) {
    writer_->AddMessage(system, record, message);
  });
}

void Recorder::AddStick(const std::vector<TraceEntry>& entries) {
  for (const TraceEntry& entry : entries) writer_->AddEntry(entry);
}

}  // namespace openr_host
