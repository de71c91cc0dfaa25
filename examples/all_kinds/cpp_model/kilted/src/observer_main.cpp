// Copyright 2026 Ada Lovelace
// SPDX-License-Identifier: Apache-2.0

// The executable of the node observer.

#include <memory>

#include "ros/run_node.hpp"

namespace all_kinds
{

std::shared_ptr<ManagedNode> make_observer_node(
  const rclcpp::NodeOptions & options);

}  // namespace all_kinds

int main(int argc, char ** argv)
{
  return all_kinds::run_node(argc, argv, all_kinds::make_observer_node);
}
