// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// Tests of the logic of worker, without ROS.

#include "gtest/gtest.h"

#include "./support/worker_harness.hpp"

/// The logic alone, with fakes that record what it does.
class TestWorkerImpl : public ::testing::Test
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

  all_kinds::WorkerHarness harness;
};

TEST_F(TestWorkerImpl, WorksWithoutAnyMessageReceived) {
  harness.run_cycle();
  harness.run_cycle();
}
