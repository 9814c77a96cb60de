// Motion files, good and broken, and their play-back.
#include <string.h>

#include "ByteOrder.h"
#include "MtnFile.h"
#include "MtnPlayer.h"
#include "dump.h"

namespace {

void Put16(std::vector<Uint8>* out, Uint32 value) {
  out->push_back(static_cast<Uint8>(value & 0xff));
  out->push_back(static_cast<Uint8>((value >> 8) & 0xff));
}

void Put32(std::vector<Uint8>* out, Uint32 value) {
  Put16(out, value & 0xffff);
  Put16(out, value >> 16);
}

void PutText(std::vector<Uint8>* out, const char* text) {
  out->push_back(static_cast<Uint8>(strlen(text)));
  out->insert(out->end(), text, text + strlen(text));
}

void PutSection(std::vector<Uint8>* out, Uint32 number, std::vector<Uint8> body) {
  while (body.size() % 4 != 0) body.push_back(0);
  Put32(out, number);
  Put32(out, static_cast<Uint32>(body.size()) + 8);
  out->insert(out->end(), body.begin(), body.end());
}

void DumpFile(const MtnFile& file) {
  printf("motion %s|%s|%s|%d.%d %d key frames, %d joints, %d ms\n", file.Name().c_str(),
         file.Creator().c_str(), file.DesignLabel().c_str(), file.MajorVersion(),
         file.MinorVersion(), file.NumKeyFrames(), file.NumJoints(), file.DurationMs());
  for (int k = 0; k < file.NumKeyFrames(); k++) {
    printf("key frame %d at %d ms:", k, file.TimeMs(k));
    for (int j = 0; j < file.NumJoints(); j++) printf(" %d", file.Angle(k, j));
    printf(" body %d %d %d\n", file.Attitude(k, 0), file.Attitude(k, 1), file.Attitude(k, 2));
  }
  for (size_t w = 0; w < file.Warnings().size(); w++) {
    printf("warning %s\n", file.Warnings()[w].c_str());
  }
}

void Play(const MtnFile& file, int loops, int perVector) {
  MtnPlayer player;
  player.Start(&file, loops, perVector);
  while (player.IsPlaying()) {
    const int frames = player.FramesOfNextVector();
    printf("vector of %d:", frames);
    for (int f = 0; f < frames; f++) {
      player.NextFrame();
      for (int j = 0; j < file.NumJoints(); j++) printf(" %d", player.Position(j));
    }
    printf(" key frame %d\n", player.KeyFrame());
  }
}

// Prints the answer to a file that is cut or damaged, for every way to do so.
void DumpBroken(const std::vector<Uint8>& bytes) {
  for (size_t size = 0; size < bytes.size(); size += 3) {
    MtnFile file;
    const bool good = file.Read(&bytes[0], size);
    printf("cut %u: %d %s\n", static_cast<unsigned>(size), good ? 1 : 0, file.Error().c_str());
  }
  Draw draw(3);
  for (int i = 0; i < 600; i++) {
    std::vector<Uint8> spoiled = bytes;
    const Uint32 at = draw.Next() % static_cast<Uint32>(bytes.size());
    spoiled[at] = static_cast<Uint8>(draw.Next());
    MtnFile file;
    bool good = file.Read(&spoiled[0], spoiled.size());
    if (good) good = file.MapTo(FindRobot("ERS-210"));
    printf("spoiled %u: %d %s (%u warnings)\n", at, good ? 1 : 0, file.Error().c_str(),
           static_cast<unsigned>(file.Warnings().size()));
  }
}

}  // namespace

std::vector<Uint8> MakeMotion(int joints, int keyFrames, Draw* draw) {
  const RobotConstants* robot = FindRobot("ERS-210");
  std::vector<Uint8> header, names, locators, frames;
  Put32(&header, 4);
  Put16(&header, 1);
  Put16(&header, 2);
  Put16(&header, static_cast<Uint32>(keyFrames));
  Put16(&header, MTN_FRAME_MS);
  Put32(&header, 0);
  PutText(&names, "stand#dump");
  PutText(&names, "dump");
  PutText(&names, "DRX-900");
  Put16(&locators, static_cast<Uint32>(joints));
  for (int j = 0; j < joints; j++) PutText(&locators, robot->joints[j].locator);
  Put32(&frames, 0);
  for (int k = 0; k < keyFrames; k++) {
    if (k > 0) Put32(&frames, draw->Next() % 12);
    for (int axis = 0; axis < 3; axis++) {
      Put32(&frames, static_cast<Uint32>(draw->Between(-500000, 500000)));
    }
    for (int j = 0; j < joints; j++) {
      const JointConstants& joint = robot->joints[j];
      Put32(&frames, static_cast<Uint32>(draw->Between(joint.minUrad, joint.maxUrad + 30)));
    }
  }
  std::vector<Uint8> out;
  const char magic[] = {'O', 'M', 'T', 'N'};
  out.insert(out.end(), magic, magic + 4);
  PutSection(&out, 0, header);
  PutSection(&out, 1, names);
  PutSection(&out, 2, locators);
  PutSection(&out, 3, frames);
  return out;
}

void DumpMotions() {
  Draw draw(4);
  for (int run = 0; run < 12; run++) {
    const std::vector<Uint8> bytes = MakeMotion(1 + run, 1 + run * 2, &draw);
    MtnFile file;
    if (!file.Read(&bytes[0], bytes.size()) || !file.MapTo(FindRobot("ERS-210"))) {
      printf("refused: %s\n", file.Error().c_str());
      continue;
    }
    DumpFile(file);
    Play(file, 1 + run % 3, run);
    if (run == 3) DumpBroken(bytes);
  }
}
