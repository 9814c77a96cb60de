#include "JointTable.h"

const JointName JOINTS[NUM_JOINTS] = {
    {"neck tilt", "PRM:/r1/c1-Joint2:j1"},
    {"neck pan", "PRM:/r1/c1/c2-Joint2:j2"},
    {"neck roll", "PRM:/r1/c1/c2/c3-Joint2:j3"},
    {"mouth", "PRM:/r1/c1/c2/c3/c4-Joint2:j4"},
    {"left fore 1", "PRM:/r2/c1-Joint2:j1"},
    {"left fore 2", "PRM:/r2/c1/c2-Joint2:j2"},
    {"left fore 3", "PRM:/r2/c1/c2/c3-Joint2:j3"},
    {"left hind 1", "PRM:/r3/c1-Joint2:j1"},
    {"left hind 2", "PRM:/r3/c1/c2-Joint2:j2"},
    {"left hind 3", "PRM:/r3/c1/c2/c3-Joint2:j3"},
    {"right fore 1", "PRM:/r4/c1-Joint2:j1"},
    {"right fore 2", "PRM:/r4/c1/c2-Joint2:j2"},
    {"right fore 3", "PRM:/r4/c1/c2/c3-Joint2:j3"},
    {"right hind 1", "PRM:/r5/c1-Joint2:j1"},
    {"right hind 2", "PRM:/r5/c1/c2-Joint2:j2"},
    {"right hind 3", "PRM:/r5/c1/c2/c3-Joint2:j3"},
    {"tail pan", "PRM:/r6/c1-Joint2:j1"},
    {"tail tilt", "PRM:/r6/c2-Joint2:j2"}
};
