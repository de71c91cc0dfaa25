// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef OWN_EXECUTOR_HPP_
#define OWN_EXECUTOR_HPP_

#include "rclcpp/callback_group.hpp"
#include "rclcpp/executors/single_threaded_executor.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace serving
{

/// Create a callback group that is not added to the node's executor.
inline rclcpp::CallbackGroup::SharedPtr make_own_group(rclcpp_lifecycle::LifecycleNode & node)
{
  return node.create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
}

/// Return executor options with the context of a node.
inline rclcpp::ExecutorOptions make_executor_options(rclcpp_lifecycle::LifecycleNode & node)
{
  rclcpp::ExecutorOptions options;
  options.context = node.get_node_base_interface()->get_context();
  return options;
}

}  // namespace serving

#endif  // OWN_EXECUTOR_HPP_
