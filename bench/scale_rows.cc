// Rows that show what a run costs besides its frames: recording, camera, start of the process, more
// dogs.
#include <OPENR/OObserver.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "cli/install_paths.h"
#include "openr/inspect/recorder.h"
#include "openr/simulation/simulation.h"
#include "runtime/base/temp_folder.h"
#include "runtime/core/code_object.h"
#include "runtime/core/system.h"

extern char** environ;

namespace openr_host {
namespace {

// An object that receives every image of the camera.
class ImageTaker : public CodeObject {
 public:
  ImageTaker() {
    in_ = AddObserver("ImageTaker.Image.OFbkImageVectorData.O",
                      [this](const ONotifyEvent&) { in_->AssertReady(); });
  }
  void Begin() {
    const CurrentScope scope(&system(), &host());
    in_->AssertReady();
  }

 private:
  OObserver* in_;
};

SimulationOptions OfDogs(const std::string& stick, const std::string& body, int robots) {
  SimulationOptions options;
  options.stick = stick;
  options.body = body;
  options.robots = robots;
  options.writable_stick = false;
  options.host_network = false;
  options.console = [](std::string_view) {};
  return options;
}

// Returns the options of a run with eight dogs in one world, which is the field with its ball.
SimulationOptions OnTheField(const std::string& stick) {
  SimulationOptions options = OfDogs(stick, "ode", 8);
  options.world = "field-2004.json";
  options.together = true;
  return options;
}

// Runs until the dogs have stood up.
void StandUp(System* system) {
  system->Boot();
  const Object* const mover = system->FindObject(system->robot_count() - 1, "JointMover");
  if (mover == nullptr ||
      !system->RunUntil([&] { return mover->state == "accepting-commands"; }, 20'000'000))
    throw std::runtime_error("bench: the dogs do not stand up");
  system->RunFor(1'000'000);
}

// A standing dog whose run is recorded.
class Recorded {
 public:
  explicit Recorded(const std::string& stick) : recorder_(folder_.path() + "/run.trace", true) {
    SimulationOptions options = OfDogs(stick, "ode", 1);
    recorder_.RecordNetworks(&options);
    simulation_ = std::make_unique<Simulation>(options);
    recorder_.Begin(simulation_.get(), options, stick);
    StandUp(&simulation_->system());
  }
  ~Recorded() { recorder_.Finish(&simulation_->system()); }
  void Run(int64_t frames) { simulation_->system().RunFor(frames * kFrameUs); }

 private:
  const TempFolder folder_;
  Recorder recorder_;
  std::unique_ptr<Simulation> simulation_;
};

// Standing dogs; with `has_camera`, an object receives every image of the first dog's camera.
class Dogs {
 public:
  explicit Dogs(const SimulationOptions& options, bool has_camera = false) : simulation_(options) {
    System& system = simulation_.system();
    ImageTaker* taker = nullptr;
    if (has_camera) {
      taker = system.AddObject<ImageTaker>(0, "ImageTaker");
      system.Connect({0, "OVirtualRobotComm.FbkImageSensor.OFbkImageVectorData.S",
                      "ImageTaker.Image.OFbkImageVectorData.O", "bench"});
    }
    StandUp(&system);
    if (taker != nullptr) taker->Begin();
  }
  void Run(int64_t frames) { simulation_.system().RunFor(frames * kFrameUs); }

 private:
  Simulation simulation_;
};

// Returns a variant whose T is made when its row runs first, and kept until the bench ends.
template <typename T, typename Make>
Variant Lazily(const std::string& name, Make make) {
  auto made = std::make_shared<std::unique_ptr<T>>();
  return {name, [made, make](int64_t count) {
            if (*made == nullptr) *made = make();
            (*made)->Run(count);
          }};
}

// Starts the program openr `count` times, each time for a run of one frame.
void StartProgram(const std::string& stick, int64_t count) {
  for (; count > 0; --count) {
    std::vector<std::string> words = {ProgramFolder() + "/openr",
                                      "run",
                                      "--stick",
                                      stick,
                                      "--for",
                                      "8ms",
                                      "--rate",
                                      "max",
                                      "--no-panel",
                                      "--body",
                                      "ideal",
                                      "--rc-port",
                                      "0"};
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", 1, 0);
    pid_t child = -1;
    if (posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ) != 0)
      throw std::runtime_error("bench: openr cannot be started");
    posix_spawn_file_actions_destroy(&actions);
    int status = -1;
    waitpid(child, &status, 0);
    if (status != 0) throw std::runtime_error("bench: openr run has failed");
  }
}

// Returns the memory of this process in kB, including the pages of files that it has read.
long ResidentKb() {
  std::ifstream file("/proc/self/smaps_rollup");
  std::string line;
  long kb = 0;
  while (std::getline(file, line)) {
    long part = 0;
    if (std::sscanf(line.c_str(), "Rss: %ld kB", &part) == 1) kb += part;
  }
  return kb;
}

}  // namespace

std::vector<Row> ScaleRows(const std::string& stick) {
  const auto dogs = [stick](const std::string& body, int robots, bool has_camera = false) {
    return Lazily<Dogs>(fmt::format("{} dog{}", robots, robots == 1 ? "" : "s"), [=] {
      return std::make_unique<Dogs>(OfDogs(stick, body, robots), has_camera);
    });
  };
  Row recording{"recording; a frame of the full graph", "ns a frame", 250, {}, 1.08};
  recording.variants = {dogs("ode", 1), Lazily<Recorded>("recorded", [stick] {
                          return std::make_unique<Recorded>(stick);
                        })};
  recording.variants[0].name = "not recorded";

  Row camera{"camera; a frame on the ideal body", "ns a frame", 500, {}, 0};
  camera.variants = {dogs("ideal", 1), dogs("ideal", 1, true)};
  camera.variants[0].name = "no object takes images";
  camera.variants[1].name = "one takes 25 images a second";

  Row start{"process start to all objects started, and its end", "ns a start", 1, {}, 0};
  start.variants = {{"openr run --for 8ms", [stick](int64_t n) { StartProgram(stick, n); }}};
  start.rounds = 15;

  std::vector<Row> rows = {recording, camera, start};
  for (const char* const body : {"ideal", "ode"}) {
    Row row{fmt::format("dogs on the {} body; a frame of all", body), "ns a frame", 25, {}, 0};
    row.variants = {dogs(body, 1), dogs(body, 10), dogs(body, 100)};
    row.rounds = 5;
    rows.push_back(std::move(row));
  }
  Row field{"8 dogs; a frame of all", "ns a frame", 25, {}, 0};
  field.variants = {dogs("ode", 8), Lazily<Dogs>("together on the field", [stick] {
                      return std::make_unique<Dogs>(OnTheField(stick));
                    })};
  field.variants[0].name = "each in a world of its own";
  rows.push_back(std::move(field));
  return rows;
}

void PrintMemoryOfDogs(const std::string& stick, const std::string& filter) {
  const std::string name = "memory a dog";
  if (name.find(filter) == std::string::npos) return;
  for (const char* const body : {"ideal", "ode"}) {
    long one_kb = 0;
    for (const int robots : {1, 10, 100}) {
      int ends[2];
      if (pipe(ends) != 0) throw std::runtime_error("bench: no pipe");
      std::fflush(nullptr);
      if (fork() == 0) {  // measures in a fork, so that each number of dogs begins alike
        Dogs dogs(OfDogs(stick, body, robots));
        const long kb = ResidentKb();
        _exit(write(ends[1], &kb, sizeof kb) == sizeof kb ? 0 : 1);
      }
      long kb = 0;
      close(ends[1]);
      const bool is_read = read(ends[0], &kb, sizeof kb) == sizeof kb;
      close(ends[0]);
      wait(nullptr);
      if (!is_read) throw std::runtime_error("bench: the dogs have not run");
      if (robots == 1) one_kb = kb;
      std::printf("%-46s %-28s %9ld kB", robots == 1 ? name.c_str() : "",
                  fmt::format("{} body, {}", body, robots).c_str(), kb);
      if (robots > 1) std::printf("; a further dog %ld kB", (kb - one_kb) / (robots - 1));
      std::printf("\n");
    }
  }
}

}  // namespace openr_host
