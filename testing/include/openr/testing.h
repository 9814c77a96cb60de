// openr::testing: tests for OPEN-R objects, with GoogleTest.
//
// Read bench.h first; docs/testing.md is the tutorial.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/bench.h"
#include "testing/snapshot.h"
