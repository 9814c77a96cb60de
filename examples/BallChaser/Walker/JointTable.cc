#include "JointTable.h"

const Joint JOINTS[NUM_JOINTS] = {{"PRM:/r2/c1-Joint2:j1", {0x16, 0x04, 0x08}},
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
                                  {"PRM:/r5/c1/c2/c3-Joint2:j3", {0x23, 0x04, 0x05}},
                                  {"PRM:/r1/c1-Joint2:j1", {0x0a, 0x08, 0x0c}},
                                  {"PRM:/r1/c1/c2-Joint2:j2", {0x0d, 0x08, 0x0b}},
                                  {"PRM:/r1/c1/c2/c3-Joint2:j3", {0x0a, 0x08, 0x0c}},
                                  {"PRM:/r1/c1/c2/c3/c4-Joint2:j4", {0x0e, 0x08, 0x10}}};
