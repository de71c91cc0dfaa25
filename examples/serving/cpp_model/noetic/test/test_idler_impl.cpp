// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// Tests of the logic of idler, without ROS.

#include "gtest/gtest.h"

#include "./idler_harness.hpp"

/// The logic alone, with fakes that record what it does.
class TestIdlerImpl : public ::testing::Test
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

  serving::IdlerHarness harness;
};

TEST_F(TestIdlerImpl, StartsAndEndsWithoutWaiting) {
  EXPECT_EQ(harness.time.nanoseconds(), 0);
}
