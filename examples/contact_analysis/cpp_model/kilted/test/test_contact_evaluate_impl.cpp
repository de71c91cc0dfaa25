// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

// Tests of the logic of contact_evaluate, without ROS.

#include "gtest/gtest.h"

#include "./contact_evaluate_harness.hpp"

/// The logic alone, with fakes that record what it does.
class TestContactEvaluateImpl : public ::testing::Test
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

  contact_analysis::ContactEvaluateHarness harness;
};

TEST_F(TestContactEvaluateImpl, WorksWithoutAnyMessageReceived) {
  harness.run_cycle();
  harness.run_cycle();
}
