// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

#ifndef ROS__RUN_NODE_HPP_
#define ROS__RUN_NODE_HPP_

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>

#include "rclcpp/rclcpp.hpp"

#include "managed_node.hpp"

namespace all_kinds
{

/// Run a node alone in its process until a signal or a failure; return the exit code.
inline int run_node(
  int argc,
  char ** argv,
  const std::function<std::shared_ptr<ManagedNode>(const rclcpp::NodeOptions &)> & make_node)
{
  try {
    rclcpp::init(argc, argv);
  } catch (const std::exception & error) {  // of arguments that ROS does not know
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
  }
  try {
    auto node = make_node(rclcpp::NodeOptions());
    node->be_alone();
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_node(node->get_node_base_interface());
    executor.spin();
    executor.remove_node(node->get_node_base_interface());
    if (node->is_stuck()) {
      // Threads that do not end may not see the end of what is global.
      std::fflush(nullptr);
      std::_Exit(EXIT_FAILURE);
    }
    const int code = node->has_failed() ? EXIT_FAILURE : EXIT_SUCCESS;
    node.reset();
    rclcpp::shutdown();
    return code;
  } catch (const std::exception & error) {
    if (!rclcpp::ok()) {
      return EXIT_SUCCESS;  // A signal came before the node was there.
    }
    RCLCPP_FATAL(rclcpp::get_logger("all_kinds"), "%s", error.what());
    return EXIT_FAILURE;
  }
}

}  // namespace all_kinds

#endif  // ROS__RUN_NODE_HPP_
