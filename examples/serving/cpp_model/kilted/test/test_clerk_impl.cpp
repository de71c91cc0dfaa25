// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// Tests of the logic of clerk, without ROS.

#include "gtest/gtest.h"

#include "serving/clerk_impl.hpp"

/// The logic alone; publishers and clients do nothing.
class TestClerkImpl : public ::testing::Test
{
protected:
  serving::ClerkConfig config;
  serving::ClerkPassthrough passthrough;
  serving::ClerkImpl impl{passthrough};
};

TEST_F(TestClerkImpl, AcceptsItsDefaultParameters) {
  EXPECT_TRUE(impl.configure(config));
}

TEST_F(TestClerkImpl, CleansUpAfterItself) {
  ASSERT_TRUE(impl.configure(config));
  impl.cleanup();
}
