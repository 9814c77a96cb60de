// RenderedWorld: draws what a camera sees of its robot's world.  The brightness of a surface
// depends only on the angle between the surface and the light.  Nothing throws a shadow.
#pragma once

#include <string>
#include <vector>

#include "virtualrobot/camera/canvas.h"
#include "virtualrobot/camera/image_source.h"
#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/worlds/world.h"

namespace openr_host {

// Draws the floor, its paint, the things of Body::Surroundings(), and the robot's own parts except
// its head and mouth.
class RenderedWorld : public ImageSource {
 public:
  // `model` is the robot that carries the camera, and must outlive this object.
  explicit RenderedWorld(const RobotModel& model);

  // Draws the picture that the camera takes with `shot`.  REQUIRES: shot.body is not null.
  std::string Capture(const CameraShot& shot, Picture* picture) override;

 private:
  const RobotModel& model_;
  std::vector<bool> is_head_;  // for each part, whether it moves with the camera and is not drawn
  Canvas canvas_;
};

// Draws the floor of `world`, and `things` in their present places, into `picture`, in the light of
// `world`.
void DrawWorld(const CameraShot& shot, const World& world, const std::vector<WorldThing>& things,
               Canvas* canvas, Picture* picture);

}  // namespace openr_host
