// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

// Tests of the node contact_evaluate, which rostest starts.

#include "gtest/gtest.h"
#include "ros/init.h"
#include "ros/service.h"

constexpr char SERVICE[] = "/contact_evaluate/get_loggers";
constexpr int TIMEOUT = 10000;  // milliseconds

/// The node runs: it offers the services of every node.
TEST(TestContactEvaluateNode, Starts) {
  EXPECT_TRUE(ros::service::waitForService(SERVICE, TIMEOUT));
}

int main(int argc, char ** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_contact_evaluate_node");
  return RUN_ALL_TESTS();
}
