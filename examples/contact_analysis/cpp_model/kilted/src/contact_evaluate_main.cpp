// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

// The executable of the node contact_evaluate.

#include <memory>

#include "ros/run_node.hpp"

namespace contact_analysis
{

std::shared_ptr<ManagedNode> make_contact_evaluate_node(
  const rclcpp::NodeOptions & options);

}  // namespace contact_analysis

int main(int argc, char ** argv)
{
  return contact_analysis::run_node(argc, argv, contact_analysis::make_contact_evaluate_node);
}
