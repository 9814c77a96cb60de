// The JSON schemas of the messages in an MCAP file.  Schemas whose names begin with "foxglove." are
// defined by Foxglove (docs.foxglove.dev, "Schemas"), so Foxglove can show their messages.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

extern const char kLogSchema[];    // schema of foxglove.Log
extern const char kPosesSchema[];  // schema of foxglove.FrameTransforms
extern const char kSceneSchema[];  // schema of foxglove.SceneUpdate
extern const char kImageSchema[];  // schema of foxglove.CompressedImage

// Numbers for the severity of a message of the type foxglove.Log.
constexpr int kLogInfo = 2, kLogWarning = 3, kLogError = 4;

// Returns the schema (JSON Schema, as text) of a topic of an MCAP file.  Each message of the topic
// has a number for each of `keys`, which are names as JSON strings, with quotes.
std::string ValueSchema(const std::string& topic, const std::vector<std::string>& keys);

}  // namespace openr_host
