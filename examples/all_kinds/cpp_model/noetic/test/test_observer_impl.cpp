// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// Tests of the logic of observer, without ROS.

#include "gtest/gtest.h"

#include "all_kinds/observer_impl.hpp"

/// The logic alone; publishers and clients do nothing.
class TestObserverImpl : public ::testing::Test
{
protected:
  all_kinds::ObserverConfig config;
  all_kinds::ObserverData data;
  all_kinds::ObserverPassthrough passthrough;
  all_kinds::ObserverImpl impl{passthrough};
};

TEST_F(TestObserverImpl, AcceptsItsDefaultParameters) {
  EXPECT_TRUE(impl.configure(config));
}

TEST_F(TestObserverImpl, WorksWithoutAnyMessageReceived) {
  ASSERT_TRUE(impl.configure(config));
  impl.update(data, config);
  impl.cleanup();
}
