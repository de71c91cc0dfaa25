// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// Tests of the logic of worker, without ROS.

#include "gtest/gtest.h"

#include "all_kinds/worker_impl.hpp"

/// The logic alone; publishers and clients do nothing.
class TestWorkerImpl : public ::testing::Test
{
protected:
  all_kinds::WorkerConfig config;
  all_kinds::WorkerData data;
  all_kinds::WorkerPassthrough passthrough;
  all_kinds::WorkerImpl impl{passthrough};
};

TEST_F(TestWorkerImpl, AcceptsItsDefaultParameters) {
  EXPECT_TRUE(impl.configure(config));
}

TEST_F(TestWorkerImpl, WorksWithoutAnyMessageReceived) {
  ASSERT_TRUE(impl.configure(config));
  impl.update(data, config);
  impl.cleanup();
}
