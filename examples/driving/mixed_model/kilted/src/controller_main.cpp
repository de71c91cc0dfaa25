// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The executable of the node controller.

#include <memory>

#include "ros/run_node.hpp"

namespace driving
{

std::shared_ptr<ManagedNode> make_controller_node(
  const rclcpp::NodeOptions & options);

}  // namespace driving

int main(int argc, char ** argv)
{
  return driving::run_node(argc, argv, driving::make_controller_node);
}
