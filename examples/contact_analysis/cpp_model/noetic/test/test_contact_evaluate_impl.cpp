// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

// Tests of the logic of contact_evaluate, without ROS.

#include "gtest/gtest.h"

#include "contact_analysis/contact_evaluate_impl.hpp"

/// The logic alone; publishers and clients do nothing.
class TestContactEvaluateImpl : public ::testing::Test
{
protected:
  contact_analysis::ContactEvaluateConfig config;
  contact_analysis::ContactEvaluateData data;
  contact_analysis::ContactEvaluatePassthrough passthrough;
  contact_analysis::ContactEvaluateImpl impl{passthrough};
};

TEST_F(TestContactEvaluateImpl, AcceptsItsDefaultParameters) {
  EXPECT_TRUE(impl.configure(config));
}

TEST_F(TestContactEvaluateImpl, WorksWithoutAnyMessageReceived) {
  ASSERT_TRUE(impl.configure(config));
  impl.update(data, config);
  impl.cleanup();
}
