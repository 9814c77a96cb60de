// PictureRequest, a picture to take during a run: --snapshot t=5s,view=side -o a.png.  A picture
// with view=camera is what the robot's camera sees, in the size of its sensor.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "openr/render/robot_scene.h"

namespace openr_host {

class VirtualRobot;

struct PictureRequest {
  int64_t time_us = -1;  // virtual time at which the picture is taken; -1: at the end of the run
  View view = View::kIso;
  int robot = 0;
  int width_px = 1280;  // width of the picture; not used by View::kCamera
  // Height of the picture; not used by View::kCamera.
  int height_px = 720;
  std::string file;
};

// Reads a picture request from a text such as "t=5s,view=side,size=1280x720,robot=0".  Each part
// may be left out; t=end is the end of the run.  Returns "" or the error.
std::string ParsePictureRequest(std::string_view text, PictureRequest* plan);

// Draws `robot` in its present state, and writes the picture to the file of `plan`.  `company` has
// the robots in the same world, which are drawn as well; `robot` itself may be among them.  The
// first picture with another view than View::kCamera loads libopenr_render.so and the graphics
// library Mesa.  Returns "" or the error.
std::string WritePicture(const PictureRequest& plan, VirtualRobot* robot,
                         const std::vector<VirtualRobot*>& company);

}  // namespace openr_host
