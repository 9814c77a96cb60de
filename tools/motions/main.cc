// openr_motions: writes the project's own motions as MTN files.
//
//   openr_motions DIR MODEL.json
//
// The motions are SIT (from standing to sitting), STAND (from sitting to standing), LIE (from
// standing to lying), BOW, and a walk of three files: WALKSTA begins it, WALK is a cycle that can
// be repeated, WALKEND ends it.  All motions are computed from the geometry and the postures of the
// model.
#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cli/output_file.h"
#include "postures.h"
#include "runtime/base/read_file.h"
#include "walk.h"

namespace {

using namespace openr_host::motions;
using openr_host::KeyFrame;
using openr_host::MotionFile;
using openr_host::WriteMtn;

// Writes the file unless its content would not change.
void WriteIfChanged(const std::filesystem::path& path, const std::vector<uint8_t>& bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (openr_host::ReadFile(path) == text) return;
  const std::string problem = openr_host::WriteFile(path, text);
  if (!problem.empty()) throw std::runtime_error(problem);
}

void WriteAll(const std::filesystem::path& directory, const Dog& dog, const Gait& gait) {
  const struct {
    const char* file;
    const char* name;
    std::vector<KeyFrame> frames;
  } motions[] = {
      {"SIT.MTN", "stand#sit", Sit(dog)},
      {"STAND.MTN", "sit#stand", Stand(dog)},
      {"LIE.MTN", "stand#lie", Lie(dog)},
      {"BOW.MTN", "stand#stand_bow", Bow(dog)},
      {"WALKSTA.MTN", "stand#walk", WalkStart(dog, gait)},
      {"WALK.MTN", "walk#walk", WalkCycle(dog, gait)},
      {"WALKEND.MTN", "walk#stand", WalkEnd(dog, gait)},
  };
  std::filesystem::create_directories(directory);
  for (const auto& motion : motions) {
    MotionFile file;
    file.name = motion.name;
    file.design_label = dog.design_label();
    file.locators = dog.Locators();
    file.key_frames = motion.frames;
    WriteIfChanged(directory / motion.file, WriteMtn(file));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: openr_motions DIR MODEL.json\n");
    return 2;
  }
  try {
    WriteAll(argv[1], Dog(argv[2]), Gait());
  } catch (const std::exception& error) {
    fmt::print(stderr, "openr_motions: {}\n", error.what());
    return 1;
  }
  return 0;
}
