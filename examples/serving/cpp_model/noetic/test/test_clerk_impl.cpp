// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// Tests of the logic of clerk, without ROS.

#include "gtest/gtest.h"

#include "./clerk_harness.hpp"

/// The logic alone, with fakes that record what it does.
class TestClerkImpl : public ::testing::Test
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

  serving::ClerkHarness harness;
};

TEST_F(TestClerkImpl, StartsAndEndsWithoutWaiting) {
  EXPECT_EQ(harness.time.nanoseconds(), 0);
}
