// Slow motions between postures, and a bow.
//
// The body moves from one stance to the next, and inverse kinematics keeps the paws on the floor.
// The joints move in straight lines between key frames, so the key frames are so close together
// that the paws stay on the floor between them, too.
#pragma once

#include <vector>

#include "dog.h"

namespace openr_host::motions {

// Motions from the posture "stand" to "sit", from "sit" to "stand", and from "stand" to "sleep".
std::vector<KeyFrame> Sit(const Dog& dog);
std::vector<KeyFrame> Stand(const Dog& dog);
std::vector<KeyFrame> Lie(const Dog& dog);

// A motion from "stand": the dog lowers its front, nods and rises again.
std::vector<KeyFrame> Bow(const Dog& dog);

}  // namespace openr_host::motions
