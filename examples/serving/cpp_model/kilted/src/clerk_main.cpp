// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The executable of the node clerk.

#include <memory>

#include "ros/run_node.hpp"

namespace serving
{

std::shared_ptr<ManagedNode> make_clerk_node(
  const rclcpp::NodeOptions & options);

}  // namespace serving

int main(int argc, char ** argv)
{
  return serving::run_node(argc, argv, serving::make_clerk_node);
}
