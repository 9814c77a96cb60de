// The messages of an MCAP file that show robots and things in three dimensions.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/worlds/world.h"

namespace openr_host {

// Returns the JSON member "timestamp" of a message, such as "timestamp":{"sec":1,"nsec":8000000}.
std::string TimestampText(int64_t time_us);

// Appends a transform of foxglove.FrameTransforms to `text`: the pose of the coordinate frame
// `child` in the world.
void AppendTransform(int64_t time_us, const std::string& child, const Eigen::Isometry3d& pose,
                     std::string* text);

// Returns the message foxglove.SceneUpdate with the shapes of a robot.  Each part of the robot is a
// coordinate frame with the name "SPACE/NAME".
std::string RobotSceneMessage(const RobotModel& model, const std::string& space);
// Returns the message foxglove.SceneUpdate with the shapes of a world.  Each thing that can move is
// a coordinate frame with the name "thing/NAME".
std::string WorldScene(const World& world);

}  // namespace openr_host
