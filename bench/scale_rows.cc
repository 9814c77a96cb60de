// Rows that show what a run costs besides its frames, and how the costs grow with the number of
// dogs: recording, images of the camera, more dogs, and their memory.
#include <OPENR/OObserver.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/dogs.h"
#include "openr/inspect/recorder.h"
#include "runtime/base/temp_folder.h"
#include "runtime/core/code_object.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// An object that is connected to a camera.  Either it receives every image, or it deasserts ready,
// so that the camera takes no images.
class ImageTaker : public CodeObject {
 public:
  ImageTaker() {
    in_ = AddObserver("ImageTaker.Image.OFbkImageVectorData.O", [this](const ONotifyEvent&) {
      if (takes_) in_->AssertReady();
    });
  }
  void SetTaking(bool takes) {
    const CurrentScope scope(&system(), &host());
    takes_ = takes;
    if (takes) {
      in_->AssertReady();
    } else {
      in_->DeassertReady();
    }
  }

 private:
  OObserver* in_;
  bool takes_ = true;
};

constexpr int kFieldDogs = 8;

// Returns the options of a run with eight dogs in one world, which is the field with its ball.
SimulationOptions OnTheField(const std::string& stick) {
  SimulationOptions options = OfDogs(stick, "ode", kFieldDogs);
  options.world = "field-2004.json";
  options.together = true;
  return options;
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

// Uses of the images of a dog's camera.
enum class Images { kNotConnected, kRefused, kTaken };

// A standing dog on the ideal body.  Unless `images` is kNotConnected, an ImageTaker is connected
// to its camera.
class CameraDog {
 public:
  CameraDog(const std::string& stick, Images images) : simulation_(OfDogs(stick, "ideal", 1)) {
    System& system = simulation_.system();
    ImageTaker* taker = nullptr;
    if (images != Images::kNotConnected) {
      taker = system.AddObject<ImageTaker>(0, "ImageTaker");
      system.Connect({0, "OVirtualRobotComm.FbkImageSensor.OFbkImageVectorData.S",
                      "ImageTaker.Image.OFbkImageVectorData.O", "bench"});
    }
    StandUp(&system);
    if (taker != nullptr) taker->SetTaking(images == Images::kTaken);
  }
  void Run(int64_t frames) { simulation_.system().RunFor(frames * kFrameUs); }

 private:
  Simulation simulation_;
};

// Counts the operations of a T in frames of a single dog, instead of frames of all its dogs.
template <typename T>
class PerDog {
 public:
  PerDog(std::unique_ptr<T> dogs, int count) : dogs_(std::move(dogs)), count_(count) {}
  // REQUIRES: `frames` is a multiple of the number of dogs.
  void Run(int64_t frames) { dogs_->Run(frames / count_); }

 private:
  const std::unique_ptr<T> dogs_;
  const int count_;
};

// Returns a variant that runs `dogs` dogs and counts the frames of each.
Variant DogsOf(const std::string& name, const std::string& stick, const std::string& body,
               int dogs) {
  return Lazily<PerDog<Dogs>>(name, [=] {
    return std::make_unique<PerDog<Dogs>>(std::make_unique<Dogs>(OfDogs(stick, body, dogs)), dogs);
  });
}

// Returns a variant that runs T, which is BareBodies or OdeWorlds, for `dogs` dogs, and counts the
// frames of each.
template <typename T>
Variant BareOf(const std::string& name, const std::string& stick, int dogs) {
  return Lazily<PerDog<T>>(
      name, [=] { return std::make_unique<PerDog<T>>(std::make_unique<T>(stick, dogs), dogs); });
}

std::string NumberOfDogs(int dogs) { return fmt::format("{} dog{}", dogs, dogs == 1 ? "" : "s"); }

Row RecordingRow(const std::string& stick) {
  Row row{"recording; a frame of the full graph", "ns a frame", 250};
  row.warm_up = 25;
  row.variants = {
      DogsOf("not recorded", stick, "ode", 1),
      Lazily<Recorded>("recorded", [stick] { return std::make_unique<Recorded>(stick); },
                       {{Limit::Kind::kRatioAtMost, 1.08}})};
  return row;
}

Row CameraRow(const std::string& stick) {
  const auto dog = [stick](const char* name, Images images) {
    return Lazily<CameraDog>(name, [=] { return std::make_unique<CameraDog>(stick, images); });
  };
  Row row{"camera; a frame on the ideal body", "ns a frame", 2500};
  row.warm_up = 25;
  row.variants = {dog("not connected", Images::kNotConnected),
                  dog("connected, none wanted", Images::kRefused),
                  dog("25 images a second taken", Images::kTaken)};
  return row;
}

// Returns a row that compares `dogs` dogs with as many bodies.  An operation is a frame of one dog.
Row PhysicsRow(const std::string& stick, int dogs) {
  constexpr int64_t kFrames = 250;
  Row row{NumberOfDogs(dogs) + " on physics; a frame of a dog", "ns a frame of a dog"};
  row.count = kFrames * std::max(dogs, 10);  // so that a round of one dog is not too short
  row.warm_up = row.count / 10;
  row.rounds = 5;
  row.variants = {BareOf<OdeWorlds>("worlds of bare ODE", stick, dogs),
                  BareOf<BareBodies>("bare bodies", stick, dogs),
                  DogsOf("full graphs", stick, "ode", dogs)};
  return row;
}

// Returns a row that compares several dogs on the ideal body with one.
Row IdealRow(const std::string& stick) {
  Row row{"dogs on the ideal body; a frame of a dog", "ns a frame of a dog", 25'000};
  row.warm_up = row.count / 10;
  row.rounds = 5;
  for (const int dogs : {1, 10, 100})
    row.variants.push_back(DogsOf(NumberOfDogs(dogs), stick, "ideal", dogs));
  return row;
}

Row FieldRow(const std::string& stick) {
  Row row{"8 dogs; a frame of a dog", "ns a frame of a dog", 250 * kFieldDogs};
  row.warm_up = row.count / 10;
  row.rounds = 5;
  row.variants = {DogsOf("each in a world of its own", stick, "ode", kFieldDogs),
                  Lazily<PerDog<Dogs>>("together on the field", [stick] {
                    return std::make_unique<PerDog<Dogs>>(std::make_unique<Dogs>(OnTheField(stick)),
                                                          kFieldDogs);
                  })};
  return row;
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

// Returns the memory in kB of a process with `dogs` dogs.  Measures in a fork, so that each number
// of dogs begins alike.
long MemoryOf(const std::string& stick, const std::string& body, int dogs) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("bench: no pipe");
  std::fflush(nullptr);
  if (fork() == 0) {
    const Dogs made(OfDogs(stick, body, dogs));
    const long kb = ResidentKb();
    _exit(write(ends[1], &kb, sizeof kb) == sizeof kb ? 0 : 1);
  }
  long kb = 0;
  close(ends[1]);
  const bool is_read = read(ends[0], &kb, sizeof kb) == sizeof kb;
  close(ends[0]);
  wait(nullptr);
  if (!is_read) throw std::runtime_error("bench: the dogs have not run");
  return kb;
}

void Print(const DogMemory& memory, const std::string& name) {
  fmt::print("{:<46} {:<28} {:>7} kB", memory.dogs == 1 ? name : "",
             fmt::format("{} body, {}", memory.body, NumberOfDogs(memory.dogs)), memory.kb);
  if (memory.dogs > 1) {
    fmt::print("; a further dog {:.0f} kB, limit {:.0f} kB {}", memory.further_kb, kDogMemoryMax_kb,
               memory.further_kb <= kDogMemoryMax_kb ? "met" : "missed");
  }
  fmt::print("\n");
}

}  // namespace

std::vector<Row> ScaleRows(const std::string& stick) {
  std::vector<Row> rows = {RecordingRow(stick), CameraRow(stick), IdealRow(stick)};
  for (const int dogs : {1, 10, 100}) rows.push_back(PhysicsRow(stick, dogs));
  rows.back().note =
      "dogs grow as bare ODE does if the ratio of the full graphs is that of the row of 1 dog";
  rows.push_back(FieldRow(stick));
  return rows;
}

std::vector<DogMemory> MeasureMemoryOfDogs(const std::string& stick, const std::string& filter) {
  const std::string name = "memory a dog";
  std::vector<DogMemory> all;
  if (name.find(filter) == std::string::npos) return all;
  for (const char* const body : {"ideal", "ode"}) {
    int64_t one_kb = 0;
    for (const int dogs : {1, 10, 100}) {
      DogMemory memory{body, dogs, MemoryOf(stick, body, dogs)};
      if (dogs == 1) one_kb = memory.kb;
      if (dogs > 1) memory.further_kb = static_cast<double>(memory.kb - one_kb) / (dogs - 1);
      Print(memory, name);
      all.push_back(memory);
    }
  }
  return all;
}

}  // namespace openr_host
