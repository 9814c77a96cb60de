// Slow motions between postures, and a bow.
//
// The body goes from one stance to the next while inverse kinematics keeps the paws on the
// floor; key frames lie close enough that the straight lines between them do, too.
#pragma once

#include <vector>

#include "dog.h"

namespace openr_host::motions {

// From the posture "stand" to "sit", and back; from "stand" to "sleep".
std::vector<KeyFrame> Sit(const Dog& dog);
std::vector<KeyFrame> Stand(const Dog& dog);
std::vector<KeyFrame> Lie(const Dog& dog);

// From "stand" down in front, a nod, and up again.
std::vector<KeyFrame> Bow(const Dog& dog);

}  // namespace openr_host::motions
