// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// Tests of the logic of observer, without ROS.

#include "gtest/gtest.h"

#include "./support/observer_harness.hpp"

/// The logic alone, with fakes that record what it does.
class TestObserverImpl : public ::testing::Test
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

  all_kinds::ObserverHarness harness;
};

TEST_F(TestObserverImpl, WorksWithoutAnyMessageReceived) {
  harness.run_cycle();
  harness.run_cycle();
}
