// Rows for a notification to an object in another process and the ready that comes back.  They are
// compared with a bare sample of Cyclone DDS that goes there and back with the same settings and
// bytes, and with a Unix socket.
#include <OPENR/OSubject.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <spawn.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "bench/bench.h"
#include "cli/install_paths.h"
#include "distribution/bus.h"
#include "distribution/worker_group.h"
#include "runtime/base/temp_folder.h"
#include "runtime/core/code_object.h"
#include "runtime/core/load_stick.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"

extern char** environ;

namespace openr_host {
namespace {

constexpr ChannelTopics kRawTopics = {&openr_wire_Answer_desc, "bench_down",
                                      &openr_wire_Answer_desc, "bench_up"};
using RawChannel = Channel<openr_wire_Answer, openr_wire_Answer>;

// Returns the number of a new DDS domain.  A process can have only one Bus in a domain, so each
// pair of processes gets a domain of its own.
int NewDomain() {
  static int domain = 100;
  return ++domain;
}

// Returns the options of a Bus.  `has_large_history` is true for comparisons with free runs, which
// have a large history too.
BusOptions BusOf(const std::string& run, int domain, bool has_large_history = false) {
  BusOptions options;
  options.has_large_history = has_large_history;
  options.run = run;
  options.domain = domain;
  return options;
}

// Binds this process to the first processor, before it makes threads.  The process at the other end
// gets the second processor, so that no variant is faster only because the kernel has placed its
// threads well.  Returns false if this is not possible, as with only one processor.
bool UseFirstProcessor() {
  cpu_set_t first;
  CPU_ZERO(&first);
  CPU_SET(0, &first);
  return sysconf(_SC_NPROCESSORS_ONLN) > 1 && sched_setaffinity(0, sizeof first, &first) == 0;
}

// Binds this process to the first processor.  Returns the words that begin the command line of the
// process at the other end, and bind it to the second processor; none if this is not possible.
std::vector<std::string> OnTheOtherProcessor() {
  static const bool has_own = UseFirstProcessor();
  if (!has_own) return {};
  return {"taskset", "--cpu-list", "1"};
}

void WaitFor(RawChannel* channel) {
  while (!channel->IsConnected()) usleep(1000);
}

// Starts this program again, as the process at the other end (RunPeer()).
pid_t StartPeer(const std::string& kind, const std::string& name) {
  std::vector<std::string> command = OnTheOtherProcessor();
  command.insert(command.end(), {ProgramFile(), "--peer", kind, name});
  std::vector<char*> words;
  for (std::string& word : command) words.push_back(word.data());
  words.push_back(nullptr);
  pid_t pid = -1;
  if (posix_spawnp(&pid, words[0], nullptr, nullptr, words.data(), environ) != 0)
    throw std::runtime_error("the other end cannot be started");
  return pid;
}

void ReadAll(int socket, char* data, size_t size) {
  for (size_t done = 0; done < size;) {
    const ssize_t count = read(socket, data + done, size - done);
    if (count <= 0) _exit(0);  // the process at the other end has ended
    done += static_cast<size_t>(count);
  }
}

// ---- The floor (bare Cyclone DDS) and the peer (a Unix socket)

class Socket {
 public:
  Socket(size_t size, int window) : window_(window), bytes_(size, 'x') {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw std::runtime_error("socketpair");
    fcntl(ends[1], F_SETFD, 0);  // lets the process at the other end inherit this descriptor
    StartPeer("socket", fmt::format("{}:{}", ends[1], size));
    close(ends[1]);
    socket_ = ends[0];
  }
  void Run(int64_t count) {
    for (int64_t i = -window_; i < count; ++i) {
      char answer = 0;
      if (i >= 0) ReadAll(socket_, &answer, 1);
      if (i + window_ < count && write(socket_, bytes_.data(), bytes_.size()) < 0)
        throw std::runtime_error("write");
    }
  }

 private:
  const int window_;
  std::string bytes_;
  int socket_ = -1;
};

// Sends bare samples of Cyclone DDS.  If `Together` is true, several samples may share a packet, as
// the samples of a free run do.
template <bool Together>
class Raw {
 public:
  Raw(size_t size, int window)
      : window_(window),
        name_(fmt::format("bench-raw-{}-{}-{}-{}", getpid(), size, window, Together)),
        domain_(NewDomain()),
        bus_(BusOf(name_, domain_, window > 1)),
        channel_(&bus_, "peer", ChannelEnd::kMaster, kRawTopics),
        payloads_(static_cast<size_t>(window), std::string(size, 'x')) {
    StartPeer(Together ? "raw-together" : "raw", fmt::format("{}:{}", domain_, name_));
    WaitFor(&channel_);
  }
  void Run(int64_t count) {
    openr_wire_Answer sample{};
    for (int64_t i = -window_; i < count; ++i) {
      while (i >= 0 && !channel_.Receive(1000)) {
      }
      if (i + window_ >= count) continue;
      const std::string& bytes = payloads_[static_cast<size_t>(i + window_) % payloads_.size()];
      sample.bytes = WireArena::View(bytes.data(), bytes.size());
      if (Together) {
        channel_.SendBatched(sample);
      } else {
        channel_.Send(sample);
      }
    }
  }

 private:
  const int window_;
  const std::string name_;
  const int domain_;
  Bus bus_;
  RawChannel channel_;
  const std::vector<std::string> payloads_;  // bytes of each sample under way at a time
};

// ---- Notifications between objects

// An object that sends the same bytes at every ready of its observer, from Begin() on.
class Source : public CodeObject {
 public:
  // `sent` counts the notifications of all Sources together.
  Source(size_t size, int64_t* sent) : sent_(sent) {
    out_ = AddSubject("Source.Out.Bytes.S", [this](const OReadyEvent&) {
      if (begun_) Send();
    });
    region_ = new RCRegion(size);
  }
  void Begin() {
    const CurrentScope scope(&system(), &host());
    begun_ = true;
    Send();
  }

 private:
  void Send() {
    ++*sent_;
    out_->SetData(region_);
    out_->NotifyObservers();
  }

  int64_t* const sent_;
  bool begun_ = false;
  OSubject* out_;
  RCRegion* region_;
};

// Sends notifications to objects in another process.  There is a dog for each notification that may
// be under way at a time: one dog in lockstep, several dogs in a free run.
class Ours {
 public:
  Ours(size_t size, int window) : is_free_(window > 1), workers_(OptionsFor(MakeStick(), size)) {
    std::vector<Source*> sources;
    for (int i = 0; i < window; ++i) {
      const int dog = system_.AddRobot("ERS-210", std::make_shared<FolderStick>(folder_.path()));
      sources.push_back(system_.AddObject<Source>(dog, "source", size, &sent_));
      LoadStick(&system_, dog, workers_.StandInsFor(&system_, dog));
    }
    const std::string problem = workers_.Connect();
    if (!problem.empty()) throw std::runtime_error(problem);
    system_.Boot();
    for (int i = 0; i < kBootFrames; ++i) {
      system_.RunFor(kFrameUs);
      if (is_free_) workers_.Pump(kPumpUs);
    }
    for (Source* const source : sources) source->Begin();
  }
  ~Ours() { workers_.End(); }

  // Sends `count` notifications, each of which is answered by a ready.
  void Run(int64_t count) {
    if (!is_free_) return system_.RunMessages(static_cast<uint64_t>(2 * count));
    for (const int64_t end = sent_ + count; sent_ < end; workers_.Pump(kPumpUs))
      system_.RunUntil(system_.now_us());
  }

 private:
  static constexpr int kBootFrames = 100;
  static constexpr int64_t kPumpUs = 10'000;

  std::string MakeStick() {
    namespace fs = std::filesystem;
    const fs::path middleware = fs::path(folder_.path()) / "OPEN-R" / "MW";
    fs::create_directories(middleware / "CONF");
    fs::create_directories(middleware / "OBJS");
    fs::copy(OPENR_IMAGES "/SINK.BIN", middleware / "OBJS" / "SINK.BIN");
    std::ofstream(middleware / "CONF" / "OBJECT.CFG") << "/MS/OPEN-R/MW/OBJS/SINK.BIN\n";
    std::ofstream(middleware / "CONF" / "CONNECT.CFG") << "Source.Out.Bytes.S Sink.In.Bytes.O\n";
    return folder_.path();
  }
  WorkerGroupOptions OptionsFor(const std::string& stick, size_t size) const {
    WorkerGroupOptions options;
    options.is_free = is_free_;
    options.bus = BusOf(fmt::format("bench-{}-{}", getpid(), size), NewDomain());
    options.placement.process_of = {{"sink", "peer"}};
    options.stick = stick;
    options.command = OnTheOtherProcessor();
    options.command.insert(
        options.command.end(),
        {ProgramFolder() + "/openr", "join", "--run-name", options.bus.run, "--dds-domain",
         std::to_string(options.bus.domain), "--child-of", std::to_string(getpid())});
    options.say = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
    return options;
  }

  const bool is_free_;
  const TempFolder folder_;
  int64_t sent_ = 0;
  System system_{{.free_deliveries = INT64_MAX}};
  WorkerGroup workers_;
};

// Returns a variant whose T is made when its row runs first.
template <typename T>
Variant VariantOf(const char* name, size_t size, int window) {
  auto made = std::make_shared<std::unique_ptr<T>>();
  return {name, [made, size, window](int64_t count) {
            OnTheOtherProcessor();
            if (*made == nullptr) *made = std::make_unique<T>(size, window);
            (*made)->Run(count);
          }};
}

}  // namespace

int RunPeer(const std::string& kind, const std::string& name) {
  if (kind == "socket") {
    const int socket = std::stoi(name);
    std::string bytes(std::stoul(name.substr(name.find(':') + 1)), ' ');
    for (;;) {
      ReadAll(socket, bytes.data(), bytes.size());
      if (write(socket, "!", 1) < 0) return 0;
    }
  }
  Bus bus(BusOf(name.substr(name.find(':') + 1), std::stoi(name)));
  RawChannel channel(&bus, "peer", ChannelEnd::kWorker, kRawTopics);
  WaitFor(&channel);
  const openr_wire_Answer answer{};
  while (channel.IsConnected()) {
    if (!channel.Receive(1000)) continue;
    if (kind == "raw") {
      channel.Send(answer);
    } else {
      channel.SendBatched(answer);
    }
  }
  return 0;
}

std::vector<Row> DistributionRows() {
  std::vector<Row> rows;
  // Rows with one message under way at a time show the latency, those with eight the throughput.
  for (const int window : {1, 8}) {
    for (const size_t size : {size_t{100}, size_t{4096}, size_t{65536}}) {
      Row row;
      row.name = fmt::format("process to process{}, {} bytes",
                             window == 1 ? " and back" : ", 8 under way", size);
      row.unit = window == 1 ? "ns a round trip" : "ns a notification";
      row.count = 500;
      row.rounds = 41;  // many short rounds, because a disturbance then spoils only a few
      row.variants = {VariantOf<Raw<false>>("bare Cyclone DDS", size, window),
                      VariantOf<Ours>("notify and ready", size, window),
                      VariantOf<Socket>("Unix socket", size, window)};
      if (window > 1)
        row.variants.push_back(VariantOf<Raw<true>>("bare, packets shared", size, window));
      row.variants[1].limits = {{Limit::Kind::kRatioAtMost, 1.10}};
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace openr_host
