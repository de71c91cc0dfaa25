// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// Tests of the node idler, which rostest starts.

#include "gtest/gtest.h"
#include "ros/init.h"
#include "ros/service.h"

constexpr char SERVICE[] = "/idler/get_loggers";
constexpr int TIMEOUT = 10000;  // milliseconds

/// The node runs: it offers the services of every node.
TEST(TestIdlerNode, Starts) {
  EXPECT_TRUE(ros::service::waitForService(SERVICE, TIMEOUT));
}

int main(int argc, char ** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_idler_node");
  return RUN_ALL_TESTS();
}
