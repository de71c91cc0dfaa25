// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// Tests of the logic of controller, without ROS.

#include "gtest/gtest.h"

#include "./controller_harness.hpp"

/// The logic alone, with fakes that record what it does.
class TestControllerImpl : public ::testing::Test
{
protected:
  void SetUp() override
  {
    ASSERT_TRUE(harness.impl.configure(harness.config));
    ASSERT_TRUE(harness.impl.activate());
  }

  void TearDown() override
  {
    harness.impl.deactivate();
    harness.impl.cleanup();
  }

  driving::ControllerHarness harness;
};

TEST_F(TestControllerImpl, WorksWithoutAnyMessageReceived) {
  harness.run_cycle();
  harness.run_cycle();
}
