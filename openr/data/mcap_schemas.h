// The JSON schemas of the messages in an MCAP file.  Names and members of those that begin with
// "foxglove." are Foxglove's, which then knows how to show them (docs.foxglove.dev, "Schemas").
#pragma once

#include <string>
#include <vector>

namespace openr_host {

extern const char kLogSchema[];    // foxglove.Log
extern const char kPosesSchema[];  // foxglove.FrameTransforms
extern const char kSceneSchema[];  // foxglove.SceneUpdate
extern const char kImageSchema[];  // foxglove.CompressedImage

// Levels of foxglove.Log.
constexpr int kLogInfo = 2, kLogWarning = 3, kLogError = 4;

// Returns the schema of a topic of values.  `keys` are the names of its members, as JSON.
std::string ValueSchema(const std::string& topic, const std::vector<std::string>& keys);

}  // namespace openr_host
