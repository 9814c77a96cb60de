#include "openr/data/mcap_schemas.h"

#include <fmt/format.h>

#define OPENR_TIME                                                                                \
  R"("timestamp":{"type":"object","title":"time","properties":{"sec":{"type":"integer"},"nsec":)" \
  R"({"type":"integer"}}})"
#define OPENR_NUMBER R"({"type":"number"})"
#define OPENR_VECTOR                                                                           \
  R"({"type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":)" \
  R"("number"}}})"
#define OPENR_QUATERNION                                                                       \
  R"({"type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":)" \
  R"("number"},"w":{"type":"number"}}})"
#define OPENR_POSE                                                    \
  R"("pose":{"type":"object","properties":{"position":)" OPENR_VECTOR \
  R"(,"orientation":)" OPENR_QUATERNION R"(}})"
#define OPENR_COLOUR                                                                           \
  R"("color":{"type":"object","properties":{"r":{"type":"number"},"g":{"type":"number"},"b":)" \
  R"({"type":"number"},"a":{"type":"number"}}})"

namespace openr_host {

const char kLogSchema[] =
    R"({"title":"foxglove.Log","type":"object","properties":{)" OPENR_TIME
    R"(,"level":{"type":"integer"},"message":{"type":"string"},"name":{"type":"string"},)"
    R"("file":{"type":"string"},"line":{"type":"integer"}}})";

const char kPosesSchema[] =
    R"({"title":"foxglove.FrameTransforms","type":"object","properties":{"transforms":{)"
    R"("type":"array","items":{"title":"foxglove.FrameTransform","type":"object",)"
    R"("properties":{)" OPENR_TIME
    R"(,"parent_frame_id":{"type":"string"},"child_frame_id":{"type":"string"},"translation":)" OPENR_VECTOR
    R"(,"rotation":)" OPENR_QUATERNION R"(}}}}})";

const char kSceneSchema[] =
    R"({"title":"foxglove.SceneUpdate","type":"object","properties":{"deletions":{"type":"array",)"
    R"("items":{"type":"object"}},"entities":{"type":"array","items":{)"
    R"("title":"foxglove.SceneEntity","type":"object","properties":{)" OPENR_TIME
    R"(,"frame_id":{"type":"string"},"id":{"type":"string"},"lifetime":{"type":"object",)"
    R"("title":"duration","properties":{"sec":{"type":"integer"},"nsec":{"type":"integer"}}},)"
    R"("frame_locked":{"type":"boolean"},)"
    R"("cubes":{"type":"array","items":{"type":"object","properties":{)" OPENR_POSE
    R"(,"size":)" OPENR_VECTOR "," OPENR_COLOUR
    R"(}}},"spheres":{"type":"array","items":{"type":"object","properties":{)" OPENR_POSE
    R"(,"size":)" OPENR_VECTOR "," OPENR_COLOUR
    R"(}}},"cylinders":{"type":"array","items":{"type":"object","properties":{)" OPENR_POSE
    R"(,"size":)" OPENR_VECTOR R"(,"bottom_scale":)" OPENR_NUMBER R"(,"top_scale":)" OPENR_NUMBER
    "," OPENR_COLOUR
    R"(}}},"triangles":{"type":"array","items":{"type":"object","properties":{)" OPENR_POSE
    R"(,"points":{"type":"array","items":)" OPENR_VECTOR "}," OPENR_COLOUR
    R"(,"colors":{"type":"array","items":{"type":"object"}},"indices":{"type":"array","items":)"
    R"({"type":"integer"}}}}}}}}}})";

const char kImageSchema[] =
    R"({"title":"foxglove.CompressedImage","type":"object","properties":{)" OPENR_TIME
    R"(,"frame_id":{"type":"string"},"data":{"type":"string","contentEncoding":"base64"},)"
    R"("format":{"type":"string"}}})";

std::string ValueSchema(const std::string& topic, const std::vector<std::string>& keys) {
  std::string text =
      fmt::format(R"({{"title":"openr.{}","type":"object","properties":{{{})", topic, OPENR_TIME);
  for (const std::string& key : keys) text += "," + key + ":" OPENR_NUMBER;
  return text + "}}";
}

}  // namespace openr_host
