#include "openr/model/urdf.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace openr_host {
namespace {

using Eigen::Vector3d;

std::string Triple(const Vector3d& v) { return fmt::format("{} {} {}", v.x(), v.y(), v.z()); }

// Returns the origin of the link of the part number `part`, in the base frame B, when all angles
// are 0.
Vector3d OriginOf(const RobotModel& model, int part) {
  const int joint = model.bodies[part].joint;
  return joint < 0 ? Vector3d(0, 0, 0) : model.joints[joint].anchor_m;
}

// Adds a shape to a link of the URDF text twice: as its look (visual) and as its shape for contacts
// (collision).
void AddShape(const Vector3d& place_m, const std::string& geometry, std::string* out) {
  for (const char* const use : {"visual", "collision"}) {
    fmt::format_to(std::back_inserter(*out),
                   "    <{0}>\n"
                   "      <origin xyz=\"{1}\" rpy=\"0 0 0\"/>\n"
                   "      <geometry><{2}/></geometry>\n"
                   "    </{0}>\n",
                   use, Triple(place_m), geometry);
  }
}

void AddLink(const RobotModel& model, int part, std::string* out) {
  const BodyPart& body = model.bodies[part];
  const Vector3d origin_m = OriginOf(model, part);
  fmt::format_to(std::back_inserter(*out), "  <link name=\"{}\">\n", body.name);
  if (body.has_box) {
    const Vector3d squares = body.size_m.cwiseProduct(body.size_m);
    const double twelfth_kg = body.mass_kg / 12;
    fmt::format_to(
        std::back_inserter(*out),
        "    <inertial>\n"
        "      <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n"
        "      <mass value=\"{}\"/>\n"
        "      <inertia ixx=\"{}\" ixy=\"0\" ixz=\"0\" iyy=\"{}\" iyz=\"0\" izz=\"{}\"/>\n"
        "    </inertial>\n",
        Triple(body.centre_m - origin_m), body.mass_kg, twelfth_kg * (squares.y() + squares.z()),
        twelfth_kg * (squares.x() + squares.z()), twelfth_kg * (squares.x() + squares.y()));
    AddShape(body.centre_m - origin_m, fmt::format("box size=\"{}\"", Triple(body.size_m)), out);
  }
  for (const Paw& paw : model.paws) {
    if (paw.body == part)
      AddShape(paw.centre_m - origin_m, fmt::format("sphere radius=\"{}\"", paw.radius_m), out);
  }
  *out += "  </link>\n";
}

void AddJoint(const RobotModel& model, const JointModel& joint, std::string* out) {
  fmt::format_to(std::back_inserter(*out),
                 "  <joint name=\"{}\" type=\"revolute\">\n"
                 "    <parent link=\"{}\"/>\n"
                 "    <child link=\"{}\"/>\n"
                 "    <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n"
                 "    <axis xyz=\"{}\"/>\n"
                 "    <limit lower=\"{}\" upper=\"{}\" effort=\"{}\" velocity=\"{}\"/>\n"
                 "  </joint>\n",
                 joint.name, model.bodies[joint.parent].name, model.bodies[joint.child].name,
                 Triple(joint.anchor_m - OriginOf(model, joint.parent)), Triple(joint.axis),
                 joint.hard_rad.min, joint.hard_rad.max, joint.stall_torque_nm,
                 joint.speed_rad_s.max);
}

// Adds to the URDF text a coordinate frame, a link without mass that is fixed to the part `parent`.
void AddFrame(const std::string& parent, const std::string& name, const std::string& place,
              std::string* out) {
  fmt::format_to(std::back_inserter(*out),
                 "  <link name=\"{1}\"/>\n"
                 "  <joint name=\"{1}_joint\" type=\"fixed\">\n"
                 "    <parent link=\"{0}\"/>\n"
                 "    <child link=\"{1}\"/>\n"
                 "    <origin {2}/>\n"
                 "  </joint>\n",
                 parent, name, place);
}

// Adds to the URDF text the coordinate frame of the camera's pictures: z along the view, x to the
// right, y down.
void AddCameraFrame(const RobotModel& model, const Camera& camera, std::string* out) {
  const Vector3d z = camera.direction.normalized();
  const Vector3d x = z.cross(Vector3d::UnitZ()).normalized();
  const Vector3d y = z.cross(x);
  // Converts the attitude of the frame, a matrix with the columns `x`, `y` and `z`, to roll, pitch
  // and yaw.  URDF gives an attitude as these three turns about the fixed axes of the part.
  const double roll = std::atan2(y.z(), z.z());
  const double pitch = std::atan2(-x.z(), std::hypot(y.z(), z.z()));
  const double yaw = std::atan2(x.y(), x.x());
  AddFrame(model.bodies[camera.body].name, "camera_optical",
           fmt::format("xyz=\"{}\" rpy=\"{} {} {}\"",
                       Triple(camera.place_m - OriginOf(model, camera.body)), roll, pitch, yaw),
           out);
}

}  // namespace

std::string Urdf(const RobotModel& model) {
  std::string out = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<robot name=\"{}\">\n"
      "  <link name=\"base_link\"/>\n"
      "  <joint name=\"base_link_joint\" type=\"fixed\">\n"
      "    <parent link=\"base_link\"/>\n"
      "    <child link=\"{}\"/>\n"
      "  </joint>\n",
      model.name, model.bodies[0].name);
  for (size_t i = 0; i < model.bodies.size(); ++i) AddLink(model, static_cast<int>(i), &out);
  for (const JointModel& joint : model.joints) AddJoint(model, joint, &out);
  AddCameraFrame(model, model.camera, &out);
  return out + "</robot>\n";
}

}  // namespace openr_host
