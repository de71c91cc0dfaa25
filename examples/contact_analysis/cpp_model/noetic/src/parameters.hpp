// Copyright 2019 My Company
// SPDX-License-Identifier: GPL-3.0-only

#ifndef PARAMETERS_HPP_
#define PARAMETERS_HPP_

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "ros/node_handle.h"

namespace contact_analysis
{

inline bool get_parameter(
  const ros::NodeHandle & node,
  const std::string & name,
  std::int64_t & value)
{
  int number = 0;
  const bool found = node.getParam(name, number);
  value = number;
  return found;
}

inline bool get_parameter(
  const ros::NodeHandle & node,
  const std::string & name,
  std::vector<std::int64_t> & value)
{
  std::vector<int> numbers;
  const bool found = node.getParam(name, numbers);
  value.assign(numbers.begin(), numbers.end());
  return found;
}

template<typename Value>
bool get_parameter(const ros::NodeHandle & node, const std::string & name, Value & value)
{
  return node.getParam(name, value);
}

/// Read a parameter of a node; without one, keep the value.
template<typename Value>
void read_parameter(const ros::NodeHandle & node, const std::string & name, Value & value)
{
  if (node.hasParam(name) && !get_parameter(node, name, value)) {
    throw std::runtime_error("Parameter " + node.resolveName(name) + " has a wrong type.");
  }
}

}  // namespace contact_analysis

#endif  // PARAMETERS_HPP_
