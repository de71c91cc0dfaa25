// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// Tests of the logic of idler, without ROS.

#include "gtest/gtest.h"

#include "serving/idler_impl.hpp"

/// The logic alone; publishers and clients do nothing.
class TestIdlerImpl : public ::testing::Test
{
protected:
  serving::IdlerConfig config;
  serving::IdlerPassthrough passthrough;
  serving::IdlerImpl impl{passthrough};
};

TEST_F(TestIdlerImpl, AcceptsItsDefaultParameters) {
  EXPECT_TRUE(impl.configure(config));
}

TEST_F(TestIdlerImpl, CleansUpAfterItself) {
  ASSERT_TRUE(impl.configure(config));
  impl.cleanup();
}
