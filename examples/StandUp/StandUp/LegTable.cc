#include "LegTable.h"

const LegJoint LEG_JOINTS[NUM_LEG_JOINTS] = {
    {"PRM:/r2/c1-Joint2:j1", {0x16, 0x04, 0x08}},
    {"PRM:/r2/c1/c2-Joint2:j2", {0x14, 0x04, 0x06}},
    {"PRM:/r2/c1/c2/c3-Joint2:j3", {0x23, 0x04, 0x05}},
    {"PRM:/r3/c1-Joint2:j1", {0x16, 0x04, 0x08}},
    {"PRM:/r3/c1/c2-Joint2:j2", {0x14, 0x04, 0x06}},
    {"PRM:/r3/c1/c2/c3-Joint2:j3", {0x23, 0x04, 0x05}},
    {"PRM:/r4/c1-Joint2:j1", {0x16, 0x04, 0x08}},
    {"PRM:/r4/c1/c2-Joint2:j2", {0x14, 0x04, 0x06}},
    {"PRM:/r4/c1/c2/c3-Joint2:j3", {0x23, 0x04, 0x05}},
    {"PRM:/r5/c1-Joint2:j1", {0x16, 0x04, 0x08}},
    {"PRM:/r5/c1/c2-Joint2:j2", {0x14, 0x04, 0x06}},
    {"PRM:/r5/c1/c2/c3-Joint2:j3", {0x23, 0x04, 0x05}}
};

const Posture POSTURES[NUM_POSTURES] = {
    {"stand", {-10, 0, 30, 0, 0, 25, -10, 0, 30, 0, 0, 25}, 24},
    {"crouch", {-35, 0, 80, -25, 0, 75, -35, 0, 80, -25, 0, 75}, 12},
    {"stand", {-10, 0, 30, 0, 0, 25, -10, 0, 30, 0, 0, 25}, 12}
};
