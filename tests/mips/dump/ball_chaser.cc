// The dump prints what the dog of examples/BallChaser does: angles of its joints, and decisions.
#include "Eyes.h"
#include "Motion.h"
#include "Player.h"
#include "dump.h"

static void DumpGait() {
  Motion motion;
  double angles[NUM_JOINTS] = {0};
  motion.Begin(angles);
  Draw draw(31);
  for (int frame = 0; frame < 3000; frame++) {
    if (frame % 60 == 0) {
      WalkCommand command;
      command.forward = draw.Between(-250, 250);
      command.left = draw.Between(-120, 120);
      command.turn = draw.Between(-2000, 2000) / 1000.0;
      command.headPan = draw.Between(-1500, 1500) / 1000.0;
      command.headTilt = draw.Between(-1200, 500) / 1000.0;
      motion.SetCommand(command);
    }
    if (frame % 4 == 0) motion.Feel(0.5, frame % 1500 < 750 ? 3 : -3, frame > 2500 ? 2 : -9.8);
    motion.Step(angles);
    if (frame % 20 != 0) continue;
    for (int j = 0; j < NUM_JOINTS; j++) printf("ball chaser joint %d %.17g\n", j, angles[j]);
  }
}

static void DumpPlay() {
  static Eyes eyes;
  static byte pixels[88 * 72];
  Player player;
  Draw draw(32);
  for (int picture = 0; picture < 1000; picture++) {
    const int x = 40 + picture % 30;
    const int y = 38 + picture / 40;
    for (int i = 0; i < 88 * 72; i++) pixels[i] = 0;
    if (picture % 300 < 200)
      pixels[y * 88 + x] = pixels[y * 88 + x + 1] = pixels[y * 88 + x + 2] = 1;
    if (picture % 70 < 50)
      for (int i = 0; i < 20; i++) pixels[20 * 88 + x - 20 + i] = picture % 500 < 300 ? 2 : 8;
    const double tilt = draw.Between(-1000, 200) / 1000.0;
    player.See(eyes.See(pixels, 88, 72, tilt, player.Command().headPan));
    const WalkCommand& command = player.Command();
    printf("ball chaser play %d %.17g %.17g %.17g %.17g %.17g\n", player.GetState(),
           command.forward, command.left, command.turn, command.headPan, command.headTilt);
  }
}

void DumpBallChaser() {
  DumpGait();
  DumpPlay();
}
